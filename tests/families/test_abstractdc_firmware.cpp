// SPDX-License-Identifier: GPL-3.0-or-later
// Firmware through OpenOCD: against a stand-in that prints what the real one printed, and against the real one where there is
// no probe. The interfaces named for the real one are kinds that hardly anybody has plugged in.
#include "families/abstractdc/firmware.h"
#include "families/abstractdc/scan.h"
#include "families/abstractdc/simulator.h"
#include "firmware/intelhex.h"
#include "model/device.h"
#include "support/eventloop.h"
#include "support/hextext.h"
#include "transport/backends/virtualcan.h"
#include "transport/externalprogram.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>

#include <csignal>
#include <functional>

namespace mb::abstractdc {
extern const Family family;
namespace {

using namespace std::chrono_literals;

/// A small program: stack pointer, reset vector, code behind them.
test::HexText program()
{
    test::HexText hex;
    hex.add(0x08000000, {0x00, 0x50, 0x00, 0x20, 0x09, 0x00, 0x00, 0x08, 0xFE, 0xE7, 0x00, 0xBF});
    return hex;
}

FirmwareImage imageOf(const test::HexText &hex)
{
    return *FirmwareImage::fromIntelHex(hex.text());
}

const char *const success = R"(Open On-Chip Debugger 0.12.0
Info : clock speed 1000 kHz
Info : STLINK V2J37S7 (API v2) VID:PID 0483:3748
Info : Target voltage: 3.236220
Info : [stm32f1x.cpu] Cortex-M3 r1p1 processor detected
[stm32f1x.cpu] halted due to debug-request, current mode: Thread
** Programming Started **
Info : device id = 0x20036410
Info : flash size = 64 KiB
** Programming Finished **
** Verify Started **
** Verified OK **
** Resetting Target **
shutdown command invoked)";

TEST(AbstractDcFirmware, AnImageIsAProgramForAnStm32)
{
    const auto good = inspect(imageOf(program()));
    ASSERT_TRUE(good) << good.error().text();
    EXPECT_EQ(good->parts, std::vector<int>{0});
    EXPECT_FALSE(inspect(imageOf(test::smallApplication()))) << "another family's";
    for (const auto &[address, page] :
        {std::pair{0x08000400U, 1}, {0x080007FFU, 1}, {0x08000800U, 2}, {0x081FFFFFU, 2047}}) {
        auto one = program();
        one.add(address, {7}); // one byte at an edge of its page
        EXPECT_EQ(inspect(imageOf(one))->parts, (std::vector<int>{0, page})) << address;
    }
    auto beyond = program();
    beyond.add(0x08200000, {7});
    EXPECT_FALSE(inspect(imageOf(beyond)));
    auto before = program();
    before.add(0x07FFFFFF, {7});
    EXPECT_FALSE(inspect(imageOf(before)));
    test::HexText noVectors;
    noVectors.add(0x08000400, {1, 2, 3, 4});
    EXPECT_FALSE(inspect(imageOf(noVectors)));
    test::HexText arm;
    arm.add(0x08000000, {0x00, 0x50, 0x00, 0x20, 0x08, 0x00, 0x00, 0x08, 0xFE, 0xE7});
    EXPECT_FALSE(inspect(imageOf(arm))) << "an even reset vector";
    for (const std::vector<std::uint8_t> &vectors :
        {std::vector<std::uint8_t>{0x00, 0x50, 0x00, 0x21, 0x09, 0, 0, 0x08},
            {0x00, 0x50, 0x00, 0x20, 0x09, 0, 0, 0x09}, {0x00, 0x50, 0x00, 0x20, 0x0D, 0, 0, 0x08},
            {0x00, 0x50, 0x00, 0x20, 0x09, 0, 0}}) {
        test::HexText other;
        other.add(0x08000000, vectors);
        other.add(0x08000008, {0xFE, 0xE7});
        EXPECT_FALSE(inspect(imageOf(other))) << "no stack in RAM, no program at its reset, seven bytes";
    }
    for (const auto &[address, touched] : {std::pair{0x0800C7FFU, false}, {0x0800C800U, true}, {0x0800D3FFU, true},
             {0x0800D400U, false}}) { // three pages of 1 KiB
        auto edge = program();
        edge.add(address, {1});
        EXPECT_EQ(inspect(imageOf(edge))->notes.size(), touched ? 2U : 1U) << address;
    }
    auto settings = program();
    settings.add(0x0800C900, {1});
    EXPECT_EQ(inspect(imageOf(settings))->notes.size(), 2U) << "it writes the stored gains";
}

TEST(AbstractDcFirmware, ItsResetVectorPointsAtAnInstructionOfTheImage)
{
    for (const auto &[reset, isThere] : {std::pair{std::uint8_t{0x09}, true}, {0x0B, false}, {0x0D, false}}) {
        test::HexText hex;
        hex.add(0x08000000, {0x00, 0x50, 0x00, 0x20, reset, 0x00, 0x00, 0x08, 0xFE, 0xE7});
        EXPECT_EQ(inspect(imageOf(hex)).has_value(), isThere) << int{reset};
    }
}

TEST(AbstractDcFirmware, TheHexFileForOpenOcdHasTheBytesOfTheImage)
{
    auto hex = program();
    hex.add(0x0800FFF8, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12});
    hex.add(0x08010100, {42});
    const FirmwareImage image = imageOf(hex);
    const auto back = FirmwareImage::fromIntelHex(toIntelHex(image));
    ASSERT_TRUE(back) << back.error().text();
    ASSERT_EQ(back->byteCount(), image.byteCount());
    for (std::size_t i = 0; i < image.segments().size(); ++i) {
        const auto a = image.bytes(image.segments()[i]);
        const auto b = back->bytes(back->segments()[i]);
        EXPECT_TRUE(std::equal(a.begin(), a.end(), b.begin(), b.end()));
    }
}

