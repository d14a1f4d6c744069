// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of the engine by themselves, without EngineCore: each needs a session, a log and the operations.
#include "app/engine/devicejobs.h"
#include "app/engine/firmwareupdates.h"
#include "app/engine/links.h"
#include "app/engine/rates.h"
#include "app/engine/scans.h"
#include "app/engine/snapshotpublisher.h"
#include "async/virtualclock.h"
#include "model/family.h"
#include "model/registry.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace mb {
namespace {

using namespace std::chrono_literals;

class EngineParts : public testing::Test {
protected:
    EngineParts()
    {
        link = session.openLink(*LinkAddress::parse("sim:can")).value();
        recordings.follow(*link);
        scans.scan(*link);
        (void)clock.runUntil([this] { return !isScanning(); }, 10s);
    }
    [[nodiscard]] bool isScanning() const
    {
        LinkView view;
        scans.describe(*link, view);
        return view.scanning;
    }
    /// A DMC60C: other families on the bench have the same numbers.
    [[nodiscard]] Device &device(int address) const
    {
        const auto all = session.devices();
        return **std::find_if(all.begin(), all.end(), [address](const Device *one) {
            return one->identity().address == address && one->family().key == "dmc60c";
        });
    }
    [[nodiscard]] DeviceId id(int address) const { return session.idOf(device(address)); }
    [[nodiscard]] ChannelIndex velocity() const { return *device(5).telemetry()->find("velocity"); }
    [[nodiscard]] Finished into(std::vector<Result<void>> &answers) const
    {
        return [&answers](Result<void> result) { answers.push_back(std::move(result)); };
    }

    /// Somebody's wish for the velocity of #5; 0: no more.
    void wish(Rates &rates, std::uint64_t wisher, double hertz) const
    {
        std::vector<Result<void>> answers;
        const std::vector<RateWish> wishes{{id(5), velocity(), hertz}};
        rates.carryOut(orders::WishRates{wisher, hertz > 0.0 ? wishes : std::vector<RateWish>()}, into(answers));
        EXPECT_EQ(answers.size(), 1U);
    }

    VirtualClock clock;
    Session session{clock, families()};
    EngineLog log{session};
    std::vector<std::string> lines;
    Subscription noticed = log.noticed().add([this](Severity, const std::string &who, const Message &text) {
        lines.push_back(who + ": " + text.english());
    });
    Operations operations{clock, session, log};
    EngineContext context{clock, session, log, operations};
    Motion motion{context, nullptr};
    Recordings recordings{context, motion};
    Scans scans{context, recordings};
    ProvisionalChanges provisional{context};
    ParameterJobs parameters{context, provisional};
    DeviceJobs jobs{context, parameters};
    Link *link = nullptr;
};

TEST_F(EngineParts, AFrameThatMovesAMotorGoesToTheDeviceThatIsArmedOnlyWhoeverSendsIt)
{
    Links links(context, motion, recordings, scans, false);
    const auto send = [&](std::string_view frame, std::optional<DeviceId> armed) {
        std::vector<Result<void>> answers;
        const std::uint64_t before = link->counters().tx;
        links.carryOut(orders::SendFrame{"sim:can", *canFrameFromText(frame), armed}, into(answers));
        EXPECT_EQ(link->counters().tx - before, answers.front() ? 1U : 0U);
        return answers.front();
    };
    constexpr std::string_view controlOfFive = "02060005#7100000000280000";
    for (const std::optional<DeviceId> armed : {std::optional<DeviceId>(), std::optional(id(7))}) {
        const auto refused = send(controlOfFive, armed);
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error().fault, Fault::Unsafe);
        EXPECT_EQ(refused.error().text(), "DMC60C #5 is not armed; select it, then hold Arm in the header");
    }
    EXPECT_FALSE(send("02060014#7100000000280000", id(5))) << "nobody knows this one";
    EXPECT_TRUE(send("123#00", {})) << "it moves nothing";
    EXPECT_TRUE(send(controlOfFive, id(5)));
}

