// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/noncopyable.h"
#include "families/quadquad2drv/borrowedsettings.h"
#include "families/quadquad2drv/codec.h"
#include "families/quadquad2drv/gainfit.h"
#include "model/family.h"
#include "model/setpointstream.h"

namespace mb::quadquad2drv {

/// Turns the motor of one axis to and fro, watches over it and records its track. However it ends, also by being destroyed in the
/// middle, the motor is stopped and the axis has its gains, limits and history back. Engine thread; outlives its tasks.
class AxisTrial : NonCopyable {
public:
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

    AxisTrial(Controller &board, SetPointStream &stream, const ExperimentOptions &options, Progress &progress);
    ~AxisTrial();

    /// Before the first run: no limit but that of the power, and a velocity estimate that is fast.
    [[nodiscard]] Task<void> prepare();
    /// After the last one: stopped, and as it was.
    [[nodiscard]] Task<void> finish();
    /// A constant power (units) until the speed is constant, in the other direction each time.
    [[nodiscard]] Task<PowerStep> powerStep(double power);
    /// One run of a closed loop, in the other direction each time.
    [[nodiscard]] Task<Track> drive(Run run);

    /// Gains of this axis that nobody knew: it is left with those that the board starts with.
    [[nodiscard]] bool leavesStartGains() const { return m_leavesStartGains; }
    /// Power units.
    [[nodiscard]] double mostPower() const { return m_most; }
    /// What is known of the motor; from then on a run that it cannot make is ended.
    void setPlant(const Plant &plant) { m_plant = plant; }
    [[nodiscard]] const Plant &plant() const { return m_plant; }

private:
    [[nodiscard]] Task<void> move(Mode mode, double target);
    [[nodiscard]] Task<void> wait(Duration time, double way = 0.0);
    [[nodiscard]] Task<void> rest();
    [[nodiscard]] Result<void> look() const;
    void begin();

    Controller &m_board;
    Clock &m_clock;
    SetPointStream &m_stream;
    ExperimentOptions m_options;
    Progress &m_progress;
    int m_axis;
    std::uint8_t m_mask;
    double m_most;
    bool m_started = false;
    bool m_leavesStartGains = false;
    double m_direction = 1.0;
    Plant m_plant;
    std::optional<BorrowedSettings> m_borrowed; ///< given back once the motor is stopped
    Track m_track;
    Instant m_begun{};
    std::optional<double> m_from; ///< counts at the start of the track
    Subscription m_samples;
};

} // namespace mb::quadquad2drv