/// A drive on a bus, both in real time, and a folder that comes first in PATH.
class AbstractDcUpdate : public testing::Test {
protected:
    AbstractDcUpdate()
        : bus(loop.clock(), 1'000'000, 1)
        , host(*LinkAddress::parse("sim:can"), bus)
        , other(*LinkAddress::parse("sim:can"), bus)
        , m_path(qgetenv("PATH"))
    {
        EXPECT_TRUE(host.open());
        EXPECT_TRUE(other.open());
        drive = *simulate(other, loop.clock(), *SimulatedUnit::parse("abstractdc:3"));
        device = family.open(host, loop.clock(), identityOf(3, &dialectF));
    }
    ~AbstractDcUpdate() override { qputenv("PATH", m_path); }

    void standIn(const std::string &script)
    {
        QFile file(folder.path() + "/openocd");
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(("#!/bin/sh\n" + script).c_str());
        file.close();
        ASSERT_TRUE(file.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner));
        qputenv("PATH", (folder.path().toUtf8() + ':' + m_path));
    }
    static std::string replay(const std::string &text, int status)
    {
        return "cat >&2 <<'END'\n" + text + "\nEND\nexit " + std::to_string(status) + "\n";
    }
    Result<UpdateReport> update(UpdateOptions options, const FirmwareImage &image = imageOf(program()))
    {
        auto task = abstractdc::update(*device, image, std::move(options), steps);
        task.start();
        EXPECT_TRUE(loop.runUntil([&] { return task.isFinished(); }, 60s));
        return std::move(task.result());
    }
    static UpdateOptions by(const std::string &via, bool erase = false)
    {
        UpdateOptions options;
        options.via = via;
        options.target = "f1";
        options.eraseSettings = erase;
        return options;
    }
    struct Steps final : Progress {
        void step(const Message &what, int, int) override
        {
            if (!said.empty() && said.back() == what.english())
                return;
            said.push_back(what.english());
            if (onStep)
                onStep(what.english());
        }
        void part(int number, PartState state) override { parts.emplace_back(number, state); }
        void log(Severity severity, const Message &) override { worst = std::max(worst, severity); }
        void mayInterrupt(bool may) override { interruptible = may; }
        void accepted(int pages, int retries) override
        {
            if (!interruptible)
                written.emplace_back(pages, retries);
        }
        std::function<void(const std::string &)> onStep;
        bool interruptible = true;
        std::vector<std::string> said;
        std::vector<std::pair<int, int>> written; ///< and retries, as it was told while it was not to be cancelled
        std::vector<std::pair<int, PartState>> parts;
        Severity worst = Severity::Info;
    } steps;

    test::EventLoop loop;
    VirtualCanBus bus;
    VirtualCanLink host;
    VirtualCanLink other;
    std::unique_ptr<Simulator> drive;
    std::unique_ptr<Device> device;
    QTemporaryDir folder;

private:
    QByteArray m_path;
};

