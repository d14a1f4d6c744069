// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/connection/axisrows.h"

#include "widgets/common/axistext.h"
#include "widgets/common/labels.h"
#include "widgets/common/spoken.h"
#include "widgets/common/stateglyph.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

namespace mb {

AxisRows::AxisRows(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
    , m_grid(new QGridLayout(this))
{
    setAccessibleName(tr("Axes"));
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setHorizontalSpacing(theme.theme().u(8));
    m_grid->setVerticalSpacing(theme.theme().u(4));
    m_grid->setColumnStretch(2, 1);
}

void AxisRows::add()
{
    const int axis = static_cast<int>(m_rows.size()) + 1;
    Row row;
    row.glyph = new StateGlyph(m_theme, GlyphState::Gone, this);
    row.name = linkButton(axisTitle(axis), this);
    row.name->setToolTip(tr("Shows this axis in Parameters, Tune and Plots"));
    row.command = new ElidedLabel({}, this);
    setTone(*row.command, Tone::Dim);
    row.value = new QLabel(this);
    row.value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_grid->addWidget(row.glyph, axis - 1, 0);
    m_grid->addWidget(row.name, axis - 1, 1);
    m_grid->addWidget(row.command, axis - 1, 2);
    m_grid->addWidget(row.value, axis - 1, 3);
    connect(row.name, &QPushButton::clicked, this, [this, axis] { Q_EMIT axisActivated(axis); });
    m_rows.push_back(row);
}

void AxisRows::show(const DeviceView &device, Instant now)
{
    const int axes = device.family->capabilities.axes;
    while (static_cast<int>(m_rows.size()) < axes)
        add();
    for (int axis = 1; axis <= axes; ++axis) {
        const Row &row = m_rows[static_cast<std::size_t>(axis - 1)];
        const QString command = commandOfAxis(device, axis);
        row.glyph->setState(glyphOfAxis(device, axis));
        row.command->setText(command);
        row.value->setText(valueOfAxis(device, axis, now));
        setSpokenLive(*row.name, glyphWord(glyphOfAxis(device, axis)) + QStringLiteral(", ") + command);
    }
}

} // namespace mb
