// SPDX-License-Identifier: GPL-3.0-or-later
// Every guard in whole experiments on simulated units: the fault is in the motor, the device or on the line, and the time from
// the guard's own condition to the stop is measured by somebody who looks on. The table it prints is in docs/safety.md.
#include "experiment/owedgains.h"
#include "families/abstractdc/setpoints.h"
#include "families/abstractdc/simulatoroptions.h"
#include "model/bench.h"
#include "model/family.h"
#include "support/unitgains.h"
#include "tests/tuning/othermaster.h"
#include "tests/tuning/tripconditions.h"

#include <gtest/gtest.h>

#include <functional>
#include <memory>

namespace mb::tuning {
namespace {

using namespace std::chrono_literals;
using namespace test;

constexpr Duration handling = 25ms; // docs/tuning-results.md#a10

struct TripBench : ExperimentBench {
    using ExperimentBench::ExperimentBench;
    std::unique_ptr<Link> other; ///< another program's end of the bus
};

/// A fault, and what must come of it.
struct Scenario {
    std::string_view guard; ///< reason of the trial
    std::string_view fault; ///< in words
    std::string_view link;
    std::string_view family;
    int address = 0;
    Mode mode = Mode::Velocity;
    double to = 0.0;
    /// Limits and gains of the plan.
    std::function<void(TripBench &, ExperimentPlan &)> prepare{};
    /// When Y has been ordered for 0.3 s; nothing: the fault is there from the beginning.
    std::function<void(TripBench &)> strike{};
    /// When the guard's condition was fulfilled, of the instant of the strike.
    Condition condition{};
    bool checked = false; ///< the direction was found good before
};

void PrintTo(const Scenario &scenario, std::ostream *out)
{
    *out << scenario.guard << " of " << scenario.family;
}

void disturb(TripBench &bench, std::string_view what, double value)
{
    EXPECT_TRUE(bench.simulator()->disturb(what, value)) << what;
}

std::function<void(TripBench &)> struckBy(std::string_view what, double value)
{
    return [what, value](TripBench &bench) { disturb(bench, what, value); };
}

/// The loop's P as a gain that is tried: `factor` times what is in force.
void tryGain(TripBench &bench, ExperimentPlan &plan, double factor)
{
    const std::string prefix = plan.mode == Mode::Position ? "position." : "velocity.";
    const std::string_view family = bench.device->family().key;
    std::string key = family == "dmc60c" ? "slot" + std::to_string(plan.slot) + ".p"
        : family == "supermodified"      ? "gain.p"
        : family == "quadquad2drv"       ? "ch1." + prefix + "p"
                                         : prefix + "p";
    const ParameterIndex index = bench.bench.index(*bench.device, key);
    const auto before = run(bench.bench.clock, bench.device->read(index));
    const std::int64_t raw = before.value_or(bench.device->parameters().entry(index).raw.value_or(0));
    plan.gains = {{index, std::llround(static_cast<double>(raw) * factor)}};
}

/// What cannot be read is written once, so that it can be put back.
void writeOnce(TripBench &bench)
{
    const auto write = [&bench](const std::string &key, std::int64_t raw) {
        EXPECT_TRUE(run(bench.bench.clock, bench.device->write(bench.bench.index(*bench.device, key), raw))) << key;
    };
    if (bench.device->family().key == "abstractdc") {
        const auto unit = SimulatedUnit::parse("abstractdc:3,dialect=F,motor=25d");
        const auto stored = abstractdc::simulation::storedGains(*abstractdc::simulation::UnitOptions::parse(*unit));
        for (const auto &[loop, gains] : {std::pair{"velocity.", stored[0]}, std::pair{"position.", stored[2]}}) {
            write(loop + std::string("p"), gains.p);
            write(loop + std::string("i"), gains.i);
            write(loop + std::string("d"), gains.d);
            write(loop + std::string("divisor"), gains.divisor);
        }
    } else if (bench.device->family().key == "quadquad2drv") {
        write("ch1.velocity.p", 100);
        for (const auto &[name, raw] :
            {std::pair("p", 100), std::pair("i", 500), std::pair("d", 500), std::pair("windup", 600)})
            write(std::string("ch1.position.") + name, raw);
    }
}

struct Outcome {
    Trial trial;
    Instant condition{};
    Instant stop{};
    Duration telemetry{};
    bool putBack = false;
    bool later = false; ///< at the next connection
};

/// Every gain that was tried has its value of before, in the unit itself.
bool isPutBack(TripBench &bench, const std::vector<OwedValue> &before)
{
    for (const OwedValue &value : before) {
        if (rawInUnit(bench.bench.clock, *bench.device, *bench.simulator(), value.key) != value.raw)
            return false;
    }
    return !before.empty();
}

/// The unit is there again, nothing turns its shaft any more, and who asks it finds out what it is owed.
void connectAgain(TripBench &bench)
{
    bench.simulator()->setPowered(true);
    disturb(bench, "load-torque", 0.0);
    bench.bench.clock.advance(3s);
    (void)run(bench.bench.clock, bench.device->refresh());
    auto owed = run(bench.bench.clock, lookForOwed(*bench.device, bench.journal));
    ASSERT_TRUE(owed) << owed.error().text();
    for (const OwedGains &debt : *owed) {
        const auto paid = run(bench.bench.clock, payOwed(*bench.device, bench.journal, debt));
        EXPECT_TRUE(paid) << paid.error().text();
    }
}

/// What the plan's gains replace.
std::vector<OwedValue> inForce(TripBench &bench, const ExperimentPlan &plan)
{
    std::vector<OwedValue> values;
    for (const ParameterChange &change : plan.gains)
        values.push_back({std::string(bench.device->parameters().parameter(change.index).key),
            bench.device->parameters().entry(change.index).raw.value_or(-1)});
    return values;
}

Outcome play(const Scenario &scenario)
{
    TripBench bench(scenario.link, scenario.family, scenario.address);
    writeOnce(bench);
    ExperimentPlan plan = stepTo(scenario.mode, scenario.to);
    plan.slot = std::min(plan.slot, bench.device->family().capabilities.gainSlots - 1);
    plan.seconds = 3.0;
    tryGain(bench, plan, 0.9);
    if (scenario.prepare)
        scenario.prepare(bench, plan);
    if (scenario.checked)
        bench.directions.add(bench.device->selector(), 1, 0.08);
    const std::vector<OwedValue> before = inForce(bench, plan);
    TripWatch watch(bench);
    auto task = bench.start(plan);
    task.start();
    SetPointStream &stream = bench.bench.session.stream(*bench.device);
    Instant struck = watch.now();
    if (scenario.strike) {
        const bool atY = bench.bench.clock.runUntil(
            [&] { return task.isFinished() || (stream.isRunning() && stream.setPoint().target == scenario.to); }, 60s);
        EXPECT_TRUE(atY && !task.isFinished());
        bench.bench.clock.advance(300ms);
        struck = watch.now();
        scenario.strike(bench);
    }
    EXPECT_TRUE(bench.bench.clock.runUntil([&task] { return task.isFinished(); }, 120s));
    Outcome outcome;
    if (!task.isFinished() || !task.result()) {
        ADD_FAILURE() << (task.isFinished() ? task.result().error().text() : "it does not end");
        return outcome;
    }
    outcome.trial = std::move(*task.result());
    outcome.stop = watch.stoppedAt();
    outcome.telemetry = watch.period("position");
    const auto condition = scenario.condition(watch, struck);
    EXPECT_TRUE(condition) << "its condition was never fulfilled";
    outcome.condition = condition.value_or(Instant{});
    outcome.later = !bench.journal.owed.empty();
    if (outcome.later)
        connectAgain(bench);
    EXPECT_FALSE(bench.simulator()->isOutputOn());
    outcome.putBack = isPutBack(bench, before) && bench.journal.owed.empty();
    return outcome;
}

using Prepare = std::function<void(TripBench &, ExperimentPlan &)>;

Prepare bounded(std::optional<double> Envelope::*limit, double value)
{
    return [limit, value](TripBench &, ExperimentPlan &plan) { plan.limits.*limit = value; };
}

Prepare harder(double factor)
{
    return [factor](TripBench &bench, ExperimentPlan &plan) { tryGain(bench, plan, factor); };
}

/// The motor's cables were changed over since its direction was found.
void swapCables(TripBench &bench, ExperimentPlan &)
{
    disturb(bench, "encoder-reversed", 1.0);
}

void takePower(TripBench &bench)
{
    bench.simulator()->setPowered(false);
}

/// Another program commands the unit.
void commandByOther(TripBench &bench)
{
    bench.other = bench.bench.session.bench(*bench.bench.link)->hostLink();
    commandElsewhere(*bench.other, bench.bench.clock, *bench.device);
}

/// P makes nearly half a duty of the whole way, and D takes back more in each pass that brought a count: the duty alone turns.
void derivativeOfCounts(TripBench &bench, ExperimentPlan &plan)
{
    for (const auto &[key, most] : {std::pair("slot1.max_forward", 0.6), std::pair("slot1.max_reverse", -0.6)}) {
        const ParameterChange limit = bench.change(key, std::round(most * 32767.0));
        EXPECT_TRUE(run(bench.bench.clock, bench.device->write(limit.index, limit.raw))) << key;
    }
    plan.gains = {bench.change("slot1.p", 0.45 * 32767.0 / 20'000.0), bench.change("slot1.d", 32767.0)};
    for (const ParameterChange &change : plan.gains)
        (void)run(bench.bench.clock, bench.device->read(change.index));
}

std::vector<Scenario> ofDmc60c()
{
    const Scenario cim{"", "", "sim:can", "dmc60c", 5, Mode::Velocity, 60'000.0};
    const auto row = [&cim](std::string_view guard, std::string_view fault, Prepare prepare,
                         std::function<void(TripBench &)> strike, Condition condition, double to = 60'000.0) {
        Scenario scenario = cim;
        scenario.guard = guard;
        scenario.fault = fault;
        scenario.prepare = std::move(prepare);
        scenario.strike = std::move(strike);
        scenario.condition = std::move(condition);
        scenario.to = to;
        return scenario;
    };
    std::vector<Scenario> rows{
        row("travel", "a load turns it on", bounded(&Envelope::travel, 190'000.0), struckBy("load-torque", -2.0),
            beyond(190'000.0)),
        row(
            "speed", "P too high",
            [](TripBench &bench, ExperimentPlan &plan) {
                tryGain(bench, plan, 4.0);
                plan.limits.speed = 60'000.0;
            },
            {}, above("velocity", 72'000.0)),
        row("current", "the shaft is blocked", bounded(&Envelope::current, 20.0), struckBy("stall", 1.0),
            overloaded(20.0), 20'000.0),
        row("current", "a heavy load", bounded(&Envelope::current, 12.0), struckBy("load-torque", 0.25),
            overloaded(12.0), 10'000.0),
        row("duty", "a heavier load", bounded(&Envelope::duty, 0.3), struckBy("load-torque", 1.0), above("duty", 0.32)),
        row("temperature", "its case is hot", {}, struckBy("temperature", 82.0), above("temperature", 80.0)),
        row(
            "energy", "a load for long",
            [](TripBench &, ExperimentPlan &plan) {
                plan.limits.current = 8.0;
                plan.seconds = 20.0;
            },
            struckBy("load-torque", 0.07), heated(8.0), 10'000.0),
        row("bus V", "the battery sags", {}, struckBy("bus-voltage", 5.0), below("bus_voltage", 6.0)),
        row("bus V", "the supply pumps up", {}, struckBy("bus-voltage", 30.0), above("bus_voltage", 28.0)),
        row("wrong direction", "cables swapped before the session", swapCables, {},
            [](const TripWatch &watch, Instant) {
                return watch.first(
                    "position", [&watch](const SeenSample &s) { return s.value <= watch.origin() - 15.0; });
            }),
        row("wrong direction", "cables swapped since the check", swapCables, {}, away),
        row("no motion", "the shaft is blocked", {}, struckBy("stall", 1.0), stuck),
        row("no motion", "the encoder died", {}, struckBy("encoder-dead", 1.0), stuck),
        row("oscillation", "P far too high", harder(8.0), {}, swinging("velocity", 60'000.0)),
        row("link", "its supply is gone", {}, takePower, silent),
        row("link", "8 % of the frames are lost", {}, {}, losing),
        row("foreign master", "another program commands it", {}, commandByOther, atOnce),
        row(
            "interrupted", "STOP", {}, [](TripBench &bench) { bench.interruption.interrupt(); }, atOnce),
    };
    for (Scenario &scenario : rows) {
        scenario.checked = scenario.fault == "cables swapped since the check";
        if (scenario.guard == "link" && !scenario.strike)
            scenario.link = "sim:can?loss=0.08";
    }
    return rows;
}

Prepare calibrated(std::string_view key, double scale)
{
    return [key, scale](TripBench &bench, ExperimentPlan &) {
        EXPECT_TRUE(bench.device->knowledge().calibrate(key, scale)) << key;
    };
}

/// An integral that nothing damps.
void undamped(TripBench &bench, ExperimentPlan &plan)
{
    plan.gains = {bench.change("ch1.position.i", 2500.0), bench.change("ch1.position.d", 0.0),
        bench.change("ch1.position.windup", 8191.0)};
}

/// What only one of them does or tells, or tells once its scale is known.
std::vector<Scenario> ofOneFamily()
{
    using namespace abstractdc;
    const auto heavy = [](Prepare also, double amperes) {
        return [also = std::move(also), amperes](TripBench &bench, ExperimentPlan &plan) {
            also(bench, plan);
            plan.limits.current = amperes;
        };
    };
    return {
        {"oscillation", "D takes back more than P", "sim:can", "dmc60c", 5, Mode::Position, 20'000.0,
            derivativeOfCounts, {}, flipping(0.6)},
        {"temperature", "its case is hot", "sim:can", "abstractdc", 3, Mode::Velocity, 4000.0,
            calibrated(calibration::degrees, 1.0 / abstractdc::simulation::countsPerDegree),
            struckBy("temperature", 78.0), above("temperature", 75.0)},
        {"current", "a heavy load", "sim:can", "abstractdc", 3, Mode::Velocity, 4000.0,
            heavy(calibrated(calibration::amperes, 1.0 / abstractdc::simulation::countsPerAmpere), 1.0),
            struckBy("load-torque", 0.3), overloaded(1.0)},
        {"current", "a heavy load", "sim:serial", "supermodified", 5, Mode::Position, 40'000.0,
            heavy([](TripBench &, ExperimentPlan &) {}, 3.0), struckBy("load-torque", 0.3), overloaded(3.0)},
        {"oscillation", "I far too high", "sim:spi", "quadquad2drv", 0, Mode::Position, 60.0, undamped, {},
            swinging("position", 60.0)},
    };
}

std::vector<Scenario> ofTheOthers()
{
    struct Unit {
        std::string_view link;
        std::string_view family;
        int address;
        Mode mode;
        double to;
        double travel;
    };
    std::vector<Scenario> rows;
    for (const Unit &unit : {Unit{"sim:can", "abstractdc", 3, Mode::Velocity, 4000.0, 12'300.0},
             Unit{"sim:spi", "quadquad2drv", 0, Mode::Velocity, 1500.0, 4600.0},
             Unit{"sim:serial", "supermodified", 4, Mode::Position, 40'000.0, 40'100.0}}) {
        const auto add = [&](std::string_view guard, std::string_view fault, Prepare prepare,
                             std::function<void(TripBench &)> strike, Condition condition) {
            rows.push_back({guard, fault, unit.link, unit.family, unit.address, unit.mode, unit.to, std::move(prepare),
                std::move(strike), std::move(condition)});
        };
        const auto pull = struckBy("load-torque", -0.5);
        add("travel", "a load turns it on", bounded(&Envelope::travel, unit.travel), pull, beyond(unit.travel));
        add("no motion", "the shaft is blocked", {}, struckBy("stall", 1.0), stuck);
        add("link", "its supply is gone", {}, takePower, silent);
        add(
            "interrupted", "STOP", {}, [](TripBench &bench) { bench.interruption.interrupt(); }, atOnce);
        if (unit.family != "quadquad2drv") // whose wire has one master
            add("foreign master", "another program commands it", {}, commandByOther, atOnce);
        if (unit.mode == Mode::Position) {
            add("wrong direction", "cables swapped since the check", swapCables, {}, away);
            rows.back().checked = true;
            continue;
        }
        add("speed", "a load turns it on", bounded(&Envelope::speed, unit.to), struckBy("load-torque", -0.5),
            above("velocity", 1.2 * unit.to));
        add("wrong direction", "cables swapped since the check", swapCables, {}, away);
        rows.back().checked = true;
        if (unit.family == "abstractdc")
            add("oscillation", "P far too high", harder(40.0), {}, swinging("velocity", unit.to));
    }
    for (const Scenario &more : ofOneFamily())
        rows.push_back(more);
    return rows;
}

class EveryGuard : public testing::TestWithParam<Scenario> { };

TEST_P(EveryGuard, StopsWithinTwoPeriodsOfItsConditionAndTheGainsAreAsBefore)
{
    const Scenario &scenario = GetParam();
    const Outcome outcome = play(scenario);
    const double after = inSeconds(outcome.stop - outcome.condition) * 1e3;
    const double limit = inSeconds(2 * outcome.telemetry + handling) * 1e3;
    EXPECT_EQ(toString(outcome.trial.reason), scenario.guard) << outcome.trial.detail;
    EXPECT_LE(after, limit);
    const bool early = after < -limit && scenario.guard != "link"; // whose device may have noticed first
    EXPECT_FALSE(early) << "before its condition";
    EXPECT_TRUE(outcome.putBack);
    std::printf("| %s | %s | %s | %.0f | %.0f | %s |\n", std::string(scenario.family).c_str(),
        std::string(scenario.guard).c_str(), std::string(scenario.fault).c_str(), after, limit,
        !outcome.putBack    ? "no"
            : outcome.later ? "at the next connection"
                            : "at once");
}

/// No wait of the story is without its limit, so only a story that is held up takes longer than its plan.
TEST(Trips, OfTheTimeComesWhenTheStoryIsHeldUp)
{
    ExperimentBench bench;
    SetPointStream &stream = bench.bench.session.stream(*bench.device);
    TrialRecorder recorder(*bench.device, stream, Mode::Velocity, 1);
    GuardPlan plan;
    plan.envelope.duty = 1.0;
    plan.swing = 20'000.0;
    plan.longest = 2s;
    SetPoint setPoint;
    setPoint.mode = Mode::Velocity;
    setPoint.target = 20'000.0;
    recorder.guard(plan);
    const Instant start = bench.device->clock().now();
    ASSERT_TRUE(stream.start(setPoint, experimentLease));
    ASSERT_TRUE(bench.bench.clock.runUntil([&stream] { return !stream.isRunning(); }, 20s));
    ASSERT_TRUE(recorder.trip());
    EXPECT_EQ(recorder.trip()->guard, EndReason::Time) << recorder.trip()->detail;
    const Duration after = recorder.stoppedAt() - start - 3s;
    EXPECT_LE(after, handling);
    EXPECT_GE(after, 0ms);
    std::printf("| dmc60c | time | the story is held up | %.0f | 25 | – |\n", inSeconds(after) * 1e3);
}

TEST(Recorded, StretchesAreThoseOfTheWholeTrace)
{
    ExperimentBench bench;
    SetPointStream &stream = bench.bench.session.stream(*bench.device);
    const TrialRecorder recorder(*bench.device, stream, Mode::Velocity, 1);
    bench.bench.clock.advance(3s);
    const Instant zero = bench.device->clock().now() - 2s;
    const Trace whole = recorder.trace("velocity", zero);
    ASSERT_GT(whole.size(), 25U);
    for (const Span within : {Span{-0.25, 1.0}, Span{whole.t[7], whole.t[20]}, Span{0.5, 0.2}, Span{2.5, 3.0}})
        EXPECT_EQ(recorder.trace("velocity", zero, within), whole.part(within.from, within.to)) << within.from;
    EXPECT_TRUE(recorder.trace("nothing", zero, {0.0, 1.0}).isEmpty());
    EXPECT_EQ(recorder.signals(zero, {0.0, 1.0}).front().trace.size(),
        recorder.signals(zero).front().trace.part(0.0, 1.0).size());
}

/// The story moves the target of a sine by itself: that says nothing of whoever watches it.
TEST(Trips, OfALeaseThatNobodyRenewsComeDuringEveryProfile)
{
    for (const Profile profile : {Profile::Step, Profile::Sine, Profile::Prbs, Profile::Ramp}) {
        ExperimentBench bench;
        ExperimentPlan plan = stepTo(Mode::Velocity, 40'000.0);
        plan.profile = profile;
        plan.seconds = profile == Profile::Prbs ? 12.7 : 6.0;
        plan.gains = {bench.change("slot0.p", 1.0)};
        const ParameterIndex p = plan.gains.front().index;
        const auto before = run(bench.bench.clock, bench.device->read(p));
        TripWatch watch(bench);
        auto task = bench.start(plan);
        task.start();
        ASSERT_TRUE(bench.bench.clock.runUntil([&] { return bench.simulator()->speed() > 10'000.0; }, 10s));
        bench.bench.clock.advance(500ms);
        const Instant hung = watch.now();
        bench.renewal.stop();
        ASSERT_TRUE(bench.bench.clock.runUntil([&] { return task.isFinished(); }, 60s));
        ASSERT_TRUE(task.result());
        EXPECT_EQ(task.result()->reason, tuning::EndReason::User) << toString(profile);
        EXPECT_LE(watch.stoppedAt() - hung, experimentLease + handling) << toString(profile);
        EXPECT_EQ(*run(bench.bench.clock, bench.device->read(p)), *before);
        std::printf("| dmc60c | user | the window hangs during a %s | %.0f | 25 | at once |\n",
            std::string(toString(profile)).c_str(),
            std::max(0.0, inSeconds(watch.stoppedAt() - hung - experimentLease) * 1e3));
    }
}

INSTANTIATE_TEST_SUITE_P(
    A10_Dmc60c, EveryGuard, testing::ValuesIn(ofDmc60c()), [](const auto &row) { return std::to_string(row.index); });
INSTANTIATE_TEST_SUITE_P(A10_Others, EveryGuard, testing::ValuesIn(ofTheOthers()),
    [](const auto &row) { return std::to_string(row.index); });

} // namespace
} // namespace mb::tuning
