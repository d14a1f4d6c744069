// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/tuning/matrix/matrixunit.h"

#include <limits>

namespace mb::test {

/// What a step did to the shaft itself, seen every millisecond without an encoder; of a current, to the current itself, four times as often.
struct ShaftResponse {
    double itae = 0.0; ///< s², of the error over the step, to the end of the hold; of a position beyond 4 counts
    double overshoot = 0.0;
    double settle = 0.0;      ///< s, until it stays within 5 % of the target; the hold where it does not
    double peakCurrent = 0.0; ///< A, of step and way back; 0 where the unit's limit needs no watching
    bool isStable = false;    ///< it stays within a band of 30 % of the step over the last quarter
    double spread = 0.0;      ///< σ of the integrals of its runs over their mean; 0 of one run
};

/// Where a run begins, what makes its luck: shares of one count, at which its rotor stands, and of 501 ms, at which it is ordered (the
/// longest that a loop takes until it meets the clock of its unit again: 25 passes of an Abstract DC Drive).
struct StepPhase {
    double count = 0.0;
    double time = 0.0;
};
/// So many of a sequence that fills both evenly, from a place in it on: the same for whoever is compared.
[[nodiscard]] std::vector<StepPhase> stepPhases(int count, int first = 0);

/// What gains are given up at: nothing is told of them then.
struct StepLimits {
    double itae = std::numeric_limits<double>::infinity(); ///< s², of the mean
    double overshoot = std::numeric_limits<double>::infinity();
};

/// A step of a cell, for whoever is compared.
struct ProbedStep {
    double size = 0.0;        ///< in the unit of the loop
    double seconds = 0.0;     ///< of each hold
    double rate = 0.0;        ///< counts/s, at which the unit's own profile leads there; 0: nothing leads
    double mostCurrent = 0.0; ///< A, that no step may draw; 0: nothing bounds it
};

/// The unit of a cell, without what is random in it, for steps with any gains: the same step for whoever is compared.
class StepProbe {
public:
    StepProbe(const Cell &cell, const ProbedStep &step);
    /// Writes the changes and steps from rest, back, and once more: the mean of the integrals, of all else the worse. Nothing where
    /// the unit does not take them.
    [[nodiscard]] std::optional<ShaftResponse> run(
        const std::vector<ParameterChange> &changes, StepPhase phase = {}, const StepLimits &limits = {});
    /// The same of a run from each phase.
    [[nodiscard]] std::optional<ShaftResponse> runAll(const std::vector<ParameterChange> &changes,
        const std::vector<StepPhase> &phases, const StepLimits &limits = {});
    /// As it is.
    [[nodiscard]] std::optional<ShaftResponse> run() { return run({}); }
    [[nodiscard]] Device &device() { return m_unit->device(); }
    [[nodiscard]] int runs() const { return m_runs; }
    [[nodiscard]] double step() const { return m_step.size; }
    [[nodiscard]] bool drawsTooMuch(const ShaftResponse &response) const
    {
        return m_step.mostCurrent > 0.0 && response.peakCurrent > m_step.mostCurrent;
    }

private:
    [[nodiscard]] bool comeToRest();
    void meet(StepPhase phase);
    [[nodiscard]] std::optional<double> begin();
    [[nodiscard]] bool waitForReturn(double origin, bool again, ShaftResponse &response);
    void leadByProfile();
    void noteCurrent(ShaftResponse &response) const;
    [[nodiscard]] double looked() const;
    [[nodiscard]] std::optional<ShaftResponse> watch(double base, const StepLimits &limits);
    [[nodiscard]] SetPoint setPoint(double target) const;

    Cell m_cell;
    ProbedStep m_step;
    std::unique_ptr<MatrixUnit> m_unit;
    int m_runs = 0;
};

} // namespace mb::test
