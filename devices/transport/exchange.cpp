// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/exchange.h"

namespace mb {

Task<CanFrame> exchange(CanLink &link, Clock &clock, CanFrame request, CanInbox::Match match, Attempts attempts)
{
    CanInbox inbox(link, clock, std::move(match));
    Error last{Fault::Timeout, say("no answer")};
    for (int i = 0; i < link.settings().patience.tries(attempts.tries); ++i) {
        co_await link.send(request);
        Result<CanFrame> reply = co_await inbox.next(link.settings().patience.answer(attempts.timeout));
        if (reply)
            co_return *reply;
        last = reply.error();
        if (last.fault != Fault::Timeout)
            break;
    }
    co_return fail(last);
}

} // namespace mb
