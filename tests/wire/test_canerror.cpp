// SPDX-License-Identifier: GPL-3.0-or-later
// Bits and codes: linux/can/error.h of Linux 6.1.
#include "wire/canerror.h"

#include <gtest/gtest.h>

#include <linux/can/error.h>

using namespace mb;

namespace {

CanFrame errorFrame(std::uint32_t classes, std::array<std::uint8_t, 8> data = {})
{
    CanFrame frame;
    frame.id = classes;
    frame.error = true;
    frame.size = 8;
    frame.data = data;
    return frame;
}

CanErrorReport controller(std::uint8_t bits, std::uint8_t transmit = 0, std::uint8_t receive = 0)
{
    return decodeError(errorFrame(CAN_ERR_CRTL, {0, bits, 0, 0, 0, 0, transmit, receive}));
}

} // namespace

TEST(CanError, ControllerBitsAreTheBusState)
{
    EXPECT_EQ(controller(CAN_ERR_CRTL_RX_WARNING).state, BusState::Warning);
    EXPECT_EQ(controller(CAN_ERR_CRTL_TX_WARNING).state, BusState::Warning);
    EXPECT_EQ(controller(CAN_ERR_CRTL_RX_PASSIVE).state, BusState::Passive);
    EXPECT_EQ(controller(CAN_ERR_CRTL_TX_WARNING | CAN_ERR_CRTL_TX_PASSIVE).state, BusState::Passive);
    EXPECT_EQ(controller(CAN_ERR_CRTL_ACTIVE).state, BusState::Active);
    EXPECT_EQ(controller(CAN_ERR_CRTL_RX_OVERFLOW).state, std::nullopt) << "an overrun says nothing of the state";
    EXPECT_EQ(decodeError(errorFrame(CAN_ERR_BUSOFF)).state, BusState::BusOff);
    EXPECT_EQ(decodeError(errorFrame(CAN_ERR_RESTARTED)).state, BusState::Active);
    EXPECT_TRUE(decodeError(errorFrame(CAN_ERR_RESTARTED)).restarted);
}

TEST(CanError, DataOfAClassThatIsNotSetIsNotRead)
{
    const CanErrorReport report = decodeError(errorFrame(CAN_ERR_BUSERROR, {5, 0xFF, 0xFF, 0xFF, 0xFF, 0, 9, 9}));
    CanErrorReport expected;
    expected.busError = true;
    EXPECT_EQ(report, expected);
    EXPECT_EQ(describe(report), "bus error");
}

TEST(CanError, OverrunsOfBothDirectionsAreToldApart)
{
    EXPECT_TRUE(controller(CAN_ERR_CRTL_RX_OVERFLOW).overrun);
    EXPECT_FALSE(controller(CAN_ERR_CRTL_RX_OVERFLOW).transmitOverrun);
    EXPECT_TRUE(controller(CAN_ERR_CRTL_TX_OVERFLOW).transmitOverrun);
    EXPECT_EQ(describe(controller(CAN_ERR_CRTL_RX_OVERFLOW)), "the controller lost received frames");
}

TEST(CanError, ArbitrationLossHasItsBit)
{
    const CanErrorReport report = decodeError(errorFrame(CAN_ERR_LOSTARB, {11}));
    EXPECT_TRUE(report.arbitrationLost);
    EXPECT_EQ(report.arbitrationBit, 11);
    EXPECT_EQ(describe(report), "arbitration lost at bit 11");
    EXPECT_EQ(describe(decodeError(errorFrame(CAN_ERR_LOSTARB))), "arbitration lost");
}

