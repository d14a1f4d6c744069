// SPDX-License-Identifier: GPL-3.0-or-later
// Experiments on loops, and what they owe to units.
#include "app/enginework.h"
#include "model/family.h"
#include "settings/snapshots.h"
#include "settings/writing.h"
#include "tuning/owedgains.h"
#include "tuning/verdict.h"

#include <algorithm>

namespace mb {
namespace {

using tuning::Trial;

/// The interruption lives as long as the story that looks at it.
template <class T> Task<T> keeping(std::shared_ptr<tuning::Interruption> interruption, Task<T> story)
{
    const auto held = std::move(interruption);
    co_return co_await std::move(story).attempt();
}

Task<void> settle(tuning::ExperimentJournal &journal, std::int64_t trial)
{
    auto settling = journal.settle(trial);
    co_await std::move(settling);
    co_return {};
}

/// With a snapshot before it, and what it has replaced in the history.
Task<tuning::TuneReport> tuneKept(
    Device &device, tuning::TunePlan plan, settings::SettingsLog *log, Task<tuning::TuneReport> story)
{
    if (log && !plan.propose) {
        NoProgress unseen;
        auto taking = settings::takeSnapshot(device, settings::Occasion::Tuning, {}, *log, unseen);
        (void)co_await std::move(taking).attempt();
    }
    tuning::TuneReport report = co_await std::move(story);
    if (log && report.result == tuning::TuneResult::Kept) {
        auto noting = settings::keepReplaced(device, report.before, settings::Origin::Tuning, *log);
        (void)co_await std::move(noting).attempt();
    }
    co_return report;
}

Message nameOf(const Trial &trial)
{
    return trial.number ? say("trial #%1", *trial.number) : say("a trial that is not kept");
}

} // namespace

/// An operation that moves the device by experiments: what is notable in it is told, what it interrupts puts back what it changed.
template <class T>
void EngineCore::runMoving(DeviceId id, const Message &title, const MovingStory<T> &story,
    const std::function<Notable(const T &)> &notableOf, const std::function<void(Result<T>)> &finished)
{
    const Finished refused = [finished](const Result<void> &result) {
        if (finished)
            finished(fail(result.error()));
    };
    if (Device *device = m_session.find(id); device && m_session.stream(*device).isRunning())
        return answer(refused, fail(Fault::Unsafe, say("stop the motor before an experiment begins")));
    const auto interruption = std::make_shared<tuning::Interruption>();
    const auto make = [this, story, interruption](Device &device, Progress &progress) {
        return keeping(interruption, story(device, m_session.stream(device), surroundings(progress, *interruption)));
    };
    Running *const running = begin<T>(
        id, title, make,
        [this, notableOf, finished](Running &done, Result<T> result) {
            experimentEnded(done);
            if (const Device *device = m_session.find(done.device)) {
                const Notable told = result
                    ? notableOf(*result)
                    : Notable{Severity::Danger, say("no experiment: %1", result.error().message())};
                notice(told.severity, labelOf(*device), told.text);
            }
            if (finished)
                finished(std::move(result));
        },
        refused);
    if (running)
        running->interruption = interruption;
}

void EngineCore::runTrial(
    DeviceId id, const tuning::ExperimentPlan &plan, const TrialMeasured &measured, const TrialFinished &finished)
{
    runMoving<Trial>(
        id, say("Experiment"),
        [plan, measured](Device &device, SetPointStream &stream, tuning::ExperimentSurroundings around) {
            around.measured = measured;
            return tuning::runExperiment(device, stream, plan, std::move(around));
        },
        [](const Trial &trial) {
            return trial.reason == "done"
                ? Notable{Severity::Good, say("%1 is done", nameOf(trial))}
                : Notable{Severity::Danger, say("%1 was stopped: %2, %3", nameOf(trial), trial.reason, trial.detail)};
        },
        finished);
}

void EngineCore::runTuning(DeviceId id, const tuning::TunePlan &plan, const TuningFinished &finished)
{
    using tuning::TuneResult;
    runMoving<tuning::TuneReport>(
        id, say("Autotune"),
        [this, plan](Device &device, SetPointStream &stream, tuning::ExperimentSurroundings around) {
            return tuneKept(device, plan, m_settingsLog, tuning::autotune(device, stream, plan, std::move(around)));
        },
        [](const tuning::TuneReport &report) {
            const bool good = report.result == TuneResult::Kept || report.result == TuneResult::Proposed;
            return Notable{good ? Severity::Good : Severity::Danger,
                say("tuning %1: %2", Message::label(toString(report.result)), report.evidence)};
        },
        finished);
}

void EngineCore::runSweep(
    DeviceId id, const tuning::SweepPlan &plan, const tuning::PlantModel &plant, const SweepFinished &finished)
{
    runMoving<tuning::FrequencyResponse>(
        id, say("Frequency response"),
        [plan, plant](Device &device, SetPointStream &stream, tuning::ExperimentSurroundings around) {
            return tuning::measureFrequencyResponse(device, stream, plan, plant, std::move(around));
        },
        [](const tuning::FrequencyResponse &response) {
            return Notable{response.stopReason.empty() ? Severity::Good : Severity::Danger,
                say("frequency response: %1", response.evidence)};
        },
        finished);
}

tuning::ExperimentSurroundings EngineCore::surroundings(Progress &progress, tuning::Interruption &interruption)
{
    tuning::ExperimentSurroundings around;
    around.journal = m_journal;
    around.directions = &m_directions;
    around.interruption = &interruption;
    around.note = [&progress](const Message &text) { progress.log(Severity::Caution, text); };
    return around;
}

void EngineCore::experimentEnded(Running &running)
{
    running.interruption.reset();
    wishAgain(running.device);
    lookAgain(running.device);
    if (const Device *device = m_session.find(running.device)) {
        for (const LogLine &line : running.operation->status().log)
            notice(line.severity, labelOf(*device), line.text);
    }
}

/// Each stops in this call, and then puts back what it has changed.
void EngineCore::interruptTrials(std::optional<DeviceId> id)
{
    for (Running &running : m_operations) {
        if (running.interruption && (!id || running.device == *id))
            running.interruption->interrupt();
    }
}

/// What a page wished for before the trial had its own rates.
void EngineCore::wishAgain(DeviceId id)
{
    for (const auto &[place, hertz] : std::map(m_wished)) {
        if (place.first == id && hertz > 0.0)
            setRate(id, place.second, hertz);
    }
}

/// What was put back into a unit that stores later is proved then.
void EngineCore::lookAgain(DeviceId id)
{
    if (const Device *device = m_session.find(id); device && tuning::storesLater(*device))
        m_lookAgain[id] = m_clock.now() + tuning::storingTime(*device);
}

/// Once for each unit that is there, when it has told who it is. Without a word to those who are owed nothing.
void EngineCore::lookForOwed()
{
    for (const auto &[id, at] : m_lookAgain) {
        if (m_clock.now() > at)
            m_lookedFor.erase(id);
    }
    std::erase_if(m_lookAgain, [this](const auto &entry) { return m_clock.now() > entry.second; });
    for (Device *device : m_session.devices()) {
        const DeviceId id = m_session.idOf(*device);
        const bool ready = m_journal && device->family().trials && device->liveness().heard
            && device->identity().state == DeviceState::Online && !device->link().address().isRecording();
        const std::string unit = tuning::unitOf(*device);
        if (!ready || m_lookedFor[id] == unit)
            continue;
        m_lookedFor[id] = unit;
        m_asking.spawn<std::vector<tuning::OwedGains>>(
            m_journal->owedTo(unit), [this, id, unit](const Result<std::vector<tuning::OwedGains>> &owed) {
                if (owed && !owed->empty())
                    compareOwed(id, unit);
            });
    }
    std::erase_if(m_owed, [this](const auto &entry) { return !m_session.find(entry.first); });
    std::erase_if(m_lookedFor, [this](const auto &entry) { return !m_session.find(entry.first); });
}

/// With what the unit has; later, when it is busy now.
void EngineCore::compareOwed(DeviceId id, const std::string &unit)
{
    begin<std::vector<tuning::OwedGains>>(
        id, say("Look for gains that are owed"),
        [this](Device &device, Progress &) { return tuning::lookForOwed(device, *m_journal); },
        [this, id](Running &, const Result<std::vector<tuning::OwedGains>> &owed) {
            if (owed && !owed->empty())
                m_owed[id] = *owed;
            else if (!owed)
                m_lookedFor.erase(id);
            lookAgain(id); // until nothing is owed
        },
        [this, id, unit](const Result<void> &) {
            if (m_lookedFor[id] == unit)
                m_lookedFor.erase(id);
        });
}

void EngineCore::endOwed(DeviceId id, std::int64_t trial)
{
    std::erase_if(m_owed[id], [trial](const tuning::OwedGains &owed) { return owed.trial == trial; });
    if (m_owed[id].empty())
        m_owed.erase(id);
    touch();
}

void EngineCore::payGains(DeviceId id, std::int64_t trial, Finished finished)
{
    const auto &all = m_owed[id];
    const auto found
        = std::find_if(all.begin(), all.end(), [trial](const tuning::OwedGains &owed) { return owed.trial == trial; });
    if (found == all.end())
        return answer(finished, fail(Fault::OutOfRange, say("this trial owes nothing to the unit")));
    beginSimple(
        id, say("Put gains back"),
        [this, owed = *found](Device &device, Progress &) { return tuning::payOwed(device, *m_journal, owed); },
        [this, id, trial, finished](const Result<void> &result) {
            if (result) {
                endOwed(id, trial);
                lookAgain(id);
            }
            if (const Device *device = m_session.find(id); device && result)
                notice(
                    Severity::Good, labelOf(*device), say("the gains that trial #%1 had changed are put back", trial));
            answer(finished, result);
        });
}

void EngineCore::dismissGains(DeviceId id, std::int64_t trial, Finished finished)
{
    if (!m_journal)
        return answer(finished, {});
    beginSimple(
        id, say("Keep the gains of a trial"), [this, trial](Device &, Progress &) { return settle(*m_journal, trial); },
        [this, id, trial, finished](const Result<void> &result) {
            if (result)
                endOwed(id, trial);
            answer(finished, result);
        });
}

} // namespace mb
