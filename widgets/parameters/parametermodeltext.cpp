// SPDX-License-Identifier: GPL-3.0-or-later
// The texts of the model: what each cell says.
#include "widgets/common/devicetext.h"
#include "widgets/common/numberformat.h"
#include "widgets/parameters/leap.h"
#include "widgets/parameters/parametermodel.h"

#include <algorithm>

namespace mb {

QString ParameterModel::groupTitle(int group) const
{
    return tableText(m_groups[static_cast<std::size_t>(group)].name);
}

QString ParameterModel::groupNote(int group) const
{
    const auto &all = m_groups[static_cast<std::size_t>(group)].members;
    const auto lost
        = std::count_if(all.begin(), all.end(), [this](ParameterIndex i) { return !parameter(i).persistent; });
    const QString count = all.size() == 1 ? tr("1 parameter") : tr("%1 parameters").arg(all.size());
    if (lost == 0)
        return count;
    const QString note = static_cast<std::size_t>(lost) == all.size() ? tr("not kept over a power cycle")
                                                                      : tr("%1 not kept over a power cycle").arg(lost);
    return count + QStringLiteral("  · ") + note;
}

QVariant ParameterModel::text(ParameterIndex index, int column) const
{
    const Parameter &row = parameter(index);
    const ParameterStanding now = standing(index);
    const auto &reference = m_reference.raws[index.value];
    switch (column) {
    case Label: return tableText(row.label);
    case Key: return qt(row.key);
    case ValueColumn:
        if (now.illegal)
            return m_edits->find(index)->text;
        return now.raw ? valueText(row, *now.raw) : QString(UnknownMark);
    case Unit: return qt(row.unit);
    case Reference: return reference ? valueText(row, *reference) : QString(UnknownMark);
    case State: return now.text;
    case Raw: return now.raw ? rawText(row, *now.raw) : QString(UnknownMark);
    default: return {};
    }
}

QString ParameterModel::faultText(ParameterIndex index) const
{
    const StagedEdit *edit = m_edits->find(index);
    if (const auto factor = m_edits->unconfirmed(index))
        return leapText(parameter(index), *m_edits->known(index), *factor);
    return edit ? edit->value.fault + QLatin1Char(' ') + edit->value.remedy : QString();
}

QString ParameterModel::toolTip(ParameterIndex index) const
{
    const Parameter &row = parameter(index);
    QStringList lines{QStringLiteral("%1  %2").arg(tableText(row.label), qt(row.key)), tableText(row.help)};
    if (row.access == Access::ReadOnly)
        lines += tr("Can only be read.");
    else if (row.nature == Nature::Counter)
        lines += tr("Is cleared with the faults, not by writing.");
    else
        lines += tr("%1, default %2").arg(rangeText(row), valueText(row, defaultRaw(row)));
    if (const auto full = fullScale(row))
        lines += tr("%1 is 100 %").arg(formatNumber(*full));
    if (!row.persistent)
        lines += tr("Not kept over a power cycle.");
    lines.removeAll(QString());
    return lines.join(QLatin1Char('\n'));
}

QVariant ParameterModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid())
        return {};
    const Kind kind = kindOf(index);
    if (kind == Kind::Group) {
        const bool shown = role == Qt::DisplayRole && index.column() == 0;
        return shown                         ? groupTitle(index.row())
            : role == Qt::AccessibleTextRole ? groupTitle(index.row()) + QStringLiteral(", ") + groupNote(index.row())
                                             : QVariant();
    }
    const ParameterIndex which = parameterAt(index);
    if (kind == Kind::Fault)
        return (role == Qt::DisplayRole || role == Qt::AccessibleTextRole) && index.column() == 0 ? faultText(which)
                                                                                                  : QVariant();
    switch (role) {
    case Qt::DisplayRole: return text(which, index.column());
    case Qt::EditRole: {
        const StagedEdit *edit = m_edits->find(which);
        const auto known = m_edits->known(which);
        return edit ? edit->text : known ? fieldText(parameter(which), *known) : QString();
    }
    case Qt::ToolTipRole: return toolTip(which);
    case Qt::AccessibleTextRole:
        return tr("%1, %2").arg(tableText(parameter(which).label), text(which, index.column()).toString());
    case Qt::AccessibleDescriptionRole: return tableText(parameter(which).help);
    case Qt::TextAlignmentRole: {
        const bool right = index.column() == ValueColumn || index.column() == Reference;
        return static_cast<int>(Qt::AlignVCenter | (right ? Qt::AlignRight : Qt::AlignLeft));
    }
    default: return {};
    }
}

bool ParameterModel::setData(const QModelIndex &index, const QVariant &value, int role)
{
    if (role != Qt::EditRole || (flags(index) & Qt::ItemIsEditable) == 0)
        return false;
    m_edits->stage(parameterAt(index), value.toString());
    return true;
}

QVariant ParameterModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    const bool right = section == ValueColumn || section == Reference;
    if (role == Qt::TextAlignmentRole)
        return static_cast<int>(Qt::AlignVCenter | (right ? Qt::AlignRight : Qt::AlignLeft));
    if (role != Qt::DisplayRole)
        return {};
    switch (section) {
    case Label: return tr("parameter");
    case Key: return tr("key");
    case ValueColumn: return tr("value");
    case Unit: return tr("unit");
    case Reference: return m_reference.title.isEmpty() ? tr("default") : m_reference.title;
    case State: return tr("state");
    case Raw: return tr("raw");
    default: return {};
    }
}

Qt::ItemFlags ParameterModel::flags(const QModelIndex &index) const
{
    if (!index.isValid() || kindOf(index) == Kind::Fault)
        return Qt::NoItemFlags;
    if (kindOf(index) == Kind::Group)
        return Qt::ItemIsEnabled;
    const Parameter &row = parameter(parameterAt(index));
    const bool field = m_writable && index.column() == ValueColumn && row.type != WireType::Boolean && isEditable(row);
    return Qt::ItemIsEnabled | Qt::ItemIsSelectable | (field ? Qt::ItemIsEditable : Qt::NoItemFlags);
}

} // namespace mb
