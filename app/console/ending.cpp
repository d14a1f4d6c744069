// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/ending.h"

namespace mb::console {

Error lossOf(const Link &link)
{
    Error loss = link.loss();
    loss.detail = say("%1 was lost: %2", link.address().text(), loss.detail);
    return loss;
}

Ending::Ending(Console &console)
    : m_time(console.clock())
    , m_posted(console.clock())
    , m_interrupted(console.interrupted().add([this] { end(Cause::Interrupted); }))
{
    if (console.isInterrupted())
        end(Cause::Interrupted);
}

void Ending::watch(Link &link)
{
    watchPatiently(link, {});
}

void Ending::watchPatiently(Link &link, std::function<bool(const Link &)> mayReturn)
{
    const auto look = [this, &link, mayReturn = std::move(mayReturn)] {
        if (link.state() != LinkState::Lost || (mayReturn && mayReturn(link)))
            return;
        m_loss = lossOf(link);
        end(Cause::LinkLost);
    };
    m_links.push_back(link.stateChanged().add([look](LinkState) { look(); }));
    look();
    if (ReplayLink *const recording = replayOf(link)) {
        m_recordings.push_back(recording);
        m_links.push_back(recording->ended().add([this] { end(Cause::Time); }));
    }
}

Event::Wait Ending::wait()
{
    for (ReplayLink *recording : m_recordings)
        recording->play();
    return m_event.wait();
}

void Ending::after(std::optional<Duration> time)
{
    if (time)
        m_time.startIn(*time, [this] { end(Cause::Time); });
}

void Ending::end(Cause cause)
{
    if (m_cause != Cause::None)
        return;
    m_cause = cause;
    m_posted.startIn(Duration::zero(), [this] { m_event.set(); });
}

} // namespace mb::console
