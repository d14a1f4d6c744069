// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/design/choicemark.h"

#include <QPainter>

namespace mb {

ChoiceMark::ChoiceMark(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    setFixedSize(theme.theme().u(14), theme.theme().u(14));
}

void ChoiceMark::setChosen(bool chosen)
{
    m_chosen = chosen;
    update();
}

void ChoiceMark::paintEvent(QPaintEvent *)
{
    const Theme &look = m_theme.theme();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QPointF middle = QRectF(rect()).center();
    const double radius = width() / 2.0 - 1.0;
    painter.setPen(QPen(m_chosen ? look.accent : look.outline, 1.6));
    painter.drawEllipse(middle, radius, radius);
    if (!m_chosen)
        return;
    painter.setPen(Qt::NoPen);
    painter.setBrush(look.accent);
    painter.drawEllipse(middle, radius * 0.55, radius * 0.55);
}

} // namespace mb
