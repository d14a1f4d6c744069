// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/virtualclock.h"
#include "model/session.h"
#include "model/snapshot.h"
#include "support/simulatedsession.h"
#include "transport/seriallink.h"

#include <gtest/gtest.h>

#include <array>

using namespace mb;
using namespace std::chrono_literals;

namespace {

using Bytes = std::vector<std::uint8_t>;

/// Answers the byte of its address with that byte + 0x80.
class Responder final : public Simulator {
public:
    Responder(SerialLink &link, int address)
        : m_address(address)
        , m_received(link.received().add([this, &link](std::span<const std::uint8_t> bytes) {
            for (const std::uint8_t byte : bytes) {
                if (byte == m_address) {
                    EXPECT_TRUE(link.send(Bytes{static_cast<std::uint8_t>(byte + 0x80)}));
                }
            }
        }))
    {
    }
    [[nodiscard]] std::string name() const override { return "responder:" + std::to_string(m_address); }
    [[nodiscard]] bool isOutputOn() const override { return false; }
    [[nodiscard]] double speed() const override { return 0.0; }
    [[nodiscard]] double position() const override { return 0.0; }
    void setPowered(bool) override { }
    bool disturb(std::string_view, double) override { return false; }

private:
    int m_address;
    Subscription m_received;
};

Result<std::unique_ptr<Simulator>> simulateResponder(Link &link, Clock &, const SimulatedUnit &unit)
{
    return std::make_unique<Responder>(static_cast<SerialLink &>(link), unit.address);
}

constexpr std::array serialLinks{LinkKind::Serial};
constexpr std::array<std::string_view, 2> units{"responder:4", "responder:5"};

Family makeResponderFamily()
{
    Family family{};
    family.key = "responder";
    family.links = serialLinks;
    family.bench = units;
    family.simulate = simulateResponder;
    return family;
}

struct SerialBench : public ::testing::Test {
    SerialLink *open(const char *address)
    {
        auto link = session.openLink(LinkAddress::parse(address).value());
        if (!link) {
            error = link.error();
            return nullptr;
        }
        auto *serial = static_cast<SerialLink *>(*link);
        received = serial->received().add(
            [this](std::span<const std::uint8_t> bytes) { heard.insert(heard.end(), bytes.begin(), bytes.end()); });
        return serial;
    }

    VirtualClock clock;
    const Family family = makeResponderFamily();
    std::array<const Family *, 1> families{&family};
    Session session{clock, families};
    std::optional<Error> error;
    Bytes heard;
    Subscription received;
};

} // namespace

TEST(Snapshots, TellARateForEachChannelAndWhatIsKnownOfADevice)
{
    test::SimulatedSession bench;
    bench.scan();
    bench.clock.advance(3s);
    Device &device = *bench.device(5);
    device.gate().moveAcknowledged({});
    const DeviceView view = viewOf(bench.session, device);
    EXPECT_EQ(view.id, bench.session.idOf(device));
    EXPECT_EQ(view.selector, device.selector());
    EXPECT_EQ(view.liveness, device.liveness());
    EXPECT_EQ(view.kept.state, KeptMove::State::Acknowledged);
    EXPECT_TRUE(view.mayNotMove.empty());
    ASSERT_EQ(view.rates.size(), device.family().channels.size());
    const auto duty = findChannel(device.family().channels, "duty");
    EXPECT_NEAR(view.rates[duty->value], 100.0, 5.0);
    EXPECT_EQ(view.parameters->size(), device.parameters().table().size());
    EXPECT_NE(viewOf(bench.session, *bench.device(9)).mayNotBeStopped, Message()) << "in its bootloader";
}

TEST(Snapshots, TellNoRateOfADeviceThatFellSilent)
{
    test::SimulatedSession bench;
    bench.scan();
    bench.clock.advance(3s);
    Device &device = *bench.device(5);
    const auto duty = findChannel(device.family().channels, "duty");
    ASSERT_GT(viewOf(bench.session, device).rates[duty->value], 90.0);
    for (const auto &unit : bench.session.bench(device.link())->simulators()) {
        if (unit->name() == "dmc60c:5")
            unit->setPowered(false);
    }
    bench.clock.advance(5s);
    EXPECT_EQ(viewOf(bench.session, device).rates[duty->value], 0.0);
}

TEST_F(SerialBench, UnitsOfSerialFamiliesLiveOnALineWithTheTimingOfItsRate)
{
    SerialLink *link = open("sim:serial");
    ASSERT_TRUE(link);
    EXPECT_EQ(link->baudrate(), 115200);
    EXPECT_EQ(link->fixedBaudrate(), std::nullopt);
    for (const std::uint8_t address : Bytes{4, 5, 6}) {
        ASSERT_TRUE(link->send(Bytes{address}));
        clock.advance(2 * link->byteTime());
    }
    EXPECT_EQ(heard, (Bytes{0x84, 0x85}));
    ASSERT_TRUE(session.bench(*link));
    EXPECT_EQ(session.bench(*link)->simulators().size(), 2U);
}

