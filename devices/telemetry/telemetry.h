// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/listeners.h"
#include "async/noncopyable.h"
#include "telemetry/channel.h"
#include "telemetry/history.h"

#include <atomic>
#include <mutex>
#include <span>

namespace mb {

/// A decoded measurement, with the time stamp of the frame it came in.
struct Sample {
    ChannelIndex channel;
    Instant time{};
    double value = 0.0;
};

/// The recordings of one device, shared by the device (which writes) and its readers on any thread. Samples gather in a
/// buffer of the engine thread, and commit() moves them into the histories under one lock a batch. Every channel index
/// must be inside the table.
class Telemetry : NonCopyable {
public:
    /// The table must live as long as this does: families have it in static storage.
    explicit Telemetry(std::span<const Channel> channels);

    /// Any thread. The units of a row may change (useTable), keys and order never do.
    [[nodiscard]] std::span<const Channel> channels() const
    {
        return {m_table.load(std::memory_order_acquire), m_live.size()};
    }
    [[nodiscard]] std::optional<ChannelIndex> find(std::string_view key) const { return findChannel(channels(), key); }

    /// @name Engine thread
    /// @{
    /// The same rows in other units, in static storage too. What was recorded in the old unit of a row is forgotten.
    void useTable(std::span<const Channel> channels);
    /// Listeners hear it now; readers after commit(). A full buffer commits by itself; appending does not allocate.
    void append(const Sample &sample);
    /// `count` samples are known missing here; the line is broken.
    void lost(ChannelIndex channel, std::uint64_t count);
    /// The next sample does not connect to the last one, and nobody knows whether any is missing.
    void breakLine(ChannelIndex channel);
    /// Chunks beyond the store's budget go to its file; nullptr: no sample is recorded, while what is latest, the rates and what was
    /// lost are known all the same. Once, before the first sample.
    void keepIn(const std::shared_ptr<ChunkStore> &store);
    /// Once a batch of frames, or a tick.
    void commit();
    [[nodiscard]] Listeners<const Sample &> &samples() { return m_samples; }
    /// The newest sample, committed or not.
    [[nodiscard]] std::optional<Point> latest(ChannelIndex channel) const { return m_live[channel.value].latest; }
    /// Samples per second over about the last second of source time; 0 once the channel is silent for 2 s before `now` (or three
    /// periods, if that is longer).
    [[nodiscard]] double rate(ChannelIndex channel, Instant now) const;
    /// @}

    /// @name Any thread: what has been committed (see History)
    /// @{
    void columns(ChannelIndex channel, Instant from, Instant to, int pixels, std::vector<Point> &out) const;
    void columns(ChannelIndex channel, Instant from, Instant to, int pixels, ColumnWindow &window) const;
    [[nodiscard]] std::optional<Point> first(ChannelIndex channel) const;
    [[nodiscard]] std::optional<Point> last(ChannelIndex channel) const;
    [[nodiscard]] std::optional<Point> at(ChannelIndex channel, Instant time) const;
    [[nodiscard]] std::optional<History::Extremes> extremes(ChannelIndex channel, Instant from, Instant to) const;
    [[nodiscard]] std::optional<History::Statistics> statistics(ChannelIndex channel, Instant from, Instant to) const;
    [[nodiscard]] std::vector<History::Gap> gaps(
        ChannelIndex channel, Instant from, Instant to, Duration merge = Duration::zero()) const;
    [[nodiscard]] std::size_t size(ChannelIndex channel) const;
    [[nodiscard]] std::uint64_t lost(ChannelIndex channel) const; ///< samples known missing
    [[nodiscard]] std::size_t memoryUse() const;                  ///< bytes, all channels
    /// Moves with every commit that brought something, and with clear(). No lock.
    [[nodiscard]] std::uint64_t revision() const { return m_revision.load(std::memory_order_acquire); }
    /// Calls `visit(const Point &)` for the samples in [from, to] and the gaps between them. The lock is let go between
    /// blocks, so that a long export never holds up the engine.
    template <class Visitor> void forEach(ChannelIndex channel, Instant from, Instant to, Visitor visit) const;
    /// The same for readers that go on later: see History::lowerBound() and History::read().
    [[nodiscard]] std::size_t lowerBound(ChannelIndex channel, Instant from) const;
    std::size_t read(
        ChannelIndex channel, std::size_t index, Instant to, std::size_t most, std::vector<Point> &out) const;
    /// Forgets the recordings. What is latest, and the rates, stay.
    void clear();
    /// Of a channel: another once what was recorded was forgotten, and numbers of samples begin anew.
    [[nodiscard]] std::uint64_t generation(ChannelIndex channel) const;
    /// @}

private:
    static constexpr std::size_t pendingMost = 4096;
    static constexpr std::size_t blockSize = 4096;

    enum class Kind : std::uint8_t { Measured, Break };
    struct Pending {
        Instant time{};
        double value = 0.0;
        std::uint64_t lost = 0;
        ChannelIndex channel;
        Kind kind = Kind::Measured;
    };
    /// What the engine thread knows of a channel without the lock.
    struct Live {
        std::optional<Point> latest;
        Instant windowStart{};
        std::uint64_t inWindow = 0; ///< samples after the one at windowStart
        double rate = 0.0;          ///< of the window before

        void measure(Instant time);
    };

    void push(const Pending &pending);
    [[nodiscard]] const History &history(ChannelIndex channel) const { return m_histories[channel.value]; }

    std::atomic<const Channel *> m_table;
    std::vector<Live> m_live;
    std::vector<Pending> m_pending;
    bool m_keeps = true;
    Listeners<const Sample &> m_samples;

    mutable std::mutex m_mutex; ///< guards m_histories
    std::vector<History> m_histories;
    std::vector<std::uint64_t> m_generations; ///< guarded, too
    std::atomic<std::uint64_t> m_revision{0};
};

template <class Visitor> void Telemetry::forEach(ChannelIndex channel, Instant from, Instant to, Visitor visit) const
{
    std::vector<Point> block;
    std::size_t index = lowerBound(channel, from);
    for (bool begun = false;; begun = true) {
        const std::size_t following = read(channel, index, to, blockSize, block);
        if (following == index)
            return;
        const std::size_t skip = !begun && block.front().isGap() ? 1 : 0;
        for (std::size_t i = skip; i < block.size(); ++i)
            visit(static_cast<const Point &>(block[i]));
        index = following;
    }
}

} // namespace mb
