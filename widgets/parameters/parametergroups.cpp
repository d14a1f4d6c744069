// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/parametergroups.h"

#include "widgets/common/devicetext.h"

#include <algorithm>

namespace mb {

ParameterGroups::ParameterGroups(const Family &family)
    : m_family(&family)
{
    for (std::uint16_t i = 0; i < family.parameters.size(); ++i) {
        const std::string_view name = family.parameters[i].group;
        auto group = std::ranges::find(m_groups, name, &Group::name);
        if (group == m_groups.end())
            group = m_groups.insert(group, Group{name, {}});
        m_places.emplace_back(static_cast<int>(group - m_groups.begin()), static_cast<int>(group->members.size()));
        group->members.push_back({i});
    }
}

QString ParameterGroups::title(int group) const
{
    return tableText(at(group).name);
}

QString ParameterGroups::note(int group) const
{
    const auto &all = members(group);
    const auto lost
        = std::ranges::count_if(all, [this](ParameterIndex i) { return !m_family->parameters[i.value].persistent; });
    const QString count = all.size() == 1 ? tr("1 parameter") : tr("%1 parameters").arg(all.size());
    if (lost == 0)
        return count;
    const QString note = static_cast<std::size_t>(lost) == all.size() ? tr("not kept over a power cycle")
                                                                      : tr("%1 not kept over a power cycle").arg(lost);
    return count + QStringLiteral("  · ") + note;
}

} // namespace mb