TEST_F(AbstractDcUpdate, IsDoneWhenTheProgrammerVerifiedAndTheDriveAnswers)
{
    standIn("echo \"$@\" > '" + folder.path().toStdString() + "/called'\n" + replay(success, 0));
    std::vector<std::string> sent;
    const Subscription tap = host.traffic().add([&sent](const Traffic &traffic) {
        if (traffic.direction == Direction::Sent)
            sent.push_back(toText(*traffic.can));
    });
    const auto report = update(by("openocd:stlink"));
    ASSERT_FALSE(sent.empty());
    EXPECT_NE(std::find(sent.begin(), sent.end(), "067#0000000000"), sent.end()) << "the motor is stopped before";
    ASSERT_TRUE(report) << report.error().text();
    EXPECT_EQ(report->outcome, UpdateOutcome::Done);
    EXPECT_TRUE(report->verified);
    EXPECT_EQ(report->to, "");
    EXPECT_EQ(report->pages, 1);
    EXPECT_EQ(steps.written, (std::vector{std::pair{1, 0}})) << "whatever ends it then";
    for (const char *step : {"Connecting through OpenOCD", "Writing flash", "Verifying flash", "Looking for the drive"})
        EXPECT_NE(std::find(steps.said.begin(), steps.said.end(), step), steps.said.end()) << step;
    QFile called(folder.path() + "/called");
    ASSERT_TRUE(called.open(QIODevice::ReadOnly));
    EXPECT_TRUE(called.readAll().contains("target/stm32f1x.cfg"));
}

TEST_F(AbstractDcUpdate, ThePagesWaitAreWrittenAndAreDoneWhenTheyAreVerified)
{
    standIn(replay(success, 0));
    ASSERT_TRUE(update(by("openocd:stlink")));
    const std::vector<std::pair<int, PartState>> expected{
        {0, PartState::Waiting}, {0, PartState::Active}, {0, PartState::Done}};
    EXPECT_EQ(steps.parts, expected);
}

TEST_F(AbstractDcUpdate, AProgrammerThatSaysNothingIsToldAsConnecting)
{
    standIn("exec sleep 60\n");
    const FirmwareImage image = imageOf(program());
    auto task = abstractdc::update(*device, image, by("openocd:stlink"), steps);
    task.start();
    EXPECT_TRUE(
        loop.runUntil([&] { return !steps.said.empty() && steps.said.back() == "Connecting through OpenOCD"; }));
}

TEST_F(AbstractDcUpdate, ErasingTheSettingsIsWarnedOfAndForgetsWhatWasAssumed)
{
    EXPECT_TRUE(family.routes.front().erasesSettings) << "as users are offered";
    standIn(replay("erased address 0x0800c800 (length 3072) in 0.124s\n" + std::string(success), 0));
    const auto report = update(by("openocd:stlink", true));
    ASSERT_TRUE(report) << report.error().text();
    EXPECT_EQ(steps.worst, Severity::Caution);
    const auto divisor = *findParameter(family.parameters, "velocity.divisor");
    EXPECT_EQ(device->parameters().entry(divisor).raw, 0) << "blank flash";
    EXPECT_EQ(device->parameters().entry(*findParameter(family.parameters, "current.averaging")).raw, 1);
    EXPECT_EQ(device->knowledge().profile().counters.at("saves.velocity"), 0);
}

TEST_F(AbstractDcUpdate, SettingsThatWereErasedBeforeItFailedAreForgottenAllTheSame)
{
    standIn(replay("erased address 0x0800c800 (length 3072) in 0.124s\n** Programming Started **\nError: failed", 1));
    const auto report = update(by("openocd:stlink", true));
    ASSERT_FALSE(report);
    const auto divisor = *findParameter(family.parameters, "velocity.divisor");
    EXPECT_EQ(device->parameters().entry(divisor).raw, 0) << "blank flash";
    EXPECT_NE(report.error().text().find("half a program"), std::string::npos) << report.error().text();
}

TEST_F(AbstractDcUpdate, WhileItsSettingsAreErasedItIsNotToBeCancelledAndTheyAreDoubted)
{
    const auto divisor = *findParameter(family.parameters, "velocity.divisor");
    device->knowledge().assume(divisor, 1000);
    standIn("echo '** Erasing Settings **' >&2\nexec sleep 60\n"); // an F4 takes a whole sector with them
    drive->setPowered(false);                                      // its processor is halted
    const FirmwareImage image = imageOf(program());
    auto task = abstractdc::update(*device, image, by("openocd:stlink", true), steps);
    task.start();
    EXPECT_TRUE(
        loop.runUntil([&] { return !steps.said.empty() && steps.said.back() == "Erasing the stored settings"; }, 5s));
    EXPECT_FALSE(steps.interruptible);
    EXPECT_TRUE(loop.runUntil([&] { return !device->parameters().entry(divisor).raw; }, 5s));
    task.cancel();
}

