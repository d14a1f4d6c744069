// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/systempalette.h"

#include <QApplication>
#include <QEvent>
#include <QTimer>

#include <utility>

namespace mb {

SystemPalette::SystemPalette()
    : m_palette(ask())
    , m_ours(QApplication::palette())
{
    qApp->installEventFilter(this);
}

/// Without a palette of its own the program has the desktop's.
QPalette SystemPalette::ask()
{
    m_asking = true;
    const QPalette ours = QApplication::palette();
    QApplication::setPalette(QPalette());
    const QPalette desktop = QApplication::palette();
    QApplication::setPalette(ours);
    m_asking = false;
    return desktop;
}

void SystemPalette::keep()
{
    m_ours = QApplication::palette();
}

bool SystemPalette::isOurs() const
{
    const QPalette now = QApplication::palette();
    for (int role = 0; role < QPalette::NColorRoles; ++role) {
        const auto colour = static_cast<QPalette::ColorRole>(role);
        if ((m_ours.resolve() & (1U << role))
            && now.color(QPalette::Active, colour) != m_ours.color(QPalette::Active, colour))
            return false;
    }
    return true;
}

/// Each window is told, and what belongs together may come in several pieces: looked at once, when all of it is there.
bool SystemPalette::eventFilter(QObject *, QEvent *event)
{
    const bool news = event->type() == QEvent::ThemeChange || event->type() == QEvent::ApplicationPaletteChange;
    m_exchanged = m_exchanged || event->type() == QEvent::ThemeChange;
    if (news && !m_asking && !m_told) {
        m_told = true;
        QTimer::singleShot(0, this, &SystemPalette::look);
    }
    return false;
}

void SystemPalette::look()
{
    m_told = false;
    if (!std::exchange(m_exchanged, false) && QApplication::palette() == m_ours)
        return; // what was told was the program's own change
    const bool foreign = !isOurs();
    const QPalette desktop = foreign ? QApplication::palette() : ask();
    if (!foreign)
        keep(); // with what the desktop has in the roles that are left to it
    if (std::exchange(m_palette, desktop) != desktop || foreign)
        Q_EMIT changed();
}

} // namespace mb
