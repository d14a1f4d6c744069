// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/noncopyable.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <utility>

namespace mb {

using Duration = std::chrono::nanoseconds;
/// A point on the monotonic time line of the clock in use. Time stamps of frames and samples are on the same line.
using Instant = std::chrono::time_point<std::chrono::steady_clock, Duration>;

/// The only source of time below `app`. Single-threaded: arm, disarm and the callbacks belong to one thread.
/// Callbacks run in the order of their deadlines, those of one deadline in the order they were armed, and may arm and
/// disarm freely.
class Clock : NonCopyable {
public:
    using Key = std::pair<Instant, std::uint64_t>;

    virtual ~Clock() = default;

    [[nodiscard]] virtual Instant now() const = 0;
    /// What to add to an Instant's count to get Unix time; zero on a virtual clock.
    [[nodiscard]] virtual Duration unixOffset() const = 0;
    /// How long the computer has slept (suspend) up to now: time that passed outside, and not on this clock. Never shrinks.
    [[nodiscard]] virtual Duration slept() const { return {}; }

    /// Runs `work` once at `deadline` (as soon as possible when that is past). The key ends with the run.
    Key arm(Instant deadline, std::function<void()> work);
    /// Forgets the work; harmless when it has run already.
    void disarm(Key key);
    /// Runs `work` after the present callback has returned.
    Key post(std::function<void()> work) { return arm(now(), std::move(work)); }

    [[nodiscard]] std::size_t armed() const { return m_queue.size(); }

protected:
    /// The earliest deadline may have changed.
    virtual void rescheduled() { }
    [[nodiscard]] bool hasWork() const { return !m_queue.empty(); }
    [[nodiscard]] Instant nextDeadline() const { return m_queue.begin()->first.first; }
    void runNext();

private:
    std::map<Key, std::function<void()>> m_queue;
    std::uint64_t m_sequence = 0;
};

/// One deadline that its owner can move or drop; dropped with its owner.
class Timer : NonCopyable {
public:
    explicit Timer(Clock &clock)
        : m_clock(clock)
    {
    }
    ~Timer() { stop(); }

    void start(Instant deadline, std::function<void()> work);
    void startIn(Duration delay, std::function<void()> work) { start(m_clock.now() + delay, std::move(work)); }
    void stop();
    [[nodiscard]] bool isActive() const { return m_active; }

private:
    Clock &m_clock;
    Clock::Key m_key{};
    bool m_active = false;
};

} // namespace mb
