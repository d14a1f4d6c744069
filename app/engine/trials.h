// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/engine/owedbook.h"
#include "app/engine/parameterjobs.h"
#include "app/engine/rates.h"
#include "experiment/experiment.h"

namespace mb {

/// Experiments that move a motor, and put back what they changed whatever ends them. Engine thread.
class Trials {
public:
    Trials(const EngineContext &context, const ParameterJobs &parameters, OwedBook &owed, Rates &rates)
        : m_context(context)
        , m_parameters(parameters)
        , m_owed(owed)
        , m_rates(rates)
    {
    }

    /// From now on trials are kept, and what they change is written down first. The journal outlives this.
    void setJournal(tuning::ExperimentJournal *journal) { m_journal = journal; }
    /// A device that fell silent may come back with other wires: its direction is found out again.
    void forgetDirection(const Device &device) { m_directions.forget(device.selector()); }

    void carryOut(const orders::RunExperiment &order, const Finished &finished);
    void carryOut(const orders::RunTrial &order, const std::function<void(Result<tuning::Trial>)> &finished);
    void carryOut(const orders::RunTuning &order, const std::function<void(Result<tuning::TuneReport>)> &finished);
    void carryOut(
        const orders::RunSweep &order, const std::function<void(Result<tuning::FrequencyResponse>)> &finished);

private:
    /// What is told of an experiment that has ended.
    struct Verdict {
        Severity severity;
        Message text;
    };
    template <class T> struct Story {
        Message title;
        std::function<Task<T>(Device &, SetPointStream &, tuning::ExperimentSurroundings)> run;
        std::function<Verdict(const T &)> notableOf;
    };
    template <class T> void run(DeviceId device, const Story<T> &story, const std::function<void(Result<T>)> &finished);
    [[nodiscard]] tuning::ExperimentSurroundings surroundings(
        DeviceId device, Progress &progress, tuning::Interruption &interruption);
    void ended(Operations::Job &job);

    EngineContext m_context;
    const ParameterJobs &m_parameters;
    OwedBook &m_owed;
    Rates &m_rates;
    tuning::ExperimentJournal *m_journal = nullptr;
    tuning::DirectionBook m_directions;
};

} // namespace mb
