// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/tuning/matrix/matrixunit.h"

namespace mb::test {

/// What a step did to the shaft itself, seen every millisecond without an encoder; of a current, to the current itself, four times as often.
struct ShaftResponse {
    double itae = 0.0; ///< s², of the error over the step, to the end of the hold; of a position beyond 4 counts
    double overshoot = 0.0;
    double settle = 0.0; ///< s, until it stays within 5 % of the target; the hold where it does not
    double peakCurrent = 0.0;
    bool isStable = false; ///< it stays within a band of 30 % of the step over the last quarter
};

/// The unit of a cell, without what is random in it, for steps with any gains: the same step for whoever is compared.
class StepProbe {
public:
    /// `step` and `seconds` of each hold in the unit of the loop.
    StepProbe(const Cell &cell, double step, double seconds);
    /// Writes the changes and steps from rest, back, and once more: the mean of the integrals, of all else the worse. Nothing where
    /// the unit does not take them.
    [[nodiscard]] std::optional<ShaftResponse> run(const std::vector<ParameterChange> &changes);
    /// As it is.
    [[nodiscard]] std::optional<ShaftResponse> run() { return run({}); }
    [[nodiscard]] Device &device() { return m_unit->device(); }
    [[nodiscard]] int runs() const { return m_runs; }
    [[nodiscard]] double step() const { return m_step; }

private:
    [[nodiscard]] bool comeToRest();
    [[nodiscard]] std::optional<double> begin();
    [[nodiscard]] bool waitForReturn(double origin, bool again);
    [[nodiscard]] double looked() const;
    [[nodiscard]] ShaftResponse watch(double base);
    [[nodiscard]] SetPoint setPoint(double target) const;

    Cell m_cell;
    double m_step;
    double m_seconds;
    std::unique_ptr<MatrixUnit> m_unit;
    int m_runs = 0;
};

} // namespace mb::test
