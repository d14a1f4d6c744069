// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/deviceprofile.h"

#include <cstdint>
#include <functional>
#include <optional>

namespace mb::abstractdc {

/// A drive whose averaging was lowered owes a power cycle before it may be driven (README.md#averaging). Kept in its profile:
/// another run of this program must know it, too. What was heard before and after a silence tells whether it had one; in doubt the debt
/// stays, and what was not saved counts as gone. Engine thread.
class PowerCycleDebt {
public:
    /// `keep` writes DeviceProfile::counters; the profile outlives this.
    PowerCycleDebt(const DeviceProfile &profile, std::function<void(std::int64_t owed)> keep);

    [[nodiscard]] bool isOwed() const;
    void incur() { m_keep(1); }
    /// It does not answer any more; `position`, in counts, was the last that it told.
    void silent(bool linkOpen, std::optional<std::int64_t> position);
    /// It tells a position, in counts. One that starts anew has lost its power, one that is heard again where it was only its cable.
    /// Whether it may have lost its power, also while its link was gone or before this program ran.
    bool heard(std::int32_t position);

private:
    const DeviceProfile &m_profile;
    std::function<void(std::int64_t)> m_keep;
    bool m_wasUnheard = true;                     ///< since it was heard last, or never heard
    bool m_wasSilent = false;                     ///< the same, while its link was open: it is off, or its cable is out
    std::optional<std::int64_t> m_positionBefore; ///< the silence
};

} // namespace mb::abstractdc