TEST_F(EngineParts, ARateForADeviceThatIsBusyIsSetOnceItIsFree)
{
    Rates rates(context);
    std::vector<Result<void>> blinked;
    jobs.carryOut(orders::Identify{id(5)}, into(blinked));
    ASSERT_TRUE(operations.has(id(5)));
    wish(rates, 1, 50.0);
    wish(rates, 1, 100.0);
    ASSERT_TRUE(clock.runUntil([&] { return !blinked.empty(); }, 20s));
    EXPECT_EQ(operations.jobs().size(), 1U) << "nothing was set before";
    clock.advance(3s);
    EXPECT_TRUE(blinked.front());
    EXPECT_EQ(operations.jobs().size(), 2U);
    EXPECT_NEAR(device(5).telemetry()->rate(velocity(), device(5).clock().now()), 100.0, 10.0)
        << "what was asked for last";
}

TEST_F(EngineParts, ARestoredRateIsWhatWasAskedForBefore)
{
    Rates rates(context);
    std::vector<Result<void>> answers;
    wish(rates, 1, 100.0);
    clock.advance(1s);
    operations.begin(
        id(5), say("An experiment"), [this](Device &unit, Progress &) { return unit.setRate(velocity(), 10.0); },
        into(answers));
    ASSERT_TRUE(clock.runUntil([&] { return answers.size() == 1; }, 20s));
    rates.restore(id(5));
    ASSERT_TRUE(operations.has(id(5)));
    clock.advance(5s);
    EXPECT_NEAR(device(5).telemetry()->rate(velocity(), device(5).clock().now()), 100.0, 10.0);
}

TEST_F(EngineParts, ARateThatGotLostIsAskedForAgain)
{
    Rates rates(context);
    clock.advance(3s);
    const double own = device(5).telemetry()->rate(velocity(), device(5).clock().now());
    const auto loseTheNext = [&] {
        ASSERT_TRUE(clock.runUntil([&] { return operations.has(id(5)); }, 1s));
        session.bench(*link)->setLoss(1.0);
        ASSERT_TRUE(clock.runUntil([&] { return !operations.has(id(5)); }, 10s));
        session.bench(*link)->setLoss(0.0);
    };
    wish(rates, 1, 50.0);
    loseTheNext();
    clock.advance(10s);
    EXPECT_NEAR(device(5).telemetry()->rate(velocity(), device(5).clock().now()), 50.0, 5.0);
    wish(rates, 1, 0.0);
    loseTheNext();
    clock.advance(10s);
    EXPECT_NEAR(device(5).telemetry()->rate(velocity(), device(5).clock().now()), own, 0.1 * own)
        << "and given back likewise";
    EXPECT_EQ(std::count_if(lines.begin(), lines.end(),
                  [](const std::string &line) { return line.find("Set telemetry rate") != std::string::npos; }),
        2);
}

TEST_F(EngineParts, ARaisedRateThatGotNoAnswerIsGivenBackOnceNobodyWishesIt)
{
    Rates rates(context);
    clock.advance(3s);
    const double own = device(5).telemetry()->rate(velocity(), device(5).clock().now());
    wish(rates, 1, 200.0);
    ASSERT_TRUE(clock.runUntil([&] { return operations.has(id(5)); }, 1s));
    session.bench(*link)->setLoss(1.0);
    wish(rates, 1, 0.0); // its page has gone
    ASSERT_TRUE(clock.runUntil([&] { return !operations.has(id(5)); }, 10s));
    session.bench(*link)->setLoss(0.0);
    clock.advance(10s);
    EXPECT_NEAR(device(5).telemetry()->rate(velocity(), device(5).clock().now()), own, 0.1 * own);
}

TEST_F(EngineParts, TheHighestWishHoldsAndWhoEndsGivesItBack)
{
    Rates rates(context);
    clock.advance(3s);
    const double own = device(5).telemetry()->rate(velocity(), device(5).clock().now());
    const auto rate = [this] {
        clock.advance(4s);
        return device(5).telemetry()->rate(velocity(), device(5).clock().now());
    };
    constexpr std::uint64_t recording = 1;
    constexpr std::uint64_t plot = 2;
    wish(rates, recording, 200.0);
    wish(rates, plot, 100.0);
    EXPECT_NEAR(rate(), 200.0, 10.0);
    wish(rates, plot, 50.0);
    EXPECT_NEAR(rate(), 200.0, 10.0) << "a lower wish never lowers another's";
    wish(rates, plot, 100.0);
    wish(rates, recording, 0.0);
    EXPECT_NEAR(rate(), 100.0, 10.0) << "who ends gives the rate back to the next";
    wish(rates, plot, 0.0);
    EXPECT_NEAR(rate(), own, 0.1 * own) << "and the last one to the device";
    const std::size_t settings = operations.jobs().size();
    wish(rates, plot, 0.0);
    clock.advance(1s);
    EXPECT_EQ(operations.jobs().size(), settings);
}

