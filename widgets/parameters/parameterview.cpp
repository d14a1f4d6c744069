// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/parameterview.h"

#include "widgets/common/devicetext.h"
#include "widgets/parameters/columnwidths.h"
#include "widgets/parameters/faultline.h"
#include "widgets/parameters/parameterdelegate.h"
#include "widgets/parameters/parameterheader.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QMenu>
#include <QPainter>
#include <QScrollBar>

#include <algorithm>

namespace mb {

ParameterView::ParameterView(const ThemeSource &theme, ParameterModel &model, QWidget *parent)
    : QTreeView(parent)
    , m_theme(theme)
    , m_model(model)
    , m_delegate(new ParameterDelegate(theme, model, this))
{
    configure();
    setItemDelegate(m_delegate);
    setModel(&model);
    prepareGroups();
    connect(this, &QTreeView::collapsed, this, [this](const QModelIndex &index) {
        if (!m_preparing && ParameterModel::kindOf(index) == ParameterModel::Kind::Group)
            m_folded.insert(m_model.groups().title(index.row()));
    });
    connect(this, &QTreeView::expanded, this, [this](const QModelIndex &index) {
        if (!m_preparing && ParameterModel::kindOf(index) == ParameterModel::Kind::Group)
            m_folded.remove(m_model.groups().title(index.row()));
    });
    connect(this, &QWidget::customContextMenuRequested, this, &ParameterView::openMenu);
    connect(&theme, &ThemeSource::changed, this, &ParameterView::fitColumns);
    connect(&model, &ParameterModel::standingChanged, this, &ParameterView::applyFilter);
    connect(&model, &QAbstractItemModel::headerDataChanged, this,
        &ParameterView::fitColumns); // numbers of another reference
}

void ParameterView::configure()
{
    setAccessibleName(tr("Parameters"));
    setIndentation(0);
    setRootIsDecorated(false);
    setExpandsOnDoubleClick(false);
    setSelectionMode(ExtendedSelection);
    setSelectionBehavior(SelectRows);
    setEditTriggers(NoEditTriggers);
    setVerticalScrollMode(ScrollPerPixel);
    setHorizontalScrollMode(ScrollPerPixel);
    setContextMenuPolicy(Qt::CustomContextMenu);
    setMouseTracking(true);
    setHeader(new ParameterHeader(m_theme, *m_delegate, this));
    header()->setSectionsMovable(false);
    header()->setStretchLastSection(false);
    header()->setMinimumSectionSize(8);
    header()->setSectionResizeMode(QHeaderView::Interactive);
}

void ParameterView::reset()
{
    QTreeView::reset();
    prepareGroups();
}

void ParameterView::prepareGroups()
{
    if (!model())
        return;
    m_preparing = true;
    for (int group = 0; group < m_model.rowCount(); ++group) {
        const QModelIndex index = m_model.index(group, 0);
        setFirstColumnSpanned(group, {}, true);
        setExpanded(index, !m_folded.contains(m_model.groups().title(group)));
        for (const ParameterIndex member : m_model.groups().members(group)) {
            const QModelIndex row = m_model.indexOf(member, 0);
            if (m_model.rowCount(row) > 0)
                showFault(m_model.index(0, 0, row));
        }
    }
    m_preparing = false;
    fitColumns();
    applyFilter();
}

void ParameterView::setFilter(const ParameterFilter &filter)
{
    m_filter = filter;
    applyFilter();
}

void ParameterView::applyFilter()
{
    m_shownRows = 0;
    for (int group = 0; group < m_model.rowCount(); ++group) {
        const QModelIndex parent = m_model.index(group, 0);
        int shown = 0;
        for (const ParameterIndex member : m_model.groups().members(group)) {
            const int row = m_model.indexOf(member, 0).row();
            const bool accepted = m_filter.accepts(m_model, member);
            shown += accepted ? 1 : 0;
            if (isRowHidden(row, parent) == accepted)
                setRowHidden(row, parent, !accepted);
        }
        if (isRowHidden(group, {}) != (shown == 0))
            setRowHidden(group, {}, shown == 0);
        m_shownRows += shown;
    }
}

void ParameterView::rowsInserted(const QModelIndex &parent, int start, int end)
{
    QTreeView::rowsInserted(parent, start, end);
    if (parent.isValid() && ParameterModel::kindOf(parent) == ParameterModel::Kind::Parameter)
        showFault(m_model.index(start, 0, parent));
}

void ParameterView::showFault(const QModelIndex &fault)
{
    const ParameterIndex which = m_model.parameterAt(fault);
    auto *line = new FaultLine(m_theme, m_model, which, viewport());
    connect(line, &FaultLine::mended, this, [this, which] { mend(which); });
    setFirstColumnSpanned(0, fault.parent(), true);
    setIndexWidget(fault, line);
    setExpanded(fault.parent(), true);
}

void ParameterView::mend(ParameterIndex index)
{
    if (QWidget *editor = indexWidget(m_model.indexOf(index)))
        closeEditor(editor, QAbstractItemDelegate::RevertModelCache);
    setFocus();
}

void ParameterView::dataChanged(const QModelIndex &topLeft, const QModelIndex &bottomRight, const QVector<int> &roles)
{
    QTreeView::dataChanged(topLeft, bottomRight, roles);
    if (topLeft.isValid() && ParameterModel::kindOf(topLeft) == ParameterModel::Kind::Fault) {
        if (auto *line = qobject_cast<FaultLine *>(indexWidget(topLeft)))
            line->refresh();
    }
}

void ParameterView::commitField()
{
    for (const ParameterIndex index : fieldsInOrder()) {
        if (QWidget *editor = indexWidget(m_model.indexOf(index))) {
            commitData(editor);
            closeEditor(editor, QAbstractItemDelegate::NoHint);
        }
    }
}

std::vector<ParameterIndex> ParameterView::fieldsInOrder() const
{
    std::vector<ParameterIndex> fields;
    for (int group = 0; group < m_model.rowCount(); ++group) {
        const QModelIndex parent = m_model.index(group, 0);
        for (const ParameterIndex member : m_model.groups().members(group)) {
            const QModelIndex cell = m_model.indexOf(member);
            if ((cell.flags() & Qt::ItemIsEditable) != 0 && isExpanded(parent) && !isRowHidden(cell.row(), parent))
                fields.push_back(member);
        }
    }
    return fields;
}

void ParameterView::editBeside(ParameterIndex from, bool forward)
{
    const auto fields = fieldsInOrder();
    const auto here = std::ranges::find(fields, from);
    if (here == fields.end() || (forward ? here + 1 == fields.end() : here == fields.begin()))
        return;
    goTo(forward ? *(here + 1) : *(here - 1));
    activateRow(currentIndex());
}

void ParameterView::closeEditor(QWidget *editor, QAbstractItemDelegate::EndEditHint hint)
{
    const auto which = currentParameter();
    if (hint == QAbstractItemDelegate::RevertModelCache && m_model.edits())
        m_model.edits()->endTyping(false);
    const bool forward = hint == QAbstractItemDelegate::EditNextItem;
    const bool moves = forward || hint == QAbstractItemDelegate::EditPreviousItem;
    QTreeView::closeEditor(editor, moves ? QAbstractItemDelegate::NoHint : hint);
    if (moves && which)
        editBeside(*which, forward);
    applyFilter();
}

std::optional<ParameterIndex> ParameterView::currentParameter() const
{
    const QModelIndex current = currentIndex();
    if (!current.isValid() || ParameterModel::kindOf(current) != ParameterModel::Kind::Parameter)
        return std::nullopt;
    return m_model.parameterAt(current);
}

void ParameterView::goTo(ParameterIndex index)
{
    const QModelIndex cell = m_model.indexOf(index);
    setExpanded(cell.parent(), true);
    setCurrentIndex(cell);
    scrollTo(cell);
}

void ParameterView::currentChanged(const QModelIndex &current, const QModelIndex &previous)
{
    QTreeView::currentChanged(current, previous);
    viewport()->update();
    Q_EMIT currentParameterChanged();
}

QString ParameterView::selectedText() const
{
    QStringList lines;
    for (std::uint16_t i = 0; m_model.family() && i < m_model.family()->parameters.size(); ++i) {
        const QModelIndex row = m_model.indexOf({i}, 0);
        const auto raw = m_model.standing({i}).raw;
        if (selectionModel()->isSelected(row) && !isRowHidden(row.row(), row.parent()) && raw)
            lines += qt(m_model.parameter({i}).key) + QLatin1Char('=') + qt(toText(m_model.parameter({i}), *raw));
    }
    return lines.join(QLatin1Char('\n'));
}

void ParameterView::copySelection() const
{
    QGuiApplication::clipboard()->setText(selectedText());
}

void ParameterView::openMenu(const QPoint &position)
{
    const QModelIndex under = indexAt(position);
    auto *menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    QAction *copy = menu->addAction(tr("Copy as key=value"), this, &ParameterView::copySelection);
    copy->setShortcut(QKeySequence::Copy);
    copy->setEnabled(!selectedText().isEmpty());
    if (under.isValid() && ParameterModel::kindOf(under) == ParameterModel::Kind::Parameter && m_model.isWritable()) {
        const ParameterIndex which = m_model.parameterAt(under);
        const Parameter &row = m_model.parameter(which);
        menu->addAction(tr("Revert the edit"), this, [this, which] { m_model.edits()->revert(which); })
            ->setEnabled(m_model.standing(which).edited);
        if (isEditable(row))
            menu->addAction(tr("Set to the default, %1").arg(valueText(row, defaultRaw(row))), this, [this, which] {
                m_model.edits()->stage(
                    which, fieldText(m_model.parameter(which), defaultRaw(m_model.parameter(which))));
            });
    }
    menu->popup(viewport()->mapToGlobal(position));
}

void ParameterView::fitColumns()
{
    const ColumnWidths widths = columnWidthsFor(m_model, *m_delegate, m_theme.theme(), font(), viewport()->width());
    for (int column = 0; column < ParameterModel::ColumnCount; ++column) {
        const int width = widths.at(static_cast<std::size_t>(column));
        setColumnHidden(column, width == 0);
        if (width > 0)
            header()->resizeSection(column, width);
    }
    scheduleDelayedItemsLayout();
}

void ParameterView::resizeEvent(QResizeEvent *event)
{
    QTreeView::resizeEvent(event);
    fitColumns();
}

void ParameterView::drawRow(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    const QRect row(0, option.rect.top(), viewport()->width(), option.rect.height());
    const QModelIndex first = index.siblingAtColumn(0);
    const bool hovered = row.contains(viewport()->mapFromGlobal(QCursor::pos())) && viewport()->underMouse();
    m_delegate->paintBackground(*painter, row, first, selectionModel()->isSelected(first), hovered);
    const bool focused = hasFocus() && currentIndex().isValid() && currentIndex().siblingAtColumn(0) == first;
    QStyleOptionViewItem cell = option;
    cell.font = font();
    cell.widget = this;
    cell.state.setFlag(QStyle::State_HasFocus, focused);
    cell.state.setFlag(QStyle::State_Open, isExpanded(first));
    const bool spanned = ParameterModel::kindOf(first) != ParameterModel::Kind::Parameter;
    for (int column = 0; column < ParameterModel::ColumnCount; ++column) {
        if (isColumnHidden(column))
            continue;
        cell.rect = spanned ? row : QRect(columnViewportPosition(column), row.top(), columnWidth(column), row.height());
        m_delegate->paint(painter, cell, index.siblingAtColumn(column));
        if (spanned)
            break;
    }
    if (focused)
        m_delegate->paintFocus(*painter, row);
}

void ParameterView::activateRow(const QModelIndex &index)
{
    if (!index.isValid())
        return;
    if (ParameterModel::kindOf(index) == ParameterModel::Kind::Group) {
        setExpanded(index.siblingAtColumn(0), !isExpanded(index.siblingAtColumn(0)));
        return;
    }
    const ParameterIndex which = m_model.parameterAt(index);
    if (m_model.parameter(which).type == WireType::Boolean)
        m_model.toggle(which);
    else
        edit(m_model.indexOf(which), AllEditTriggers, nullptr);
}

bool ParameterView::event(QEvent *event)
{
    if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent *>(event)->key() == Qt::Key_F2) {
        event->accept();
        return true;
    }
    const bool isTaken = QTreeView::event(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
        fitColumns();
    return isTaken;
}

void ParameterView::keyPressEvent(QKeyEvent *event)
{
    const auto which = currentParameter();
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter || event->key() == Qt::Key_F2) {
        activateRow(currentIndex());
        return;
    }
    if (event->matches(QKeySequence::Copy)) {
        copySelection();
        return;
    }
    const QString text = event->text();
    const bool number = !text.isEmpty() && (text[0].isDigit() || QStringLiteral("+-.,").contains(text[0]));
    if (number && which && m_model.parameter(*which).type != WireType::Boolean
        && m_model.parameter(*which).choices.empty()) {
        setEditTriggers(AnyKeyPressed); // only this trigger hands the key on to the field
        edit(m_model.indexOf(*which), AnyKeyPressed, event);
        setEditTriggers(NoEditTriggers);
        return;
    }
    if (event->key() == Qt::Key_Delete && which && m_model.edits() && m_model.isWritable()) {
        m_model.edits()->revert(*which);
        return;
    }
    QTreeView::keyPressEvent(event);
}

void ParameterView::mouseReleaseEvent(QMouseEvent *event)
{
    QTreeView::mouseReleaseEvent(event);
    const QModelIndex index = indexAt(event->pos());
    const bool isDrag = selectionModel()->selectedRows().size() > 1;
    if (event->button() != Qt::LeftButton || event->modifiers() != Qt::NoModifier || !index.isValid() || isDrag)
        return;
    if (ParameterModel::kindOf(index) == ParameterModel::Kind::Group || index.column() == ParameterModel::ValueColumn)
        activateRow(index);
    else if (index.column() == ParameterModel::State && m_model.standing(m_model.parameterAt(index)).unread)
        Q_EMIT retryRequested();
}

} // namespace mb
