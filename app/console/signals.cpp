// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/signals.h"

#include <csignal>

#include <sys/signalfd.h>
#include <unistd.h>

namespace mb::console {
namespace {

sigset_t ending()
{
    sigset_t set;
    sigemptyset(&set);
    for (const int number : {SIGINT, SIGTERM, SIGHUP})
        sigaddset(&set, number);
    return set;
}

int makeDescriptor()
{
    const sigset_t set = ending();
    ::sigprocmask(SIG_BLOCK, &set, nullptr);
    return ::signalfd(-1, &set, SFD_NONBLOCK | SFD_CLOEXEC);
}

} // namespace

Signals::Signals(std::function<void()> received)
    : m_descriptor(makeDescriptor())
    , m_notifier(m_descriptor, QSocketNotifier::Read)
{
    QObject::connect(&m_notifier, &QSocketNotifier::activated, &m_notifier, [this, received = std::move(received)] {
        signalfd_siginfo caught{};
        while (::read(m_descriptor, &caught, sizeof caught) == sizeof caught)
            received();
    });
}

Signals::~Signals()
{
    m_notifier.setEnabled(false);
    ::close(m_descriptor);
    release();
}

void Signals::release()
{
    const sigset_t set = ending();
    ::sigprocmask(SIG_UNBLOCK, &set, nullptr);
}

} // namespace mb::console
