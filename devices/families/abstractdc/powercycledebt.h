// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/deviceprofile.h"

#include <cstdint>
#include <functional>

namespace mb::abstractdc {

/// A drive whose averaging was lowered, by anybody, owes a power cycle before it may be driven (README.md#averaging). Kept in its profile:
/// another run of this program must know it, too. In doubt (Whereabouts) the debt stays. Engine thread.
class PowerCycleDebt {
public:
    static constexpr const char *fault = "power_cycle_owed"; ///< Liveness::faults

    /// `keep` writes DeviceProfile::counters; the profile outlives this.
    PowerCycleDebt(const DeviceProfile &profile, std::function<void(std::int64_t owed)> keep);

    [[nodiscard]] bool isOwed() const;
    void incur()
    {
        if (!isOwed())
            m_keep(1);
    }
    /// It has begun anew.
    void pay();

private:
    const DeviceProfile &m_profile;
    std::function<void(std::int64_t)> m_keep;
};

} // namespace mb::abstractdc
