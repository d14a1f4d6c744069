// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/caninbox.h"

namespace mb {

CanInbox::CanInbox(CanLink &link, Clock &clock, Match match)
    : m_link(link)
    , m_timer(clock)
    , m_received(link.received().add([this, match = std::move(match)](const CanFrame &frame) {
        if (!match(frame))
            return;
        m_frames.push_back(frame);
        wake();
    }))
    , m_stateChanged(link.stateChanged().add([this](LinkState) { wake(); }))
{
}

void CanInbox::wait(std::coroutine_handle<> handle, Duration timeout)
{
    m_waiting = handle;
    m_timer.startIn(timeout, [this] { wake(); });
}

void CanInbox::wake()
{
    m_timer.stop();
    if (const auto handle = std::exchange(m_waiting, {}))
        handle.resume();
}

void CanInbox::forget()
{
    m_waiting = {};
    m_timer.stop();
}

Result<CanFrame> CanInbox::take()
{
    if (!m_frames.empty()) {
        const CanFrame frame = m_frames.front();
        m_frames.pop_front();
        return frame;
    }
    if (m_link.state() != LinkState::Open)
        return fail(m_link.notOpen());
    return fail(Fault::Timeout, say("no answer"));
}

} // namespace mb
