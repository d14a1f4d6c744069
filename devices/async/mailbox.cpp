// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/mailbox.h"

#include <cstdint>
#include <utility>

#include <sys/eventfd.h>
#include <unistd.h>

namespace mb {

Mailbox::Mailbox()
    : m_event(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC))
{
}

Mailbox::~Mailbox()
{
    ::close(m_event);
}

bool Mailbox::post(std::function<void()> work)
{
    return put(m_waiting, std::move(work));
}

bool Mailbox::postUrgent(std::function<void()> work)
{
    return put(m_urgent, std::move(work));
}

bool Mailbox::put(std::vector<std::function<void()>> &lane, std::function<void()> work)
{
    const std::lock_guard lock(m_mutex);
    if (m_closed)
        return false;
    lane.push_back(std::move(work));
    const std::uint64_t one = 1;
    // A full counter means that it is readable already.
    [[maybe_unused]] const auto written = ::write(m_event, &one, sizeof one);
    return true;
}

void Mailbox::drain()
{
    std::vector<std::function<void()>> work;
    {
        const std::lock_guard lock(m_mutex);
        std::uint64_t count = 0;
        [[maybe_unused]] const auto taken = ::read(m_event, &count, sizeof count);
        work.swap(m_waiting);
    }
    for (const auto &item : work) {
        drainUrgent();
        if (m_closed)
            break;
        item();
    }
    drainUrgent();
}

void Mailbox::drainUrgent()
{
    std::vector<std::function<void()>> work;
    {
        const std::lock_guard lock(m_mutex);
        work.swap(m_urgent);
    }
    for (const auto &item : work) {
        if (m_closed)
            break;
        item();
    }
}

void Mailbox::close()
{
    std::vector<std::function<void()>> dropped;
    std::vector<std::function<void()>> droppedUrgent;
    const std::lock_guard lock(m_mutex);
    m_closed = true;
    dropped.swap(m_waiting);
    droppedUrgent.swap(m_urgent);
}

} // namespace mb
