// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/leastheight.h"

#include <QLayout>
#include <QResizeEvent>

namespace mb {

QSize LeastHeight::minimumSizeHint() const
{
    const QSize least = QWidget::minimumSizeHint();
    const QLayout *const parts = layout();
    if (!parts || !parts->hasHeightForWidth())
        return least;
    return {least.width(), parts->minimumHeightForWidth(std::max(width(), least.width()))};
}

void LeastHeight::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    if (event->size().width() != event->oldSize().width())
        updateGeometry();
}

} // namespace mb
