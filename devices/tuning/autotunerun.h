// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/tunereport.h"

#include <optional>
#include <vector>

namespace mb::tuning {

/// What the stages of one tuning share: its experiments, its limits, its time and its report. Lives in the frame of autotune().
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
        std::optional<double> fastest{};
        bool grows = false; ///< from nothing to its duty, slowly, and at once back
    };

    /// One experiment within the limits of the tuning; what ended it, if it was not its own end, ends the tuning. `followed`: s that
    /// what is done next takes at least.
    [[nodiscard]] Task<Trial> run(ExperimentPlan plan, double followed = 0.0);
    [[nodiscard]] Task<Trial> push(Push push);
    /// Limits of the plan and of the device together, from where the motor stands.
    [[nodiscard]] Task<void> readEnvelope();
    /// Refused with the gate that it did not pass.
    [[nodiscard]] Result<void> take(Finding finding);
    /// Ends the tuning for this reason.
    void end(EndReason reason, Message evidence);
    /// Something else than run() moves the motor now; lookWhere() afterwards.
    void setMoved() { m_moved = true; }
    /// ExperimentSurroundings::before, for what moves the motor so.
    [[nodiscard]] Task<void> keepBefore();
    /// Where the motor stands, as it was told last: travel counts from the first such place.
    void lookWhere();
    /// Its time begins now: what was found out before was not of this motor.
    void beginClock();
    /// s that are left of a minute.
    [[nodiscard]] double left() const;
    /// The last experiment ended by a guard, and that was to be expected.
    void forgive()
    {
        m_report.stopReason = EndReason::None;
        m_report.evidence = {};
    }
    void note(const Message &text) const;

    /// Takes the model that the plan brings, and where the motor stands now; no motion.
    [[nodiscard]] Task<void> recall();

    /// The motor makes so many counts/s per duty at most: what is announced of the next experiments.
    void expect(double gain) { m_gain = gain; }

    /// A guard, the user or a link has ended it.
    [[nodiscard]] bool isOver() const { return m_report.stopReason != EndReason::None; }
    [[nodiscard]] bool hasMoved() const { return m_moved; }
    [[nodiscard]] TuneReport &report() { return m_report; }
    [[nodiscard]] const TuneReport &report() const { return m_report; }
    [[nodiscard]] const TunePlan &plan() const { return m_plan; }
    [[nodiscard]] const Envelope &envelope() const { return m_envelope; }
    [[nodiscard]] Device &device() const { return m_device; }
    [[nodiscard]] SetPointStream &stream() const { return m_stream; }
    /// Its journal, and who is told.
    [[nodiscard]] const ExperimentSurroundings &around() const { return m_around; }
    /// Counts either side of where the motor stands now; nothing: no limit is known.
    [[nodiscard]] std::optional<double> travelLeft() const;
    /// The same one way: what the motor has gone since the tuning began counts.
    [[nodiscard]] std::optional<double> room(double sign) const;
    /// Who may end it at any time.
    [[nodiscard]] const Interruptible &user() const { return m_user; }
    /// Counts, where the motor is.
    [[nodiscard]] double place() const { return m_here; }

private:
    [[nodiscard]] Task<Trial> runOnce(ExperimentPlan plan);
    [[nodiscard]] Result<void> judgeEnding(const Trial &trial);
    /// Of the motor, for what is announced and what guards count on.
    void expectOf(const PlantModel &plant, const std::optional<TriedScale> &scale);

    Device &m_device;
    SetPointStream &m_stream;
    TunePlan m_plan;
    ExperimentSurroundings m_around;
    Interruptible m_user;
    TuneReport m_report;
    Envelope m_envelope;           ///< of limits and device together
    std::optional<double> m_start; ///< counts, where the tuning began
    double m_here = 0.0;           ///< counts, where the last experiment ended
    double m_gain = 0.0;           ///< counts/s per duty at most; 0: not known yet
    bool m_moved = false;
    Instant m_begin;
};

} // namespace mb::tuning