TEST_F(SerialBench, TheBitRateOfTheAddressIsThatOfEveryEnd)
{
    SerialLink *link = open("sim:serial?bitrate=9600");
    ASSERT_TRUE(link);
    EXPECT_EQ(link->fixedBaudrate(), 9600);
    ASSERT_TRUE(link->send(Bytes{4}));
    clock.advance(2 * link->byteTime() - 1ns);
    EXPECT_TRUE(heard.empty());
    clock.advance(1ns);
    EXPECT_EQ(heard, Bytes{0x84});
    ASSERT_TRUE(link->setBaudrate(115200));
    heard.clear();
    ASSERT_TRUE(link->send(Bytes{4}));
    clock.advance(1s);
    EXPECT_TRUE(heard.empty()) << "understood at another rate";
}

TEST_F(SerialBench, LossAndACableThatComesOutAreOptions)
{
    SerialLink *link = open("sim:serial?loss=0.5&fault=busoff@5");
    ASSERT_TRUE(link);
    for (int i = 0; i < 400; ++i) {
        ASSERT_TRUE(link->send(Bytes{4}));
        clock.advance(10ms);
    }
    EXPECT_NEAR(static_cast<double>(heard.size()), 100.0, 30.0) << "of 400 there and back";
    EXPECT_EQ(link->state(), LinkState::Open);
    clock.advance(2s);
    EXPECT_EQ(link->state(), LinkState::Lost);
    EXPECT_EQ(link->loss().message(), "the cable was pulled out; plug it in again");
}

TEST_F(SerialBench, WhatDoesNotExistIsRefused)
{
    EXPECT_FALSE(open("sim:can"));
    EXPECT_EQ(error->fault, Fault::Unsupported) << "no family of this session is on CAN";
    EXPECT_FALSE(open("sim:spi"));
    EXPECT_EQ(error->fault, Fault::Unsupported);
    EXPECT_FALSE(open("sim:"));
    for (const char *address : {"sim:serial?bitrate=10", "sim:serial?bitrate=5000000", "sim:serial?baud=9600"}) {
        EXPECT_FALSE(open(address)) << address;
        EXPECT_EQ(error->fault, Fault::OutOfRange) << address;
    }
    EXPECT_EQ(expandLink(LinkAddress::parse("sim:?seed=3").value(), families),
        std::vector{LinkAddress::parse("sim:serial?seed=3").value()});
}

TEST_F(SerialBench, TheSnapshotHasRateLoadAndRoundTrip)
{
    SerialLink *link = open("sim:serial");
    ASSERT_TRUE(link);
    EXPECT_EQ(viewOf(*link, clock).roundTrip, std::nullopt);
    link->noteRoundTrip(2ms);
    link->noteRoundTrip(4ms);
    const LinkView view = viewOf(*link, clock);
    EXPECT_EQ(view.kind, LinkKind::Serial);
    EXPECT_EQ(view.bitrate, 115200);
    ASSERT_TRUE(view.roundTrip);
    EXPECT_GT(*view.roundTrip, 2ms);
    EXPECT_LT(*view.roundTrip, 4ms);
}

TEST(Benches, TheSimulatedLinksTogetherShareAFaultOutToThoseThatCanHaveIt)
{
    const auto expanded = [](const char *address) {
        std::string all;
        for (const LinkAddress &each : expandLink(LinkAddress::parse(address).value(), families()))
            all += each.text() + ' ';
        return all;
    };
    EXPECT_EQ(expanded("sim:"), "sim:can sim:serial sim:spi ");
    EXPECT_EQ(expanded("sim:can?fault=melt@1"), "sim:can?fault=melt@1 ");
    EXPECT_EQ(expanded("socketcan:can0"), "socketcan:can0 ");
    EXPECT_EQ(expanded("sim:?fault=power-page@3"), "sim:can?fault=power-page@3 sim:serial sim:spi ");
    EXPECT_EQ(expanded("sim:?fault=melt@1"), "sim:can?fault=melt@1 sim:serial?fault=melt@1 sim:spi?fault=melt@1 ")
        << "each of them refuses it";
    EXPECT_EQ(expanded("sim:?seed=3&fault=power-page@3&fault=stall@1"),
        "sim:can?seed=3&fault=power-page@3&fault=stall@1 sim:serial?seed=3&fault=stall@1 "
        "sim:spi?seed=3&fault=stall@1 ");
}
