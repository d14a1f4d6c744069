// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/engine/trials.h"

#include "experiment/verdict.h"
#include "model/family.h"
#include "settings/settingslog.h"
#include "settings/writing.h"
#include "tuning/autotune.h"

#include <algorithm>
#include <tuple>

namespace mb {
namespace {

using tuning::Trial;

/// The interruption lives as long as the story that looks at it: what is declared last is gone first.
template <class T> Task<T> keeping(std::shared_ptr<tuning::Interruption> interruption, Task<T> story)
{
    const auto held = std::move(interruption);
    auto running = std::move(story);
    co_return co_await std::move(running).attempt();
}

/// With a snapshot before it, and what it has replaced in the history.
Task<tuning::TuneReport> tuneKept(Device &device, SetPointStream &stream, tuning::TunePlan plan,
    tuning::ExperimentSurroundings around, const ParameterJobs &parameters)
{
    ProgressLines warnings(around.warn);
    if (tuning::writesGains(device, plan))
        around.before = [&] { return parameters.keepBefore(device, settings::Occasion::Tuning, warnings); };
    auto story = tuning::autotune(device, stream, std::move(plan), std::move(around));
    tuning::TuneReport report = co_await std::move(story);
    auto *const log = parameters.log();
    if (log && (report.result == tuning::TuneResult::Kept || !report.notPutBack.empty()))
        (void)co_await settings::keepReplaced(device, report.before, settings::Origin::Tuning, *log).attempt();
    co_return report;
}

/// What is in force afterwards, and was not before, is in the history.
Task<Trial> tryKept(Device &device, std::vector<ParameterChange> gains, settings::SettingsLog *log, Task<Trial> story)
{
    settings::Numbers before;
    if (log && !gains.empty()) {
        before = co_await settings::numbersBefore(device, std::move(gains));
    }
    Result<Trial> trial = co_await std::move(story).attempt();
    if (!before.empty())
        (void)co_await settings::keepReplaced(device, std::move(before), settings::Origin::Window, *log).attempt();
    co_return trial;
}

Task<void> runOf(
    Device &device, SetPointStream &stream, const Experiment &experiment, ExperimentOptions options, Progress &progress)
{
    const ExperimentReport report = co_await experiment.run(device, stream, options, progress);
    progress.log(Severity::Good, report.sentence);
    co_return {};
}

/// What somebody waits for who does not see the table.
Message resultOf(const Trial &trial)
{
    const auto &[overshoot, settle] = std::tie(trial.metrics.overshoot, trial.metrics.settle);
    if (Message shortfall = tuning::shortfallOf(trial.metrics); !shortfall.empty())
        return shortfall;
    if (!overshoot)
        return say("done");
    const MessageNumber percent{100.0 * *overshoot, 1, "%"};
    return settle ? say("overshoot %1, settled in %2", percent, MessageNumber{1000.0 * *settle, 0, "ms"})
                  : say("overshoot %1, not settled", percent);
}

Message nameOf(const Trial &trial)
{
    return trial.number ? say("trial #%1", *trial.number) : say("a trial that is not kept");
}

} // namespace

void Trials::carryOut(const orders::RunExperiment &order, const Finished &finished)
{
    Device *device = m_context.session.find(order.device);
    if (!device)
        return finished(fail(Fault::Timeout, say("the device is gone")));
    const std::span<const Experiment> known = device->family().experiments;
    const auto found = std::ranges::find(known, order.key, &Experiment::key);
    if (found == known.end())
        return finished(fail(Fault::Unsupported, say("this device has no experiment '%1'", order.key)));
    SetPointStream &stream = m_context.session.stream(*device);
    if (stream.isRunning())
        return finished(fail(Fault::Unsafe, say("stop the motor before an experiment begins")));
    stream.renew(); // by this order
    m_context.operations.begin(
        order.device, {Message::label(found->title), OperationKind::FamilyExperiment},
        [&stream, &experiment = *found, options = order.options](
            Device &unit, Progress &progress) { return runOf(unit, stream, experiment, options, progress); },
        finished);
}

/// An operation that moves the device by experiments: what is notable in it is told, what it interrupts puts back what it changed.
template <class T> void Trials::run(DeviceId id, const Story<T> &story, const std::function<void(Result<T>)> &finished)
{
    const Finished refused = [finished](const Result<void> &result) { finished(fail(result.error())); };
    if (Device *device = m_context.session.find(id); device && m_context.session.stream(*device).isRunning())
        return refused(fail(Fault::Unsafe, say("stop the motor before an experiment begins")));
    if (auto same = m_context.operations.checkRecognised(id); !same)
        return refused(same);
    const auto interruption = std::make_shared<tuning::Interruption>();
    Operations::Job *const job = m_context.operations.begin<T>(
        id, {story.title, OperationKind::Trial},
        [this, id, run = story.run, interruption](Device &device, Progress &progress) {
            m_context.session.stream(device).renew(); // by this order
            return keeping(
                interruption, run(device, m_context.session.stream(device), surroundings(id, progress, *interruption)));
        },
        [this, notableOf = story.notableOf, finished](Operations::Job &done, Result<T> result) {
            ended(done);
            const Verdict told = result ? notableOf(*result)
                                        : Verdict{Severity::Danger, say("no experiment: %1", result.error().message())};
            m_context.log.tell(told.severity, done.device, told.text);
            finished(std::move(result));
        },
        refused);
    if (job)
        job->interruption = interruption;
}

void Trials::carryOut(const orders::RunTrial &order, const std::function<void(Result<Trial>)> &finished)
{
    Story<Trial> story;
    story.title = say("Experiment");
    story.run = [this, plan = order.plan, measured = order.measured](
                    Device &device, SetPointStream &stream, tuning::ExperimentSurroundings around) {
        around.measured = measured;
        return tryKept(
            device, plan.gains, m_parameters.log(), tuning::runExperiment(device, stream, plan, std::move(around)));
    };
    story.notableOf = [](const Trial &trial) {
        if (trial.reason == tuning::EndReason::Done && !trial.notPutBack.empty())
            return Verdict{
                Severity::Caution, say("%1: the gains were not put back: %2", nameOf(trial), trial.notPutBack)};
        if (trial.reason == tuning::EndReason::Done)
            return Verdict{Severity::Good, say("%1: %2", nameOf(trial), resultOf(trial))};
        return Verdict{Severity::Danger,
            say("%1 was stopped: %2, %3", nameOf(trial), Message::label(tuning::endingLabel(trial.reason)),
                trial.detail)};
    };
    run(order.device, story, finished);
}

void Trials::carryOut(const orders::RunTuning &order, const std::function<void(Result<tuning::TuneReport>)> &finished)
{
    using tuning::TuneResult;
    Story<tuning::TuneReport> story;
    story.title = say("Autotune");
    story.run
        = [this, plan = order.plan](Device &device, SetPointStream &stream, tuning::ExperimentSurroundings around) {
              return tuneKept(device, stream, plan, std::move(around), m_parameters);
          };
    story.notableOf = [](const tuning::TuneReport &report) {
        const bool good = report.result == TuneResult::Kept || report.result == TuneResult::Proposed;
        return Verdict{good ? Severity::Good : Severity::Danger,
            say("tuning %1: %2", Message::label(toString(report.result)), report.evidence)};
    };
    run(order.device, story, finished);
}

void Trials::carryOut(
    const orders::RunSweep &order, const std::function<void(Result<tuning::FrequencyResponse>)> &finished)
{
    Story<tuning::FrequencyResponse> story;
    story.title = say("Frequency response");
    story.run = [plan = order.plan, plant = order.plant](
                    Device &device, SetPointStream &stream, tuning::ExperimentSurroundings around) {
        return tuning::measureFrequencyResponse(device, stream, plan, plant, std::move(around));
    };
    story.notableOf = [](const tuning::FrequencyResponse &response) {
        return Verdict{response.stopReason == tuning::EndReason::None ? Severity::Good : Severity::Danger,
            say("frequency response: %1", response.evidence)};
    };
    run(order.device, story, finished);
}

/// What an experiment says goes into the log when it says it.
tuning::ExperimentSurroundings Trials::surroundings(
    DeviceId device, Progress &progress, tuning::Interruption &interruption)
{
    tuning::ExperimentSurroundings around;
    around.journal = m_journal;
    around.directions = &m_directions;
    around.interruption = &interruption;
    const auto teller = [this, device, &progress](Severity severity) {
        return [this, device, &progress, severity](const Message &text) {
            progress.log(severity, text);
            m_context.log.tell(severity, device, text);
        };
    };
    around.note = teller(Severity::Info);
    around.warn = teller(Severity::Caution);
    return around;
}

void Trials::ended(Operations::Job &job)
{
    job.interruption.reset();
    m_rates.restore(job.device);
    m_owed.ended(job.device);
}

} // namespace mb
