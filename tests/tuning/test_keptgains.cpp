// SPDX-License-Identifier: GPL-3.0-or-later
// What a tuning leaves in a unit where its motor, the unit or this program lets it down.
#include "experiment/owedgains.h"
#include "tests/tuning/tuningbench.h"
#include "transport/canlink.h"
#include "wire/canframe.h"

namespace mb::tuning {
namespace {

using namespace std::chrono_literals;
using namespace test;

/// A tuning of a velocity loop, and what is in the slot that its result belongs to.
struct Tuned {
    Tuned()
        : p(bench.bench.index(*bench.device, "slot0.p"))
        , before(rawOf(bench, "slot0.p"))
        , task(autotune(
              *bench.device, bench.bench.session.stream(*bench.device), planOf(Mode::Velocity), bench.surroundings))
    {
    }
    /// Until the first of the gains that are kept is in force, and the others are not.
    void runUntilHalfIsWritten()
    {
        task.start();
        ASSERT_TRUE(bench.bench.clock.runUntil([this] { return valueOfP() != before; }, 2min));
        ASSERT_FALSE(task.isFinished());
    }
    [[nodiscard]] std::int64_t valueOfP() const { return bench.device->parameters().entry(p).raw.value_or(-1); }
    [[nodiscard]] std::optional<std::int64_t> owed(std::string_view key) const
    {
        for (const OwedValue &value : bench.journal.owed) {
            if (value.key == key)
                return value.raw;
        }
        return std::nullopt;
    }

