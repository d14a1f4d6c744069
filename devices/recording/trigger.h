// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/samplecursor.h"

#include <optional>

namespace mb {

/// What makes a trigger fire. Level and hysteresis are in the unit of the channel as it is recorded.
struct TriggerRule {
    enum class Kind {
        Rising,  ///< crosses the level upwards
        Falling, ///< crosses it downwards
        Either,
        Above, ///< is above the level
        Below,
    };
    Kind kind = Kind::Rising;
    double level = 0.0;
    /// How far back across the level it must go before the next edge counts: noise at the level is one edge.
    double hysteresis = 0.0;

    friend bool operator==(const TriggerRule &, const TriggerRule &) = default;
};

/// Decides sample by sample. An edge needs two samples that connect: a gap never fires.
class TriggerScanner {
public:
    explicit TriggerScanner(const TriggerRule &rule)
        : m_rule(rule)
    {
    }
    /// The time it fired, on the straight line between two samples; nothing when it did not.
    [[nodiscard]] std::optional<Instant> feed(const Point &point);
    [[nodiscard]] const TriggerRule &rule() const { return m_rule; }

private:
    [[nodiscard]] std::optional<Instant> edge(const Point &point, bool rising);

    TriggerRule m_rule;
    std::optional<Point> m_last;
    bool m_readyUp = false;   ///< was low enough since the last edge
    bool m_readyDown = false; ///< was high enough
};

/// Looks for trigger events in a recording that grows.
class TriggerSearch {
public:
    TriggerSearch(
        const TriggerRule &rule, std::shared_ptr<const Telemetry> telemetry, ChannelIndex channel, Instant from);

    /// Looks at what is new, at most `most` samples; the first event at or after `notBefore`, if there is one.
    [[nodiscard]] std::optional<Instant> poll(Instant notBefore, std::size_t most = 200'000);

private:
    TriggerScanner m_scanner;
    SampleCursor m_cursor;
};

} // namespace mb
