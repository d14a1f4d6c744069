// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/systempalette.h"

#include <QApplication>
#include <QEvent>
#include <QTimer>

namespace mb {

SystemPalette::SystemPalette()
    : m_palette(ask())
{
    qApp->installEventFilter(this);
}

/// Without a palette of its own the program has the desktop's.
QPalette SystemPalette::ask()
{
    const QPalette ours = QApplication::palette();
    QApplication::setPalette(QPalette());
    const QPalette desktop = QApplication::palette();
    QApplication::setPalette(ours);
    return desktop;
}

/// Each window is told; the last of them asks.
bool SystemPalette::eventFilter(QObject *, QEvent *event)
{
    if (event->type() == QEvent::ThemeChange)
        QTimer::singleShot(0, this, [this] {
            const QPalette desktop = ask();
            if (std::exchange(m_palette, desktop) != desktop)
                Q_EMIT changed();
        });
    return false;
}

} // namespace mb
