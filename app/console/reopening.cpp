// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/reopening.h"

#include "transport/canlink.h"

namespace mb::console {
namespace {

constexpr Duration retryPeriod = std::chrono::milliseconds(500); // where the kernel gives no notice

} // namespace

Reopening::Reopening(Console &console, Link &link, std::function<Task<void>()> again)
    : m_console(console)
    , m_link(link)
    , m_again(std::move(again))
    , m_watch(console.clock())
    , m_retry(console.clock())
    , m_plugged(m_watch.changed().add([this] { attempt(); }))
    , m_state(link.stateChanged().add([this](LinkState state) { follow(state); }))
    , m_scope(console.clock())
{
}

bool Reopening::mayReturn(const Link &link)
{
    if (link.address().scheme != "socketcan" || link.kind() != LinkKind::Can)
        return false;
    return static_cast<const CanLink &>(link).health().state != BusState::BusOff;
}

void Reopening::follow(LinkState state)
{
    if (state != LinkState::Lost || !mayReturn(m_link))
        return;
    m_console.note(
        m_link.address().text() + " is lost: " + m_link.loss().message().english() + "; waiting for it to come back");
    m_retry.startIn(retryPeriod, [this] { attempt(); });
}

void Reopening::attempt()
{
    if (m_link.state() != LinkState::Lost || !mayReturn(m_link))
        return;
    m_retry.startIn(retryPeriod, [this] { attempt(); });
    if (!m_link.open())
        return;
    m_retry.stop();
    m_console.note(m_link.address().text() + " is back");
    m_scope.spawn<void>(resume(), [](const Result<void> &) {});
}

Task<void> Reopening::resume()
{
    (void)co_await m_console.session().scan(m_link).attempt();
    if (!m_again)
        co_return {};
    co_await m_again();
    co_return {};
}

} // namespace mb::console
