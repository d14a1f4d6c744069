// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "telemetry/telemetry.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace mb::dmc60c {

/// One periodic status frame on its way into the telemetry. Frames carry no counter, so a lost one shows only as a gap
/// of several periods; the same gaps, all alike, mean that somebody changed the period. A frame behind such a gap is
/// held back until the next one or setPeriod() tells: at most `relearn` of them. Times are those of the source. A computer or an
/// adapter that was held up brings the frames of such a gap at once: they were late, not lost, and get the times at which the device
/// sent them.
class StatusStream {
public:
    static constexpr std::size_t mostValues = 4;
    static constexpr int relearn = 8; ///< so many equal gaps make a new period
    using Values = std::array<double, mostValues>;

    /// `channels` gets one value each per frame; `period` is what the device does after a restart.
    StatusStream(std::shared_ptr<Telemetry> telemetry, std::vector<ChannelIndex> channels, Duration period);

    void add(Instant time, const Values &values);
    /// The device said so: what is held back was no loss, unless this is the period known before.
    void setPeriod(Duration period);
    [[nodiscard]] bool isHolding() const { return !m_held.empty(); }
    /// The device was silent or restarted: nothing is missing as far as anybody knows.
    void interrupt();
    /// As setPeriod() with the value after a restart, and interrupt().
    void restart();

    [[nodiscard]] Duration period() const { return m_period; }

private:
    struct Frame {
        Instant time{};
        Values values{};
        std::int64_t periods = 1; ///< since the frame before
    };
    [[nodiscard]] std::int64_t periodsSince(Instant time) const;
    void adjustPhase(Instant time, std::int64_t periods);
    void learnShorter(Duration gap);
    [[nodiscard]] bool gapsAreAlike() const;
    void hold(const Frame &frame);
    [[nodiscard]] std::vector<Frame>::reverse_iterator gapWithMissing();
    [[nodiscard]] bool wasLate(const Frame &frame);
    void spread();
    void releaseAsLoss(std::size_t count);
    void release();
    void emit(const Frame &frame);
    void startAt(Instant time);

    std::shared_ptr<Telemetry> m_telemetry;
    std::vector<ChannelIndex> m_channels;
    Duration m_initial;
    Duration m_period;
    std::optional<Instant> m_last;
    Instant m_emitted{};       ///< time of the last frame that is in the telemetry
    Instant m_phase{};         ///< when the last frame was due; jitter is smoothed out of it
    bool m_unsure = false;     ///< the period changed: the next gap is a mixture
    bool m_mayRestart = false; ///< the device was told its period again, and may have begun a new one with that
    bool m_confirmed = false;  ///< by the device, since the last regular frame
    int m_shortGaps = 0;
    Duration m_shortSum{};
    std::vector<Frame> m_held;
};

} // namespace mb::dmc60c