    ExperimentBench bench{"sim:can", "dmc60c", 7};
    ParameterIndex p;
    std::int64_t before;
    Task<TuneReport> task;
};

TEST(KeptGains, OfATuningThatIsKilledWhileItWritesThemOweWhatWasThere)
{
    Tuned tuned;
    tuned.runUntilHalfIsWritten();
    tuned.task.cancel();
    EXPECT_EQ(tuned.owed("slot0.p"), tuned.before);
    EXPECT_TRUE(tuned.owed("slot0.i"));
}

TEST(KeptGains, ThatCouldNotBeWrittenAreRolledBackAndOwedWhereTheUnitIsGone)
{
    Tuned tuned;
    tuned.runUntilHalfIsWritten();
    tuned.bench.simulator()->setPowered(false);
    ASSERT_TRUE(tuned.bench.bench.clock.runUntil([&] { return tuned.task.isFinished(); }, 2min));
    ASSERT_TRUE(tuned.task.result());
    const TuneReport report = std::move(*tuned.task.result());
    EXPECT_NE(report.result, TuneResult::Kept);
    EXPECT_FALSE(report.notPutBack.empty());
    EXPECT_FALSE(isPutBack(report));
    EXPECT_EQ(tuned.owed("slot0.p"), tuned.before);
}

TEST(KeptGains, ThatCouldNotAllBeWrittenAreTakenBack)
{
    Tuned tuned;
    tuned.bench.surroundings.note = [&](const Message &text) {
        if (text.english().find("could not be written") != std::string::npos)
            tuned.bench.simulator()->setPowered(true);
    };
    tuned.task = autotune(*tuned.bench.device, tuned.bench.bench.session.stream(*tuned.bench.device),
        planOf(Mode::Velocity), tuned.bench.surroundings);
    tuned.runUntilHalfIsWritten();
    tuned.bench.simulator()->setPowered(false);
    ASSERT_TRUE(tuned.bench.bench.clock.runUntil([&] { return tuned.task.isFinished(); }, 2min));
    ASSERT_TRUE(tuned.task.result());
    const TuneReport report = std::move(*tuned.task.result());
    EXPECT_EQ(report.result, TuneResult::RolledBack) << report.evidence.english();
    EXPECT_TRUE(report.notPutBack.empty()) << report.notPutBack.english();
    EXPECT_TRUE(isPutBack(report));
    EXPECT_EQ(rawOf(tuned.bench, "slot0.p"), tuned.before);
    EXPECT_TRUE(tuned.bench.journal.owed.empty());
}

TEST(KeptGains, AreNotTakenBackFromAMotorThatIsSeenToTurn)
{
    Tuned tuned;
    tuned.bench.surroundings.note = [&](const Message &text) {
        if (text.english().find("could not be written") == std::string::npos)
            return;
        tuned.bench.simulator()->setPowered(true);
        tuned.bench.simulator()->disturb("load-torque", -0.5);
    };
    tuned.task = autotune(*tuned.bench.device, tuned.bench.bench.session.stream(*tuned.bench.device),
        planOf(Mode::Velocity), tuned.bench.surroundings);
    tuned.runUntilHalfIsWritten();
    tuned.bench.simulator()->setPowered(false);
    ASSERT_TRUE(tuned.bench.bench.clock.runUntil([&] { return tuned.task.isFinished(); }, 2min));
    ASSERT_TRUE(tuned.task.result());
    ASSERT_GT(std::abs(tuned.bench.simulator()->speed()), 1000.0);
    EXPECT_FALSE(tuned.task.result()->notPutBack.empty());
    EXPECT_EQ(tuned.owed("slot0.p"), tuned.before);
}

TEST(KeptGains, AreOwedByNobodyOnceAllAreWritten)
{
    Tuned tuned;
    tuned.task.start();
    ASSERT_TRUE(tuned.bench.bench.clock.runUntil([&] { return tuned.task.isFinished(); }, 2min));
    ASSERT_EQ(tuned.task.result()->result, TuneResult::Kept);
    EXPECT_TRUE(tuned.bench.journal.owed.empty());
}

TEST(KeptGains, WhoseDebtCouldNotBeTakenBackAreKeptAndThatIsSaid)
{
    Tuned tuned;
    std::vector<std::string> warned;
    tuned.bench.surroundings.warn = [&](const Message &text) { warned.push_back(text.english()); };
    tuned.bench.journal.releaseFails = true;
    tuned.task = autotune(*tuned.bench.device, tuned.bench.bench.session.stream(*tuned.bench.device),
        planOf(Mode::Velocity), tuned.bench.surroundings);
    tuned.task.start();
    ASSERT_TRUE(tuned.bench.bench.clock.runUntil([&] { return tuned.task.isFinished(); }, 2min));
    ASSERT_TRUE(tuned.task.result());
    const TuneReport &report = *tuned.task.result();
    EXPECT_EQ(report.result, TuneResult::Kept);
    EXPECT_NE(report.evidence.english().find("the disk is full"), std::string::npos) << report.evidence.english();
    ASSERT_EQ(warned.size(), 1U);
    EXPECT_NE(warned.front().find("the disk is full"), std::string::npos) << warned.front();
    ASSERT_FALSE(tuned.bench.journal.owed.empty());
    tuned.bench.journal.releaseFails = false;
    tuned.bench.journal.isKept = true;
    const auto asked = test::run(tuned.bench.bench.clock, lookForOwed(*tuned.bench.device, tuned.bench.journal));
    ASSERT_TRUE(asked);
    EXPECT_TRUE(asked->empty()) << "what was kept is there on purpose";
    EXPECT_TRUE(tuned.bench.journal.owed.empty());
}

/// Half of what is put to the second proof is in force when the unit falls silent.
TEST(KeptGains, OfAProofThatCouldNotBeginAreSaidToBeStillInForce)
{
    Tuned tuned;
    const auto owed = [&] { return std::count(tuned.bench.journal.log.begin(), tuned.bench.journal.log.end(), "owe"); };
    tuned.task.start();
    ASSERT_TRUE(tuned.bench.bench.clock.runUntil([&] { return owed() == 2; }, 2min));
    tuned.bench.simulator()->setPowered(false);
    ASSERT_TRUE(tuned.bench.bench.clock.runUntil([&] { return tuned.task.isFinished(); }, 2min));
    ASSERT_TRUE(tuned.task.result()) << tuned.task.result().error().text();
    const TuneReport &report = *tuned.task.result();
    EXPECT_FALSE(report.notPutBack.empty());
    EXPECT_NE(report.evidence.english().find("the gains were not put back"), std::string::npos)
        << report.evidence.english();
    EXPECT_FALSE(tuned.bench.journal.owed.empty());
}

/// It commands the unit, which stands all the same, from the end of the first push on.
TEST(Tuning, IsStoppedByAnotherMasterBetweenTwoOfItsExperiments)
{
    Tuned tuned;
    SetPointStream &stream = tuned.bench.bench.session.stream(*tuned.bench.device);
    const auto other = tuned.bench.bench.session.bench(*tuned.bench.bench.link)->hostLink();
    ASSERT_TRUE(other->open());
    Timer timer(tuned.bench.bench.clock);
    std::function<void()> command = [&] {
        ASSERT_TRUE(dynamic_cast<CanLink &>(*other).send(*canFrameFromText("02060007#0000000000000000")));
        timer.startIn(20ms, command);
    };
    const auto isPush = [](const std::string &note) { return note.starts_with("pushing"); };
    tuned.task.start();
    ASSERT_TRUE(tuned.bench.bench.clock.runUntil(
        [&] { return std::any_of(tuned.bench.notes.begin(), tuned.bench.notes.end(), isPush) && stream.isRunning(); },
        2min));
    ASSERT_TRUE(tuned.bench.bench.clock.runUntil([&] { return !stream.isRunning(); }, 2min));
    command();
    ASSERT_TRUE(tuned.bench.bench.clock.runUntil([&] { return tuned.task.isFinished(); }, 2min));
    ASSERT_TRUE(tuned.task.result()) << tuned.task.result().error().text();
    const TuneReport &report = *tuned.task.result();
    EXPECT_EQ(report.result, TuneResult::Stopped) << report.evidence.english();
    EXPECT_EQ(report.stopReason, tuning::EndReason::ForeignMaster);
    EXPECT_EQ(report.stopped, tuned.bench.device->isSeenStopped());
}

/// Its supply goes when the first push ends.
TEST(Tuning, EndsWhereTheStopOfATrialIsNotConfirmed)
{
    Tuned tuned;
    SetPointStream &stream = tuned.bench.bench.session.stream(*tuned.bench.device);
    bool ran = false;
    const Subscription ending = stream.changed().add([&] {
        if (std::exchange(ran, stream.isRunning()) && !stream.isRunning())
            tuned.bench.simulator()->setPowered(false);
    });
    tuned.task.start();
    ASSERT_TRUE(tuned.bench.bench.clock.runUntil([&] { return tuned.task.isFinished(); }, 2min));
    ASSERT_TRUE(tuned.task.result());
    const TuneReport &report = *tuned.task.result();
    EXPECT_FALSE(report.stopped);
    EXPECT_NE(report.evidence.english().find("was not confirmed"), std::string::npos) << report.evidence.english();
    const auto isPush = [](const std::string &note) { return note.starts_with("pushing"); };
    EXPECT_EQ(std::count_if(tuned.bench.notes.begin(), tuned.bench.notes.end(), isPush), 1) << "nothing follows it";
}

/// A load drives it on when the first push ends; nobody else commands it, and it is heard.
TEST(Tuning, IsStoppedWhereItsMotorIsHeardAndNotSeenToStand)
{
    ExperimentBench bench("sim:can", "abstractdc", 3);
    SetPointStream &stream = bench.bench.session.stream(*bench.device);
    bool ran = false;
    const Subscription ending = stream.changed().add([&] {
        if (std::exchange(ran, stream.isRunning()) && !stream.isRunning())
            bench.simulator()->disturb("load-torque", -0.5);
    });
    TunePlan plan = planOf(Mode::Velocity);
    plan.propose = true;
    const auto report = tune(bench, plan);
    ASSERT_TRUE(report) << report.error().text();
    EXPECT_FALSE(report->stopped);
    EXPECT_EQ(report->result, TuneResult::Stopped) << report->evidence;
    EXPECT_EQ(report->stopReason, tuning::EndReason::Unconfirmed);
}

} // namespace
} // namespace mb::tuning
