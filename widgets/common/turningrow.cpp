// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/turningrow.h"

#include "widgets/common/layoutin.h"

#include <algorithm>

namespace mb {

TurningRow::TurningRow(const ThemeSource &theme, int besideFrom, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
    , m_besideFrom(besideFrom)
    , m_parts(layoutIn<QHBoxLayout>(this))
{
}

QSize TurningRow::minimumSizeHint() const
{
    int width = 0;
    for (int i = 0; i < m_parts->count(); ++i)
        width = std::max(width, m_parts->itemAt(i)->minimumSize().width());
    const QMargins margins = m_parts->contentsMargins();
    return {width + margins.left() + margins.right(), QWidget::minimumSizeHint().height()};
}

bool TurningRow::isTurned() const
{
    return width() < m_theme.theme().u(m_besideFrom);
}

void TurningRow::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    m_parts->setDirection(isTurned() ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
}

} // namespace mb
