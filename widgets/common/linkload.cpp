// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/linkload.h"

#include <limits>

namespace mb {
namespace {

constexpr Duration keepTime = std::chrono::milliseconds(500);

} // namespace

double loadOf(const LinkView &link)
{
    return link.load.value_or(std::numeric_limits<double>::quiet_NaN());
}

bool LinkLoads::keep(const Snapshot &snapshot)
{
    if (snapshot.time - m_keptAt < keepTime)
        return false;
    m_keptAt = snapshot.time;
    std::erase_if(m_loads, [&snapshot](const auto &entry) { return !snapshot.link(entry.first); });
    for (const LinkView &link : snapshot.links) {
        std::deque<double> &loads = m_loads[link.address];
        if (!link.load)
            continue;
        loads.push_back(*link.load);
        if (loads.size() > points)
            loads.pop_front();
    }
    return true;
}

} // namespace mb
