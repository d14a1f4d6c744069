// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/autotune.h"

namespace mb::tuning {

/// The stages of one tuning and what they share. Lives in the frame of autotune().
class AutotuneRun {
public:
    AutotuneRun(Device &device, SetPointStream &stream, TunePlan plan, ExperimentSurroundings surroundings);

    /// Pushes that grow until the motor turns: how strong and how long the others are.
    [[nodiscard]] Task<void> probe();
    /// Pushes of two sizes, both ways.
    [[nodiscard]] Task<void> push();
    /// The model and its gates; no motion.
    [[nodiscard]] Result<void> identifyMotor();
    /// Takes the model that the plan brings, and where the motor stands now; no motion.
    [[nodiscard]] Task<void> recall();
    /// Gains, rounded to the device's, and what they will do; no motion.
    [[nodiscard]] Result<void> propose();
    /// Steps both ways with the proposal in force.
    [[nodiscard]] Task<void> prove();
    /// Writes what was proven.
    [[nodiscard]] Task<void> keep();

    /// A guard, the user or a link has ended it.
    [[nodiscard]] bool isOver() const { return !m_report.stopReason.empty(); }
    [[nodiscard]] bool hasMoved() const { return m_moved; }
    [[nodiscard]] TuneReport &report() { return m_report; }

private:
    struct Push {
        double duty = 0.0;
        double seconds = 0.0;
        int repeat = 1;
    };

    [[nodiscard]] Task<Trial> run(ExperimentPlan plan);
    [[nodiscard]] Task<Trial> pushOnce(Push push);
    [[nodiscard]] Task<void> readEnvelope();
    [[nodiscard]] Result<Proposal> proposalFor(Aim aim) const;
    [[nodiscard]] std::vector<ParameterChange> inProvingSlot() const;
    void note(const std::string &text) const;

    Device &m_device;
    SetPointStream &m_stream;
    TunePlan m_plan;
    ExperimentSurroundings m_around;
    TuneReport m_report;
    std::vector<Trial> m_pushes;
    Envelope m_envelope;    ///< of limits and device together
    double m_duty = 0.0;    ///< of the stronger pushes
    double m_seconds = 0.0; ///< of each
    double m_step = 0.0;    ///< of the proof, in the unit of the loop
    double m_start = 0.0;   ///< counts, where the tuning began
    double m_here = 0.0;    ///< counts, where the last experiment ended
    int m_provingSlot = 0;
    bool m_moved = false;
};

} // namespace mb::tuning
