// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <optional>
#include <utility>

namespace mb {

/// Which stretch of time a stack of plots shows: the last seconds of the present, what lies around the key of a trigger,
/// or a stretch that stands still. Draws nothing. GUI thread. Keys are seconds on any one time line.
class PlotView : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    /// Length of the time axis in seconds (1 ms … 1 day).
    void setWindow(double seconds);
    [[nodiscard]] double window() const { return m_window; }
    void setLive(bool live);
    [[nodiscard]] bool isLive() const { return m_live; }
    /// All that there is: a recording has no present, and what would follow it shows all of it.
    void setWhole(double from, double to);
    [[nodiscard]] const std::optional<std::pair<double, double>> &whole() const { return m_whole; }
    /// Shows this stretch of time, at least a millisecond about its middle, and stops following.
    void setRange(double from, double to);
    [[nodiscard]] std::pair<double, double> range() const { return {m_from, m_to}; }
    [[nodiscard]] double span() const { return m_to - m_from; }
    /// While live, shows the window around this key instead of the present, `before` (0 … 1) of it earlier; empty
    /// follows the present again.
    void hold(std::optional<double> key, double before);
    [[nodiscard]] std::optional<double> heldKey() const { return m_held; }
    /// Where the keys of aligned traces count from: the held key, or the left edge.
    [[nodiscard]] double origin() const { return m_held.value_or(m_from); }

    /// Shorter below 1. Live it is the window that changes; paused, `around` stays where it is (the middle without one).
    void zoom(double factor, std::optional<double> around);
    void pan(double seconds);
    /// The present; it is shown by follow().
    void setNow(double now) { m_now = now; }
    [[nodiscard]] double now() const { return m_now; }
    /// Moves on to the present by whole pixel columns of so many; false when there is nothing to move.
    bool follow(double now, int columns);

Q_SIGNALS:
    /// Something else is to be drawn.
    void changed();
    void liveChanged(bool live);
    void windowChanged(double seconds);

private:
    double m_window = 12.0;
    double m_from = 0.0;
    double m_to = 12.0;
    double m_now = 0.0;
    bool m_live = true;
    std::optional<std::pair<double, double>> m_whole;
    std::optional<double> m_held; ///< key of a trigger
    double m_heldBefore = 0.5;
};

} // namespace mb
