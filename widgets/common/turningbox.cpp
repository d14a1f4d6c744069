// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/turningbox.h"

#include <QWidget>

#include <algorithm>

namespace mb {

TurningBox::TurningBox(const ThemeSource &theme, int besideFrom, QWidget *parent)
    : QBoxLayout(LeftToRight, parent)
    , m_theme(theme)
    , m_besideFrom(besideFrom)
{
    setContentsMargins(0, 0, 0, 0);
}

QSize TurningBox::minimumSize() const
{
    int width = 0;
    for (int i = 0; i < count(); ++i)
        width = std::max(width, itemAt(i)->minimumSize().width());
    const QMargins margins = contentsMargins();
    return {width + margins.left() + margins.right(), QBoxLayout::minimumSize().height()};
}

/// Which way it lies follows from the width that is asked about, as everything else that a layout keeps of it.
void TurningBox::turnFor(int width) const
{
    const_cast<TurningBox *>(this)->setDirection(width < m_theme.theme().u(m_besideFrom) ? TopToBottom : LeftToRight);
}

int TurningBox::heightForWidth(int width) const
{
    turnFor(width);
    return QBoxLayout::hasHeightForWidth() ? QBoxLayout::heightForWidth(width) : QBoxLayout::sizeHint().height();
}

void TurningBox::setGeometry(const QRect &rect)
{
    turnFor(rect.width());
    QBoxLayout::setGeometry(rect);
}

} // namespace mb
