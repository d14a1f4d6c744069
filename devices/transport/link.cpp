// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/link.h"

#include "async/noncopyable.h"

namespace mb {

Link::Link(LinkAddress address, LinkKind kind)
    : m_address(std::move(address))
    , m_kind(kind)
{
}

Link::~Link() = default;

Outlet Link::outlet() const
{
    return m_address.isSimulated() ? Outlet{Outlet::Form::InProcess, -1} : doOutlet();
}

Result<void> Link::open()
{
    if (m_state == LinkState::Open)
        return {};
    MB_TRY_VOID(beginOpening());
    MB_TRY_VOID(doOpen());
    return endOpening();
}

namespace {

Error replaced(const Link &link)
{
    return {Fault::LinkLost, say("another adapter is called %1 now", link.address().shortName()),
        say("close the link, and open it again to see who is there")};
}

} // namespace

bool isReplaced(Link &link)
{
    if (link.line().empty())
        return false;
    const std::string now = link.settings().identify(link.address());
    return now != link.line() && isPlace(now); // else there may be nobody
}

Result<void> Link::beginOpening()
{
    if (isReplaced(*this))
        return fail(replaced(*this));
    ++m_attempt;
    if (m_state == LinkState::Lost)
        doClose();
    else
        m_counters = {};
    return {};
}

/// Another one may have come while it was opened.
Result<void> Link::endOpening()
{
    const std::string now = m_settings.identify(m_address);
    if (!m_line.empty() && now != m_line) {
        doClose();
        return fail(replaced(*this));
    }
    m_line = now;
    m_loss = {Fault::LinkLost};
    setState(LinkState::Open);
    return {};
}

Task<void> Link::openSoon()
{
    if (m_state == LinkState::Open)
        co_return {};
    if (m_opening)
        co_return fail(Fault::LinkLost, say("%1 is being opened already", m_address.shortName()));
    if (!m_settings.background)
        co_return open();
    struct Mark : private NonCopyable {
        explicit Mark(bool &opening)
            : isOpening(opening)
        {
            isOpening = true;
        }
        ~Mark() { isOpening = false; }
        bool &isOpening;
    };
    const Mark mark(m_opening);
    if (auto begun = beginOpening(); !begun)
        co_return begun;
    const int attempt = m_attempt;
    const Result<void> opened = co_await doOpenSoon(*m_settings.background).attempt();
    if (!opened)
        co_return fail(opened.error());
    if (attempt != m_attempt) {
        doClose();
        co_return fail(Fault::Cancelled, say("%1 was closed before it was open", m_address.shortName()));
    }
    m_opening = false;
    co_return endOpening();
}

void Link::close()
{
    ++m_attempt;
    if (m_state == LinkState::Closed)
        return;
    doClose();
    m_loss = {Fault::LinkLost};
    setState(LinkState::Closed);
}

void Link::closedFor(Message reason)
{
    if (m_state != LinkState::Closed)
        return;
    m_loss.detail = std::move(reason);
    setState(LinkState::Lost);
}

Error Link::notOpen() const
{
    return m_loss.detail.empty() ? Error{Fault::LinkLost, say("%1 is not open", m_address.shortName())} : m_loss;
}

void Link::lose(Error loss)
{
    if (m_state != LinkState::Open)
        return;
    m_loss = std::move(loss);
    setState(LinkState::Lost);
}

void Link::setState(LinkState state)
{
    if (std::exchange(m_state, state) == state)
        return;
    m_stateChanged.notify(state);
}

void Link::passed(const Traffic &traffic)
{
    const std::uint64_t count = traffic.can ? 1 : traffic.bytes.size();
    (traffic.direction == Direction::Received ? m_counters.rx : m_counters.tx) += count;
    m_traffic.notify(traffic);
}

} // namespace mb
