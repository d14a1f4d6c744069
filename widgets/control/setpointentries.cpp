// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/setpointentries.h"

namespace mb {

SetPointEntries::Range SetPointEntries::range(Mode mode) const
{
    const auto found = ranges.find(mode);
    return found == ranges.end() ? Range{} : found->second;
}

double SetPointEntries::limit(const Family *family, Mode mode) const
{
    const double entered = range(mode).limit;
    return entered > 0.0 ? entered : usualLimit(family, mode);
}

double SetPointEntries::slewRate(const Family *family, Mode mode) const
{
    const double time = slewTimes.at(static_cast<std::size_t>(slew < 0 ? usualSlew : slew));
    return time > 0.0 && mode != Mode::Follow ? 2.0 * limit(family, mode) / time : 0.0;
}

void SetPointEntries::forgetPositions()
{
    for (auto &[mode, range] : ranges) {
        if (startsAtPresent(mode))
            range = {0.0, range.limit, false};
    }
}

bool startsAtPresent(Mode mode)
{
    return mode == Mode::Position || mode == Mode::RampPosition;
}

double usualLimit(const Family *family, Mode mode)
{
    if (!family)
        return usualRange({}, mode);
    return mode == Mode::Follow ? family->capabilities.lastFollowed : usualRange(family->ranges, mode);
}

bool isProfiled(const Family *family, Mode mode)
{
    return family && family->capabilities.commandsProfile && (mode == Mode::RampPosition || mode == Mode::RampVelocity);
}

} // namespace mb
