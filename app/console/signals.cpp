// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/signals.h"

#include <csignal>

#include <sys/signalfd.h>
#include <unistd.h>

namespace mb::console {
namespace {

/// A hang-up that `nohup` has made to be ignored stays so. An interrupt does not: a script's `drive … &` is stopped by it.
bool isIgnored(int number)
{
    struct sigaction action { };
    return ::sigaction(number, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

const sigset_t &ending()
{
    static const sigset_t set = [] {
        sigset_t made;
        sigemptyset(&made);
        for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
            if (number != SIGHUP || !isIgnored(number))
                sigaddset(&made, number);
        }
        return made;
    }();
    return set;
}

int makeDescriptor()
{
    ::sigprocmask(SIG_BLOCK, &ending(), nullptr);
    return ::signalfd(-1, &ending(), SFD_NONBLOCK | SFD_CLOEXEC);
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
    ::sigprocmask(SIG_UNBLOCK, &ending(), nullptr);
}

} // namespace mb::console
