// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/linkframerate.h"

#include <algorithm>

namespace mb {
namespace {

constexpr Duration rateTime = std::chrono::milliseconds(500);

} // namespace

double LinkFrameRate::of(const LinkView &link, Instant now)
{
    const bool known = m_link == link.address;
    if (known && now - m_since < rateTime)
        return m_rate;
    const std::uint64_t frames = link.counters.rx + link.counters.tx;
    m_rate = known ? static_cast<double>(frames - std::min(frames, m_frames))
            / std::chrono::duration<double>(now - m_since).count()
                   : 0.0;
    m_link = link.address;
    m_since = now;
    m_frames = frames;
    return m_rate;
}

} // namespace mb
