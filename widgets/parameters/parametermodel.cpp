// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/parametermodel.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/numberformat.h"

#include <algorithm>

namespace mb {
namespace {

// internalId: 0 for a group, group + 1 for a parameter, faultMark + parameter for a fault
constexpr quintptr faultMark = 0x10000;

GlyphState glyphOf(ParameterState state)
{
    switch (state) {
    case ParameterState::Unknown: return GlyphState::Waiting;
    case ParameterState::Stored: return GlyphState::Stored;
    case ParameterState::Ram: return GlyphState::InRam;
    case ParameterState::Volatile: return GlyphState::Volatile;
    case ParameterState::Assumed: return GlyphState::Assumed;
    case ParameterState::Failed: return GlyphState::Fault;
    }
    return GlyphState::Waiting;
}

} // namespace

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
    m_groups.clear();
    m_place.clear();
    m_faults.clear();
    m_shown.clear();
    m_reference = {};
    if (!m_family)
        return;
    for (std::uint16_t i = 0; i < m_family->parameters.size(); ++i) {
        const std::string_view name = m_family->parameters[i].group;
        auto group = std::find_if(m_groups.begin(), m_groups.end(), [name](const Group &g) { return g.name == name; });
        if (group == m_groups.end())
            group = m_groups.insert(group, Group{name, {}});
        m_place.emplace_back(static_cast<int>(group - m_groups.begin()), static_cast<int>(group->members.size()));
        group->members.push_back({i});
        m_faults.push_back(asks({i}));
    }
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
    return m_groups[index.internalId() - 1].members[static_cast<std::size_t>(index.row())];
}

QModelIndex ParameterModel::indexOf(ParameterIndex index, int column) const
{
    const auto [group, row] = m_place[index.value];
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
        return static_cast<int>(m_groups.size());
    if (parent.column() != 0 || kindOf(parent) == Kind::Fault)
        return 0;
    if (kindOf(parent) == Kind::Group)
        return static_cast<int>(m_groups[static_cast<std::size_t>(parent.row())].members.size());
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

} // namespace mb
