// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/linkreturn.h"

#include "async/sleep.h"
#include "transport/canlink.h"

namespace mb {
namespace {

constexpr Duration retryPeriod = std::chrono::milliseconds(250);

bool mayReturn(const Link &link)
{
    if (link.state() == LinkState::Closed)
        return false;
    return link.kind() != LinkKind::Can || static_cast<const CanLink &>(link).health().state != BusState::BusOff;
}

} // namespace

Task<void> linkReturn(Link &link, Clock &clock, Duration limit)
{
    const Instant end = clock.now() + limit;
    Error cause = link.notOpen();
    while (true) {
        co_await Sleep(clock, retryPeriod); // before it is opened, and before it is trusted: it may be going only now
        if (link.state() == LinkState::Open)
            co_return {};
        if (!mayReturn(link))
            co_return fail(link.notOpen());
        if (clock.now() >= end)
            co_return fail(cause);
        if (const Result<void> opened = co_await link.openSoon().attempt(); !opened)
            cause = opened.error();
    }
}

} // namespace mb
