// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include <functional>

namespace mb {

class HelpDesk;
class PageKeys;
class PageStack;
class ParametersPage;
class Settings;
class SideDocks;
class WindowMenu;

/// The keys of the window, and the two lists of what can be done: all keys (F1), and everything that has a name (Ctrl+K). Made from the
/// same tables as the keys themselves. Lives as long as the window. GUI thread.
class WindowKeys : public QObject {
    Q_OBJECT
public:
    /// What they act on; outlives this.
    struct Surroundings {
        PageStack &pages;
        SideDocks &docks;
        WindowMenu &menu;
        HelpDesk &help;
        Settings &settings;
    };
    /// `production` and `rename`: what F11 and F2 do.
    WindowKeys(const Surroundings &surroundings, QWidget &window, std::function<void()> production,
        std::function<void()> rename);

    /// Of the page that is shown, then those of the window.
    void list();
    /// Keys of the window and of every page, the menu, and the buttons of the page that is shown.
    void listCommands();

private:
    void build(Settings &settings, std::function<void()> production, std::function<void()> rename);
    [[nodiscard]] std::function<void()> ordering(void (ParametersPage::*order)());

    PageStack &m_pages;
    SideDocks &m_docks;
    WindowMenu &m_menu;
    HelpDesk &m_help;
    QWidget &m_window;
    PageKeys *m_keys = nullptr;
};

} // namespace mb
