// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/livestate.h"

namespace mb {

std::vector<const StateRow *> conditionsOf(std::span<const StateRow> table, const LiveStates &states)
{
    std::vector<const StateRow *> found;
    for (std::size_t i = 0; i < table.size(); ++i) {
        if (table[i].kind != StateKind::Input && states.isOn({static_cast<std::uint16_t>(i)}))
            found.push_back(&table[i]);
    }
    return found;
}

} // namespace mb
