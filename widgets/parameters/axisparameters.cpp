// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/axisparameters.h"

#include "model/axis.h"

#include <QCoreApplication>

namespace mb {
namespace {

struct AxisParameters {
    Q_DECLARE_TR_FUNCTIONS(AxisParameters)
};

std::string_view suffixOf(std::string_view key)
{
    return key.substr(key.find('.') + 1);
}

std::optional<std::int64_t> valueOf(const StagedEdits &edits, ParameterIndex index)
{
    const StagedEdit *edit = edits.find(index);
    return edit && edit->value.raw ? edit->value.raw : edits.known(index);
}

} // namespace

std::optional<ParameterIndex> twinOf(const Family &family, ParameterIndex index, int axis)
{
    const std::string_view key = family.parameters[index.value].key;
    return axisOf(key) == 0 ? std::nullopt : findParameter(family.parameters, axisKey(axis, suffixOf(key)));
}

std::vector<ParameterChange> gainsOfAxis(const Family &family, const StagedEdits &edits, int from, int to)
{
    std::vector<ParameterChange> changes;
    for (std::uint16_t i = 0; i < family.parameters.size(); ++i) {
        const std::string_view key = family.parameters[i].key;
        const bool isOfMotion = family.parameters[i].role != Role::None;
        const auto twin = axisOf(key) == from && isOfMotion ? twinOf(family, {i}, to) : std::nullopt;
        if (const auto raw = valueOf(edits, {i}); twin && raw)
            changes.push_back({*twin, *raw});
    }
    return changes;
}

ParameterReference axisReference(const Family &family, const StagedEdits &edits, int axis)
{
    ParameterReference reference{AxisParameters::tr("axis %1").arg(axis), {}};
    for (std::uint16_t i = 0; i < family.parameters.size(); ++i) {
        const auto twin = twinOf(family, {i}, axis);
        reference.raws.push_back(twin ? edits.known(*twin) : std::nullopt);
    }
    return reference;
}

} // namespace mb