TEST_F(AbstractDcUpdate, AProbeOnAnotherDriveIsFoundOutByTheOneThatAnswersMeanwhile)
{
    const auto gain = *findParameter(family.parameters, "velocity.p");
    device->knowledge().assume(gain, 7);
    const std::string text = success;
    const auto middle = text.find("Info : device id");
    standIn("echo '** Erasing Settings **' >&2\nsleep 1\necho 'erased address 0x0800c800 (length 3072) in 0.124s' >&2\n"
            "cat >&2 <<'END'\n"
        + text.substr(0, middle) + "END\nsleep 0.5\n" + replay(text.substr(middle), 0));
    const auto report = update(by("openocd:stlink", true));
    ASSERT_FALSE(report);
    EXPECT_EQ(report.error().fault, Fault::BadCheck);
    EXPECT_NE(report.error().text().find("another unit"), std::string::npos) << report.error().text();
    EXPECT_EQ(device->parameters().entry(gain).raw, 7) << "that of the other one was replaced";
}

TEST_F(AbstractDcUpdate, ADriveThatAnswersWhileAnotherIsErasedKeepsItsSettingsThoughThatFails)
{
    const auto gain = *findParameter(family.parameters, "velocity.p");
    device->knowledge().assume(gain, 7);
    standIn("echo '** Erasing Settings **' >&2\nsleep 1\n"
        + replay("erased address 0x0800c800 (length 3072) in 0.124s\n** Programming Started **\nError: failed", 1));
    ASSERT_FALSE(update(by("openocd:stlink", true)));
    EXPECT_EQ(device->parameters().entry(gain).raw, 7) << "that of the other one was erased";
}

TEST_F(AbstractDcUpdate, ADriveThatIsSilentWhileItIsWrittenAndAnswersThenIsDone)
{
    const std::string text = success;
    const auto middle = text.find("Info : device id");
    standIn("cat >&2 <<'END'\n" + text.substr(0, middle) + "END\nsleep 0.5\n" + replay(text.substr(middle), 0));
    steps.onStep = [this](const std::string &step) {
        if (step == "Writing flash" || step == "Restarting the drive")
            drive->setPowered(step == "Restarting the drive");
    };
    const auto report = update(by("openocd:stlink"));
    ASSERT_TRUE(report) << report.error().text();
    EXPECT_TRUE(report->verified);
}

TEST_F(AbstractDcUpdate, ADriveThatWasMuteBeforeIsDoneAndKnownAgainByItsAnswer)
{
    Identity mute = identityOf(3, nullptr);
    mute.state = DeviceState::Bootloader;
    device = family.open(host, loop.clock(), mute);
    drive->setPowered(false);
    standIn(replay(success, 0));
    steps.onStep = [this](const std::string &step) {
        if (step == "Restarting the drive")
            drive->setPowered(true);
    };
    const auto report = update(by("openocd:stlink"));
    ASSERT_TRUE(report) << report.error().text();
    EXPECT_EQ(report->outcome, UpdateOutcome::Done);
    EXPECT_TRUE(report->verified);
    EXPECT_EQ(device->identity(), identityOf(3, &dialectF)) << "and not half a program any more";
}

TEST_F(AbstractDcUpdate, AVerifyThatFailsIsAFailureWhateverTheExitStatus)
{
    standIn(
        replay("** Programming Started **\n** Programming Finished **\n** Verify Started **\n** Verify Failed **", 0));
    const auto report = update(by("openocd:stlink"));
    ASSERT_FALSE(report);
    EXPECT_EQ(report.error().fault, Fault::BadCheck);
}

TEST_F(AbstractDcUpdate, WithoutAnAnswerItIsNotDone)
{
    standIn(replay(success, 0));
    drive->setPowered(false);
    const auto report = update(by("openocd:stlink"));
    ASSERT_TRUE(report);
    EXPECT_EQ(report->outcome, UpdateOutcome::Failed);
    EXPECT_FALSE(report->verified);
    EXPECT_NE(report->summary().english().find("nothing answers"), std::string::npos);
}

TEST_F(AbstractDcUpdate, ADryRunStartsNothing)
{
    standIn("touch '" + folder.path().toStdString() + "/ran'\n");
    UpdateOptions options = by("openocd:stlink");
    options.dryRun = true;
    const auto report = update(options);
    ASSERT_TRUE(report);
    EXPECT_EQ(report->outcome, UpdateOutcome::Done);
    EXPECT_FALSE(report->verified);
    EXPECT_FALSE(QFile::exists(folder.path() + "/ran"));
}

