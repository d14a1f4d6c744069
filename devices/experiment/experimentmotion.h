// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/experimentplan.h"
#include "experiment/trialrecorder.h"

#include <utility>
#include <vector>

namespace mb::tuning {

constexpr double stopLag = 0.2; ///< s, in which a motor is taken to stop, where a push is to end within its reach

/// What the motor does in an experiment: it goes to X, follows the stimulus and comes back, as often as planned. Ends early where a guard,
/// the stream or somebody ends it. All that it is given outlives it; its task ends before it.
class ExperimentMotion {
public:
    /// From an edge to its end.
    using Hold = std::pair<Instant, Instant>;

    ExperimentMotion(Device &device, SetPointStream &stream, const ExperimentPlan &plan,
        const ExperimentSurroundings &surroundings, TrialRecorder &recorder, Trial &trial);

    /// Under `guards`, of samples `period` s apart; stops the motor afterwards. Takes the stimulus from the trial, and leaves there
    /// the one that was followed. Fails where the motor may not be driven so.
    [[nodiscard]] Task<void> run(GuardPlan guards, double period);
    /// All repeats were done, and nobody had ended them by then.
    [[nodiscard]] bool isCompleted() const { return m_completed; }
    /// X was not reached in time, so the motor was stopped and nothing followed.
    [[nodiscard]] const std::optional<Trip> &unreached() const { return m_unreached; }
    /// At most, from its beginning.
    [[nodiscard]] Duration longest() const;
    [[nodiscard]] SetPoint setPointAt(double target) const;
    /// Of each step to Y.
    [[nodiscard]] const std::vector<Hold> &holds() const { return m_holds; }
    /// Of each way back.
    [[nodiscard]] const std::vector<Hold> &returns() const { return m_returns; }

private:
    [[nodiscard]] Task<void> goTo(double target);
    [[nodiscard]] Task<void> followOnce(double dither);
    [[nodiscard]] Task<void> followProfile(Instant begin, Instant end);
    [[nodiscard]] Task<void> swing(Instant end);
    [[nodiscard]] Task<void> comeBack();
    [[nodiscard]] bool beginsHere();
    [[nodiscard]] bool hasGoneFar(double from) const;
    [[nodiscard]] bool hasReturned(Instant since) const;
    [[nodiscard]] double restWidth() const;
    /// Something has ended the motion.
    [[nodiscard]] bool isOver() const { return m_recorder.trip() || !m_stream.isRunning(); }
    void setTarget(double target);
    void keepHolds(Instant begin, Instant back);
    void tellMeasured() const;

    Device &m_device;
    SetPointStream &m_stream;
    const ExperimentPlan &m_plan;
    const ExperimentSurroundings &m_around;
    TrialRecorder &m_recorder;
    Trial &m_trial;
    const Duration m_beat; ///< of the device's set-points
    double m_origin = 0.0; ///< counts
    bool m_completed = false;
    std::optional<Trip> m_unreached;
    std::vector<Hold> m_holds;
    std::vector<Hold> m_returns;
};

} // namespace mb::tuning
