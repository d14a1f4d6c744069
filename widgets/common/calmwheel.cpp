// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/calmwheel.h"

#include <QAbstractSlider>
#include <QComboBox>
#include <QEvent>
#include <QScrollBar>

namespace mb {

void CalmWheel::watch(QWidget &panel)
{
    const auto widgets = panel.findChildren<QWidget *>();
    for (QWidget *widget : widgets) {
        const bool turns = qobject_cast<QComboBox *>(widget)
            || (qobject_cast<QAbstractSlider *>(widget) && !qobject_cast<QScrollBar *>(widget));
        if (!turns)
            continue;
        widget->setFocusPolicy(Qt::StrongFocus);
        widget->installEventFilter(this);
    }
}

bool CalmWheel::eventFilter(QObject *object, QEvent *event)
{
    const auto *widget = qobject_cast<QWidget *>(object);
    if (event->type() != QEvent::Wheel || !widget || widget->hasFocus())
        return QObject::eventFilter(object, event);
    event->ignore(); // it goes on to what scrolls
    return true;
}

} // namespace mb
