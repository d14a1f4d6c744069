// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/endsignals.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <utility>

#include <sys/eventfd.h>
#include <unistd.h>

namespace mb {
namespace {

constexpr std::array endings{SIGINT, SIGTERM, SIGHUP};
std::atomic<int> arrivals = -1; // the handler has no argument of ours

void tellArrival(int)
{
    const int before = errno;
    const std::uint64_t one = 1;
    (void)!::write(arrivals, &one, sizeof one);
    errno = before;
}

void setHandler(void (*from)(int), void (*to)(int))
{
    for (const int number : endings) {
        struct sigaction action { };
        if (::sigaction(number, nullptr, &action) != 0 || action.sa_handler != from)
            continue;
        action = {};
        action.sa_handler = to;
        action.sa_flags = SA_RESTART;
        ::sigaction(number, &action, nullptr);
    }
}

} // namespace

EndSignals::EndSignals(std::function<void()> received)
    : m_descriptor(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC))
    , m_notifier(m_descriptor, QSocketNotifier::Read)
{
    QObject::connect(&m_notifier, &QSocketNotifier::activated, &m_notifier, [this, received = std::move(received)] {
        std::uint64_t count = 0;
        if (::read(m_descriptor, &count, sizeof count) == sizeof count)
            received();
    });
    arrivals = m_descriptor;
    setHandler(SIG_DFL, tellArrival);
}

EndSignals::~EndSignals()
{
    setHandler(tellArrival, SIG_DFL);
    arrivals = -1;
    m_notifier.setEnabled(false);
    ::close(m_descriptor);
}

} // namespace mb
