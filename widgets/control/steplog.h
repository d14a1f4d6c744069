// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/snapshot.h"
#include "widgets/control/stepmetrics.h"

#include <array>
#include <vector>

namespace mb {

/// One change of a set-point and what became of it.
struct StepRecord {
    int number = 0;
    Instant begin{};
    Instant end{}; ///< of what is measured
    Mode mode = Mode::Off;
    int slot = 0;
    int axis = 0;      ///< of a board with several
    double from = 0.0; ///< measured before
    double to = 0.0;
    double ramp = 0.0; ///< seconds that the set-point took; 0 is a step
    bool finished = false;
    bool cut = false;                                   ///< stopped or changed before it could settle
    std::uint64_t lost = 0;                             ///< samples that are missing in it
    std::array<std::optional<std::int64_t>, 4> gains{}; ///< raw P, I, D, F in force when it began
    StepMetrics metrics;
    double peakCurrent = 0.0;
};

/// Every step of one device, or of one of its axes, since it was found, taken from its recording: nothing that was run is lost. GUI thread.
class StepLog {
public:
    /// 0: the device has one motor.
    explicit StepLog(int axis = 0)
        : m_axis(axis)
    {
    }
    /// Looks at what was recorded since the last call. True when a record began or ended.
    bool follow(const DeviceView &device, Instant now);
    /// Oldest first; the last one may be running.
    [[nodiscard]] const std::vector<StepRecord> &records() const { return m_records; }

private:
    void take(const DeviceView &device, const Point &setPoint);
    void begin(const DeviceView &device, Instant time, double target);
    void finish(const DeviceView &device, Instant end, bool cut);
    [[nodiscard]] StepRecord *running();
    [[nodiscard]] const SetPoint *told(const DeviceView &device) const;

    int m_axis;
    std::vector<StepRecord> m_records;
    Instant m_seen{};
    Instant m_changedAt{};
    std::optional<double> m_target; ///< nothing while nobody commands
    bool m_news = false;
};

/// The channel that a mode commands: velocity, position, current; empty where there is none.
[[nodiscard]] std::string_view measuredChannel(Mode mode);

} // namespace mb
