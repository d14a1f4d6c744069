// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/connection/axiscells.h"

#include "widgets/common/axistext.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/sparkline.h"
#include "widgets/common/spoken.h"
#include "widgets/common/stateglyph.h"
#include "widgets/connection/recentvalues.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

namespace mb {
namespace {

constexpr int besideFrom = 460; ///< units for all of them in one row

} // namespace

AxisCells::AxisCells(const ThemeSource &theme, Look look, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
    , m_look(look)
    , m_grid(new QGridLayout(this))
{
    setAccessibleName(tr("Axes"));
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setHorizontalSpacing(theme.theme().u(look == Look::Rows ? 8 : 12));
    m_grid->setVerticalSpacing(theme.theme().u(look == Look::Rows ? 4 : 8));
    m_grid->setColumnStretch(2, look == Look::Rows ? 1 : 0);
}

void AxisCells::add()
{
    const int axis = static_cast<int>(m_cells.size()) + 1;
    Cell cell;
    cell.whole = m_look == Look::Rows ? this : new QWidget(this);
    cell.glyph = new StateGlyph(m_theme, GlyphState::Gone, cell.whole);
    cell.name = linkButton(axisTitle(axis), cell.whole);
    cell.name->setToolTip(tr("Shows this axis in Parameters, Tune and Plots"));
    cell.command = new ElidedLabel({}, cell.whole);
    setTone(*cell.command, Tone::Dim);
    cell.value = new QLabel(cell.whole);
    connect(cell.name, &QPushButton::clicked, this, [this, axis] { Q_EMIT axisActivated(axis); });
    if (m_look == Look::Cells) {
        fill(cell);
    } else {
        cell.value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        m_grid->addWidget(cell.glyph, axis - 1, 0);
        m_grid->addWidget(cell.name, axis - 1, 1);
        m_grid->addWidget(cell.command, axis - 1, 2);
        m_grid->addWidget(cell.value, axis - 1, 3);
    }
    m_cells.push_back(cell);
}

void AxisCells::fill(Cell &cell)
{
    const Theme &theme = m_theme.theme();
    auto *column = layoutIn<QVBoxLayout>(cell.whole, theme.u(2));
    auto *head = new QHBoxLayout;
    head->setSpacing(theme.u(6));
    setTextRole(*cell.command, TextRole::Caption);
    cell.line = new Sparkline(m_theme, TraceRole::Position, cell.whole);
    cell.line->setCapacity(recentPoints);
    cell.line->setMinimumHeight(theme.u(30));
    head->addWidget(cell.glyph);
    head->addWidget(cell.name);
    head->addStretch();
    column->addLayout(head);
    column->addWidget(cell.command);
    column->addWidget(cell.value);
    column->addWidget(cell.line, 1);
}

void AxisCells::arrange()
{
    const int all = static_cast<int>(m_cells.size());
    const int columns = width() >= m_theme.theme().u(besideFrom) ? all : std::min(all, 2);
    if (m_look == Look::Rows || columns < 1 || columns == m_columns)
        return;
    m_columns = columns;
    for (int i = 0; i < all; ++i)
        m_grid->addWidget(m_cells[static_cast<std::size_t>(i)].whole, i / columns, i % columns);
    for (int i = 0; i < all; ++i)
        m_grid->setColumnStretch(i, i < columns ? 1 : 0);
}

void AxisCells::show(const DeviceView &device, Instant now)
{
    const int axes = device.family->capabilities.axes;
    while (static_cast<int>(m_cells.size()) < axes) {
        add();
        m_columns = 0;
    }
    arrange();
    for (int axis = 1; axis <= axes; ++axis) {
        const Cell &cell = m_cells[static_cast<std::size_t>(axis - 1)];
        const QString command = commandOfAxis(device, axis);
        cell.glyph->setState(glyphOfAxis(device, axis));
        cell.command->setText(command);
        cell.value->setText(valueOfAxis(device, axis, now));
        setSpokenLive(*cell.name, glyphWord(glyphOfAxis(device, axis)) + QStringLiteral(", ") + command);
        if (cell.line && isVisible()) {
            cell.line->setRole(turnsAxis(device, axis) ? TraceRole::Velocity : TraceRole::Position);
            cell.line->setValues(recentValues(device, channelOfAxis(device, axis), now));
        }
    }
}

} // namespace mb
