// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/wallclock.h"
#include "telemetry/telemetry.h"
#include "widgets/plots/tracesource.h"

#include <memory>

namespace mb {

/// Seconds on the time line of all time stamps: the keys of live plots.
[[nodiscard]] inline double plotKey(Instant time)
{
    return std::chrono::duration<double>(time.time_since_epoch()).count();
}

/// The time of a key; of a Unix time it is right to a microsecond.
[[nodiscard]] inline Instant instantOf(double key)
{
    return Instant(std::chrono::duration_cast<Duration>(std::chrono::duration<double>(key)));
}

/// What to add to a key to get Unix time, s.
[[nodiscard]] inline double clockShift(const WallClock &clock, double key)
{
    return std::chrono::duration<double>(clock.shiftAt(instantOf(key))).count();
}

/// One channel of a recording as a trace. Keeps the columns of the picture before, so that a window that scrolls costs
/// only what is new. GUI thread; the recording itself is locked by Telemetry.
class TelemetrySource final : public TraceSource {
public:
    /// When rate and loss are told in the foot line.
    enum class Foot { Always, WhenLossy, Never };

    TelemetrySource(std::shared_ptr<const Telemetry> telemetry, ChannelIndex channel, Foot foot = Foot::Always);

    /// Values are multiplied by it: the unit that is shown.
    void setScale(double scale) { m_scale = scale; }
    /// Hides what is older: a set-point of another mode has another unit.
    void setSince(Instant since) { m_since = since; }
    /// Says this in the foot line instead of rate and loss of its own; sources that say the same are named once.
    void setFootText(const QString &text) { m_footText = text; }
    /// What only the page knows: samples per second, and the present.
    void follow(double rate, Instant now);

    [[nodiscard]] double scale() const { return m_scale; }
    [[nodiscard]] const Telemetry &telemetry() const { return *m_telemetry; }
    [[nodiscard]] const std::shared_ptr<const Telemetry> &sharedTelemetry() const { return m_telemetry; }
    [[nodiscard]] ChannelIndex channel() const { return m_channel; }
    [[nodiscard]] double rate() const { return m_rate; }
    [[nodiscard]] std::uint64_t lost() const { return m_telemetry->lost(m_channel); }

    void columns(double from, double to, int pixels, std::vector<PlotPoint> &points) const override;
    /// Nothing once the channel is silent for 2 s (3 periods, if that is longer).
    [[nodiscard]] std::optional<double> latest() const override;
    [[nodiscard]] QString foot() const override;
    [[nodiscard]] std::optional<Statistics> statistics(double from, double to) const override;
    [[nodiscard]] std::optional<double> valueAt(double key) const override;
    [[nodiscard]] bool lossy() const override { return lost() > 0; }

private:
    std::shared_ptr<const Telemetry> m_telemetry;
    ChannelIndex m_channel;
    Foot m_foot;
    QString m_footText;
    double m_scale = 1.0;
    double m_rate = 0.0;
    Instant m_since{};
    Instant m_now{};
    mutable ColumnWindow m_window;
};

} // namespace mb
