// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/qtclock.h"

#include <QSocketNotifier>

#include <algorithm>
#include <cstdint>

#include <sys/timerfd.h>
#include <unistd.h>

namespace mb {
namespace {

constexpr Duration longestPass = std::chrono::milliseconds(2);

} // namespace

QtClock::QtClock()
    : m_descriptor(::timerfd_create(CLOCK_MONOTONIC, TFD_NONBLOCK | TFD_CLOEXEC))
    , m_notifier(std::make_unique<QSocketNotifier>(m_descriptor, QSocketNotifier::Read))
{
    QObject::connect(m_notifier.get(), &QSocketNotifier::activated, m_notifier.get(), [this] { runDue(); });
}

QtClock::~QtClock()
{
    m_notifier.reset();
    ::close(m_descriptor);
}

Instant QtClock::now() const
{
    return std::chrono::time_point_cast<Duration>(std::chrono::steady_clock::now());
}

Duration QtClock::unixOffset() const
{
    // Somebody who is held up between the two clocks is wrong by as much: of a few looks, the quickest counts.
    constexpr Duration quick = std::chrono::microseconds(20);
    constexpr int looks = 5;
    Duration taken = Duration::max();
    Duration offset{};
    for (int i = 0; i < looks && taken > quick; ++i) {
        const Instant before = now();
        const auto unixTime = std::chrono::duration_cast<Duration>(std::chrono::system_clock::now().time_since_epoch());
        const Duration took = now() - before;
        if (took < taken)
            offset = unixTime - (before + took / 2).time_since_epoch();
        taken = std::min(took, taken);
    }
    return offset;
}

void QtClock::rescheduled()
{
    if (m_running)
        return; // runDue() programs the timer once, at its end
    const Instant next = hasWork() ? std::max(nextDeadline(), Instant(Duration(1))) : Instant{};
    if (next == m_programmed)
        return;
    m_programmed = next;
    const auto nanoseconds = next.time_since_epoch().count();
    itimerspec spec{};
    spec.it_value.tv_sec = static_cast<time_t>(nanoseconds / 1'000'000'000);
    spec.it_value.tv_nsec = static_cast<long>(nanoseconds % 1'000'000'000);
    ::timerfd_settime(m_descriptor, TFD_TIMER_ABSTIME, &spec, nullptr);
}

void QtClock::runDue()
{
    std::uint64_t expirations = 0;
    [[maybe_unused]] const auto got = ::read(m_descriptor, &expirations, sizeof expirations);
    m_running = true;
    // Work that arms itself again for now, or lags behind its deadlines, must not starve the descriptors: one pass up
    // to the time it began at, for a short while.
    const Instant until = now();
    while (hasWork() && nextDeadline() <= until && now() - until < longestPass)
        runNext();
    m_running = false;
    m_programmed = {};
    rescheduled();
}

} // namespace mb