TEST_F(EngineParts, TheEndGivesRaisedRatesBackAndWaitsForNobodyLongerThanASecond)
{
    Rates rates(context);
    clock.advance(3s);
    const auto rate = [this] { return device(5).telemetry()->rate(velocity(), device(5).clock().now()); };
    const double own = rate();
    int ends = 0;
    wish(rates, 1, 200.0);
    clock.advance(3s);
    ASSERT_NEAR(rate(), 200.0, 10.0);
    wish(rates, 1, 0.0); // its window has gone
    rates.end([&ends] { ++ends; });
    ASSERT_TRUE(clock.runUntil([&ends] { return ends > 0; }, 500ms));
    clock.advance(4s);
    EXPECT_NEAR(rate(), own, 0.1 * own);
    EXPECT_EQ(ends, 1);

    wish(rates, 1, 200.0);
    clock.advance(3s);
    session.bench(*link)->setLoss(1.0);
    rates.end([&ends] { ++ends; });
    clock.advance(990ms);
    EXPECT_EQ(ends, 1) << "it is told as long as it may answer";
    clock.advance(20ms);
    EXPECT_EQ(ends, 2);
    rates.end([&ends] { ++ends; });
    session.bench(*link)->setLoss(0.0);
    ASSERT_TRUE(clock.runUntil([&ends] { return ends == 3; }, 1010ms));
}

TEST_F(EngineParts, ADeviceHasOneJobAtATimeAndWhoIsRefusedIsTold)
{
    std::vector<Result<void>> first;
    std::vector<Result<void>> refused;
    std::vector<Result<void>> elsewhere;
    jobs.carryOut(orders::Identify{id(5)}, into(first));
    jobs.carryOut(orders::Rename{id(5), "intake"}, into(refused));
    jobs.carryOut(orders::Identify{id(7)}, into(elsewhere));
    ASSERT_EQ(refused.size(), 1U);
    EXPECT_EQ(refused.front().error().fault, Fault::Unsafe);
    ASSERT_TRUE(clock.runUntil([&] { return !first.empty() && !elsewhere.empty(); }, 20s));
    EXPECT_TRUE(first.front() && elsewhere.front());
    EXPECT_EQ(operations.jobs().size(), 2U);
}

TEST_F(EngineParts, WhatSetPointsAreComputedFromIsNotChangedWhileTheyAreSent)
{
    const auto all = session.devices();
    Device &drive = **std::ranges::find_if(all, [](const Device *one) { return one->family().key == "abstractdc"; });
    std::vector<Result<void>> answers;
    const auto calibrate = [&](double amperes) {
        jobs.carryOut(orders::Calibrate{session.idOf(drive), "amperes_per_count", amperes}, into(answers));
        return answers.back();
    };
    ASSERT_TRUE(calibrate(0.01));
    SetPoint current;
    current.mode = Mode::Current;
    current.target = 1.0;
    ASSERT_TRUE(session.stream(drive).start(current, 10s));
    clock.advance(100ms);
    EXPECT_EQ(calibrate(0.001).error().fault, Fault::Unsafe);
    EXPECT_EQ(drive.knowledge().profile().calibrated("amperes_per_count"), 0.01);
    EXPECT_TRUE(session.stream(drive).isRunning());
    session.stream(drive).stop();
    EXPECT_TRUE(calibrate(0.001));
}

TEST_F(EngineParts, WhatBeganByItselfMakesWayForAnOrder)
{
    std::vector<Result<void>> byItself;
    std::vector<Result<void>> ordered;
    auto *job = operations.begin(
        id(5), say("Look"), [](Device &unit, Progress &) { return unit.identify(); }, into(byItself));
    ASSERT_TRUE(job);
    job->yields = true;
    jobs.carryOut(orders::Identify{id(5)}, into(ordered));
    ASSERT_EQ(byItself.size(), 1U);
    EXPECT_EQ(byItself.front().error().fault, Fault::Cancelled);
    ASSERT_TRUE(clock.runUntil([&] { return !ordered.empty(); }, 20s));
    EXPECT_TRUE(ordered.front());
}

