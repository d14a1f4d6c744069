// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/differencetable.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/stateglyph.h"
#include "widgets/parameters/differencedelegate.h"
#include "widgets/parameters/parametergroups.h"
#include "widgets/parameters/parametermodel.h"
#include "widgets/parameters/valuetext.h"

#include <QHeaderView>
#include <QKeyEvent>

#include <algorithm>

namespace mb {
namespace {

using Column = DifferenceDelegate::Column;

QString stateValue(const Parameter &parameter, const ParameterStore::Entry &entry)
{
    return entry.raw ? valueText(parameter, *entry.raw) : QStringLiteral("–");
}

bool isWritable(const Parameter &parameter, const ParameterStore::Entry &b)
{
    return b.raw && isLegal(parameter, b.raw.value_or(0));
}

} // namespace

DifferenceTable::DifferenceTable(const ThemeSource &theme, QWidget *parent)
    : QTableWidget(0, Column::Columns, parent)
    , m_theme(theme)
{
    setAccessibleName(tr("Differences"));
    setHorizontalHeaderLabels({tr("parameter"), tr("key"), tr("A"), tr("B"), tr("unit"), tr("state")});
    for (const int number : {Column::A, Column::B})
        horizontalHeaderItem(number)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    horizontalHeader()->setStretchLastSection(true);
    horizontalHeader()->setHighlightSections(false);
    verticalHeader()->hide();
    verticalHeader()->setDefaultSectionSize(theme.theme().u(30));
    setItemDelegate(new DifferenceDelegate(theme, this));
    setShowGrid(false);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    connect(this, &QTableWidget::itemChanged, this, &DifferenceTable::follow);
}

DifferenceTable::Counts DifferenceTable::show(
    const Family &family, const settings::Side &a, const settings::Side &b, bool everything)
{
    const QSignalBlocker quiet(this);
    const auto differences = settings::compare(a, b);
    keepTicks();
    clearSpans();
    setRowCount(0);
    Counts counts{differences.size()};
    const ParameterGroups groups(family);
    std::vector<Shown> ofUnit;
    int spokenOfUnit = 0;
    for (int group = 0; group < groups.count(); ++group) {
        std::vector<Shown> rows;
        int spoken = 0;
        for (const ParameterIndex index : groups.members(group)) {
            const Parameter &parameter = family.parameters[index.value];
            const auto difference = std::ranges::find_if(
                differences, [index](const settings::SideDifference &each) { return each.index == index; });
            const bool differs = difference != differences.end();
            const bool known = a.entries[index.value] && b.entries[index.value] && settings::isSetting(parameter);
            (parameter.belongsToUnit ? spokenOfUnit : spoken) += known ? 1 : 0;
            auto &place = parameter.belongsToUnit ? ofUnit : rows;
            if (differs)
                place.push_back({*difference, true});
            else if (known && everything)
                place.push_back({{index, *a.entries[index.value], *b.entries[index.value]}, false});
        }
        counts.all += spoken;
        addGroup(family, groups.title(group), false, rows, spoken);
    }
    counts.all += spokenOfUnit;
    addGroup(family, tr("This unit"), true, ofUnit, spokenOfUnit);
    return counts;
}

void DifferenceTable::keepTicks()
{
    for (int row = 0; row < rowCount(); ++row) {
        const QTableWidgetItem *name = item(row, Column::Name);
        if (!isGroup(row) && name->flags().testFlag(Qt::ItemIsUserCheckable))
            m_ticks[static_cast<std::uint16_t>(name->data(IndexRole).toUInt())] = name->checkState() == Qt::Checked;
    }
}

void DifferenceTable::forgetTicks(bool on)
{
    const QSignalBlocker quiet(this);
    m_comeTicked = on;
    clearSpans();
    setRowCount(0);
    m_ticks.clear();
}

bool DifferenceTable::isGroup(int row) const
{
    return !item(row, Column::Name)->data(IndexRole).isValid();
}

void DifferenceTable::addGroup(
    const Family &family, const QString &title, bool ofUnit, const std::vector<Shown> &rows, int spoken)
{
    if (rows.empty())
        return;
    const auto differ = std::ranges::count_if(rows, [](const Shown &each) { return each.differs; });
    const int head = rowCount();
    insertRow(head);
    auto *name = new QTableWidgetItem(title);
    name->setFlags(Qt::ItemIsEnabled);
    const QString note = tr("%1 of %2 differ").arg(differ).arg(spoken);
    name->setData(GroupNoteRole,
        ofUnit ? note + QStringLiteral(" · ") + tr("belongs to one unit, copied only if you tick it") : note);
    setItem(head, Column::Name, name);
    setSpan(head, 0, 1, Column::Columns);
    name->setData(GroupTicksRole, !ofUnit);
    for (const Shown &each : rows)
        addRow(family, each);
    judgeGroup(head);
}

void DifferenceTable::addRow(const Family &family, const Shown &shown)
{
    const settings::SideDifference &values = shown.values;
    const Parameter &parameter = family.parameters[values.index.value];
    const int row = rowCount();
    insertRow(row);
    const bool assumed = values.a.state == ParameterState::Assumed || values.b.state == ParameterState::Assumed;
    const GlyphState glyph = assumed ? GlyphState::Assumed : glyphOf(values.a.state);
    const bool known = glyph != GlyphState::Gone;
    const QStringList texts{tableText(parameter.label), qt(parameter.key), stateValue(parameter, values.a),
        stateValue(parameter, values.b), tableText(parameter.unit),
        assumed     ? tr("assumed: it cannot be read")
            : known ? glyphWord(glyph)
                    : QString()};
    for (int column = 0; column < Column::Columns; ++column) {
        auto *cell = new QTableWidgetItem(texts.at(column));
        cell->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
        cell->setToolTip(texts.at(column));
        setItem(row, column, cell);
    }
    if (known)
        item(row, Column::State)->setData(GlyphRole, static_cast<int>(glyph));
    QTableWidgetItem *name = item(row, Column::Name);
    name->setData(IndexRole, values.index.value);
    name->setData(DiffersRole, shown.differs);
    if (values.b.raw)
        name->setData(RawRole, static_cast<qint64>(*values.b.raw));
    if (shown.differs && isWritable(parameter, values.b)) {
        name->setFlags(name->flags() | Qt::ItemIsUserCheckable);
        const auto kept = m_ticks.find(values.index.value);
        const bool on = kept == m_ticks.end() ? m_comeTicked && !parameter.belongsToUnit : kept->second;
        name->setCheckState(on ? Qt::Checked : Qt::Unchecked);
    }
}

/// A group ticks its rows, and a row changes what its group shows.
void DifferenceTable::follow(QTableWidgetItem *changed)
{
    if (changed->column() != Column::Name || !changed->flags().testFlag(Qt::ItemIsUserCheckable))
        return;
    const QSignalBlocker quiet(this);
    int row = changed->row();
    if (!isGroup(row)) {
        while (!isGroup(row))
            --row;
        judgeGroup(row);
        return;
    }
    for (int below = row + 1; below < rowCount() && !isGroup(below); ++below) {
        if (item(below, Column::Name)->flags().testFlag(Qt::ItemIsUserCheckable))
            item(below, Column::Name)->setCheckState(changed->checkState());
    }
}

void DifferenceTable::judgeGroup(int row)
{
    QTableWidgetItem &head = *item(row, Column::Name);
    int ticked = 0;
    int all = 0;
    for (int below = row + 1; below < rowCount() && !isGroup(below); ++below) {
        const QTableWidgetItem &name = *item(below, Column::Name);
        const bool can = name.flags().testFlag(Qt::ItemIsUserCheckable);
        all += can ? 1 : 0;
        ticked += can && name.checkState() == Qt::Checked ? 1 : 0;
    }
    if (all == 0 || !head.data(GroupTicksRole).toBool())
        return;
    head.setFlags(Qt::ItemIsEnabled | Qt::ItemIsUserCheckable);
    head.setCheckState(ticked == 0 ? Qt::Unchecked : ticked == all ? Qt::Checked : Qt::PartiallyChecked);
}

std::vector<ParameterChange> DifferenceTable::ticked() const
{
    std::vector<ParameterChange> changes;
    for (int row = 0; row < rowCount(); ++row) {
        const QTableWidgetItem *name = item(row, Column::Name);
        if (!isGroup(row) && name->flags().testFlag(Qt::ItemIsUserCheckable) && name->checkState() == Qt::Checked)
            changes.push_back(
                {{static_cast<std::uint16_t>(name->data(IndexRole).toUInt())}, name->data(RawRole).toLongLong()});
    }
    return changes;
}

QString DifferenceTable::asText() const
{
    QStringList lines{QStringLiteral("%1\t%2\t%3\t%4").arg(tr("key"), tr("A"), tr("B"), tr("unit"))};
    for (int row = 0; row < rowCount(); ++row) {
        QStringList cells;
        for (int column = Column::Key; !isGroup(row) && column < Column::State; ++column)
            cells << item(row, column)->text();
        if (!cells.isEmpty())
            lines << cells.join(QLatin1Char('\t'));
    }
    return lines.join(QLatin1Char('\n'));
}

void DifferenceTable::setNarrow(bool narrow)
{
    setColumnHidden(Column::Key, narrow);
}

/// Space is a stop key.
void DifferenceTable::keyPressEvent(QKeyEvent *event)
{
    QTableWidgetItem *name = currentRow() < 0 ? nullptr : item(currentRow(), Column::Name);
    const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (enter && name && name->flags().testFlag(Qt::ItemIsUserCheckable))
        name->setCheckState(name->checkState() == Qt::Checked ? Qt::Unchecked : Qt::Checked);
    else
        QTableWidget::keyPressEvent(event);
}

} // namespace mb
