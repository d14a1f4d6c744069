// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/service/unitchecks.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/serviceview.h"
#include "widgets/common/workbench.h"

#include <algorithm>

namespace mb {

UnitChecks::UnitChecks(const ThemeSource &theme, QWidget *parent)
    : CheckRow(theme, tr("Before each unit"), Checks, parent)
{
}

void UnitChecks::follow(const Snapshot &shot, const JournalState &journal, const std::string &link)
{
    const auto tell = [this](Check check, bool holds, const QString &words) {
        set(check, holds ? GlyphState::Done : GlyphState::Warning, words);
    };
    const auto found = std::ranges::find(shot.links, link, &LinkView::address);
    const bool open = found != shot.links.end() && found->state == LinkState::Open;
    const auto units = static_cast<int>(std::ranges::count_if(
        shot.devices, [&](const DeviceView &device) { return device.link == link && device.liveness.heard; }));
    const auto turning = std::ranges::find_if(shot.devices,
        [&](const DeviceView &device) { return device.link == link && (device.motion.running || device.mayTurn); });
    const bool stands = turning == shot.devices.end();
    tell(LinkOpen, open,
        open               ? tr("%1 is open").arg(qt(found->name))
            : link.empty() ? tr("no link is open")
                           : tr("%1 is not open").arg(qt(link)));
    set(UnitAnswers, units > 0 ? GlyphState::Done : GlyphState::Waiting,
        !open           ? QString()
            : units > 0 ? tr("%n units answer, one at a time", nullptr, units)
                        : tr("no unit answers yet"));
    tell(NothingTurns, stands,
        !open        ? QString()
            : stands ? tr("no motor turns")
                     : tr("%1 may turn").arg(titleOf(*turning)));
    tell(JournalTakes, journal.trouble.empty(),
        journal.trouble.empty() ? tr("the journal takes entries") : tr("the journal keeps entries on this computer"));
}

} // namespace mb
