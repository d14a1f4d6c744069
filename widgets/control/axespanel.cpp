// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/axespanel.h"

#include "widgets/common/axistext.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QMenu>
#include <QPushButton>
#include <QToolButton>

#include <algorithm>

namespace mb {

AxesPanel::AxesPanel(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
    , m_group(new QButtonGroup(this))
{
    setObjectName(QStringLiteral("axesPanel"));
    setAccessibleName(tr("Axes"));
    auto *column = layoutIn<QVBoxLayout>(this, theme.theme().u(4));
    auto *head = new QHBoxLayout;
    head->addWidget(new SectionLabel(tr("Axes"), this));
    head->addStretch(1);
    m_all = new QCheckBox(tr("together"), this);
    m_all->setLayoutDirection(Qt::RightToLeft);
    m_all->setAccessibleName(tr("All axes run together"));
    m_all->setToolTip(tr("Run starts every ticked axis at the same moment, each with its own mode and set-point."));
    head->addWidget(m_all);
    column->addLayout(head);
    m_grid = new QGridLayout;
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setHorizontalSpacing(theme.theme().u(6));
    m_grid->setVerticalSpacing(theme.theme().u(2));
    m_grid->setColumnStretch(2, 1);
    column->addLayout(m_grid);
    buildFoot();
    connect(m_all, &QCheckBox::clicked, this, [this](bool on) {
        for (Row &row : m_rows)
            row.ticked = on;
        showTicks();
        Q_EMIT togetherChanged();
    });
    connect(m_group, &QButtonGroup::idClicked, this, [this](int axis) {
        if (axis != m_axis)
            Q_EMIT axisChosen(axis);
    });
    hide();
}

void AxesPanel::buildFoot()
{
    auto *row = new QVBoxLayout;
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    m_copy = linkButton(tr("Copy gains from…"), this);
    m_copy->setToolTip(tr("Stages the gains and limits of another axis for this one."));
    m_copy->setMenu(new QMenu(m_copy));
    m_spread = linkButton(tr("Same set-point for all ticked"), this);
    m_spread->setToolTip(
        tr("Mode and set-point of this axis for every ticked one; a position becomes the same distance."));
    row->addWidget(m_copy, 0, Qt::AlignLeft);
    row->addWidget(m_spread, 0, Qt::AlignLeft);
    static_cast<QVBoxLayout *>(layout())->addLayout(row);
    connect(m_copy->menu(), &QMenu::aboutToShow, this, &AxesPanel::fillCopyMenu);
    connect(m_spread, &QPushButton::clicked, this, &AxesPanel::spreadRequested);
}

void AxesPanel::fillCopyMenu()
{
    m_copy->menu()->clear();
    for (int axis = 1; axis <= count(); ++axis) {
        if (axis != m_axis)
            m_copy->menu()->addAction(axisTitle(axis), this, [this, axis] { Q_EMIT copyGainsRequested(axis); });
    }
}

void AxesPanel::add()
{
    const int axis = count() + 1;
    Row row;
    row.name = new QToolButton(this);
    row.name->setText(axisTitle(axis));
    row.name->setCheckable(true);
    row.name->setToolTip(tr("Shows this axis: its mode, set-point, gains, limits and traces"));
    setStyleProperty(*row.name, "segment", QStringLiteral("only"));
    row.glyph = new StateGlyph(m_theme, GlyphState::Gone, this);
    row.command = new ElidedLabel({}, this);
    setTextRole(*row.command, TextRole::Caption);
    row.value = new QLabel(this);
    setTextRole(*row.value, TextRole::Caption);
    row.value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    row.together = new QCheckBox(this);
    row.together->setAccessibleName(tr("Axis %1 runs together with the others").arg(axis));
    m_group->addButton(row.name, axis);
    m_grid->addWidget(row.name, axis - 1, 0);
    m_grid->addWidget(row.glyph, axis - 1, 1);
    m_grid->addWidget(row.command, axis - 1, 2);
    m_grid->addWidget(row.value, axis - 1, 3);
    m_grid->addWidget(row.together, axis - 1, 4);
    connect(row.together, &QCheckBox::clicked, this, [this, axis](bool on) {
        m_rows[static_cast<std::size_t>(axis - 1)].ticked = on;
        showTicks();
        Q_EMIT togetherChanged();
    });
    m_rows.push_back(row);
}

void AxesPanel::setAxes(int count)
{
    setVisible(count > 1);
    if (count < 2)
        count = 0;
    while (static_cast<int>(m_rows.size()) > count) {
        const Row row = m_rows.back();
        m_rows.pop_back();
        for (QWidget *widget :
            {static_cast<QWidget *>(row.name), static_cast<QWidget *>(row.glyph), static_cast<QWidget *>(row.command),
                static_cast<QWidget *>(row.value), static_cast<QWidget *>(row.together)})
            delete widget;
    }
    while (static_cast<int>(m_rows.size()) < count)
        add();
    for (Row &row : m_rows)
        row.ticked = false;
    showTicks();
}

void AxesPanel::setAxis(int axis)
{
    m_axis = axis;
    if (QAbstractButton *button = m_group->button(axis))
        button->setChecked(true);
    showTicks();
}

void AxesPanel::setState(int axis, const State &state)
{
    const Row &row = m_rows.at(static_cast<std::size_t>(axis - 1));
    row.glyph->setState(state.glyph);
    setTone(*row.command, state.glyph == GlyphState::Moving ? Tone::Text : Tone::Dim);
    row.command->setText(state.command);
    row.value->setText(state.value);
    row.name->setAccessibleName(
        QStringList{axisTitle(axis), glyphWord(state.glyph), state.command, state.value}.join(QStringLiteral(", ")));
}

void AxesPanel::showTicks()
{
    bool all = true;
    for (int axis = 1; axis <= count(); ++axis) {
        const Row &row = m_rows[static_cast<std::size_t>(axis - 1)];
        row.together->setChecked(row.ticked || axis == m_axis);
        row.together->setEnabled(axis != m_axis);
        row.together->setToolTip(axis == m_axis ? tr("Run always moves the axis that is shown.")
                                                : tr("Run moves this axis, too, at the same moment."));
        all = all && row.together->isChecked();
    }
    m_all->setChecked(all && count() > 0);
    m_spread->setVisible(together().size() > 1);
}

std::vector<int> AxesPanel::together() const
{
    std::vector<int> axes;
    for (int axis = 1; axis <= count(); ++axis) {
        if (axis == m_axis || m_rows[static_cast<std::size_t>(axis - 1)].ticked)
            axes.push_back(axis);
    }
    return axes;
}

void AxesPanel::setTogether(const std::vector<int> &axes)
{
    for (int axis = 1; axis <= count(); ++axis)
        m_rows[static_cast<std::size_t>(axis - 1)].ticked = std::ranges::find(axes, axis) != axes.end();
    showTicks();
    Q_EMIT togetherChanged();
}

QWidget *AxesPanel::chainAfter(QWidget *before)
{
    for (const Row &row : m_rows) {
        for (QWidget *widget : {static_cast<QWidget *>(row.name), static_cast<QWidget *>(row.together)}) {
            setTabOrder(before, widget);
            before = widget;
        }
    }
    return before;
}

} // namespace mb
