// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/qtclock.h"

#include <QSocketNotifier>

#include <algorithm>
#include <cstdint>
#include <ctime>
#include <utility>

#include <sys/timerfd.h>
#include <unistd.h>

namespace mb {
namespace {

constexpr Duration longestPass = std::chrono::milliseconds(2);

Duration timeOf(clockid_t clock)
{
    timespec time{};
    ::clock_gettime(clock, &time);
    return std::chrono::seconds(time.tv_sec) + Duration(time.tv_nsec);
}

/// How far `other` is ahead of `clock`. Who is held up between the two is wrong by as much: of a few looks, the quickest counts.
template <class Clock, class Other> Duration ahead(const Clock &clock, const Other &other)
{
    constexpr Duration quick = std::chrono::microseconds(20);
    constexpr int looks = 5;
    Duration taken = Duration::max();
    Duration difference{};
    for (int i = 0; i < looks && taken > quick; ++i) {
        const Duration before = clock();
        const Duration elsewhere = other();
        const Duration took = clock() - before;
        if (took < taken)
            difference = elsewhere - (before + took / 2);
        taken = std::min(took, taken);
    }
    return difference;
}

} // namespace

KernelClocks KernelClocks::ofSystem()
{
    return {[] { return timeOf(CLOCK_MONOTONIC); }, [] { return timeOf(CLOCK_BOOTTIME); }};
}

QtClock::QtClock(KernelClocks clocks)
    : m_clocks(std::move(clocks))
    , m_descriptor(::timerfd_create(CLOCK_MONOTONIC, TFD_NONBLOCK | TFD_CLOEXEC))
    , m_notifier(std::make_unique<QSocketNotifier>(m_descriptor, QSocketNotifier::Read))
{
    lookForSleep();
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
    return ahead([this] { return now().time_since_epoch(); },
        [] { return std::chrono::duration_cast<Duration>(std::chrono::system_clock::now().time_since_epoch()); });
}

Duration QtClock::slept() const
{
    return ahead(m_clocks.awake, m_clocks.always);
}

SleepLog QtClock::sleeps()
{
    lookForSleep();
    const std::lock_guard lock(m_sleepMutex);
    return m_sleeps;
}

void QtClock::lookForSleep()
{
    const std::lock_guard lock(m_sleepMutex);
    m_sleeps.look(now(), slept());
}

void QtClock::rescheduled()
{
    if (m_running)
        return; // runDue() programs the timer once, at its end
    const Instant next = hasWork() ? std::max(nextDeadline(), Instant(Duration(1))) : Instant{};
    if (std::exchange(m_programmed, next) == next)
        return;
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
    lookForSleep();
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
