// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/parameters/parameterfilter.h"

#include <QSet>
#include <QTreeView>

namespace mb {

class ParameterDelegate;

/// The table: groups that fold, rows that are edited in place, faults below their row. Arrows move, Enter edits or
/// switches, a digit starts editing, Tab goes on to the next field. Rows are hidden by the filter, never taken out.
class ParameterView : public QTreeView {
    Q_OBJECT
public:
    ParameterView(const ThemeSource &theme, ParameterModel &model, QWidget *parent);

    void setFilter(const ParameterFilter &filter);
    /// Shows and hides rows anew: values or edits changed.
    void applyFilter();
    [[nodiscard]] int shownRows() const { return m_shownRows; }
    /// Takes what stands in an open field.
    void commitField();
    /// The parameter the cursor is on.
    [[nodiscard]] std::optional<ParameterIndex> currentParameter() const;
    /// Scrolls there and puts the cursor on it.
    void goTo(ParameterIndex index);
    /// key=value of the selected rows, one a line.
    [[nodiscard]] QString selectedText() const;

    void reset() override;

Q_SIGNALS:
    void currentParameterChanged();
    /// "no answer, retry" was clicked.
    void retryRequested();

protected:
    /// F2 edits a row, wherever else it renames; another font asks for other columns.
    bool event(QEvent *event) override;
    void drawRow(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const override;
    void drawBranches(QPainter *, const QRect &, const QModelIndex &) const override { }
    void keyPressEvent(QKeyEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void closeEditor(QWidget *editor, QAbstractItemDelegate::EndEditHint hint) override;
    void currentChanged(const QModelIndex &current, const QModelIndex &previous) override;
    void rowsInserted(const QModelIndex &parent, int start, int end) override;
    void dataChanged(const QModelIndex &topLeft, const QModelIndex &bottomRight, const QVector<int> &roles) override;

private:
    void configure();
    void prepareGroups();
    void showFault(const QModelIndex &fault);
    void mend(ParameterIndex index);
    void activateRow(const QModelIndex &index);
    void editBeside(ParameterIndex from, bool forward);
    [[nodiscard]] std::vector<ParameterIndex> fieldsInOrder() const;
    void openMenu(const QPoint &position);
    void copySelection() const;
    void fitColumns();

    const ThemeSource &m_theme;
    ParameterModel &m_model;
    ParameterDelegate *m_delegate = nullptr;
    ParameterFilter m_filter;
    QSet<QString> m_folded;
    int m_shownRows = 0;
    bool m_preparing = false;
};

} // namespace mb
