// SPDX-License-Identifier: GPL-3.0-or-later
// Firmware through avrdude: a stand-in that prints what version 7.1 of Debian 12 prints, and the real one for what it says
// without a programmer.
#include "supermodifiedupdatebench.h"

#include "families/supermodified/line.h"
#include "firmware/intelhex.h"

#include <algorithm>
#include <numeric>

namespace mb::supermodified {
namespace {

using avrdude::Reading;
using avrdude::Stage;

/// A program of these bytes from an address below 64 KiB on.
FirmwareImage programOf(std::uint16_t address, const std::vector<std::uint8_t> &bytes)
{
    std::vector<std::uint8_t> record{static_cast<std::uint8_t>(bytes.size()), static_cast<std::uint8_t>(address >> 8U),
        static_cast<std::uint8_t>(address & 0xFFU), 0};
    record.insert(record.end(), bytes.begin(), bytes.end());
    record.push_back(static_cast<std::uint8_t>(-std::accumulate(record.begin(), record.end(), 0)));
    QByteArray hex(reinterpret_cast<const char *>(record.data()), static_cast<int>(record.size()));
    return image(
        ":" + hex.toHex().toUpper().toStdString() + "\n" + std::string(address == 0 ? ":00000001FF\n" : imageText));
}

TEST(SupermodifiedAvrdude, TakesAProgrammerAndAPort)
{
    const auto job = avrdude::jobOf("avrdude:arduino:/dev/serial/by-id/usb-FTDI:0");
    ASSERT_TRUE(job);
    EXPECT_EQ(job->programmer, "arduino");
    EXPECT_EQ(job->port, "/dev/serial/by-id/usb-FTDI:0");
    EXPECT_TRUE(job->isBootloader());
    EXPECT_TRUE(avrdude::jobOf("avrdude:x:usb")) << "a name of one letter";
    for (const std::string_view bad : {"", "avrdude", "avrdude:", "avrdude:usbasp", "avrdude:usbasp:", "openocd:stlink",
             "avrdude:-x:usb", "avrdude:a b:usb", "avrdude:usbasp:-U", "avrdude::usb", "avrdude:usbasp;:usb"}) {
        EXPECT_EQ(avrdude::jobOf(bad).error().fault, Fault::OutOfRange) << bad;
    }
}

TEST(SupermodifiedAvrdude, OnlyEverWritesFlash)
{
    for (const std::string_view via : {"avrdude:arduino:/dev/ttyUSB0", "avrdude:usbasp:usb"}) {
        auto job = *avrdude::jobOf(via);
        job.file = "/some/a.hex";
        job.rate = job.isBootloader() ? 57600 : 0;
        const auto command = avrdude::commandOf(job);
        EXPECT_EQ(command.program, "avrdude");
        EXPECT_EQ(std::count(command.arguments.begin(), command.arguments.end(), "-U"), 1);
        EXPECT_EQ(command.arguments.back(), "flash:w:/some/a.hex:i");
        EXPECT_EQ(std::count(command.arguments.begin(), command.arguments.end(), "-V"), 0) << "it verifies";
        EXPECT_EQ(std::count(command.arguments.begin(), command.arguments.end(), "-D"), job.isBootloader() ? 1 : 0);
        EXPECT_EQ(std::count(command.arguments.begin(), command.arguments.end(), "-b"), job.isBootloader() ? 1 : 0);
        for (const std::string &argument : command.arguments)
            EXPECT_EQ(argument.find("fuse"), std::string::npos);
    }
}

TEST(SupermodifiedAvrdude, ReadsProgressAndProof)
{
    Reading reading;
    reading.take("avrdude: AVR device initialized and ready to accept instructions", true);
    reading.take("Reading | ################################################## | 100% 0.00s", true);
    EXPECT_EQ(reading.stage(), Stage::Connecting);
    EXPECT_FALSE(reading.hasBegun());
    reading.take("Writing | ##########", false);
    EXPECT_EQ(reading.stage(), Stage::Writing);
    EXPECT_EQ(reading.percent(), 20);
    reading.take("Writing | " + std::string(50, '#'), false);
    EXPECT_EQ(reading.percent(), 100);
    reading.take("Writing | " + std::string(51, '#'), false);
    EXPECT_EQ(reading.percent(), 100);
    reading.take("avrdude: 768 bytes of flash written", true);
    EXPECT_EQ(reading.stage(), Stage::Verifying);
    EXPECT_EQ(reading.percent(), 0);
    reading.take("Reading | #########################", false);
    EXPECT_EQ(reading.percent(), 50);
    EXPECT_FALSE(reading.isVerified());
    reading.take("avrdude: 768 bytes of flash verified", true);
    EXPECT_TRUE(reading.isVerified());
}

TEST(SupermodifiedAvrdude, NamesCauseAndRemedyOfWhatItSays)
{
    struct Row {
        std::string_view line;
        Fault fault;
    };
    const auto job = *avrdude::jobOf("avrdude:arduino:/dev/ttyUSB0");
    for (const Row &row : {Row{"avrdude error: cannot find programmer id nosuch", Fault::OutOfRange},
             Row{"avrdude OS error: cannot open port /dev/x: Permission denied", Fault::LinkLost},
             Row{"avrdude OS error: cannot open port /dev/x: No such file or directory", Fault::LinkLost},
             Row{"avrdude error: cannot find USB device with vid=0x16c0 pid=0x5dc", Fault::LinkLost},
             Row{"avrdude warning: attempt 10 of 10: not in sync: resp=0x00", Fault::Timeout},
             Row{"avrdude error: verification mismatch", Fault::BadCheck},
             Row{"avrdude: expected signature for ATmega328P is 1E 95 0F", Fault::Refused},
             Row{"avrdude error: something new", Fault::BadReply}}) {
        Reading reading;
        reading.take(row.line, true);
        const Error error = reading.failure(job);
        EXPECT_EQ(error.fault, row.fault) << row.line;
        EXPECT_NE(error.text().find_first_of(";'"), std::string::npos) << error.text();
    }
}

TEST(SupermodifiedAvrdude, FindsTheCauseBehindAPageOfOtherWords)
{
    Reading reading;
    for (int i = 0; i < 40; ++i)
        reading.take("avrdude: reading configuration file /etc/avrdude.conf", true);
    reading.take("avrdude error: verification mismatch", true);
    EXPECT_EQ(reading.failure(*avrdude::jobOf("avrdude:usbasp:usb")).fault, Fault::BadCheck);
}

TEST(SupermodifiedFirmware, TakesProgramsOfAnAvrOnly)
{
    const auto summary = inspect(image());
    ASSERT_TRUE(summary) << summary.error().text();
    EXPECT_EQ(summary->parts, std::vector<int>{0});
    EXPECT_EQ(inspect(image(":060000000C942000FFCF6C\n:01007F00017F\n:00000001FF\n"))->parts, (std::vector<int>{0}));
    EXPECT_EQ(inspect(image(":060000000C942000FFCF6C\n:0101000000FE\n:00000001FF\n"))->parts, (std::vector<int>{0, 2}));
    EXPECT_EQ(inspect(image(":060000000C942000FFCF6C\n:0100800001"
                            "7E\n:00000001FF\n"))
                  ->parts,
        (std::vector<int>{0, 1}));
    EXPECT_FALSE(inspect(image(":0400000000020400F6\n:00000001FF\n"))) << "vectors of a Cortex";
    EXPECT_FALSE(inspect(image(":028000000C94DE\n:00000001FF\n"))) << "beyond 32 KiB";
    EXPECT_EQ(image(toIntelHex(image())).byteCount(), image().byteCount());
}

TEST(SupermodifiedFirmware, BeginsWithAJumpLongOrShort)
{
    for (const std::vector<std::uint8_t> &jump :
        {std::vector<std::uint8_t>{0x0C, 0x94}, {0x0D, 0x94}, {0x00, 0xC0}, {0xFF, 0xCF}})
        EXPECT_TRUE(inspect(programOf(0, jump))) << int{jump[0]} << ' ' << int{jump[1]};
    for (const std::vector<std::uint8_t> &other :
        {std::vector<std::uint8_t>{0x0C, 0x95}, {0x0E, 0x94}, {0x00, 0xD0}, {0x94, 0x0C}, {0x0C}})
        EXPECT_FALSE(inspect(programOf(0, other))) << int{other[0]};
    EXPECT_FALSE(inspect(image(":01000100C03E\n:00000001FF\n"))) << "half a jump";
}

TEST(SupermodifiedFirmware, EndsWithTheFlash)
{
    EXPECT_EQ(inspect(programOf(0x7FFF, {0}))->parts, (std::vector<int>{0, 255}));
    EXPECT_FALSE(inspect(programOf(0x8000, {0})));
    for (const auto &[address, isBootloader] : {std::pair{0x77FF, false}, {0x7800, true}, {0x7FFF, true}})
        EXPECT_EQ(inspect(programOf(static_cast<std::uint16_t>(address), {0}))->notes.size(), isBootloader ? 4U : 3U)
            << address << ": whether it says that it needs a programmer on the pins";
}

TEST(SupermodifiedUpdate, IsDoneWhenAvrdudeVerifiedAndTheNodeAnswersAgain)
{
    SupermodifiedUpdateBench bench;
    bench.standIn(supermodifiedSuccess);
    const auto report = bench.update("avrdude:usbasp:usb");
    ASSERT_TRUE(report) << report.error().text();
    EXPECT_EQ(report->outcome, UpdateOutcome::Done);
    EXPECT_TRUE(report->verified);
    EXPECT_TRUE(report->to.empty()) << "the wire carries no version";
    EXPECT_EQ(report->pages, 1);
    EXPECT_NE(report->summary().english().find("answers again"), std::string::npos) << report->evidence;
    EXPECT_EQ(bench.calls().count('\n'), 1);
    EXPECT_GT(bench.log.size(), 4U);
}

TEST(SupermodifiedUpdate, ANodeThatWasMuteBeforeIsDoneAndKnownAgainByItsAnswer)
{
    SupermodifiedUpdateBench bench;
    Identity mute = bench.device->identity();
    mute.dialect.clear();
    mute.descriptors = {{"baud", "38400"}}; // as it was left when nobody answered at any rate
    mute.state = DeviceState::Bootloader;
    bench.device->setIdentity(mute);
    bench.cut();
    bench.standIn(supermodifiedSuccess);
    const auto report = bench.update("avrdude:usbasp:usb", [&bench](const Operation &operation) {
        if (operation.status().step.english() == "Looking for the controller")
            bench.power(true);
    });
    ASSERT_TRUE(report) << report.error().text();
    EXPECT_EQ(report->outcome, UpdateOutcome::Done) << report->evidence;
    EXPECT_EQ(bench.device->identity().state, DeviceState::Online);
    EXPECT_EQ(bench.device->identity().dialect, "D1");
}

TEST(SupermodifiedUpdate, NothingButAGoodEndThatWasVerifiedCounts)
{
    for (const QByteArray &script :
        {QByteArray("exit 0\n"), QByteArray("echo 'avrdude: 6 bytes of flash written' >&2\n"),
            QByteArray(supermodifiedSuccess) + "exit 1\n"}) {
        SupermodifiedUpdateBench bench;
        bench.standIn(script);
        const auto report = bench.update("avrdude:usbasp:usb");
        EXPECT_FALSE(report && report->outcome == UpdateOutcome::Done) << script.toStdString();
        EXPECT_FALSE(report && report->verified) << script.toStdString();
    }
}

TEST(SupermodifiedUpdate, IsNotDoneWhenTheNodeStaysSilent)
{
    SupermodifiedUpdateBench bench;
    bench.standIn(supermodifiedSuccess);
    bench.cut();
    const auto report = bench.update("avrdude:usbasp:usb");
    ASSERT_TRUE(report);
    EXPECT_EQ(report->outcome, UpdateOutcome::Failed);
    EXPECT_FALSE(report->verified);
    EXPECT_NE(report->summary().english().find("does not answer"), std::string::npos);
}

TEST(SupermodifiedUpdate, AsksTheBootloaderAtBothOfItsRates)
{
    SupermodifiedUpdateBench bench;
    bench.standIn("case \"$*\" in *59524*) ;; *) echo 'avrdude warning: attempt 10 of 10: not in sync: resp=0x00' >&2; "
                  "exit 1;; esac\n"
        + QByteArray(supermodifiedSuccess));
    const auto report = bench.update("avrdude:arduino:/dev/ttyUSB7");
    ASSERT_TRUE(report) << report.error().text();
    EXPECT_EQ(report->outcome, UpdateOutcome::Done);
    EXPECT_EQ(bench.calls().count('\n'), 2);
    EXPECT_TRUE(bench.calls().contains("-b 57600 -D -U flash:w:"));
}

TEST(SupermodifiedUpdate, AProgrammerThatHasAnotherNodeIsFoundOutByTheOneThatAnswersMeanwhile)
{
    for (const std::string programmer : {"usbasp:usb", "arduino:/dev/ttyUSB7"}) {
        SupermodifiedUpdateBench bench;
        bench.halts = false;
        bench.standIn("echo 'Writing | ####' >&2; sleep 1\n" + QByteArray(supermodifiedSuccess));
        const auto report = bench.update("avrdude:" + programmer);
        ASSERT_FALSE(report) << programmer;
        EXPECT_EQ(report.error().fault, Fault::BadCheck);
        EXPECT_NE(report.error().text().find("another unit"), std::string::npos) << report.error().text();
    }
}

TEST(SupermodifiedUpdate, WhatItsMemoryHeldIsUnknownOnceAvrdudeHasBegunHoweverItEnds)
{
    for (const auto &[script, isKept] :
        {std::pair{QByteArray("echo 'avrdude: programmer is not responding' >&2; exit 1\n"), true},
            {QByteArray("echo 'Writing | ####' >&2; exit 1\n"), false}, {QByteArray(supermodifiedSuccess), false}}) {
        SupermodifiedUpdateBench bench;
        const auto gain = *findParameter(bench.device->family().parameters, "gain.p");
        bench.device->parameters().setRead(gain, 900);
        bench.standIn(script);
        (void)bench.update("avrdude:arduino:/dev/ttyUSB7");
        EXPECT_EQ(bench.device->parameters().entry(gain).raw.has_value(), isKept) << script.toStdString();
    }
}

TEST(SupermodifiedUpdate, AFailureInTheMiddleSaysWhatTheUnitIsWorth)
{
    SupermodifiedUpdateBench bench;
    bench.standIn("echo 'Writing | ####' >&2; echo 'avrdude error: verification mismatch' >&2; exit 1\n");
    const auto report = bench.update("avrdude:arduino:/dev/ttyUSB7");
    ASSERT_FALSE(report);
    EXPECT_EQ(report.error().fault, Fault::BadCheck);
    EXPECT_NE(report.error().text().find("half a program"), std::string::npos) << report.error().text();
    EXPECT_EQ(bench.calls().count('\n'), 1) << "not tried again at another rate";
}

TEST(SupermodifiedUpdate, MayBeCancelledBeforeItWritesAndNotWhileItDoes)
{
    SupermodifiedUpdateBench bench;
    bench.standIn("echo 'avrdude: waiting' >&2; sleep 20\n");
    bool asked = false;
    const auto cancelled = bench.update("avrdude:usbasp:usb", [&](Operation &operation) {
        if (!operation.status().log.empty() && !asked) {
            asked = true;
            EXPECT_TRUE(operation.cancel());
        }
    });
    ASSERT_FALSE(cancelled);
    EXPECT_EQ(cancelled.error().fault, Fault::Cancelled);
    SupermodifiedUpdateBench writing;
    writing.standIn("echo 'Writing | ####' >&2; sleep 0.3\n" + QByteArray(supermodifiedSuccess));
    bool refused = false;
    const auto done = writing.update("avrdude:usbasp:usb", [&](Operation &operation) {
        if (!operation.status().mayInterrupt && !refused) {
            refused = true;
            EXPECT_FALSE(operation.cancel());
        }
    });
    EXPECT_TRUE(refused);
    EXPECT_TRUE(done);
    EXPECT_TRUE(writing.interruptible) << "when it was over";
}

TEST(SupermodifiedUpdate, RefusesBeforeAnythingRuns)
{
    SupermodifiedUpdateBench bench;
    bench.standIn(supermodifiedSuccess);
    EXPECT_EQ(bench.update("").error().fault, Fault::OutOfRange);
    EXPECT_EQ(bench.update("openocd:stlink").error().fault, Fault::OutOfRange);
    bench.options.target = "master";
    EXPECT_EQ(bench.update("avrdude:usbasp:usb").error().fault, Fault::OutOfRange);
    EXPECT_TRUE(bench.calls().isEmpty());
}

TEST(SupermodifiedUpdate, LeavesABootloaderToAProgrammerOnThePins)
{
    SupermodifiedUpdateBench bench;
    bench.standIn(supermodifiedSuccess);
    for (const std::uint16_t address : {std::uint16_t{0x7800}, std::uint16_t{0x7FFF}}) {
        bench.written = programOf(address, {0});
        const auto refused = bench.update("avrdude:arduino:/dev/ttyUSB7");
        ASSERT_FALSE(refused) << address;
        EXPECT_NE(refused.error().text().find("bootloader"), std::string::npos) << refused.error().text();
    }
    EXPECT_TRUE(bench.calls().isEmpty());
    EXPECT_TRUE(bench.update("avrdude:usbasp:usb"));
    bench.written = programOf(0x77FF, {0});
    EXPECT_TRUE(bench.update("avrdude:arduino:/dev/ttyUSB7"));
}

TEST(SupermodifiedUpdate, RefusesWhileAMotorOnItsLineIsDriven)
{
    SupermodifiedUpdateBench bench;
    bench.standIn(supermodifiedSuccess);
    Line::of(bench.host, bench.loop.clock())->driven().set(5, true);
    const auto refused = bench.update("avrdude:usbasp:usb");
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().fault, Fault::Unsafe);
    EXPECT_TRUE(bench.calls().isEmpty());
}

TEST(SupermodifiedUpdate, ADryRunSaysHowManyPagesAndWritesNone)
{
    SupermodifiedUpdateBench bench;
    bench.standIn(supermodifiedSuccess);
    bench.options.dryRun = true;
    const auto report = bench.update("avrdude:usbasp:usb");
    ASSERT_TRUE(report);
    EXPECT_FALSE(report->verified);
    EXPECT_NE(report->evidence.english().find("1 pages"), std::string::npos) << report->evidence;
    EXPECT_TRUE(bench.calls().isEmpty());
}

TEST(SupermodifiedUpdate, OnlyASilentBootloaderIsAskedAtTheOtherRate)
{
    for (const QByteArray &script :
        {QByteArray("echo 'avrdude OS error: cannot open port /dev/x: Permission denied' >&2; exit 1\n"),
            QByteArray("echo 'Writing | ####' >&2; echo 'avrdude: programmer is not responding' >&2; exit 1\n")}) {
        SupermodifiedUpdateBench bench;
        bench.standIn(script);
        EXPECT_FALSE(bench.update("avrdude:arduino:/dev/ttyUSB7"));
        EXPECT_EQ(bench.calls().count('\n'), 1) << script.toStdString();
    }
    SupermodifiedUpdateBench silent;
    silent.standIn("echo 'avrdude: programmer is not responding' >&2; exit 1\n");
    EXPECT_FALSE(silent.update("avrdude:arduino:/dev/ttyUSB7"));
    EXPECT_EQ(silent.calls().count('\n'), 2);
}

TEST(SupermodifiedUpdate, TheRealAvrdudeIsUnderstood)
{
    if (!ExternalProgram::locate("avrdude"))
        GTEST_SKIP() << "avrdude is not installed";
    SupermodifiedUpdateBench bench;
    const auto unknown = bench.update("avrdude:nosuchprogrammer:usb");
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.error().fault, Fault::OutOfRange) << unknown.error().text();
    for (const Programmer &listed : bench.device->family().routes.front().programmers) {
        const auto result = bench.update("avrdude:" + std::string(listed.name)
            + (listed.port == Programmer::Port::Usb ? ":usb" : ":/dev/ttyNOSUCH9"));
        ASSERT_FALSE(result);
        EXPECT_NE(result.error().fault, Fault::OutOfRange) << listed.name << ": " << result.error().text();
    }
    const auto absent = bench.update("avrdude:arduino:/dev/ttyNOSUCH9");
    ASSERT_FALSE(absent);
    EXPECT_EQ(absent.error().fault, Fault::LinkLost) << absent.error().text();
    const auto unplugged = bench.update("avrdude:usbasp:usb");
    ASSERT_FALSE(unplugged);
    EXPECT_EQ(unplugged.error().fault, Fault::LinkLost) << unplugged.error().text();
}

} // namespace
} // namespace mb::supermodified
