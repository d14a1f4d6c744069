// SPDX-License-Identifier: GPL-3.0-or-later
// The update over the bootloader's serial line, on virtual time: steps for hands, settings for what nobody knows, failures.
#include "families/quadquad2drvupdatebench.h"

namespace mb::quadquad2drv {
namespace {

TEST(QuadQuad2DrvUpdate, GoesThroughEveryStepAndComparesTheVersion)
{
    QuadQuad2DrvUpdateBench bench;
    bench.hand = [&bench] { // closes the jumper when asked, takes it out when asked
        const std::string &step = bench.operation.status().step.english();
        if (step.starts_with("close the jumper"))
            bench.boot->setJumper(true);
        if (step.starts_with("take the jumper out"))
            bench.boot->setJumper(false);
    };
    bench.boot->setJumper(true);
    const UpdateReport report = bench.update();
    EXPECT_EQ(report.outcome, UpdateOutcome::Done) << report.evidence;
    EXPECT_EQ(report.from, "1.3");
    EXPECT_EQ(report.to, "1.4");
    for (int step = 0; step < static_cast<int>(routes().front().steps.size()); ++step)
        EXPECT_EQ(bench.step(step), PartState::Done) << step;
    EXPECT_TRUE(bench.said("> :0400000001020304F2"));
    EXPECT_TRUE(bench.said("< ok"));
}

TEST(QuadQuad2DrvUpdate, TheSameVersionAsBeforeProvesNothing)
{
    QuadQuad2DrvUpdateBench bench;
    bench.boot->setJumper(true);
    bench.hand = [&bench] {
        const std::string &step = bench.operation.status().step.english();
        if (step.starts_with("sending"))
            bench.board->setVersion({1, 2, 1}); // so that what the simulator counts up is what was there before
        if (step.starts_with("take the jumper out"))
            bench.boot->setJumper(false);
    };
    const UpdateReport report = bench.update();
    EXPECT_EQ(report.outcome, UpdateOutcome::Done) << report.evidence;
    EXPECT_EQ(report.to, "1.3");
    EXPECT_FALSE(report.verified);
    EXPECT_NE(report.summary().english().find("nothing proves"), std::string::npos) << report.evidence;
}

TEST(QuadQuad2DrvUpdate, WaitsForTheGreetingAndSaysWhatToLookAtWhenNoneComes)
{
    QuadQuad2DrvUpdateBench bench;
    const Instant begin = bench.clock.now();
    const UpdateReport report = bench.update();
    EXPECT_EQ(report.outcome, UpdateOutcome::Failed);
    EXPECT_NE(report.summary().english().find("check the jumper"), std::string::npos);
    EXPECT_GE(bench.clock.now() - begin, 30s);
    EXPECT_EQ(bench.step(0), PartState::Active) << "it never got further than the hands";
    EXPECT_EQ(bench.step(3), PartState::Waiting);
}

TEST(QuadQuad2DrvUpdate, AJumperThatWasLeftInIsToldAndTheUpdateEndsOnceItIsOut)
{
    QuadQuad2DrvUpdateBench bench;
    bench.boot->setJumper(true);
    BootSettings settings;
    settings.farewell = {}; // only jumper and reset leave this bootloader
    bool told = false;
    Instant since{};
    bench.hand = [&] {
        const std::string &step = bench.operation.status().step.english();
        if (!told && step.starts_with("the jumper is still in")) {
            told = true;
            since = bench.clock.now();
        }
        if (told && bench.clock.now() - since > 3s)
            bench.boot->setJumper(false);
    };
    const UpdateReport report = bench.update(settings);
    EXPECT_TRUE(told);
    EXPECT_EQ(report.outcome, UpdateOutcome::Done) << report.evidence;
    EXPECT_EQ(report.to, "1.4");
    EXPECT_EQ(bench.step(4), PartState::Done);
}

/// In the pause of 50 ms behind each line, and behind the last one.
TEST(QuadQuad2DrvUpdate, ARestartOrARefusalThatComesAfterAConfirmationEndsIt)
{
    struct Case {
        const char *after; ///< sent
        const char *says;
        const char *tells;
    };
    for (const Case &c : {Case{":0400000001020304F2", "QuadQuad bootloader\r\n", "restarted at line 1"},
             Case{":0400000001020304F2", "error: bad line\r\n", "line 1 was refused: error: bad line"},
             Case{":00000001FF", "error: checksum\r\n", "line 3 was refused: error: checksum"}}) {
        QuadQuad2DrvUpdateBench bench;
        bench.boot->setJumper(true);
        bool done = false;
        bench.hand = [&] {
            const auto &log = bench.operation.status().log;
            if (done || log.size() < 2 || log.back().text.english() != "< ok"
                || log[log.size() - 2].text.english() != std::string("> ") + c.after)
                return;
            done = true;
            const std::string text = c.says;
            ASSERT_TRUE(bench.boardEnd.send(std::vector<std::uint8_t>(text.begin(), text.end())));
        };
        const UpdateReport report = bench.update();
        EXPECT_TRUE(done) << c.says;
        EXPECT_EQ(report.outcome, UpdateOutcome::Failed) << c.says;
        EXPECT_NE(report.summary().english().find(c.tells), std::string::npos) << report.summary().english();
    }
}

TEST(QuadQuad2DrvUpdate, ARefusalIsRecognisedByTheWordsThatWereSet)
{
    QuadQuad2DrvUpdateBench bench;
    bench.boot->setJumper(true);
    BootSettings settings;
    settings.failures = {"ok"};
    const UpdateReport report = bench.update(settings);
    EXPECT_EQ(report.outcome, UpdateOutcome::Failed);
    EXPECT_NE(report.summary().english().find("line 1 was refused: ok"), std::string::npos) << report.evidence;
}

TEST(QuadQuad2DrvUpdate, AnEchoedRecordThatSpellsAWordOfFailureIsNoRefusal)
{
    QuadQuad2DrvUpdateBench bench;
    bench.boot->setJumper(true);
    const std::string first = bench.image.lines().front();
    BootSettings settings;
    settings.failures = {first.substr(1, 6), "bad"};
    const Subscription echo = bench.hostEnd.traffic().add([&](const Traffic &traffic) {
        const std::string sent(traffic.bytes.begin(), traffic.bytes.end());
        if (traffic.direction == Direction::Sent && sent.starts_with(first))
            (void)bench.boardEnd.send(std::vector<std::uint8_t>(traffic.bytes.begin(), traffic.bytes.end()));
    });
    bench.hand = [&bench] {
        if (bench.operation.status().step.english().starts_with("take the jumper out"))
            bench.boot->setJumper(false);
    };
    const UpdateReport report = bench.update(settings);
    EXPECT_EQ(report.evidence.english().find("refused"), std::string::npos) << report.evidence;
    EXPECT_TRUE(bench.said("< " + first)) << "it was echoed";
    EXPECT_EQ(report.outcome, UpdateOutcome::Done);
    for (const LogLine &row : bench.operation.status().log)
        EXPECT_TRUE(row.severity != Severity::Danger) << row.text;
}

TEST(QuadQuad2DrvUpdate, ALineThatIsLostWhileItSendsIsToldAsThat)
{
    QuadQuad2DrvUpdateBench bench;
    bench.boot->setJumper(true);
    bench.hand = [&bench] {
        if (bench.operation.status().step.english().starts_with("sending"))
            bench.hostEnd.close();
    };
    const UpdateReport report = bench.update();
    EXPECT_EQ(report.outcome, UpdateOutcome::Failed);
    EXPECT_EQ(report.fault, Fault::LinkLost) << report.evidence;
    EXPECT_EQ(report.evidence.english().find("was not confirmed"), std::string::npos) << report.evidence;
}

TEST(QuadQuad2DrvUpdate, ASecondAnswerToOneLineDoesNotConfirmTheNext)
{
    for (const std::string late : {"ok\r", "o"}) {
        QuadQuad2DrvUpdateBench bench;
        bench.boot->setJumper(true);
        bool gone = false;
        bench.hand = [&] {
            if (gone || !bench.said("< ok"))
                return;
            gone = true;
            bench.boot.reset(); // from here on the test is the bootloader
            (void)bench.boardEnd.send(std::vector<std::uint8_t>(late.begin(), late.end()));
        };
        const UpdateReport report = bench.update();
        EXPECT_TRUE(gone);
        EXPECT_EQ(report.outcome, UpdateOutcome::Failed);
        EXPECT_TRUE(report.evidence.english().starts_with("line 2 was not confirmed")) << report.evidence;
        EXPECT_EQ(report.pages, 1);
    }
}

/// The steps for hands as they begin, and what was told of the lines.
struct StepLog final : Progress {
    void step(const Message &, int, int) override { }
    void part(int number, PartState state) override
    {
        if (state == PartState::Active)
            begun.push_back(number);
    }
    void log(Severity, const Message &text) override { lines += text.english() + '\n'; }
    void replaces(const std::string &version) override { before = version; }
    void accepted(int sent, int again) override { confirmed.emplace_back(sent, again); }
    std::vector<int> begun;
    std::string lines;
    std::string before;
    std::vector<std::pair<int, int>> confirmed;
};

TEST(QuadQuad2DrvUpdate, TellsEveryStepAsItBeginsAndEveryLineAsItIsConfirmed)
{
    QuadQuad2DrvUpdateBench bench;
    bench.boot->setJumper(true);
    BootSettings settings;
    settings.farewell = {};
    StepLog told;
    Updater updater(*bench.device, bench.hostEnd, bench.image, told, settings);
    Task<UpdateReport> task = updater.run(false);
    task.start();
    ASSERT_TRUE(bench.clock.runUntil([&] { return told.confirmed.size() == 3; }, 1min));
    bench.clock.advance(5s);
    bench.boot->setJumper(false);
    ASSERT_TRUE(bench.clock.runUntil([&] { return task.isFinished(); }, 2min));
    EXPECT_EQ(told.begun, (std::vector<int>{0, 1, 2, 3, 4, 5}));
    EXPECT_EQ(told.before, "1.3");
    EXPECT_EQ(told.confirmed, (std::vector<std::pair<int, int>>{{1, 0}, {2, 0}, {3, 0}}));
}

TEST(QuadQuad2DrvUpdate, WhileTheJumperStaysInTheBoardIsResetWithEveryFourthQuestionAndItsGreetingsAreTold)
{
    QuadQuad2DrvUpdateBench bench;
    bench.boot->setJumper(true);
    BootSettings settings;
    settings.farewell = {};
    const UpdateReport report = bench.update(settings);
    EXPECT_EQ(report.outcome, UpdateOutcome::Failed);
    EXPECT_TRUE(report.evidence.english().ends_with("does not answer over SPI")) << report.evidence;
    std::vector<Duration> pulses; // the first before the greeting, the others since the last line was confirmed
    Instant confirmed{};
    int greetings = 0;
    for (const LogLine &row : bench.operation.status().log) {
        const std::string &text = row.text.english();
        if (text == "< ok")
            confirmed = row.time;
        else if (text == "the reset line was pulsed")
            pulses.push_back(row.time - confirmed);
        greetings += confirmed != Instant{} && text == "< QuadQuad2Drv bootloader 1.0" ? 1 : 0;
    }
    constexpr Duration question = 1040ms; // half a second, and no answer
    ASSERT_GT(pulses.size(), 3U);
    EXPECT_GT(pulses[1], 4 * question - 100ms) << "not before there was time to take the jumper out";
    for (std::size_t i = 3; i < pulses.size(); ++i)
        EXPECT_NEAR(std::chrono::duration<double>(pulses[i] - pulses[i - 1]).count(),
            std::chrono::duration<double>(4 * question + resetTime).count(), 0.02)
            << "a board that starts is asked once it can answer";
    EXPECT_GT(greetings, 30) << "more than one a pulse";
}

TEST(QuadQuad2DrvUpdate, GoesOverASerialPortAndNoOtherKindOfLink)
{
    QuadQuad2DrvUpdateBench bench;
    for (const auto &[via, outcome] : {std::pair{"socketcan:can0", UpdateOutcome::Refused},
             {"spidev:/dev/spidev0.0", UpdateOutcome::Refused}, {"serial:/dev/ttyNOSUCH9", UpdateOutcome::Failed}}) {
        UpdateOptions options;
        options.via = via;
        const auto report
            = test::run(bench.clock, quadquad2drv::update(*bench.device, bench.image, options, bench.operation));
        ASSERT_TRUE(report) << via;
        EXPECT_EQ(report->outcome, outcome) << via << ": " << report->summary().english();
    }
}

TEST(QuadQuad2DrvUpdate, CancelledWhileItWaitsForHandsItLeavesNothingBehind)
{
    QuadQuad2DrvUpdateBench bench;
    Updater updater(*bench.device, bench.hostEnd, bench.image, bench.operation, {});
    std::optional<Fault> end;
    bench.operation.run<UpdateReport>(updater.run(false),
        [&end](const Result<UpdateReport> &report) { end = report ? Fault::BadCheck : report.error().fault; });
    bench.clock.advance(5s);
    ASSERT_TRUE(bench.operation.cancel());
    bench.clock.advance(1s);
    EXPECT_EQ(end, Fault::Cancelled);
}

TEST(QuadQuad2DrvUpdate, SettingsAreTakenOutOfTheLinkAndTheRestStays)
{
    LinkAddress via = *LinkAddress::parse(
        "serial:/dev/ttyUSB0?baud=57600&ending=lf&pause=80&failure=No|Oops&banner=hello&farewell=none&format=8E1");
    const auto settings = BootSettings::take(via);
    ASSERT_TRUE(settings);
    EXPECT_EQ(settings->ending, "\n");
    EXPECT_EQ(settings->lineTime, 80ms);
    EXPECT_EQ(settings->failures, (std::vector<std::string>{"no", "oops"}));
    EXPECT_EQ(settings->banner, "hello");
    EXPECT_EQ(settings->farewell, "");
    EXPECT_EQ(via.text(), "serial:/dev/ttyUSB0?baud=57600&format=8E1");
    for (const auto &[text, time] : {std::pair{"serial:x?pause=0", 0ms}, {"serial:x?pause=1000", 1000ms}}) {
        LinkAddress edge = *LinkAddress::parse(text);
        ASSERT_TRUE(BootSettings::take(edge)) << text;
        edge = *LinkAddress::parse(text);
        EXPECT_EQ(BootSettings::take(edge)->lineTime, time);
    }
    for (const char *wrong : {"serial:x?pause=-1", "serial:x?pause=1001", "serial:x?ending=tab", "serial:x?pause=9999",
             "serial:x?pause=1x"}) {
        LinkAddress bad = *LinkAddress::parse(wrong);
        EXPECT_EQ(BootSettings::take(bad).error().fault, Fault::OutOfRange) << wrong;
    }
}

} // namespace
} // namespace mb::quadquad2drv