TEST_F(EngineParts, AJobIsInTheListWhileItsEndIsToldThoughManyHaveEndedBeforeIt)
{
    const auto setRate = [this](Device &unit, Progress &) { return unit.setRate(velocity(), 20.0); };
    std::vector<Result<void>> others;
    bool isKept = false;
    operations.begin<void>(
        id(5), say("A long one"), [](Device &unit, Progress &) { return unit.identify(); },
        [&](const Operations::Job &done, const Result<void> &) {
            const OperationId mine = done.id; // another job may get its memory
            operations.begin(id(5), say("Set telemetry rate"), setRate, into(others));
            isKept
                = std::ranges::any_of(operations.jobs(), [mine](const Operations::Job &job) { return job.id == mine; });
        },
        into(others));
    for (std::size_t ended = 1; ended <= 40; ++ended) {
        operations.begin(id(7), say("Set telemetry rate"), setRate, into(others));
        ASSERT_TRUE(clock.runUntil([&] { return others.size() == ended; }, 1s));
    }
    ASSERT_TRUE(clock.runUntil([&] { return others.size() == 41; }, 20s));
    EXPECT_TRUE(isKept);
    EXPECT_LE(operations.jobs().size(), 33U) << "those that ended first are forgotten";
}

TEST_F(EngineParts, ALinkThatASearchLeavesOutIsNamedWithTheReason)
{
    std::vector<Result<void>> answers;
    operations.begin<void>(
        id(5), {say("Update firmware"), OperationKind::UpdateFirmware},
        [](Device &unit, Progress &) { return unit.identify(); }, [](const Operations::Job &, const Result<void> &) {},
        into(answers));
    scans.carryOut(orders::ScanLinks{}, into(answers));
    EXPECT_FALSE(isScanning());
    ASSERT_FALSE(lines.empty());
    EXPECT_EQ(lines.back().find("sim:can: firmware is written here"), 0U) << lines.back();
    EXPECT_TRUE(answers.back()) << "the others are searched";
}

TEST_F(EngineParts, AnUpdateThatEndsASearchOfItsLinkSaysSo)
{
    FirmwareUpdates firmware(context, parameters, scans);
    std::vector<Result<void>> answers;
    for (const bool isAsked : {false, true}) {
        lines.clear();
        if (isAsked)
            scans.carryOut(orders::ScanEverything{"sim:can"}, into(answers));
        else
            scans.scan(*link); // as it is done by itself
        ASSERT_TRUE(isScanning());
        firmware.carryOut(orders::UpdateFirmware{id(5), std::make_shared<FirmwareImage>(), {}}, into(answers));
        ASSERT_TRUE(clock.runUntil([&] { return !isScanning(); }, 1s));
        EXPECT_EQ(std::count_if(lines.begin(), lines.end(),
                      [](const std::string &line) { return line.find("sim:can: the search ends here") == 0; }),
            isAsked ? 1 : 0);
        ASSERT_TRUE(clock.runUntil([&] { return !operations.has(id(5)) && !isScanning(); }, 60s));
    }
}

TEST_F(EngineParts, AScanIsShownWhileItRunsAndEndsWhenItIsCancelled)
{
    std::vector<Result<void>> answers;
    EXPECT_FALSE(isScanning());
    scans.carryOut(orders::ScanEverything{"sim:can"}, into(answers));
    EXPECT_TRUE(isScanning());
    scans.carryOut(orders::CancelScan{"sim:can"}, into(answers));
    EXPECT_FALSE(isScanning());
    scans.carryOut(orders::ScanEverything{"sim:spi"}, into(answers));
    ASSERT_EQ(answers.size(), 3U);
    EXPECT_TRUE(answers[0] && answers[1]);
    EXPECT_EQ(answers[2].error().fault, Fault::LinkLost);
    EXPECT_NE(
        std::find(lines.begin(), lines.end(), "sim:can: the search was cancelled; what it found stays"), lines.end());
}

