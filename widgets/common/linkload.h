// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/snapshot.h"

#include <deque>
#include <map>
#include <string>

namespace mb {

/// Fraction of the line in use, 0…1; NaN where it is not known (yet), which is shown as "–".
[[nodiscard]] double loadOf(const LinkView &link);

/// The load of every link during the last minute, a point each half second, for who sees every snapshot, shown or not.
class LinkLoads {
public:
    static constexpr std::size_t points = 120;

    /// Whether it was time for a point.
    bool keep(const Snapshot &snapshot);
    /// Oldest first; as much as is known.
    [[nodiscard]] const std::deque<double> &of(const std::string &link) { return m_loads[link]; }

private:
    std::map<std::string, std::deque<double>> m_loads; ///< by address of the link
    Instant m_keptAt{};
};

} // namespace mb
