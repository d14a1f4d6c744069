// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/trigger.h"
#include "widgets/plots/plotstack.h"
#include "widgets/plots/telemetrysource.h"

namespace mb {

/// What a person asked the trigger for.
struct TriggerSetup {
    enum class Mode { Normal, Single };
    Mode mode = Mode::Normal;
    TriggerRule::Kind kind = TriggerRule::Kind::Rising;
    double level = 0.0;  ///< in the unit that is shown
    double before = 0.2; ///< part of the window that lies before the event
};

/// Watches one trace and holds the plot at the newest event: until there is one it follows the present. Normal goes on
/// once the window is full, single stops there. Looks only when it is asked; what was recorded meanwhile is not missed.
class TriggerWatch {
public:
    explicit TriggerWatch(PlotStack &stack)
        : m_stack(stack)
    {
    }
    /// From `now` on.
    void arm(const TriggerSetup &setup, std::shared_ptr<const TelemetrySource> source, double now);
    void disarm();
    [[nodiscard]] bool isArmed() const { return m_search.has_value(); }
    /// That it is armed with.
    [[nodiscard]] const TriggerSetup &setup() const { return m_setup; }
    /// Armed on this source, in the unit that it has now.
    [[nodiscard]] bool isOn(const TelemetrySource &source) const
    {
        return isArmed() && m_source.get() == &source && m_scale == source.scale();
    }
    /// A single event is there and its window is full.
    [[nodiscard]] bool isDone() const { return m_done; }
    [[nodiscard]] std::optional<double> event() const { return m_event; }
    [[nodiscard]] int events() const { return m_events; }
    /// Call it on every tick, before the stack is refreshed.
    void poll(double now);

private:
    [[nodiscard]] double windowEnd() const;
    void show(double now);

    PlotStack &m_stack;
    TriggerSetup m_setup;
    std::optional<TriggerSearch> m_search;
    std::shared_ptr<const TelemetrySource> m_source;
    double m_scale = 1.0;
    std::optional<double> m_event;
    double m_armedAt = 0.0;
    int m_events = 0;
    bool m_done = false;
};

} // namespace mb
