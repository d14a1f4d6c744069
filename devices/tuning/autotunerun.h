// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/proof.h"
#include "tuning/proposals.h"
#include "tuning/tunereport.h"

#include <optional>
#include <string>
#include <vector>

namespace mb::tuning {

/// The stages of one tuning and what they share. Lives in the frame of autotune().
class AutotuneRun {
public:
    AutotuneRun(Device &device, SetPointStream &stream, TunePlan plan, ExperimentSurroundings surroundings);

    /// What an identification has found.
    struct Finding {
        MotorFound motor;
        PlantModel plant; ///< as the loop sees it
        std::vector<Gate> gates;
        std::optional<TriedScale> scale;
    };
    /// A push of duty from standstill.
    struct Push {
        double duty = 0.0;
        double seconds = 0.0;
        int repeat = 1;
        std::optional<double> reach{}; ///< as ExperimentPlan
        std::optional<double> relay{};
    };

    /// One experiment within the limits of the tuning; what ended it, if it was not its own end, ends the tuning.
    [[nodiscard]] Task<Trial> run(ExperimentPlan plan);
    [[nodiscard]] Task<Trial> push(Push push);
    /// Limits of the plan and of the device together, from where the motor stands.
    [[nodiscard]] Task<void> readEnvelope();
    /// Refused with the gate that it did not pass.
    [[nodiscard]] Result<void> take(Finding finding);
    /// Ends the tuning for this reason: a guard's name, "link", "interrupted".
    void end(std::string_view reason, Message evidence);
    /// Something else than run() moves the motor now; lookWhere() afterwards.
    void setMoved() { m_moved = true; }
    /// Where the motor stands, as it was told last: travel counts from the first such place.
    void lookWhere();
    /// The last experiment ended by a guard, and that was to be expected.
    void forgive() { m_report.stopReason.clear(); }
    void note(const Message &text) const;

    /// Takes the model that the plan brings, and where the motor stands now; no motion.
    [[nodiscard]] Task<void> recall();
    /// Gains, rounded to the device's, and what they will do; no motion.
    [[nodiscard]] Task<void> propose();
    /// Steps both ways with the proposal in force.
    [[nodiscard]] Task<void> prove();
    /// What to prove after a proposal did not do what was predicted: the same on the model as those steps correct it, then the calm one.
    /// False where there is none, or numbers were asked for.
    [[nodiscard]] Task<bool> reconsider();
    /// Writes what was proven.
    [[nodiscard]] Task<void> keep();

    /// A guard, the user or a link has ended it.
    [[nodiscard]] bool isOver() const { return !m_report.stopReason.empty(); }
    [[nodiscard]] bool hasMoved() const { return m_moved; }
    [[nodiscard]] TuneReport &report() { return m_report; }
    [[nodiscard]] const TunePlan &plan() const { return m_plan; }
    [[nodiscard]] const Envelope &envelope() const { return m_envelope; }
    [[nodiscard]] Device &device() const { return m_device; }
    [[nodiscard]] SetPointStream &stream() const { return m_stream; }
    /// nullptr: nobody can interrupt.
    [[nodiscard]] Interruption *interruption() const { return m_around.interruption; }
    /// Counts, where the motor is.
    [[nodiscard]] double place() const { return m_here; }

private:
    [[nodiscard]] Task<Trial> runOnce(ExperimentPlan plan);
    [[nodiscard]] ProposalBasis basis() const;
    [[nodiscard]] ProposalWish wishFor(Aim aim) const;
    [[nodiscard]] Task<bool> refine();
    void beginAnew();
    void choose(const Proposal &proposal);
    [[nodiscard]] VelocityTaking taking() const;
    [[nodiscard]] double resting() const;
    [[nodiscard]] double proofSeconds() const;
    [[nodiscard]] double proofTarget(double sign) const;
    [[nodiscard]] std::vector<ParameterChange> inProvingSlot() const;

    Device &m_device;
    SetPointStream &m_stream;
    TunePlan m_plan;
    ExperimentSurroundings m_around;
    TuneReport m_report;
    Envelope m_envelope;   ///< of limits and device together
    double m_step = 0.0;   ///< of the proof, in the unit of the loop
    double m_start = 0.0;  ///< counts, where the tuning began
    double m_here = 0.0;   ///< counts, where the last experiment ended
    bool m_placed = false; ///< m_start is known
    int m_provingSlot = 0;
    bool m_moved = false;
    bool m_refined = false;  ///< the model was corrected, or could not be
    bool m_isCalmed = false; ///< the calm proposal took the place of the one that was asked for
    Message m_quicker;       ///< what gains did that were proven before; empty: none were
};

} // namespace mb::tuning
