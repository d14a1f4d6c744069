// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/tuning/tripwatch.h"

namespace mb::test {

/// When the condition of a guard (docs/safety.md#what-ends-an-experiment) was fulfilled, out of the samples alone; `struck` is when the fault came.
using Condition = std::function<std::optional<Instant>(const TripWatch &watch, Instant struck)>;

inline Condition above(std::string_view key, double limit)
{
    return [key, limit](const TripWatch &watch, Instant) {
        return watch.first(key, [limit](const SeenSample &s) { return std::abs(s.value) > limit; });
    };
}

inline Condition below(std::string_view key, double limit)
{
    return [key, limit](const TripWatch &watch, Instant) {
        return watch.first(key, [limit](const SeenSample &s) { return s.value < limit; });
    };
}

/// Braked from its real speed it would leave the envelope. A guard that saw it faster than it was, by whole counts, stopped it
/// before: then this is when it would have been so.
inline Condition beyond(double travel)
{
    return [travel](const TripWatch &watch, Instant) -> std::optional<Instant> {
        constexpr auto handling = std::chrono::milliseconds(20 + 25);
        const double latency = tuning::inSeconds(watch.period("position") + handling) + 0.15;
        std::optional<Instant> expected;
        for (const SeenSample *sample : watch.of("position")) {
            const double left = travel - std::abs(sample->value + sample->speed * latency - watch.origin());
            if (left < 0.0)
                return sample->time;
            expected = sample->time + tuning::ofSeconds(left / std::max(std::abs(sample->speed), 1.0));
        }
        return expected;
    };
}

/// Above a limit for 100 ms without a break, or half as much again above it.
inline Condition overloaded(double limit)
{
    return [limit](const TripWatch &watch, Instant) {
        std::optional<Instant> since;
        return watch.first("current", [&](const SeenSample &s) {
            since = std::abs(s.value) > limit ? std::optional(since.value_or(s.time)) : std::nullopt;
            return std::abs(s.value) > 1.5 * limit || (since && s.time - *since >= std::chrono::milliseconds(100));
        });
    };
}

/// The heat of ten seconds at the limit.
inline Condition heated(double limit)
{
    return [limit](const TripWatch &watch, Instant) {
        double heat = 0.0;
        const SeenSample *last = nullptr;
        return watch.first("current", [&](const SeenSample &s) {
            if (last)
                heat += last->value * last->value * tuning::inSeconds(s.time - last->time);
            last = &s;
            return heat > 10.0 * limit * limit;
        });
    };
}

/// Half a second after its last move.
inline std::optional<Instant> stuck(const TripWatch &watch, Instant struck)
{
    double place = 0.0;
    Instant moved = struck;
    return watch.first("position", [&](const SeenSample &s) {
        if (s.time < struck)
            place = s.value;
        else if (std::abs(s.value - place) >= 3.0) {
            place = s.value;
            moved = s.time;
        }
        return s.time >= struck && s.time - moved >= std::chrono::milliseconds(500);
    });
}

/// Five samples on end away from the target, more than 10 counts from where it was.
inline std::optional<Instant> away(const TripWatch &watch, Instant)
{
    const auto positions = watch.of("position");
    if (positions.empty())
        return std::nullopt;
    const double from = positions.front()->value;
    int wrong = 0;
    return watch.first("position", [&](const SeenSample &s) {
        wrong = s.target > 0.0 && s.value < from - 10.0 ? wrong + 1 : 0;
        return wrong >= 5;
    });
}

/// Six half waves of the error on end, none smaller than 95 % of the one before on its side.
inline Condition swinging(std::string_view key, double swing)
{
    return [key, swing](const TripWatch &watch, Instant) {
        double peak = 0.0;
        double last = 0.0;
        double other = 0.0;
        bool positive = false;
        int waves = 0;
        return watch.first(key, [&](const SeenSample &s) {
            const double error = s.target - s.value;
            if (error == 0.0 || (error > 0.0) == positive) {
                peak = std::max(peak, std::abs(error));
                return false;
            }
            waves = peak > 0.05 * swing && peak > 0.95 * last ? waves + 1 : 0;
            positive = error > 0.0;
            last = std::exchange(other, peak);
            peak = std::abs(error);
            return waves >= 6;
        });
    };
}

/// Twenty-one changes of direction above half the duty's limit within a second.
inline Condition flipping(double limit)
{
    return [limit](const TripWatch &watch, Instant) {
        std::vector<Instant> flips;
        double strong = 0.0;
        return watch.first("duty", [&](const SeenSample &s) {
            if (std::abs(s.value) > 0.5 * limit) {
                if (s.value * strong < 0.0)
                    flips.push_back(s.time);
                strong = s.value;
            }
            return flips.size() > 20 && s.time - flips[flips.size() - 21] <= std::chrono::seconds(1);
        });
    };
}

/// Five periods, or 100 ms, after the last sample.
inline std::optional<Instant> silent(const TripWatch &watch, Instant)
{
    return watch.lastHeard() + std::max<Duration>(std::chrono::milliseconds(100), 5 * watch.period("position"));
}

inline std::optional<Instant> atOnce(const TripWatch &, Instant struck)
{
    return struck;
}

/// More than 5 % of what the unit sends in a second did not come in the last one, of forty samples or more.
inline std::optional<Instant> losing(const TripWatch &watch, Instant)
{
    const auto &seen = watch.seen();
    for (std::size_t i = 0, from = 0; i < seen.size(); ++i) {
        while (seen[i].time - std::max(seen[from].time, watch.startedAt()) > std::chrono::seconds(1)
            || seen[from].time < watch.startedAt())
            if (++from >= i)
                break;
        const auto lost = static_cast<double>(seen[i].lost - seen[std::min(from, i)].lost);
        const auto came = static_cast<double>(i - std::min(from, i));
        const std::chrono::duration<double> part
            = seen[i].time - std::max(seen[std::min(from, i)].time, watch.startedAt());
        if (seen[i].time > watch.startedAt() && came + lost >= 40.0 && lost * part.count() > 0.05 * (came + lost))
            return seen[i].time;
    }
    return std::nullopt;
}

} // namespace mb::test
