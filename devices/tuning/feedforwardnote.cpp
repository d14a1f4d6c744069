// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/feedforwardnote.h"

#include "model/loopparameters.h"

#include <algorithm>

namespace mb::tuning {

Message feedForwardNote(const TuneReport &report, const Family *family)
{
    const auto &rows = report.proposed.rows;
    const bool idle = std::ranges::any_of(rows, [family](const ScaledGains::Row &row) {
        const Role role = row.role == Role::None && family ? roleOf(*family, row.key) : row.role;
        return role == Role::FeedForward && row.raw == 0;
    });
    if (!idle)
        return {};
    return report.loop == Mode::Position
        ? say("F is 0: in a position loop it would push by where the target lies, not by how far it is")
        : say("F is 0: with an integral both would give what friction and speed take, and it would overshoot");
}

} // namespace mb::tuning
