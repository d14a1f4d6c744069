// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"

#include <QCoreApplication>
#include <QString>

#include <vector>

namespace mb {

/// The parameters of a family under the groups of its table, in the order in which the table names them first.
class ParameterGroups {
    Q_DECLARE_TR_FUNCTIONS(mb::ParameterGroups)
public:
    ParameterGroups() = default;
    explicit ParameterGroups(const Family &family);

    [[nodiscard]] int count() const { return static_cast<int>(m_groups.size()); }
    [[nodiscard]] const std::vector<ParameterIndex> &members(int group) const { return at(group).members; }
    /// Group and row of a parameter.
    [[nodiscard]] std::pair<int, int> placeOf(ParameterIndex index) const { return m_places[index.value]; }
    [[nodiscard]] QString title(int group) const;
    /// "11 parameters · not kept over a power cycle"
    [[nodiscard]] QString note(int group) const;

private:
    struct Group {
        std::string_view name;
        std::vector<ParameterIndex> members;
    };
    [[nodiscard]] const Group &at(int group) const { return m_groups[static_cast<std::size_t>(group)]; }

    const Family *m_family = nullptr;
    std::vector<Group> m_groups;
    std::vector<std::pair<int, int>> m_places;
};

} // namespace mb
