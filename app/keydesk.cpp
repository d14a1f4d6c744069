// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/keydesk.h"

#include "widgets/common/segmented.h"
#include "widgets/service/productionpage.h"

namespace mb {

void noteFixedKeys(PageKeys &window)
{
    window.note({Qt::Key_Escape, Qt::Key_Pause}, KeyDesk::tr("stop every motor"));
    window.note({Qt::Key_Space}, KeyDesk::tr("stops every motor, unless words can be typed where the focus is"));
    window.note({Qt::Key_Return, Qt::Key_Enter}, KeyDesk::tr("presses the button or ticks the box that has the focus"));
    window.note({QKeySequence(QStringLiteral("Ctrl+Shift+F12"))},
        KeyDesk::tr("held for 1 s: arms; let go early it does nothing"));
    window.note({QKeySequence(QStringLiteral("Ctrl+Return")), QKeySequence(QStringLiteral("Ctrl+Enter"))},
        KeyDesk::tr("keeps values that go back by themselves otherwise"));
}

KeyDesk::KeyDesk(QWidget &window, Settings &settings, std::function<QWidget *(int)> page)
    : QObject(&window)
    , m_window(window)
    , m_settings(settings)
    , m_page(std::move(page))
{
    apply();
}

KeyBook KeyDesk::book()
{
    KeyBook book;
    const auto *tabs = m_window.findChild<PageTabs *>();
    book.add(tr("Everywhere"), true, *PageKeys::of(m_window));
    for (int i = 0; i < tabs->count(); ++i) {
        if (const PageKeys *keys = PageKeys::of(*m_page(i)))
            book.add(tabs->tabText(i), false, *keys);
    }
    book.add(tr("Production"), false, *PageKeys::of(*m_window.findChild<ProductionPage *>()));
    return book;
}

void KeyDesk::use(const KeyChoices &choices)
{
    m_settings.setKeys(choices);
    apply();
}

/// What was written into the settings by hand and cannot be had stays as it came.
void KeyDesk::apply()
{
    const QList<PageKeys *> tables = m_window.findChildren<PageKeys *>();
    KeyBook book;
    for (const PageKeys *table : tables)
        book.add(QString::number(reinterpret_cast<quintptr>(table)), table->parent() == &m_window, *table);
    book.take(m_settings.keys());
    const KeyChoices choices = book.choices();
    for (PageKeys *table : tables)
        table->use(choices);
    nameTabs();
}

void KeyDesk::nameTabs()
{
    auto *tabs = m_window.findChild<PageTabs *>();
    for (int i = 0; i < tabs->count(); ++i)
        tabs->setHint(i,
            tr("%1  %2", "page, key")
                .arg(tabs->tabText(i), keyShown(*tabs, QStringLiteral("Ctrl+%1").arg(i + 1)))
                .trimmed());
}

} // namespace mb