TEST_F(EngineParts, AnOperationIsPublishedAgainOnlyWhenItHasChanged)
{
    Links links(context, motion, recordings, scans, false);
    SnapshotPublisher publisher(context, links, provisional);
    std::vector<Result<void>> answers;
    Progress *progress = nullptr;
    operations.begin(
        id(5), say("First"),
        [&progress](Device &unit, Progress &seen) {
            progress = &seen;
            return unit.identify();
        },
        into(answers));
    operations.begin(
        id(7), say("Second"), [](Device &unit, Progress &) { return unit.identify(); }, into(answers));
    Snapshot shown = merged({}, publisher.changes());
    ASSERT_EQ(shown.operations.size(), 2U);
    const SnapshotChanges none = publisher.changes();
    EXPECT_TRUE(none.snapshot.operations.empty());
    EXPECT_EQ(none.operations.size(), 2U);
    shown = merged(std::move(shown), none);
    EXPECT_EQ(shown.operations.size(), 2U) << "what has not changed is still shown";
    progress->log(Severity::Info, say("one line"));
    SnapshotChanges one = publisher.changes();
    ASSERT_EQ(one.snapshot.operations.size(), 1U);
    shown = merged(std::move(shown), std::move(one));
    const Snapshot whole = publisher.take();
    ASSERT_EQ(shown.operations.size(), whole.operations.size());
    for (std::size_t i = 0; i < whole.operations.size(); ++i) {
        EXPECT_EQ(shown.operations[i].id, whole.operations[i].id) << "oldest first";
        EXPECT_EQ(shown.operations[i].status.log.size(), whole.operations[i].status.log.size());
        EXPECT_EQ(shown.operations[i].status.title, whole.operations[i].status.title);
    }
    ASSERT_TRUE(clock.runUntil([&] { return answers.size() == 2; }, 20s));
    shown = merged(std::move(shown), publisher.changes());
    for (const OperationView &view : shown.operations)
        EXPECT_EQ(view.status.state, OperationStatus::State::Done);
    operations.forget(*link);
    EXPECT_TRUE(merged(std::move(shown), publisher.changes()).operations.empty());
}

TEST_F(EngineParts, WhatADeviceIsAndHoldsIsOneObjectForAllPicturesUntilItChanges)
{
    Links links(context, motion, recordings, scans, false);
    SnapshotPublisher publisher(context, links, provisional);
    const auto next = [&] {
        clock.advance(33ms);
        return publisher.changes().snapshot;
    };
    const Snapshot first = next();
    Snapshot now = next();
    ASSERT_GE(now.devices.size(), 2U);
    for (const DeviceView &view : now.devices) {
        const DeviceView *before = first.device(view.id);
        ASSERT_NE(before, nullptr);
        EXPECT_TRUE(view.identity.isSameAs(before->identity)) << view.selector;
        EXPECT_TRUE(view.parameters.isSameAs(before->parameters)) << view.selector;
        EXPECT_TRUE(view.profile.isSameAs(before->profile)) << view.selector;
    }

    Device &written = device(5);
    const ParameterIndex p = findParameter(written.family().parameters, "slot0.p").value();
    written.parameters().setWritten(p, 4711);
    now = next();
    EXPECT_FALSE(now.device(id(5))->parameters.isSameAs(first.device(id(5))->parameters));
    EXPECT_NE((*first.device(id(5))->parameters)[p.value].raw, 4711) << "an older picture stays as it was";
    EXPECT_EQ((*now.device(id(5))->parameters)[p.value].raw, 4711);
    EXPECT_TRUE(next().device(id(5))->parameters.isSameAs(now.device(id(5))->parameters))
        << "one write, one new object";
    EXPECT_TRUE(now.device(id(5))->profile.isSameAs(first.device(id(5))->profile));
    EXPECT_TRUE(now.device(id(7))->parameters.isSameAs(first.device(id(7))->parameters)) << "of another device";

    written.knowledge().setVerdict("direction", DirectionVerdict::Reversed);
    Identity renamed = written.identity();
    renamed.name = "shooter";
    written.setIdentity(renamed);
    now = next();
    EXPECT_EQ(now.device(id(5))->profile->verdicts.at("direction"), DirectionVerdict::Reversed);
    EXPECT_EQ(now.device(id(5))->identity->name, "shooter");
    EXPECT_TRUE(first.device(id(5))->profile->verdicts.empty());
    EXPECT_NE(first.device(id(5))->identity->name, "shooter");
}

TEST_F(EngineParts, AStopReachesEveryMotorAndEndsWhatMoves)
{
    std::vector<Result<void>> answers;
    SetPoint half;
    half.mode = Mode::Duty;
    half.target = 0.3;
    motion.carryOut(orders::StartMotion{id(5), half, 60s, {}}, into(answers));
    clock.advance(1s);
    ASSERT_TRUE(device(5).liveness().moving);
    motion.stopAll(StopCause::User);
    EXPECT_FALSE(session.stream(device(5)).isRunning());
    EXPECT_TRUE(clock.runUntil([&] { return device(5).stopping().state() == StopState::Seen; }, 5s));
}

} // namespace
} // namespace mb
