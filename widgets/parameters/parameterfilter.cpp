// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/parameterfilter.h"

#include "model/axis.h"
#include "widgets/common/devicetext.h"

#include <algorithm>

namespace mb {
namespace {

bool isIn(ParameterFilter::Segment segment, const ParameterStanding &standing)
{
    switch (segment) {
    case ParameterFilter::All: return true;
    case ParameterFilter::Changed: return standing.changed;
    case ParameterFilter::Edited: return standing.edited;
    case ParameterFilter::Errors: return standing.illegal || standing.unread;
    }
    return true;
}

} // namespace

bool ParameterFilter::accepts(const ParameterModel &model, ParameterIndex index) const
{
    if (model.edits()->typing() == index)
        return true;
    if (!isIn(segment, model.standing(index)))
        return false;
    const Parameter &row = model.parameter(index);
    if (axis && axisOf(row.key) != *axis)
        return false;
    const QStringList texts{tableText(row.label), qt(row.key), tableText(row.group), qt(row.unit), tableText(row.help)};
    const QString all = texts.join(QLatin1Char('\n'));
    const QStringList wanted = words.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    return std::ranges::all_of(wanted, [&all](const QString &word) { return all.contains(word, Qt::CaseInsensitive); });
}

ParameterCounts countParameters(const ParameterModel &model, std::optional<int> axis)
{
    ParameterCounts counts;
    if (!model.family())
        return counts;
    for (std::uint16_t i = 0; i < model.family()->parameters.size(); ++i) {
        if (axis && axisOf(model.parameter({i}).key) != *axis)
            continue;
        ++counts.all;
        const ParameterStanding standing = model.standing({i});
        counts.changed += standing.changed ? 1 : 0;
        counts.edited += standing.edited && !standing.illegal ? 1 : 0;
        counts.illegal += standing.illegal ? 1 : 0;
        counts.unread += standing.unread ? 1 : 0;
        counts.notKept += model.parameter({i}).persistent ? 0 : 1; // as the heads of the groups say
        switch (model.edits()->entries()[i].state) {
        case ParameterState::Ram: ++counts.inRam; break;
        case ParameterState::Stored: ++counts.stored; break;
        case ParameterState::Assumed: ++counts.assumed; break;
        case ParameterState::Volatile:
        case ParameterState::Unknown:
        case ParameterState::Failed: break;
        }
    }
    return counts;
}

} // namespace mb
