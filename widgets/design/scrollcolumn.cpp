// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/design/scrollcolumn.h"

#include "widgets/common/layoutin.h"

namespace mb {

ScrollColumn::ScrollColumn(const Theme &theme, QWidget *parent)
    : QScrollArea(parent)
{
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFocusPolicy(Qt::NoFocus);
    m_content = new QWidget(this);
    m_content->setProperty("transparent", true);
    m_rows = layoutIn<QVBoxLayout>(m_content, theme.u(10), {theme.u(12), theme.u(10), theme.u(12), theme.u(10)});
    m_rows->setSizeConstraint(QLayout::SetMinimumSize);
    setWidget(m_content);
}

} // namespace mb
