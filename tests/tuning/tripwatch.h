// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/seconds.h"
#include "model/axis.h"
#include "tests/tuning/experimentbench.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace mb::test {

/// A sample as it came during an experiment, with what the bench knew then.
struct SeenSample {
    std::string key; ///< without the axis
    Instant time{};
    double value = 0.0;
    double target = 0.0;    ///< of the running stream
    double speed = 0.0;     ///< counts/s, of the shaft
    std::uint64_t lost = 0; ///< of all channels, so far
};

/// Looks on while an experiment runs, beside its recorder and its guards: what was measured, and when the motor was last told
/// to stop. Whoever asks it when a condition held uses nothing of devices/tuning.
class TripWatch {
public:
    explicit TripWatch(ExperimentBench &bench)
        : m_bench(bench)
        , m_stream(bench.bench.session.stream(*bench.device))
        , m_samples(bench.device->telemetry()->samples().add([this](const Sample &sample) { take(sample); }))
        , m_changed(m_stream.changed().add([this] { streamChanged(); }))
    {
    }
    [[nodiscard]] Instant now() const { return m_bench.device->clock().now(); }
    [[nodiscard]] const std::vector<SeenSample> &seen() const { return m_seen; }
    /// The motion that ended last.
    [[nodiscard]] Instant startedAt() const { return m_startedAt; }
    [[nodiscard]] Instant stoppedAt() const { return m_stoppedAt; }
    /// Counts, before anything moved.
    [[nodiscard]] double origin() const { return m_origin; }
    /// The newest position before the motion ended.
    [[nodiscard]] Instant lastHeard() const
    {
        Instant last = m_startedAt;
        for (const SeenSample *sample : of("position"))
            last = std::max(last, sample->time);
        return last;
    }
    /// Usual time between two samples of a channel during the motion that ended last.
    [[nodiscard]] Duration period(std::string_view key) const
    {
        std::vector<double> gaps;
        std::optional<Instant> last;
        for (const SeenSample *sample : of(key)) {
            if (last)
                gaps.push_back(tuning::inSeconds(sample->time - *last));
            last = sample->time;
        }
        std::sort(gaps.begin(), gaps.end());
        return gaps.empty() ? Duration::zero() : tuning::ofSeconds(gaps[gaps.size() / 2]);
    }
    /// The samples of a channel during the motion that ended last.
    [[nodiscard]] std::vector<const SeenSample *> of(std::string_view key) const
    {
        std::vector<const SeenSample *> found;
        for (const SeenSample &sample : m_seen) {
            if (sample.key == key && sample.time >= m_startedAt && sample.time <= m_stoppedAt)
                found.push_back(&sample);
        }
        return found;
    }
    /// The first of them that `holds`.
    template <class Condition> [[nodiscard]] std::optional<Instant> first(std::string_view key, Condition holds) const
    {
        for (const SeenSample *sample : of(key)) {
            if (holds(*sample))
                return sample->time;
        }
        return std::nullopt;
    }

private:
    void take(const Sample &sample)
    {
        const std::string_view key = m_bench.device->telemetry()->channels()[sample.channel.value].key;
        const int axis = axisOf(key);
        if (axis > 1)
            return;
        m_seen.push_back({std::string(axis == 0 ? key : key.substr(key.find('.') + 1)), sample.time, sample.value,
            m_stream.setPoint().target, m_bench.simulator()->speed(), lost()});
    }
    [[nodiscard]] double position() const
    {
        const auto position = std::find_if(
            m_seen.rbegin(), m_seen.rend(), [](const SeenSample &sample) { return sample.key == "position"; });
        return position == m_seen.rend() ? 0.0 : position->value;
    }
    [[nodiscard]] std::uint64_t lost() const
    {
        const Telemetry &telemetry = *m_bench.device->telemetry();
        std::uint64_t lost = 0;
        for (std::size_t i = 0; i < telemetry.channels().size(); ++i)
            lost += telemetry.lost(ChannelIndex{static_cast<std::uint16_t>(i)});
        return lost;
    }
    void streamChanged()
    {
        if (m_stream.isRunning() && !m_wasRunning) {
            if (m_startedAt == Instant{})
                m_origin = position();
            m_startedAt = now();
        }
        if (!m_stream.isRunning() && m_wasRunning)
            m_stoppedAt = now();
        m_wasRunning = m_stream.isRunning();
    }

    ExperimentBench &m_bench;
    SetPointStream &m_stream;
    bool m_wasRunning = false;
    double m_origin = 0.0;
    Instant m_startedAt{};
    Instant m_stoppedAt{};
    std::vector<SeenSample> m_seen;
    Subscription m_samples;
    Subscription m_changed;
};

} // namespace mb::test
