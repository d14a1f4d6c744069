// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/parametermodel.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/numberformat.h"
#include "widgets/parameters/leap.h"

namespace mb {
namespace {

// internalId: 0 for a group, group + 1 for a parameter, faultMark + parameter for a fault
constexpr quintptr faultMark = 0x10000;

} // namespace

GlyphState glyphOf(ParameterState state)
{
    switch (state) {
    case ParameterState::Unknown: return GlyphState::Gone;
    case ParameterState::Stored: return GlyphState::Stored;
    case ParameterState::Ram: return GlyphState::InRam;
    case ParameterState::Volatile: return GlyphState::Volatile;
    case ParameterState::Assumed: return GlyphState::Assumed;
    case ParameterState::Failed: return GlyphState::Fault;
    }
    return GlyphState::Gone;
}

ParameterReference defaultsOf(const Family &family)
{
    ParameterReference reference{ParameterModel::tr("default"), {}};
    for (const Parameter &parameter : family.parameters)
        reference.raws.emplace_back(defaultRaw(parameter));
    return reference;
}

void ParameterModel::show(const Family *family, StagedEdits *edits, bool writable)
{
    beginResetModel();
    if (m_edits)
        disconnect(m_edits, nullptr, this, nullptr);
    m_family = edits ? family : nullptr;
    m_edits = edits;
    m_writable = writable;
    build();
    if (m_edits)
        connect(m_edits, &StagedEdits::changed, this, &ParameterModel::editChanged);
    endResetModel();
    Q_EMIT standingChanged();
}

void ParameterModel::build()
{
    m_groups = {};
    m_faults.clear();
    m_shown.clear();
    m_reference = {};
    if (!m_family)
        return;
    m_groups = ParameterGroups(*m_family);
    for (std::uint16_t i = 0; i < m_family->parameters.size(); ++i)
        m_faults.push_back(asks({i}));
    m_shown = m_edits->entries();
    m_reference = defaultsOf(*m_family);
}

void ParameterModel::refresh()
{
    if (!m_edits)
        return;
    const auto &entries = m_edits->entries();
    bool any = false;
    for (std::uint16_t i = 0; i < entries.size(); ++i) {
        if (entries[i].raw == m_shown[i].raw && entries[i].state == m_shown[i].state)
            continue;
        m_shown[i] = entries[i];
        any = true;
        touchRow({i});
    }
    if (any)
        Q_EMIT standingChanged();
}

void ParameterModel::setReference(ParameterReference reference)
{
    if (!m_family)
        return;
    reference.raws.resize(m_family->parameters.size());
    m_reference = std::move(reference);
    for (std::uint16_t i = 0; i < m_reference.raws.size(); ++i)
        touchRow({i});
    Q_EMIT headerDataChanged(Qt::Horizontal, Reference, Reference);
    Q_EMIT standingChanged();
}

/// It has a row below it: for what is wrong, or for one more look.
bool ParameterModel::asks(ParameterIndex index) const
{
    const StagedEdit *edit = m_edits->find(index);
    return edit && (!edit->value.raw || m_edits->unconfirmed(index));
}

void ParameterModel::editChanged(ParameterIndex index)
{
    const bool fault = asks(index);
    const QModelIndex row = indexOf(index, 0);
    if (fault && !m_faults[index.value]) {
        beginInsertRows(row, 0, 0);
        m_faults[index.value] = true;
        endInsertRows();
    } else if (!fault && m_faults[index.value]) {
        beginRemoveRows(row, 0, 0);
        m_faults[index.value] = false;
        endRemoveRows();
    }
    touchRow(index);
    Q_EMIT standingChanged();
}

void ParameterModel::touchRow(ParameterIndex index)
{
    Q_EMIT dataChanged(indexOf(index, 0), indexOf(index, ColumnCount - 1));
    if (m_faults[index.value]) {
        const QModelIndex fault = this->index(0, 0, indexOf(index, 0));
        Q_EMIT dataChanged(fault, fault);
    }
}

ParameterModel::Kind ParameterModel::kindOf(const QModelIndex &index)
{
    if (index.internalId() == 0)
        return Kind::Group;
    return index.internalId() >= faultMark ? Kind::Fault : Kind::Parameter;
}

ParameterIndex ParameterModel::parameterAt(const QModelIndex &index) const
{
    if (index.internalId() >= faultMark)
        return {static_cast<std::uint16_t>(index.internalId() - faultMark)};
    return m_groups.members(static_cast<int>(index.internalId()) - 1)[static_cast<std::size_t>(index.row())];
}

QModelIndex ParameterModel::indexOf(ParameterIndex index, int column) const
{
    const auto [group, row] = m_groups.placeOf(index);
    return createIndex(row, column, static_cast<quintptr>(group) + 1);
}

QModelIndex ParameterModel::index(int row, int column, const QModelIndex &parent) const
{
    if (!hasIndex(row, column, parent))
        return {};
    if (!parent.isValid())
        return createIndex(row, column, quintptr{0});
    if (kindOf(parent) == Kind::Group)
        return createIndex(row, column, static_cast<quintptr>(parent.row()) + 1);
    return createIndex(row, column, faultMark + parameterAt(parent).value);
}

QModelIndex ParameterModel::parent(const QModelIndex &child) const
{
    if (!child.isValid() || kindOf(child) == Kind::Group)
        return {};
    if (kindOf(child) == Kind::Parameter)
        return createIndex(static_cast<int>(child.internalId()) - 1, 0, quintptr{0});
    return indexOf(parameterAt(child), 0);
}

int ParameterModel::rowCount(const QModelIndex &parent) const
{
    if (!parent.isValid())
        return m_groups.count();
    if (parent.column() != 0 || kindOf(parent) == Kind::Fault)
        return 0;
    if (kindOf(parent) == Kind::Group)
        return static_cast<int>(m_groups.members(parent.row()).size());
    return m_faults[parameterAt(parent).value] ? 1 : 0;
}

int ParameterModel::columnCount(const QModelIndex &) const
{
    return ColumnCount;
}

ParameterStanding ParameterModel::standing(ParameterIndex index) const
{
    ParameterStanding standing;
    const auto &entry = m_edits->entries()[index.value];
    const StagedEdit *edit = m_edits->find(index);
    const auto known = m_edits->known(index);
    const auto &reference = m_reference.raws[index.value];
    standing.raw = edit ? edit->value.raw : known;
    standing.edited = edit != nullptr;
    standing.illegal = edit && !edit->value.raw;
    standing.changed = standing.raw && reference && *standing.raw != *reference;
    standing.unread = entry.state == ParameterState::Failed;
    standing.glyph = standing.illegal ? GlyphState::OutOfRange : edit ? GlyphState::Edited : glyphOf(entry.state);
    if (standing.illegal)
        standing.text = glyphWord(GlyphState::OutOfRange);
    else if (edit && known)
        standing.text = tr("edited, was %1").arg(valueText(parameter(index), *known));
    else if (edit)
        standing.text = tr("edited, was unknown");
    else if (standing.unread)
        standing.text = tr("no answer, retry");
    else if (entry.state == ParameterState::Unknown)
        standing.text = parameter(index).access == Access::WriteOnly ? tr("unknown until written") : tr("not read");
    else
        standing.text = m_writable ? glyphWord(standing.glyph) : tr("from a file");
    return standing;
}

void ParameterModel::toggle(ParameterIndex index)
{
    if (!m_writable || parameter(index).type != WireType::Boolean || !isEditable(parameter(index)))
        return;
    const bool on = standing(index).raw.value_or(0) != 0;
    m_edits->stage(index, on ? QStringLiteral("off") : QStringLiteral("on"));
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
        return shown ? m_groups.title(index.row())
            : role == Qt::AccessibleTextRole
            ? m_groups.title(index.row()) + QStringLiteral(", ") + m_groups.note(index.row())
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
