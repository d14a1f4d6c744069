// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/accessibility.h"

#include <QApplication>

namespace mb {

Accessibility::Accessibility(QApplication &application)
{
    for (QObject *filter : std::initializer_list<QObject *>{&m_order, &m_enter, &m_names})
        application.installEventFilter(filter);
}

} // namespace mb
