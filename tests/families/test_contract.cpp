// SPDX-License-Identifier: GPL-3.0-or-later
// What every family promises (docs/adding-a-family.md#what-each-part-promises). Iterates over the registry: a new folder is tested from its first day.
#include "model/parametertransfer.h"
#include "support/simulatedsession.h"
#include "transport/canlink.h"
#include "transport/seriallink.h"

#include <fstream>
#include <sstream>

namespace mb {
namespace {

using namespace std::chrono_literals;
using test::run;
using test::SimulatedSession;

class Contract : public testing::TestWithParam<const Family *> {
protected:
    void SetUp() override
    {
        ASSERT_FALSE(family().links.empty());
        bench = std::make_unique<SimulatedSession>("sim:" + std::string(toString(family().links.front())));
        ASSERT_NE(bench->link, nullptr);
        bench->scan();
    }
    [[nodiscard]] const Family &family() const { return *GetParam(); }
    [[nodiscard]] Device *online() const
    {
        for (Device *device : bench->session.devices()) {
            if (&device->family() == &family() && device->identity().state == DeviceState::Online)
                return device;
        }
        return nullptr;
    }
    /// Of the first mode: moves the motor of the bench without hurry.
    [[nodiscard]] double gentleTarget() const
    {
        switch (family().modes.front()) {
        case Mode::Velocity: return 2000.0;
        case Mode::Position: return 1000.0;
        default: return 0.3;
        }
    }
    [[nodiscard]] Simulator *simulatorOf(const Device &device) const
    {
        return bench->simulator(std::string(family().key) + ':' + std::to_string(device.identity().address));
    }
    std::unique_ptr<SimulatedSession> bench;
};

TEST_P(Contract, ScanFindsEveryUnitOfItsBench)
{
    std::size_t found = 0;
    for (const Device *device : bench->session.devices())
        found += &device->family() == &family() ? 1U : 0U;
    EXPECT_EQ(found, family().bench.size());
}

TEST_P(Contract, ScanIsCompleteInTimeAndWritesNothing)
{
    SimulatedSession fresh("sim:" + std::string(toString(family().links.front())));
    const Instant begin = fresh.clock.now();
    fresh.scan();
    EXPECT_LE(fresh.clock.now() - begin, family().capabilities.scanLimit);
    for (const Device *device : fresh.session.devices()) {
        for (const auto &entry : device->parameters().entries())
            EXPECT_EQ(entry.state, ParameterState::Unknown);
    }
}

TEST_P(Contract, EveryReadableParameterReads)
{
    Device *device = online();
    ASSERT_NE(device, nullptr);
    if (!family().capabilities.readback) {
        EXPECT_TRUE(readable(*device).empty());
        return;
    }
    NoProgress progress;
    const auto outcomes = run(bench->clock, readParameters(*device, readable(*device), progress));
    ASSERT_TRUE(outcomes);
    EXPECT_EQ(outcomes->size(), readable(*device).size());
    for (const TransferOutcome &outcome : *outcomes)
        EXPECT_TRUE(outcome.raw) << device->parameters().parameter(outcome.index).key;
}

TEST_P(Contract, AUnitThatHasFallenSilentIsNotAskedForEveryParameter)
{
    Device *device = online();
    ASSERT_NE(device, nullptr);
    for (Simulator *simulator : bench->session.bench(*bench->link)->simulators())
        simulator->setPowered(false);
    NoProgress progress;
    const auto outcomes = run(bench->clock, readParameters(*device, readable(*device), progress));
    ASSERT_TRUE(outcomes);
    EXPECT_LE(outcomes->size(), family().capabilities.readback ? 2U : 0U) << "until its silence is known";
    for (const TransferOutcome &outcome : *outcomes)
        EXPECT_EQ(outcome.raw.error().fault, Fault::Timeout);
}

TEST_P(Contract, AsksASilentUnitAsLongAndAsOftenAsTheUserSays)
{
    const auto askFor = [this](Patience patience) {
        SimulatedSession fresh("sim:" + std::string(toString(family().links.front())));
        const auto found = fresh.scan();
        const auto device = std::find_if(found.begin(), found.end(), [this](const Device *candidate) {
            return &candidate->family() == &family() && candidate->identity().state == DeviceState::Online;
        });
        EXPECT_NE(device, found.end());
        for (Simulator *simulator : fresh.session.bench(*fresh.link)->simulators())
            simulator->setPowered(false);
        fresh.link->settings().patience = patience;
        const Instant begin = fresh.clock.now();
        const auto asked = run(fresh.clock, (*device)->refresh());
        EXPECT_FALSE(asked);
        return fresh.clock.now() - begin;
    };
    const Duration usual = askFor({});
    const Duration brief = askFor({20ms, 0});
    EXPECT_LT(brief, usual);
    EXPECT_GE(askFor({2s, 0}), std::max<Duration>(2s, usual));
    EXPECT_GE(askFor({20ms, 20}), brief + 20 * 20ms);
}

TEST_P(Contract, EveryWritableParameterWritesAndReadsBackWhereTheDeviceCan)
{
    Device *device = online();
    ASSERT_NE(device, nullptr);
    NoProgress progress;
    for (std::uint16_t i = 0; i < family().parameters.size(); ++i) {
        const Parameter &parameter = family().parameters[i];
        if (parameter.access == Access::ReadOnly || parameter.nature == Nature::Counter || !device->offers({i}))
            continue;
        const auto raw = toRaw(parameter, parameter.fallback);
        ASSERT_TRUE(raw) << parameter.key;
        const auto outcomes = run(bench->clock, writeParameters(*device, {{{i}, *raw}}, progress));
        ASSERT_TRUE(outcomes) << parameter.key;
        ASSERT_EQ(outcomes->size(), 1U);
        EXPECT_TRUE(outcomes->front().raw) << parameter.key << ": " << outcomes->front().raw.error().text();
        if (parameter.afterRestart) {
            EXPECT_FALSE(outcomes->front().verified) << parameter.key << " is not in force yet";
        } else if (family().capabilities.readback && parameter.access == Access::ReadWrite) {
            EXPECT_TRUE(outcomes->front().verified.value_or(false)) << parameter.key;
        }
        if (parameter.access == Access::WriteOnly) {
            EXPECT_FALSE(outcomes->front().verified) << parameter.key << ": nobody can know";
            EXPECT_EQ(device->parameters().entry({i}).state, ParameterState::Assumed) << parameter.key;
            EXPECT_EQ(device->parameters().entry({i}).raw, *raw) << parameter.key;
            EXPECT_EQ(device->knowledge().profile().written.at(std::string(parameter.key)), *raw)
                << "kept for the next run";
        }
    }
}

TEST_P(Contract, WhatCannotBeReadBackIsNeverCalledStored)
{
    Device *device = online();
    ASSERT_NE(device, nullptr);
    if (family().capabilities.readback)
        return;
    for (const Parameter &parameter : family().parameters)
        EXPECT_EQ(parameter.access, Access::WriteOnly) << parameter.key;
    const auto raw = toRaw(family().parameters[0], family().parameters[0].fallback);
    ASSERT_TRUE(raw);
    NoProgress progress;
    ASSERT_TRUE(run(bench->clock, device->write({0}, *raw)));
    const auto proved = run(bench->clock, device->store(progress));
    ASSERT_TRUE(proved) << proved.error().text();
    EXPECT_FALSE(*proved);
    EXPECT_EQ(device->parameters().entry({0}).state, ParameterState::Assumed);
    EXPECT_EQ(run(bench->clock, device->read({0})).error().fault, Fault::Unsupported);
}

TEST_P(Contract, AChosenDialectIsShownWithItsWarningAndForgottenAgain)
{
    Device *device = online();
    ASSERT_NE(device, nullptr);
    EXPECT_FALSE(device->knowledge().setDialect("no such dialect"));
    const std::string probed = device->identity().dialect;
    for (const DialectChoice &choice : family().dialects) {
        ASSERT_TRUE(device->knowledge().setDialect(choice.key)) << choice.key;
        EXPECT_EQ(device->identity().dialect, choice.key);
        EXPECT_FALSE(choice.warning.empty());
        EXPECT_EQ(device->identity().detail.english().find(choice.warning) != std::string::npos, choice.key != probed);
    }
    ASSERT_TRUE(device->knowledge().setDialect({}));
    EXPECT_EQ(device->identity().dialect, probed);
}

TEST_P(Contract, CalibrationsAreCheckedKeptAndForgotten)
{
    Device *device = online();
    ASSERT_NE(device, nullptr);
    EXPECT_FALSE(device->knowledge().calibrate("no_such_key", 1.0));
    for (const Calibration &row : family().calibrations) {
        EXPECT_FALSE(row.label.empty() || row.help.empty()) << row.key;
        EXPECT_FALSE(device->knowledge().calibrate(row.key, row.maximum * 2.0)) << row.key;
        ASSERT_TRUE(device->knowledge().calibrate(row.key, row.minimum)) << row.key;
        EXPECT_EQ(device->knowledge().profile().calibrated(row.key), row.minimum);
        ASSERT_TRUE(device->knowledge().calibrate(row.key, std::nullopt)) << row.key;
        EXPECT_EQ(device->knowledge().profile().calibrated(row.key, -1.0), -1.0);
    }
}

TEST_P(Contract, AChoiceOfACalibrationIsOneOfItsRows)
{
    Device *device = online();
    ASSERT_NE(device, nullptr);
    for (const Calibration &row : family().calibrations) {
        for (const Choice &choice : row.choices) {
            EXPECT_FALSE(choice.label.empty()) << row.key;
            EXPECT_TRUE(device->knowledge().calibrate(row.key, static_cast<double>(choice.raw))) << row.key;
        }
        if (!row.choices.empty()) {
            EXPECT_FALSE(device->knowledge().calibrate(row.key, row.minimum + 0.5)) << row.key;
        }
        ASSERT_TRUE(device->knowledge().calibrate(row.key, std::nullopt)) << row.key;
    }
}

TEST_P(Contract, WhatAResetTakesIsLostAndCanBeWrittenAgain)
{
    Device *device = online();
    ASSERT_NE(device, nullptr);
    std::vector<ParameterChange> changes;
    for (std::uint16_t i = 0; i < family().parameters.size() && changes.size() < 3; ++i) {
        const Parameter &parameter = family().parameters[i];
        if (parameter.access != Access::ReadOnly && parameter.nature == Nature::Setting && device->offers({i}))
            changes.push_back({{i}, toRaw(parameter, parameter.fallback).value_or(0)});
    }
    NoProgress progress;
    ASSERT_TRUE(run(bench->clock, writeParameters(*device, changes, progress)));
    EXPECT_TRUE(lostSettings(family(), device->knowledge().profile()).empty());
    Simulator *simulator = simulatorOf(*device);
    ASSERT_NE(simulator, nullptr);
    simulator->setPowered(false);
    bench->clock.advance(200ms);
    simulator->setPowered(true);
    bench->clock.advance(3s);
    if (family().capabilities.keepsSettings && family().capabilities.readback) {
        EXPECT_TRUE(lostSettings(family(), device->knowledge().profile()).empty())
            << "the device has them, or is asked";
        return;
    }
    EXPECT_TRUE(device->liveness().restarted || family().capabilities.keepsSettings);
    ASSERT_EQ(lostSettings(family(), device->knowledge().profile()).size(), changes.size());
    for (const ParameterChange &change : changes)
        EXPECT_EQ(device->parameters().entry(change.index).state, ParameterState::Unknown);
    const auto written = run(bench->clock, rewriteSettings(*device, progress));
    ASSERT_TRUE(written) << written.error().text();
    EXPECT_TRUE(lostSettings(family(), device->knowledge().profile()).empty());
}

TEST_P(Contract, AnExperimentSaysWhatItDoesAndLeavesTheMotorStoppedWhenItIsCutAnywhere)
{
    Device *device = online();
    ASSERT_NE(device, nullptr);
    SetPointStream &stream = bench->session.stream(*device);
    NoProgress progress;
    for (const Experiment &experiment : family().experiments) {
        EXPECT_FALSE(experiment.title.empty() || experiment.explanation.empty()) << experiment.key;
        EXPECT_EQ(experiment.question.empty(), experiment.answers.empty()) << experiment.key;
        EXPECT_LE(experiment.power, experiment.mostPower) << experiment.key;
        ASSERT_NE(experiment.run, nullptr) << experiment.key;
        for (int cut = 1; cut < 60; cut += 7) {
            bench->clock.advance(500ms);
            auto task = experiment.run(*device, stream, {.axis = 1, .power = experiment.power}, progress);
            task.start();
            for (int i = 0; i < cut * 10 && !task.isFinished(); ++i)
                bench->clock.step();
            task.cancel();
            bench->clock.advance(100ms);
            EXPECT_FALSE(simulatorOf(*device)->isOutputOn()) << experiment.key << " cut after " << cut;
            EXPECT_FALSE(stream.isRunning()) << experiment.key << " cut after " << cut;
        }
    }
}

TEST_P(Contract, ReadOnlyParametersRefuseToBeWritten)
{
    Device *device = online();
    ASSERT_NE(device, nullptr);
    for (std::uint16_t i = 0; i < family().parameters.size(); ++i) {
        if (family().parameters[i].access != Access::ReadOnly)
            continue;
        const auto written = run(bench->clock, device->write({i}, 0));
        ASSERT_FALSE(written);
        EXPECT_EQ(written.error().fault, Fault::OutOfRange);
    }
}

TEST_P(Contract, EveryModeOfTheFamilyIsAcceptedAndOthersAreUnsupported)
{
    const Device *device = online();
    ASSERT_NE(device, nullptr);
    for (const Mode mode : {Mode::Duty, Mode::Velocity, Mode::Position, Mode::Current, Mode::Voltage, Mode::Follow,
             Mode::RampPosition, Mode::RampVelocity}) {
        const bool offered = std::find(family().modes.begin(), family().modes.end(), mode) != family().modes.end();
        SetPoint setPoint;
        setPoint.mode = mode;
        setPoint.target = mode == Mode::Follow ? device->identity().address + 1 : 0.0;
        setPoint.velocity = mode == Mode::RampPosition ? 100.0 : 0.0;
        const auto checked = device->check(setPoint);
        EXPECT_EQ(checked.has_value(), offered) << toString(mode);
        if (!checked && !offered) {
            EXPECT_EQ(checked.error().fault, Fault::Unsupported) << toString(mode);
        }
    }
}

TEST_P(Contract, StopWorksInTheMiddleOfMotion)
{
    Device *device = online();
    ASSERT_NE(device, nullptr);
    Simulator *simulator = simulatorOf(*device);
    ASSERT_NE(simulator, nullptr);
    SetPoint setPoint;
    setPoint.mode = family().modes.front();
    setPoint.target = gentleTarget();
    SetPointStream &stream = bench->session.stream(*device);
    bench->clock.advance(200ms);
    ASSERT_TRUE(stream.start(setPoint, 10s));
    bench->clock.advance(500ms);
    ASSERT_TRUE(simulator->isOutputOn());
    EXPECT_GT(std::abs(simulator->speed()), 0.0);
    EXPECT_FALSE(device->isSeenStopped());
    stream.stop();
    bench->clock.advance(20ms);
    EXPECT_FALSE(simulator->isOutputOn());
    bench->clock.advance(300ms);
    EXPECT_TRUE(device->isSeenStopped());
}

TEST_P(Contract, AnExpiredLeaseStopsTheMotor)
{
    Device *device = online();
    ASSERT_NE(device, nullptr);
    SetPoint setPoint;
    setPoint.mode = family().modes.front();
    setPoint.target = gentleTarget();
    SetPointStream &stream = bench->session.stream(*device);
    bench->clock.advance(200ms);
    ASSERT_TRUE(stream.start(setPoint, 500ms));
    bench->clock.advance(400ms);
    EXPECT_TRUE(simulatorOf(*device)->isOutputOn());
    bench->clock.advance(150ms);
    EXPECT_EQ(stream.end(), SetPointStream::End::LeaseExpired);
    EXPECT_FALSE(simulatorOf(*device)->isOutputOn());
}

TEST_P(Contract, ADeviceWithAWatchdogStopsWhenNobodyCommandsIt)
{
    Device *device = online();
    ASSERT_NE(device, nullptr);
    if (!family().capabilities.watchdog)
        return; // the guardian's tests cover the others
    SetPoint setPoint;
    setPoint.mode = family().modes.front();
    setPoint.target = gentleTarget();
    bench->clock.advance(200ms);
    ASSERT_TRUE(device->command(setPoint));
    bench->clock.advance(50ms);
    EXPECT_TRUE(simulatorOf(*device)->isOutputOn());
    bench->clock.advance(150ms);
    EXPECT_FALSE(simulatorOf(*device)->isOutputOn());
    EXPECT_GE(family().capabilities.watchdogLimit, family().capabilities.commandLimit);
    ASSERT_TRUE(device->command(setPoint));
    bench->clock.advance(family().capabilities.watchdogLimit);
    EXPECT_FALSE(simulatorOf(*device)->isOutputOn());
}

TEST_P(Contract, ADeviceSaysHowItIsStoppedFromOutside)
{
    const Device *device = online();
    ASSERT_NE(device, nullptr);
    const StopScript script = device->stopScript();
    EXPECT_FALSE(script.isEmpty());
    int messages = 0;
    for (const StopStep &step : script.steps) {
        const bool says = step.frame.has_value() || !step.bytes.empty();
        messages += says ? 1 : 0;
        EXPECT_TRUE(says || step.reply.empty()) << "a pause has no answer";
        EXPECT_EQ(step.frame.has_value(), says && device->link().kind() == LinkKind::Can);
        EXPECT_TRUE(step.bytes.empty() || !step.frame.has_value());
        EXPECT_TRUE(step.replyMask.empty() || step.replyMask.size() == step.reply.size());
        EXPECT_TRUE(step.wait >= 1ms && step.wait <= 500ms) << step.wait.count();
        EXPECT_TRUE(step.attempts >= 1 && step.attempts <= 100) << step.attempts;
    }
    EXPECT_EQ(messages > 0, !script.isEmpty());
}

TEST_P(Contract, EveryTimeOutSurfacesWhenTheUnitIsWithoutPower)
{
    Device *device = online();
    ASSERT_NE(device, nullptr);
    simulatorOf(*device)->setPowered(false);
    const auto indices = readable(*device);
    if (!indices.empty()) {
        const auto raw = run(bench->clock, device->read(indices.front()));
        ASSERT_FALSE(raw);
        EXPECT_EQ(raw.error().fault, Fault::Timeout);
    }
    for (std::uint16_t i = 0; indices.empty() && i < 1; ++i) {
        const auto raw = run(bench->clock, device->write({i}, 1));
        ASSERT_FALSE(raw);
        EXPECT_EQ(raw.error().fault, Fault::Timeout);
    }
    const auto refreshed = run(bench->clock, device->refresh());
    ASSERT_FALSE(refreshed);
    EXPECT_EQ(refreshed.error().fault, Fault::Timeout);
    bench->clock.advance(1s);
    EXPECT_FALSE(device->liveness().heard);
}

/// Who listens to what comes over a link.
std::size_t listenersOf(Link &link)
{
    switch (link.kind()) {
    case LinkKind::Can: return static_cast<CanLink &>(link).received().size();
    case LinkKind::Serial: return static_cast<SerialLink &>(link).received().size();
    case LinkKind::Spi: return link.traffic().size();
    }
    return 0;
}

/// Starts what `make` makes again and again, destroys it one clock step later each time, until it runs to its end.
template <class T> void cancelEverywhere(SimulatedSession &bench, const std::function<Task<T>()> &make, int mostSteps)
{
    bench.clock.advance(3s);
    const std::size_t listeners = listenersOf(*bench.link);
    int steps = 0;
    for (;; ++steps) {
        ASSERT_LT(steps, mostSteps);
        Task<T> task = make();
        task.start();
        for (int i = 0; i < steps && !task.isFinished(); ++i)
            ASSERT_TRUE(bench.clock.step());
        const bool finished = task.isFinished();
        task.cancel();
        EXPECT_EQ(listenersOf(*bench.link), listeners) << "after " << steps << " steps";
        if (finished)
            break;
        bench.clock.advance(1s);
    }
    EXPECT_GT(steps, 1);
}

TEST_P(Contract, CancellingAScanAtEveryStepLeavesNoListener)
{
    auto &link = *bench->link;
    struct Sink final : ScanSink {
        void found(const Identity &) override { }
        void progress(const Message &, int, int) override { }
    } sink;
    cancelEverywhere<void>(
        *bench, [&] { return family().scan(link, bench->clock, sink); }, 5000);
}

TEST_P(Contract, CancellingATransferAtEveryStepLeavesNoListener)
{
    Device *device = online();
    ASSERT_NE(device, nullptr);
    auto indices = readable(*device);
    indices.resize(std::min<std::size_t>(indices.size(), 2));
    NoProgress progress;
    const std::vector<ParameterChange> changes{{{0}, 1}, {{1}, 1}};
    cancelEverywhere<std::vector<TransferOutcome>>(
        *bench,
        [&] {
            return indices.empty() ? writeParameters(*device, changes, progress)
                                   : readParameters(*device, indices, progress);
        },
        5000);
}

TEST_P(Contract, KeysAndChannelsFollowTheNamingOfTheProduct)
{
    for (const Parameter &parameter : family().parameters) {
        EXPECT_EQ(parameter.key.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789._"), std::string_view::npos)
            << parameter.key;
        EXPECT_FALSE(parameter.help.empty()) << parameter.key;
    }
    EXPECT_FALSE(family().channels.empty());
    std::set<std::string_view> faults;
    for (const FaultRow &fault : family().faults) {
        EXPECT_FALSE(fault.key.empty() || fault.label.empty());
        EXPECT_TRUE(faults.insert(fault.key).second) << fault.key;
    }
}

INSTANTIATE_TEST_SUITE_P(Registry, Contract, testing::ValuesIn(families().begin(), families().end()),
    [](const auto &entry) { return std::string(entry.param->key); });

} // namespace
} // namespace mb