TEST(CanError, ProtocolErrorsHaveKindAndPlace)
{
    const CanErrorReport report = decodeError(
        errorFrame(CAN_ERR_PROT | CAN_ERR_BUSERROR, {0, 0, CAN_ERR_PROT_STUFF, CAN_ERR_PROT_LOC_DATA, 0, 0, 0, 0}));
    EXPECT_TRUE(report.protocol);
    EXPECT_FALSE(report.noAcknowledge);
    EXPECT_EQ(describe(report), "stuff error in the data");
    EXPECT_EQ(describe(decodeError(
                  errorFrame(CAN_ERR_PROT, {0, 0, CAN_ERR_PROT_FORM | CAN_ERR_PROT_BIT, CAN_ERR_PROT_LOC_CRC_DEL}))),
        "bit error and form error in the checksum delimiter");
    EXPECT_EQ(describe(decodeError(errorFrame(CAN_ERR_PROT, {}))), "protocol error");
}

TEST(CanError, AMissingAcknowledgeIsKnownInBothItsForms)
{
    EXPECT_TRUE(decodeError(errorFrame(CAN_ERR_ACK)).noAcknowledge);
    const CanErrorReport slot
        = decodeError(errorFrame(CAN_ERR_PROT, {0, 0, CAN_ERR_PROT_TX, CAN_ERR_PROT_LOC_ACK, 0, 0, 0, 0}));
    EXPECT_TRUE(slot.noAcknowledge);
    EXPECT_FALSE(slot.protocol);
    EXPECT_EQ(describe(slot), "nobody acknowledged");
}

TEST(CanError, ErrorCountersComeWithTheirClassOrBesideTheState)
{
    const CanErrorReport told = decodeError(errorFrame(CAN_ERR_CNT, {0, 0, 0, 0, 0, 0, 0, 0}));
    EXPECT_EQ(told.transmitErrors, 0);
    const CanErrorReport older = controller(CAN_ERR_CRTL_TX_PASSIVE, 136, 3);
    EXPECT_EQ(older.transmitErrors, 136);
    EXPECT_EQ(older.receiveErrors, 3);
    EXPECT_EQ(describe(older), "136 transmit and 3 receive errors, error-passive");
    EXPECT_EQ(controller(CAN_ERR_CRTL_TX_PASSIVE).transmitErrors, std::nullopt);
    EXPECT_EQ(controller(CAN_ERR_CRTL_TX_PASSIVE, 136, 0).transmitErrors, 136) << "one of them is enough";
    EXPECT_EQ(controller(CAN_ERR_CRTL_TX_PASSIVE, 136, 0).receiveErrors, 0);
    EXPECT_EQ(controller(CAN_ERR_CRTL_RX_PASSIVE, 0, 1).transmitErrors, 0);
    EXPECT_EQ(controller(CAN_ERR_CRTL_RX_PASSIVE, 0, 1).receiveErrors, 1);
    EXPECT_EQ(decodeError(errorFrame(CAN_ERR_ACK, {0, 0, 0, 0, 0, 0, 5, 5})).transmitErrors, std::nullopt)
        << "of another class they are something else";
}

TEST(CanError, WiringIsNamed)
{
    EXPECT_EQ(describe(decodeError(errorFrame(CAN_ERR_TRX, {0, 0, 0, 0, CAN_ERR_TRX_CANL_SHORT_TO_CANH}))),
        "CAN low is short to CAN high");
    EXPECT_EQ(describe(decodeError(errorFrame(CAN_ERR_TRX, {}))), "the transceiver reports an error");
}

TEST(CanError, EveryFrameHasADescription)
{
    for (std::uint32_t classes = 0; classes < 0x800; ++classes) {
        for (int byte = 0; byte < 256; byte += 5) {
            const auto value = static_cast<std::uint8_t>(byte);
            ASSERT_FALSE(
                describe(decodeError(errorFrame(classes, {value, value, value, value, value, value, value, value})))
                    .empty());
        }
    }
    EXPECT_EQ(describe(decodeError(errorFrame(0))), "unknown error");
}

TEST(CanError, EveryStateHasItsWord)
{
    EXPECT_EQ(toString(BusState::Active), "error-active");
    EXPECT_EQ(toString(BusState::Warning), "error-warning");
    EXPECT_EQ(toString(BusState::Passive), "error-passive");
    EXPECT_EQ(toString(BusState::BusOff), "bus-off");
}
