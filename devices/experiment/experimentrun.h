// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/noncopyable.h"
#include "experiment/direction.h"
#include "experiment/experimentmotion.h"
#include "experiment/raisedrates.h"

namespace mb::tuning {

/// The stages of one experiment and what they share. Lives in the frame of runExperiment(); its tasks end before it.
class ExperimentRun : NonCopyable {
public:
    ExperimentRun(Device &device, SetPointStream &stream, ExperimentPlan plan, ExperimentSurroundings surroundings);
    ~ExperimentRun();

    /// Reads what it must know and refuses what it must; nothing is changed.
    [[nodiscard]] Task<void> prepare();
    /// Rates, gains, direction, motion. Fails where it could not begin.
    [[nodiscard]] Task<void> perform();
    /// Stop, gains and rates back, the trial complete; whatever happened before.
    [[nodiscard]] Task<void> conclude(std::optional<Error> error);
    [[nodiscard]] Trial takeTrial() { return std::move(m_trial); }
    /// The motor was told to move.
    [[nodiscard]] bool hasMoved() const { return m_moved; }
    /// What ended it is the result of a trial: the user did, or the motor was told to move.
    [[nodiscard]] bool hasResult() const { return m_moved || m_user.isRequested(); }

private:
    /// Counts.
    struct Start {
        double origin = 0.0; ///< from where its travel is counted
        double gone = 0.0;   ///< from there to where it stands
    };
    [[nodiscard]] Task<double> hearPosition();
    [[nodiscard]] Task<void> writeDown();
    [[nodiscard]] Task<void> zero();
    [[nodiscard]] Task<void> findDirection();
    [[nodiscard]] Task<void> releaseKept();
    [[nodiscard]] Task<void> putBack();
    [[nodiscard]] bool isCounted() const; ///< its positions are counted from its start
    /// `inForce`: the gains of the plan are. Before, what is unsafe with those that stand may be safe with them.
    [[nodiscard]] Result<void> checkTargets(bool inForce) const;
    [[nodiscard]] GuardPlan guardPlan() const;
    [[nodiscard]] double rate() const;
    void note(const Message &text) const;
    void classifyEnding(const std::optional<Error> &error);

    Device &m_device;
    SetPointStream &m_stream;
    ExperimentPlan m_plan;
    ExperimentSurroundings m_around;
    Interruptible m_user;
    TrialRecorder m_recorder;
    Trial m_trial;
    ExperimentMotion m_motion;
    Start m_start;
    double m_breakaway = 0.1;
    std::optional<Trip> m_trip;
    std::optional<std::int64_t> m_number;
    std::vector<OwedValue> m_owed;
    bool m_wrote = false;          ///< some of its gains at least
    bool m_inForce = false;        ///< all of them
    bool m_stoppedForZero = false; ///< and nobody knows what became of the order that made its place 0
    bool m_moved = false;
    bool m_concluded = false; ///< the journal has its result
    bool m_stands = true;     ///< the motor was seen to stand after that
    RaisedRates m_rates;
};

} // namespace mb::tuning