TEST_F(AbstractDcUpdate, RefusesToEraseTheSettingsThatItsImageWrites)
{
    standIn("touch '" + folder.path().toStdString() + "/ran'\n" + replay(success, 0));
    auto hex = program();
    hex.add(0x0800C800, {1});
    const auto refused = update(by("openocd:stlink", true), imageOf(hex));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().fault, Fault::OutOfRange);
    EXPECT_FALSE(QFile::exists(folder.path() + "/ran"));
    EXPECT_TRUE(update(by("openocd:stlink"), imageOf(hex)));
}

TEST_F(AbstractDcUpdate, AMissingProgramIsOneLineThatSaysWhatToInstall)
{
    qputenv("PATH", folder.path().toUtf8());
    const auto report = update(by("openocd:stlink"));
    ASSERT_FALSE(report);
    EXPECT_EQ(report.error().fault, Fault::LinkLost);
    EXPECT_EQ(report.error().text(), "openocd is not installed; install it with: sudo apt install openocd");
}

TEST_F(AbstractDcUpdate, CancellingEndsTheProgrammer)
{
    standIn("echo $$ > '" + folder.path().toStdString() + "/pid'\necho '** Programming Started **'\nexec sleep 60\n");
    const FirmwareImage image = imageOf(program());
    auto task = abstractdc::update(*device, image, by("openocd:stlink"), steps);
    task.start();
    ASSERT_TRUE(loop.runUntil([&] { return !steps.said.empty() && steps.said.back() == "Writing flash"; }));
    QFile file(folder.path() + "/pid");
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const int pid = file.readAll().trimmed().toInt();
    ASSERT_EQ(::kill(pid, 0), 0);
    task.cancel();
    EXPECT_NE(::kill(pid, 0), 0);
}

TEST_F(AbstractDcUpdate, SettingsThatWereErasedBeforeItWasCancelledAreForgottenAllTheSame)
{
    const auto divisor = *findParameter(family.parameters, "velocity.divisor");
    device->knowledge().assume(divisor, 1000);
    standIn("echo 'erased address 0x0800c800 (length 3072) in 0.124s' >&2\necho '** Programming Started **' "
            ">&2\nexec sleep 60\n");
    const FirmwareImage image = imageOf(program());
    auto task = abstractdc::update(*device, image, by("openocd:stlink", true), steps);
    task.start();
    ASSERT_TRUE(loop.runUntil([&] { return !steps.said.empty() && steps.said.back() == "Writing flash"; }));
    EXPECT_FALSE(steps.interruptible) << "half a program may be in its flash";
    task.cancel();
    EXPECT_EQ(device->parameters().entry(divisor).raw, 0) << "blank flash";
}

TEST_F(AbstractDcUpdate, AnImageThatWritesTheSettingsPagesOrTheirSectorLeavesThemUnknown)
{
    struct Case {
        std::uint32_t address;
        const char *target;
        bool takes;
    };
    const auto gain = *findParameter(family.parameters, "velocity.p");
    for (const Case &c : {Case{0x0800C800, "f1", true}, Case{0x0800C000, "f1", false}, Case{0x0800C000, "f4", true},
             Case{0x0800FFFC, "f4", true}, Case{0x08010000, "f4", false}}) {
        device->knowledge().assume(gain, 1);
        standIn(replay(success, 0));
        auto hex = program();
        hex.add(c.address, {1, 2, 3, 4});
        UpdateOptions options = by("openocd:stlink");
        options.target = c.target;
        ASSERT_TRUE(update(options, imageOf(hex)));
        EXPECT_EQ(device->parameters().entry(gain).raw.has_value(), !c.takes) << c.target << ' ' << c.address;
        EXPECT_EQ(device->knowledge().profile().lost.contains("velocity.p"), c.takes);
        EXPECT_TRUE(steps.interruptible) << "it is over";
    }
}

TEST_F(AbstractDcUpdate, TheRealOpenOcdWithoutAProbeIsOneClearLine)
{
    ASSERT_TRUE(ExternalProgram::locate("openocd")) << "install the package openocd: scripts/install-packages test";
    for (const char *via : {"openocd:kitprog", "openocd:xds110"}) {
        const auto report = update(by(via));
        ASSERT_FALSE(report) << via;
        EXPECT_EQ(report.error().fault, Fault::LinkLost) << report.error().text();
        EXPECT_NE(report.error().text().find("no debug probe"), std::string::npos) << report.error().text();
    }
    const auto unknown = update(by("openocd:no-such-thing"));
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.error().fault, Fault::OutOfRange) << unknown.error().text();
    const auto jtag = update(by("openocd:ulink"));
    ASSERT_FALSE(jtag);
    EXPECT_EQ(jtag.error().fault, Fault::OutOfRange) << jtag.error().text();
}

} // namespace
} // namespace mb::abstractdc
