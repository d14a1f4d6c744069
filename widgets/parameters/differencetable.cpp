// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/differencetable.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/icons.h"
#include "widgets/parameters/valuetext.h"

#include <QHeaderView>
#include <QStyle>

namespace mb {
namespace {

enum Column { NameColumn, KeyColumn, AColumn, BColumn, UnitColumn, NoteColumn, Columns };

constexpr int indexRole = Qt::UserRole;
constexpr int rawRole = Qt::UserRole + 1;

QString stateValue(const Parameter &parameter, const ParameterStore::Entry &entry)
{
    return entry.raw ? valueText(parameter, *entry.raw) : QStringLiteral("–");
}

} // namespace

DifferenceTable::DifferenceTable(const ThemeSource &theme, QWidget *parent)
    : QTableWidget(0, Columns, parent)
    , m_theme(theme)
{
    setAccessibleName(tr("Differences"));
    setHorizontalHeaderLabels({tr("parameter"), tr("key"), tr("A"), tr("B"), tr("unit"), tr("note")});
    horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    horizontalHeader()->setSectionResizeMode(NameColumn, QHeaderView::Interactive); // fitNames()
    horizontalHeader()->setStretchLastSection(true);
    verticalHeader()->hide();
    setShowGrid(false);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setSelectionBehavior(QAbstractItemView::SelectRows);
}

DifferenceTable::Counts DifferenceTable::show(
    const Family &family, const settings::Side &a, const settings::Side &b, bool everything)
{
    const auto differences = settings::compare(a, b);
    keepTicks();
    setRowCount(0);
    Counts counts{differences.size()};
    auto next = differences.begin();
    for (std::uint16_t i = 0; i < family.parameters.size(); ++i) {
        const bool differs = next != differences.end() && next->index.value == i;
        const bool spoken = a.entries[i] && b.entries[i] && settings::isSetting(family.parameters[i]);
        counts.all += spoken ? 1 : 0;
        if (differs)
            addRow(family, *next++, true);
        else if (spoken && everything)
            addRow(family, {{i}, *a.entries[i], *b.entries[i]}, false);
    }
    fitNames();
    return counts;
}

void DifferenceTable::keepTicks()
{
    for (int row = 0; row < rowCount(); ++row) {
        const QTableWidgetItem *name = item(row, NameColumn);
        if (name->flags().testFlag(Qt::ItemIsUserCheckable))
            m_ticks[static_cast<std::uint16_t>(name->data(indexRole).toUInt())] = name->checkState() == Qt::Checked;
    }
}

void DifferenceTable::forgetTicks(bool on)
{
    m_comeTicked = on;
    setRowCount(0);
    m_ticks.clear();
}

/// The contents' own width forgets the box before the name, which the style sheet draws.
void DifferenceTable::fitNames()
{
    resizeColumnToContents(NameColumn);
    const int box = style()->pixelMetric(QStyle::PM_IndicatorWidth, nullptr, this)
        + style()->pixelMetric(QStyle::PM_CheckBoxLabelSpacing, nullptr, this);
    horizontalHeader()->resizeSection(NameColumn, horizontalHeader()->sectionSize(NameColumn) + box);
}

void DifferenceTable::addRow(const Family &family, const settings::SideDifference &difference, bool differs)
{
    const Parameter &parameter = family.parameters[difference.index.value];
    const int row = rowCount();
    insertRow(row);
    const bool writable = differs && difference.b.raw && isLegal(parameter, difference.b.raw.value_or(0));
    QString note;
    if (parameter.belongsToUnit)
        note = tr("belongs to one unit, copied only if you tick it");
    else if (difference.a.state == ParameterState::Assumed || difference.b.state == ParameterState::Assumed)
        note = tr("assumed: it cannot be read");
    const QStringList texts{tableText(parameter.label), qt(parameter.key), stateValue(parameter, difference.a),
        stateValue(parameter, difference.b), tableText(parameter.unit), note};
    for (int column = 0; column < Columns; ++column) {
        auto *item = new QTableWidgetItem(texts.at(column));
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
        if (column == AColumn || column == BColumn)
            item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        if (column == BColumn && differs) {
            QFont bold = font();
            bold.setBold(true);
            item->setFont(bold);
        }
        if (column == NameColumn && writable) {
            item->setFlags(item->flags() | Qt::ItemIsUserCheckable);
            const auto kept = m_ticks.find(difference.index.value);
            const bool on = kept == m_ticks.end() ? m_comeTicked && !parameter.belongsToUnit : kept->second;
            item->setCheckState(on ? Qt::Checked : Qt::Unchecked);
        }
        if (column == NameColumn && parameter.belongsToUnit)
            item->setIcon(symbolIcon(Symbol::Lock, m_theme.theme(), Tone::Dim));
        item->setData(indexRole, difference.index.value);
        if (difference.b.raw)
            item->setData(rawRole, static_cast<qint64>(*difference.b.raw));
        setItem(row, column, item);
    }
}

std::vector<ParameterChange> DifferenceTable::ticked() const
{
    std::vector<ParameterChange> changes;
    for (int row = 0; row < rowCount(); ++row) {
        const QTableWidgetItem *name = item(row, NameColumn);
        if (name->flags().testFlag(Qt::ItemIsUserCheckable) && name->checkState() == Qt::Checked)
            changes.push_back(
                {{static_cast<std::uint16_t>(name->data(indexRole).toUInt())}, name->data(rawRole).toLongLong()});
    }
    return changes;
}

void DifferenceTable::setNarrow(bool narrow)
{
    setColumnHidden(KeyColumn, narrow);
}

} // namespace mb
