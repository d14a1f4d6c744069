// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/quadquad2drv/axistrial.h"

namespace mb::quadquad2drv {

/// Finds the scale of the gains of one axis by moving its motor (README.md#gain-scale), one after the other. Engine thread;
/// outlives its task.
class ScaleSearch {
public:
    ScaleSearch(Controller &board, SetPointStream &stream, const ExperimentOptions &options, Progress &progress);

    [[nodiscard]] Task<ExperimentReport> run();

private:
    using Loop = AxisTrial::Loop;
    using Run = AxisTrial::Run;

    [[nodiscard]] Task<void> measureAll();
    [[nodiscard]] Task<void> measurePlant();
    [[nodiscard]] Task<double> findVelocityP();
    [[nodiscard]] Task<double> velocityP(int gain, double aim);
    [[nodiscard]] Task<double> findIntegral(Run run, double way);
    [[nodiscard]] Task<double> findVelocityI();
    [[nodiscard]] Task<double> findPositionP();
    [[nodiscard]] Task<double> findPositionI();
    [[nodiscard]] Task<std::optional<double>> findPositionD();
    /// The first gain of 1, 2, 4 … at which the motor goes the way within the time of the run.
    [[nodiscard]] Task<int> firstGain(Run run, std::size_t which, double way);
    [[nodiscard]] Task<double> scaleAt(Run run, std::size_t which);
    [[nodiscard]] std::vector<double> termsOf(const Run &run, const Track &track, std::size_t which) const;
    void found(std::string_view key, double scale);
    void tell(const Message &text) { m_progress.log(Severity::Info, text); }

    Controller &m_board;
    Progress &m_progress;
    AxisTrial m_trial;
    double m_positionP = 0.0;
    double m_velocityP = 0.0;
    ExperimentReport m_report;
};

} // namespace mb::quadquad2drv
