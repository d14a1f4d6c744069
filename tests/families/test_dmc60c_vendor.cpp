// SPDX-License-Identifier: GPL-3.0-or-later
// What the answers to vendor commands mean, in words and as faults; and how long the texts are that a unit keeps.
#include "async/virtualclock.h"
#include "dmc60csimulatorbench.h"
#include "families/dmc60c/parameterexchange.h"
#include "families/dmc60c/setpoints.h"
#include "families/dmc60c/vendor.h"
#include "support/simulatedsession.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace mb::dmc60c {
namespace {

using namespace std::chrono_literals;

VendorReply statusReply(CommandStatus status)
{
    VendorReply reply;
    reply.status = status;
    return reply;
}

TEST(Dmc60cVendor, EachStatusHasItsWordsAndItsFault)
{
    const std::vector<std::tuple<CommandStatus, Fault, std::string>> refusals{
        {CommandStatus::NotSupported, Fault::Unsupported, "not supported"},
        {CommandStatus::BadParameter, Fault::Refused, "bad parameter"},
        {CommandStatus::DataRcvMore, Fault::BadCheck, "more data than announced"},
        {CommandStatus::InBootloader, Fault::Refused, "in the bootloader"},
        {CommandStatus::CrcMismatch, Fault::BadCheck, "CRC mismatch"},
        {CommandStatus::FlashWriteFailed, Fault::Refused, "flash write failed"},
        {CommandStatus::AckReset, Fault::Refused, "restarted"},
        {CommandStatus::TestPassed, Fault::BadReply, "test passed"},
        {CommandStatus::TestFailed, Fault::Refused, "test failed"},
        {static_cast<CommandStatus>(77), Fault::BadReply, "unknown status"}};
    EXPECT_TRUE(check(Command::GetFwver, statusReply(CommandStatus::NoError)));
    for (const auto &[status, fault, words] : refusals) {
        const auto refused = check(Command::GetFwver, statusReply(status));
        ASSERT_FALSE(refused) << words;
        EXPECT_EQ(refused.error().fault, fault) << words;
        EXPECT_EQ(refused.error().text(), "GetFwver: the device answers '" + words + "'");
    }
    const auto noBootloader = check(Command::EnterBootloader, statusReply(CommandStatus::NoError));
    ASSERT_FALSE(noBootloader);
    EXPECT_EQ(noBootloader.error().fault, Fault::BadReply);
    EXPECT_EQ(noBootloader.error().text(), "EnterBootloader: the device answers 'no error'");
}

TEST(Dmc60cVendor, EachCommandHasItsNameAndWhatIsItsSuccess)
{
    using enum Command;
    std::string names;
    for (const Command command : {SetDevNumber, SetDevName, SetManName, SetProdName, SetManDate, SetHardwareVer, SetSN,
             FlashLEDs, GetDescriptors, GetFwver, GetFlashSeqnum, EnterBootloader, SoftReset, EraseWriteFlashPage,
             J1ShortTest, J1OpenTest}) {
        names += std::string(toString(command)) + ' ';
        const CommandStatus success = command == EnterBootloader ? CommandStatus::InBootloader
            : command == SoftReset                               ? CommandStatus::AckReset
            : command == J1ShortTest || command == J1OpenTest    ? CommandStatus::TestPassed
                                                                 : CommandStatus::NoError;
        EXPECT_EQ(successOf(command), success) << toString(command);
        EXPECT_TRUE(check(command, statusReply(success))) << toString(command);
    }
    EXPECT_EQ(names,
        "SetDevNumber SetDevName SetManName SetProdName SetManDate SetHardwareVer SetSN FlashLEDs GetDescriptors "
        "GetFwver "
        "GetFlashSeqnum EnterBootloader SoftReset EraseWriteFlashPage J1ShortTest J1OpenTest ");
    EXPECT_EQ(toString(static_cast<Command>(0xFFFF)), "unknown command");
    EXPECT_EQ(attemptsOf(static_cast<Command>(0xFFFF)).timeout, Attempts{}.timeout);
}

TEST(Dmc60cVendor, DescriptorsThatEndTooEarlyAreNone)
{
    VendorReply reply = statusReply(CommandStatus::NoError);
    reply.data = {1, 200, 'x'};
    const auto list = descriptorsIn(reply);
    ASSERT_FALSE(list);
    EXPECT_EQ(list.error().fault, Fault::BadReply);
    EXPECT_EQ(list.error().text(), "GetDescriptors: a field ends too early");
    EXPECT_EQ(descriptorsIn(statusReply(CommandStatus::NotSupported)).error().fault, Fault::Unsupported);
}

TEST(Dmc60cVendor, AnAnswerAboutAParameterHasItsWords)
{
    const auto text = [](ParameterStatus status) {
        const auto answered = check(ParamResponse{5, 9, 0, status}, "slot0.p");
        return answered ? std::pair(Fault::Timeout, std::string())
                        : std::pair(answered.error().fault, answered.error().text());
    };
    EXPECT_EQ(text(ParameterStatus::NoError).second, "");
    EXPECT_EQ(text(ParameterStatus::BadParameter),
        std::pair(Fault::Refused, std::string("slot0.p: this firmware does not know the parameter")));
    EXPECT_EQ(text(ParameterStatus::BadValue),
        std::pair(Fault::Refused, std::string("slot0.p: the device refused the value")));
    EXPECT_EQ(text(static_cast<ParameterStatus>(7)),
        std::pair(Fault::BadReply, std::string("slot0.p: status 7 has no meaning")));
}

TEST(Dmc60cVendor, EveryModeThatAUnitReportsIsOneOfOursAndAnotherNone)
{
    const std::vector<std::pair<ControlMode, Mode>> modes{{ControlMode::Voltage, Mode::Duty},
        {ControlMode::Velocity, Mode::Velocity}, {ControlMode::Position, Mode::Position},
        {ControlMode::Current, Mode::Current}, {ControlMode::VoltageCompensated, Mode::Voltage},
        {ControlMode::Follower, Mode::Follow}, {ControlMode::NoDrive, Mode::Off}};
    for (const auto &[reported, mode] : modes)
        EXPECT_EQ(modeOf(reported), mode) << static_cast<int>(reported);
    EXPECT_EQ(modeOf(static_cast<ControlMode>(14)), std::nullopt);
}

/// One unit of the simulated bench, asked as nobody asks it but its maker.
TEST(Dmc60cVendor, ASimulatedUnitKeepsTextsAsLongAsTheirFields)
{
    VirtualClock clock;
    VirtualCanBus bus(clock, bitrate, 1);
    VirtualCanLink host(*LinkAddress::parse("sim:can"), bus);
    VirtualCanLink box(*LinkAddress::parse("sim:can"), bus);
    ASSERT_TRUE(host.open() && box.open());
    const auto unit = simulate(box, clock, *SimulatedUnit::parse("dmc60c:5,session=0x1234"));
    ASSERT_TRUE(unit);
    const auto ask = [&](Command command, std::vector<std::uint8_t> data) {
        VendorRequest request;
        request.device = 5;
        request.session = 0x1234;
        request.command = {command, static_cast<std::uint16_t>(data.size())};
        request.data = std::move(data);
        return test::run(clock, vendorExchange(host, clock, request, attemptsOf(command)));
    };
    for (const auto &[command, longest] : std::vector<std::pair<Command, std::size_t>>{{Command::SetDevName, 64},
             {Command::SetManName, 28}, {Command::SetProdName, 28}, {Command::SetManDate, 20},
             {Command::SetHardwareVer, 8}, {Command::SetSN, 12}}) {
        for (const std::size_t more : {0U, 1U}) {
            std::vector<std::uint8_t> text(longest + more, 'x');
            text.push_back(0);
            const auto reply = ask(command, text);
            ASSERT_TRUE(reply) << toString(command);
            EXPECT_EQ(reply->status, more == 0 ? CommandStatus::NoError : CommandStatus::BadParameter)
                << toString(command);
        }
    }
    const auto list = descriptorsIn(ask(Command::GetDescriptors, {}).value());
    ASSERT_TRUE(list);
    std::vector<std::size_t> lengths;
    for (const auto &[key, text] : *list)
        lengths.push_back(text.size());
    EXPECT_EQ(lengths, (std::vector<std::size_t>{64, 28, 28, 20, 8, 12}));
}

} // namespace
} // namespace mb::dmc60c
