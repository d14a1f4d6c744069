// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/canqueue.h"

#include <algorithm>

namespace mb {

Result<void> CanQueue::admit(const CanFrame &frame, Priority priority, const std::string &link)
{
    const std::size_t waiting = priority == Priority::Urgent ? m_urgent.size() : m_normal.size();
    if (waiting >= mostWaiting)
        return fail(Fault::LinkLost, say("%1 takes no frames: %2 wait to be sent", link, waiting),
            say("check that somebody else is on the bus"));
    if (priority == Priority::Urgent) {
        std::erase_if(m_normal, [&frame](const CanFrame &other) { return sameIdentifier(other, frame); });
        std::erase_if(m_urgent, [&frame](const CanFrame &other) { return sameContent(other, frame); });
        if (!isStop(frame))
            m_stops.push_back(frame);
    }
    return {};
}

void CanQueue::push(const CanFrame &frame, Priority priority)
{
    if (m_normal.empty())
        m_frontSince = frame.time;
    (priority == Priority::Urgent ? m_urgent : m_normal).push_back(frame);
}

CanQueue::Next CanQueue::take()
{
    const Priority priority = m_urgent.empty() ? Priority::Normal : Priority::Urgent;
    auto &queue = m_urgent.empty() ? m_normal : m_urgent;
    const Next next{queue.front(), priority};
    queue.pop_front();
    return next;
}

void CanQueue::wentOut(const Next &next)
{
    if (next.priority == Priority::Normal)
        m_frontSince = m_clock.now();
}

bool CanQueue::putBack(const Next &next)
{
    const bool urgent = next.priority == Priority::Urgent;
    if (!urgent && std::ranges::any_of(m_urgent, [&next](const CanFrame &waiting) {
            return sameIdentifier(waiting, next.frame);
        }))
        return false;
    (urgent ? m_urgent : m_normal).push_front(next.frame);
    return true;
}

/// A stop waits on also where it comes a second time, behind a set-point that the interface may still hold.
std::size_t CanQueue::dropStale()
{
    const Instant now = m_clock.now();
    if (m_normal.empty() || now - m_frontSince < mostPatience)
        return 0;
    return std::erase_if(
        m_normal, [&](const CanFrame &waiting) { return now - waiting.time >= mostPatience && !isStop(waiting); });
}

void CanQueue::clear()
{
    m_urgent.clear();
    m_normal.clear();
}

bool CanQueue::isStop(const CanFrame &frame) const
{
    return std::ranges::any_of(m_stops, [&frame](const CanFrame &stop) { return sameContent(stop, frame); });
}

} // namespace mb
