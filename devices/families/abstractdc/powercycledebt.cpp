// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/powercycledebt.h"

#include "families/abstractdc/parameters.h"

#include <utility>

namespace mb::abstractdc {

PowerCycleDebt::PowerCycleDebt(const DeviceProfile &profile, std::function<void(std::int64_t)> keep)
    : m_profile(profile)
    , m_keep(std::move(keep))
{
}

bool PowerCycleDebt::isOwed() const
{
    const auto owed = m_profile.counters.find(std::string(counter::powerCycle));
    return owed != m_profile.counters.end() && owed->second != 0;
}

void PowerCycleDebt::pay()
{
    if (isOwed())
        m_keep(0);
}

} // namespace mb::abstractdc
