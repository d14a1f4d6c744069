// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/supermodified/linepolls.h"

#include <algorithm>

namespace mb::supermodified {

LinePolls::LinePolls(Clock &clock, std::function<void()> due)
    : m_clock(clock)
    , m_due(std::move(due))
    , m_timer(clock)
{
}

LinePolls::Key LinePolls::add(LineRequest request, Duration period, LineReply done)
{
    request.rank = LineRequest::Rank::Poll;
    const Key key = m_schedule.add(period, m_clock.now());
    m_polls[key] = Poll{request, std::move(done), key};
    m_timer.startIn(Duration::zero(), m_due);
    return key;
}

void LinePolls::setPeriod(Key key, Duration period)
{
    m_schedule.setPeriod(key, period, m_clock.now());
    arm();
}

void LinePolls::setRequest(Key key, LineRequest request)
{
    request.rank = LineRequest::Rank::Poll;
    m_polls.at(key).request = request;
}

void LinePolls::remove(Key key)
{
    m_schedule.remove(key);
    m_polls.erase(key);
}

std::optional<LinePolls::Poll> LinePolls::next(bool tasksWait)
{
    const auto due = m_schedule.nextDue();
    if (!due || *due > m_clock.now() || (tasksWait && !m_taskWasLast))
        return std::nullopt;
    m_taskWasLast = false;
    return m_polls.at(m_schedule.take(m_clock.now()));
}

void LinePolls::arm()
{
    const auto due = m_schedule.nextDue();
    if (!due)
        m_timer.stop();
    else
        m_timer.start(std::max(*due, m_clock.now()), m_due);
}

} // namespace mb::supermodified
