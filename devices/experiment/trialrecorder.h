// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/noncopyable.h"
#include "experiment/guards.h"
#include "experiment/recentextremes.h"
#include "experiment/trial.h"
#include "model/setpointstream.h"

namespace mb::tuning {

/// Keeps the samples of one axis while a trial runs, and shows each to the guards: the first trip stops the motor inside the
/// same call that brought the sample. From its construction on.
class TrialRecorder : NonCopyable {
public:
    TrialRecorder(Device &device, SetPointStream &stream, Mode mode, int axis);

    /// Watches from now on; what tripped before is forgotten.
    void guard(const GuardPlan &plan);
    void unguard();
    /// The target that the loop follows now, of its mode.
    void expect(double target);

    [[nodiscard]] const std::optional<Trip> &trip() const { return m_trip; }
    /// When the stop of the trip was handed to the link.
    [[nodiscard]] Instant stoppedAt() const { return m_stoppedAt; }
    /// Newest value of the measured channel, or of another of this axis.
    [[nodiscard]] std::optional<double> latest(std::string_view key) const;
    static constexpr Span everything{-1e9, 1e9};
    /// Seconds since `zero`, and only what is within a stretch of them.
    [[nodiscard]] Trace trace(std::string_view key, Instant zero, const Span &within = everything) const;
    [[nodiscard]] std::vector<Signal> signals(Instant zero, const Span &within = everything) const;
    [[nodiscard]] std::uint64_t samples() const { return m_samples; }
    [[nodiscard]] std::uint64_t lost() const;
    /// The limit switch that held while the motor was driven, by its row; nullptr: none did, or the device tells none.
    [[nodiscard]] const StateRow *limitMet() const { return m_limitMet; }
    /// Counts where the motor would come to rest by what its last positions say, in `lag` seconds; 0 while there are too few.
    [[nodiscard]] double stopsAt(double lag) const;
    /// Median time between the last positions, s; 0 while there are too few.
    [[nodiscard]] double positionPeriod() const;
    /// The measured value stayed within `width` over the last `share` of the time since `from`, which is `least` at least.
    [[nodiscard]] bool isSettled(Instant from, Duration least, double share, double width) const;
    /// Where a loop goes: from what was measured to what it is told.
    struct Way {
        double start = 0.0;
        double aim = 0.0;
    };
    /// The measured value has come to rest within `width`: at the aim of its way, if it has one, or beside it, which takes longer to be
    /// told from a loop that turns round, creeps, or has lost its sensor. One that has not left its start has not settled.
    /// `from` is `least` ago at least.
    [[nodiscard]] bool hasSettled(Instant from, Duration least, const std::optional<Way> &way, double width) const;
    /// The position was told often enough and moved by a count at most over the last `span`, all of it after `from`.
    [[nodiscard]] bool isStill(Instant from, Duration span) const;

private:
    struct Recorded {
        ChannelIndex channel;
        std::string key; ///< without the axis
        std::vector<Point> points;
    };

    void take(const Sample &sample);
    [[nodiscard]] std::optional<Trip> show(const std::string &key, const Sample &sample);
    void look();
    void lookForLimits();
    void ended(std::optional<Trip> trip);
    [[nodiscard]] std::uint64_t lostSoFar() const;
    [[nodiscard]] const Recorded *find(std::string_view key) const;

    Device &m_device;
    SetPointStream &m_stream;
    std::string_view m_measured;
    bool m_isOpen;                ///< there is no error: what is ordered is the duty
    bool m_ordersAreDuty = false; ///< and the device does not tell it
    std::vector<Recorded> m_recorded;
    RecentExtremes<Instant, double> m_extremes; ///< of the measured channel
    std::optional<Guards> m_guards;
    std::optional<double> m_target;
    std::optional<Trip> m_trip;
    Instant m_stoppedAt{};
    Instant m_lookedAt{};
    bool m_wasLate = false; ///< it came late when it looked last
    const StateRow *m_limitMet = nullptr;
    std::uint64_t m_samples = 0;
    std::uint64_t m_lostBefore = 0;
    Timer m_timer;
    Subscription m_subscription;
};

} // namespace mb::tuning
