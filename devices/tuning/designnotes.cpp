// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/designnotes.h"

#include "experiment/figures.h"
#include "model/loopparameters.h"
#include "model/parameter.h"

#include <cmath>

namespace mb::tuning {

std::vector<Message> designNotes(const TuneReport &report, const Family *family)
{
    std::vector<Message> notes;
    for (const ScaledGains::Row &row : report.proposed.rows) {
        const Role role = row.role == Role::None && family ? roleOf(*family, row.key) : row.role;
        const double steps = std::abs(static_cast<double>(row.raw));
        if (isGain(role) && steps > 0.0 && steps < leastGainSteps)
            notes.push_back(say("%1 is %2 of its smallest steps, fewer than %3: one of them is %4", row.key, steps,
                leastGainSteps, percentText(1.0 / steps)));
        if (role == Role::FeedForward && row.raw == 0)
            notes.push_back(report.loop == Mode::Position
                    ? say("F is 0: in a position loop it would push by where the target lies, not by how far it is")
                    : say("F is 0: with an integral both would give what friction and speed take, and it would "
                          "overshoot"));
    }
    return notes;
}

} // namespace mb::tuning
