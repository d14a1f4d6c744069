// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/supermodified/movecommand.h"

#include <array>

namespace mb::supermodified {

bool isPosition(Mode mode)
{
    return mode == Mode::Position || mode == Mode::RampPosition;
}

bool isProfiled(Mode mode)
{
    return mode == Mode::RampPosition || mode == Mode::RampVelocity;
}

Result<Command> commandFor(const SetPoint &setPoint)
{
    struct Row {
        Mode mode;
        bool relative;
        Command now;
        Command buffered;
    };
    constexpr std::array rows{
        Row{Mode::Velocity, false, Command::MoveVelocity, Command::BufferVelocity},
        Row{Mode::RampVelocity, false, Command::MoveProfiledVelocity, Command::BufferProfiledVelocity},
        Row{Mode::Position, false, Command::MoveAbsolute, Command::BufferAbsolute},
        Row{Mode::Position, true, Command::MoveRelative, Command::BufferRelative},
        Row{Mode::RampPosition, false, Command::MoveProfiledAbsolute, Command::BufferProfiledAbsolute},
        Row{Mode::RampPosition, true, Command::MoveProfiledRelative, Command::BufferProfiledRelative},
    };
    for (const Row &row : rows) {
        if (row.mode == setPoint.mode && (row.relative == setPoint.relative || !isPosition(row.mode)))
            return setPoint.buffered ? row.buffered : row.now;
    }
    return fail(Fault::Unsupported, say("a Supermodified has no mode '%1'", toString(setPoint.mode)));
}

bool isHold(const SetPoint &setPoint)
{
    return setPoint.relative && !setPoint.buffered && isPosition(setPoint.mode) && setPoint.target == 0.0;
}

} // namespace mb::supermodified
