// SPDX-License-Identifier: GPL-3.0-or-later
// A report with all that one can tell: of a drive with tunings, trials, sines and visits, of a board that nobody has tuned, and of a
// unit of a family that this program does not know.
#pragma once

#include "model/family.h"
#include "model/registry.h"
#include "report/report.h"

#include <cmath>

namespace mb::documents {

using namespace tuning;

inline constexpr double spring = 1.7e9; ///< Unix, s

inline const Family *familyOf(std::string_view key)
{
    for (const Family *family : families()) {
        if (family->key == key)
            return family;
    }
    return nullptr;
}

inline Trace approach(double from, double to, double end)
{
    Trace trace;
    for (int i = -5; 0.02 * i < end; ++i)
        trace.add(0.02 * i, i < 0 ? from : to - (to - from) * std::exp(-0.3 * i) * std::cos(0.5 * i));
    return trace;
}

inline KeptTrial stepTrial()
{
    KeptTrial kept;
    kept.number = 12;
    kept.time = spring;
    kept.star = true;
    kept.note = "with the <new> belt";
    Trial &trial = kept.trial;
    trial.number = 12;
    trial.firmware = "1.23";
    trial.simulated = true;
    trial.stimulus = *Stimulus::make(Profile::Step, 0.0, 60'000.0, {}, 0.02);
    trial.repeat = 2;
    trial.holds = {{0.0, 0.8}, {2.0, 2.7}};
    trial.returns = {{0.8, 1.3}};
    trial.gains = {{"slot0.p", 1.165}, {"slot0.i", std::nullopt}, {"slot0.f", 0.25}, {"current-limit", 30.0}};
    trial.envelope = {40'000.0, 80'000.0, 12.5, 0.45};
    trial.metrics.rise = 0.131;
    trial.metrics.overshoot = 0.204;
    trial.metrics.settle = 0.524;
    trial.metrics.sse = -0.0004;
    trial.metrics.peakCurrent = 7.25;
    trial.errors.rise = 0.002;
    trial.flags = {"lost-samples", "saturated"};
    trial.reason = EndReason::Done;
    trial.stopped = true;
    trial.samples = 4711;
    trial.lost = 3;
    trial.signals = {{"velocity", "counts/s", approach(0.0, 60'000.0, 1.3)},
        {"duty", "fraction", approach(0.0, 0.3, 1.3)}, {"current", "A", approach(0.0, 2.5, 1.3)}};
    return kept;
}

/// A motor without friction under a sine of duty.
inline KeptTrial sineTrial(std::int64_t number, double hertz)
{
    KeptTrial kept;
    kept.number = number;
    kept.time = spring + 60.0;
    kept.trial.mode = Mode::Duty;
    kept.trial.reason = EndReason::Done;
    kept.trial.stimulus = *Stimulus::make(Profile::Sine, 0.15, 0.35, 6.0 / hertz, 0.001);
    Trace position;
    Trace velocity;
    Trace duty;
    double speed = 105'000.0 * 0.25;
    double place = 0.0;
    for (int i = -1000; i < static_cast<int>(6.0 / hertz / 0.0005); ++i) {
        const double push = i < 0 ? 0.25 : kept.trial.stimulus.at(0.0005 * i);
        if (i % 10 == 0) {
            position.add(0.0005 * i, std::floor(place));
            duty.add(0.0005 * i, push);
            if (i % 100 == 0)
                velocity.add(0.0005 * i, std::round(speed));
        }
        speed += 0.0005 / 0.168 * (105'000.0 * push - speed);
        place += 0.0005 * speed;
    }
    kept.trial.signals
        = {{"position", "counts", position}, {"velocity", "counts/s", velocity}, {"duty", "fraction", duty}};
    return kept;
}

/// A position that follows a ramp, and was stopped.
inline KeptTrial rampTrial()
{
    KeptTrial kept;
    kept.number = 14;
    kept.time = spring + 90.0;
    kept.trial.mode = Mode::Position;
    kept.trial.slot = 1;
    kept.trial.stimulus = *Stimulus::make(Profile::Ramp, -200.0, 1000.0, 1.0, 0.02);
    kept.trial.reason = EndReason::Unknown;
    kept.trial.detail = say("the motor is %1 counts behind", "812");
    kept.trial.metrics.sse = 0.031;
    kept.trial.gains = {{"slot1.p", 0.0}, {"not-in-the-table", 2.0}};
    Trace position;
    for (int i = -3; i < 20; ++i)
        position.add(0.05 * i, i == 7 ? std::nan("") : -200.0 + 40.0 * std::max(i, 0));
    kept.trial.signals = {{"position", "counts", position}};
    return kept;
}

inline KeptTuning velocityTuning()
{
    KeptTuning kept;
    kept.number = 1;
    kept.time = spring + 30.0;
    TuneReport &report = kept.report;
    report.result = TuneResult::Kept;
    report.simulated = true;
    report.firmware = "1.23";
    report.evidence = say("the steps in both directions did what was predicted");
    report.plant = {105'000.0, 0.168, 0.052, 0.021};
    report.motor.emplace();
    report.motor->pushes.tauError = 0.0031;
    report.motor->pushes.delayError = 0.0007;
    report.motor->line.gainError = 120.0;
    report.motor->line.frictionError = 0.0011;
    report.motor->line.offset = 0.0123;
    report.motor->line.offsetError = 0.0045;
    report.motor->line.forward = 106'000.0;
    report.motor->line.reverse = 103'000.0;
    report.motor->restNoise = 0.37;
    report.motor->latency = 0.0137;
    report.motor->filter = VelocityFilter{VelocityFilter::Kind::Rolling, 0.064, 0.032, 0.002};
    report.profile = ProfileLimits{82'000.0, 491'000.0};
    report.gates = {{"fit", say("what the fit leaves is 1.4 times"), true, {}},
        {"friction", say("it takes 2.1 %"), true, {}, true}, {"resolution", say("4 counts a pass"), false, {}}};
    report.proposed.rows = {{"slot0.p", 38083, 0.5811}, {"slot0.i", 12, 0.00018}, {"slot0.f", 0, 0.0}};
    report.proposed.made = {1e-5, 6e-5, 0.0, 0.0};
    Proposal calm;
    calm.aim = Aim::Calm;
    calm.design.response = 0.9;
    Proposal normal;
    normal.gains.made = report.proposed.made;
    normal.design.response = 0.183;
    normal.design.bounds = {"delay", "margin"};
    normal.step = 30'000.0;
    normal.margins.ms = 1.44;
    normal.predicted = predictStep(Mode::Velocity, report.plant, normal.gains.made, 0.0, normal.step, 1.0, 1.0, 0.02);
    report.proposals = {calm, normal};
    report.design = normal.design;
    report.step = normal.step;
    report.before = {{"slot0.p", 1.165}, {"slot0.i", std::nullopt}};
    report.margins = Margins{1.44, 3.9, 67.0, 4.0};
    report.predicted.emplace();
    report.predicted->measured = approach(0.0, 30'000.0, 1.0);
    report.predicted->shape = normal.predicted.shape;
    report.predicted->metrics.settle = 0.15;
    report.measured.overshoot = 0.013;
    report.measured.settle = 0.161;
    report.proof = {stepTrial().trial, stepTrial().trial};
    report.proof.back().stimulus.to = -60'000.0;
    report.proof.back().signals = {{"velocity", "counts/s", approach(0.0, -58'000.0, 1.3)}};
    report.seconds = 41.27;
    report.trials = {10, 11, 12};
    return kept;
}

inline KeptTuning currentTuning()
{
    KeptTuning kept;
    kept.time = spring + 20.0;
    kept.report.loop = Mode::Current;
    kept.report.result = TuneResult::Refused;
    kept.report.evidence = say("the winding could not be told");
    kept.report.plant.gain = 20.0;
    kept.report.plant.tau = 0.001;
    return kept;
}

inline service::Visit visitAt(double time, service::Outcome outcome, double friction)
{
    service::Visit visit;
    visit.time = time;
    visit.recipe = "drive-base <rev C>";
    visit.station = "bench 1";
    visit.person = "anna";
    visit.serial = "2103343A7B2E";
    visit.from = "1.23";
    visit.outcome = outcome;
    visit.test = {{"friction", friction, 0.1, 0.4, friction <= 0.4}, {"gain", 4000.0 + 1000.0 * friction, {}, 9000.0},
        {"resistance", std::nullopt, 0.02, 0.5, false}, {"encoder", 1.0, 1.0, 1.0}, {"overshoot", 0.1, {}, 0.2}};
    return visit;
}

inline std::vector<service::Visit> visits()
{
    service::Visit refused = visitAt(spring - 3e6, service::Outcome::Refused, 0.0);
    refused.test.clear();
    refused.cause = say("another program drives it");
    service::Visit passed = visitAt(spring - 2e6, service::Outcome::Passed, 0.24);
    passed.to = "1.25";
    passed.note = "bearing <greased>";
    service::Visit failed = visitAt(spring - 1e6, service::Outcome::Failed, 0.61);
    failed.cause = say("friction is %1", "0.61");
    failed.remedy = say("free the shaft");
    failed.note = "squeaks";
    failed.number = 36;
    failed.parameters = 55;
    failed.trial = 12;
    return {refused, passed, failed};
}

inline ReportUnit drive()
{
    ReportUnit unit;
    unit.family = familyOf("dmc60c");
    unit.identity.family = "dmc60c";
    unit.identity.address = 7;
    unit.identity.serial = "210334ABCDEF";
    unit.identity.name = "lift & tilt";
    unit.identity.firmware = "1.23";
    unit.identity.bootloader = "1.0";
    unit.identity.descriptors = {{"board_revision", "C"}, {"empty", ""}, {"told", "210334ABCDEF"}};
    unit.simulated = true;
    unit.selector = "sim:can/dmc60c:7";
    unit.tunings = {currentTuning(), velocityTuning()};
    unit.trials = {rampTrial(), stepTrial(), sineTrial(15, 2.0)};
    unit.sines = {sineTrial(16, 2.0), sineTrial(17, 0.5), sineTrial(18, 24.0)};
    for (int number = 0; number < 3; ++number) {
        unit.history.push_back(number % 2 == 0 ? stepTrial() : rampTrial());
        unit.history.back().number = 11 + number; // 10 was forgotten
    }
    unit.visits = visits();
    std::size_t place = 0;
    for (const Parameter &parameter : unit.family->parameters)
        unit.parameters.push_back(
            {std::llround(parameter.fallback * parameter.one) + (place++ % 3 == 0 ? 1 : 0), ParameterState::Stored});
    unit.parameters[1].state = ParameterState::Failed;
    unit.parameters[3].raw.reset();
    return unit;
}

inline ReportUnit board()
{
    ReportUnit unit;
    unit.family = familyOf("quadquad2drv");
    unit.identity.family = "quadquad2drv";
    unit.identity.address = 2;
    unit.unit = "place spi0 quadquad2drv:0";
    unit.trials = {stepTrial()};
    unit.trials.front().trial.axis = 3;
    unit.trials.front().trial.firmware.clear();
    unit.trials.front().trial.reason = EndReason::None;
    unit.trials.front().trial.stopped = false;
    unit.trials.front().trial.signals.clear();
    return unit;
}

inline Report wholeReport()
{
    Report report;
    report.time = spring;
    report.program = "MotorBench 0.1.0";
    ReportUnit stranger;
    stranger.identity.family = "of a newer version";
    stranger.identity.address = 9;
    stranger.parameters = {{1, ParameterState::Stored}};
    report.units = {drive(), board(), stranger};
    return report;
}

} // namespace mb::documents
