// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/quadquad2drv/codec.h"
#include "families/quadquad2drv/controller.h"
#include "families/quadquad2drv/gainfit.h"
#include "model/family.h"
#include "model/setpointstream.h"

namespace mb::quadquad2drv {

/// Finds the scale of the gains of one axis by moving its motor (README.md#gain-scale). However it ends, also by being destroyed in
/// the middle, the motor is stopped and the axis has its gains, limits and history back.
class ScaleSearch {
public:
    ScaleSearch(Controller &board, SetPointStream &stream, const ExperimentOptions &options, Progress &progress);
    ScaleSearch(const ScaleSearch &) = delete;
    ScaleSearch &operator=(const ScaleSearch &) = delete;
    ~ScaleSearch();

    [[nodiscard]] Task<ExperimentReport> run();

private:
    enum class Loop { Velocity, Position };
    /// P, I, D.
    using Gains = std::array<int, 3>;
    struct Run {
        Loop loop = Loop::Velocity;
        Gains gains{};
        double aim = 0.0;     ///< counts/s, or counts from where it stands, in the direction of the run
        double seconds = 0.0; ///< at most
        double way = 0.0;     ///< ends when it has come so far; 0: it does not matter
    };

    [[nodiscard]] Task<void> measureAll();
    [[nodiscard]] Task<void> prepare();
    [[nodiscard]] Task<void> measurePlant();
    [[nodiscard]] Task<PowerStep> powerStep(double power);
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
    [[nodiscard]] Task<Track> drive(Run run);
    [[nodiscard]] Task<void> move(Mode mode, double target);
    [[nodiscard]] Task<void> wait(Duration time, double way = 0.0);
    [[nodiscard]] Task<void> rest();
    [[nodiscard]] Task<void> finish();
    [[nodiscard]] Result<void> look() const;
    [[nodiscard]] std::vector<double> termsOf(const Run &run, const Track &track, std::size_t which) const;
    void begin();
    void found(std::string_view key, double scale);
    void say(const std::string &text) { m_progress.log(Severity::Info, text); }

    Controller &m_board;
    Clock &m_clock;
    SetPointStream &m_stream;
    ExperimentOptions m_options;
    Progress &m_progress;
    int m_axis;
    std::uint8_t m_mask;
    double m_most; ///< power units
    bool m_started = false;
    double m_direction = 1.0;
    Plant m_plant;
    double m_positionP = 0.0;
    double m_velocityP = 0.0;
    std::vector<Bytes> m_before; ///< puts the axis back
    Track m_track;
    Instant m_begun{};
    std::optional<double> m_from; ///< counts at the start of the track
    ExperimentReport m_report;
    Subscription m_samples;
};

} // namespace mb::quadquad2drv
