// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/leaserenewal.h"

#include <utility>

namespace mb {

LeaseRenewal::LeaseRenewal(Clock &clock, std::function<void()> renew)
    : m_renew(std::move(renew))
    , m_timer(clock)
{
    next();
}

/// The next is set before this one, so that stop() from inside ends it.
void LeaseRenewal::next()
{
    m_timer.startIn(period, [this] { next(); });
    m_renew();
}

} // namespace mb
