// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/windowkeys.h"

#include "app/helpdesk.h"
#include "app/keydesk.h"
#include "app/pagestack.h"
#include "app/sidedocks.h"
#include "app/windowmenu.h"
#include "widgets/common/commandpalette.h"
#include "widgets/common/pagekeys.h"
#include "widgets/parameters/parameterspage.h"

namespace mb {

WindowKeys::WindowKeys(
    const Surroundings &surroundings, QWidget &window, std::function<void()> production, std::function<void()> rename)
    : QObject(&window)
    , m_pages(surroundings.pages)
    , m_docks(surroundings.docks)
    , m_menu(surroundings.menu)
    , m_help(surroundings.help)
    , m_window(window)
    , m_keys(new PageKeys(window))
{
    build(surroundings.settings, std::move(production), std::move(rename));
    connect(&m_menu, &WindowMenu::keysRequested, this, &WindowKeys::list);
    connect(&m_menu, &WindowMenu::commandsRequested, this, &WindowKeys::listCommands);
}

/// Of the selected device, on whatever page; in production none is.
std::function<void()> WindowKeys::ordering(void (ParametersPage::*order)())
{
    return [this, order] {
        if (m_pages.isVisible())
            (qobject_cast<ParametersPage *>(m_pages.page(PageId::Parameters))->*order)();
    };
}

void WindowKeys::build(Settings &settings, std::function<void()> production, std::function<void()> rename)
{
    noteFixedKeys(*m_keys);
    m_keys->add({Qt::Key_F1}, tr("shows these keys; once more, the help for this page"), [this] { list(); });
    m_keys->add(
        {Qt::Key_F2}, tr("renames the selected device; in production: goes to the serial number"), std::move(rename));
    m_keys->add({Qt::Key_F11}, tr("production: unit after unit, full screen; and back"), std::move(production));
    m_keys->add({QKeySequence(QStringLiteral("Ctrl+S"))}, tr("stores what the selected device has in RAM only"),
        ordering(&ParametersPage::store));
    m_keys->add({QKeySequence(QStringLiteral("Ctrl+Shift+S"))}, tr("takes a snapshot of the selected device"),
        ordering(&ParametersPage::takeSnapshot));
    for (const PageId id : m_pages.all()) {
        const QKeySequence key(QStringLiteral("Ctrl+%1").arg(static_cast<int>(id) + 1));
        m_keys->add({key}, tr("shows page %1").arg(m_pages.title(id)), [this, id] { m_pages.showPage(id); });
    }
    m_docks.addTo(*m_keys);
    m_menu.addTo(*m_keys);
    auto *desk
        = new KeyDesk(m_window, settings, [this](int place) { return m_pages.page(static_cast<PageId>(place)); });
    connect(&m_pages, &PageStack::pageMade, desk, &KeyDesk::apply);
    m_menu.setKeys(*desk);
}

void WindowKeys::list()
{
    showKeys(m_window, m_pages.title(m_pages.shown()), {PageKeys::of(*m_pages.shownPage()), m_keys},
        [this] { (void)m_help.open(m_help.topicOf(m_pages.shown())); });
}

void WindowKeys::listCommands()
{
    std::vector<Command> commands;
    addButtons(commands, m_pages.title(m_pages.shown()), *m_pages.shownPage());
    for (const PageId id : m_pages.all()) {
        const PageKeys *keys = PageKeys::of(*m_pages.page(id));
        if (keys && m_pages.isAvailable(id))
            addCommands(commands, m_pages.title(id), *keys, [this, id] { m_pages.showPage(id); });
    }
    addCommands(commands, tr("Window"), *m_keys, [] {});
    addCommands(commands, tr("Menu"), m_menu.menu());
    (new CommandPalette(std::move(commands), &m_window))->open();
}

} // namespace mb
