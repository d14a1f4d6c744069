// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/turningsplitter.h"

#include <algorithm>

namespace mb {

TurningSplitter::TurningSplitter(const ThemeSource &theme, int besideFrom, QWidget *parent)
    : QSplitter(Qt::Horizontal, parent)
    , m_theme(theme)
    , m_besideFrom(besideFrom)
{
    setChildrenCollapsible(false);
}

QSize TurningSplitter::minimumSizeHint() const
{
    int width = 0;
    for (int i = 0; i < count(); ++i)
        width = std::max({width, widget(i)->minimumSizeHint().width(), widget(i)->minimumWidth()});
    return {width, QSplitter::minimumSizeHint().height()};
}

void TurningSplitter::resizeEvent(QResizeEvent *event)
{
    const Qt::Orientation wanted = width() < m_theme.theme().u(m_besideFrom) ? Qt::Vertical : Qt::Horizontal;
    if (wanted != orientation())
        setOrientation(wanted);
    QSplitter::resizeEvent(event);
}

} // namespace mb
