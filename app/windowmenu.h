// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/settings.h"
#include "widgets/common/theme.h"
#include "widgets/common/workbench.h"

#include <QObject>

class QMenu;

namespace mb {

class KeyDesk;
class PageKeys;

/// The menu of the window, and what its entries do: links, recordings, how the program looks, what it is. GUI thread.
class WindowMenu : public QObject {
    Q_OBJECT
public:
    WindowMenu(Workbench &workbench, ThemeSource &theme, Settings &settings, QWidget &window);

    [[nodiscard]] QMenu &menu() { return *m_menu; }

    /// Whom the preferences ask for the keys; outlives this.
    void setKeys(KeyDesk &keys) { m_keys = &keys; }
    /// Its entries that have a key, into the table of the window.
    void addTo(PageKeys &keys) const;

    void addLink();
    /// `keep`: at every start from now on, once it could be opened.
    void openAddress(const QString &address, bool keep);
    /// Asks for a file, then openFile().
    void openRecording();
    /// Samples (.mcap, .csv) in a window of their own, anything else as a link that plays. It is not opened again at the next
    /// start: it was there to be looked at.
    void openFile(const QString &path);
    void openSimulation();
    void switchTheme();
    void askPreferences();

Q_SIGNALS:
    /// A recording of frames is a link now.
    void framesOpened(const QString &address);
    /// Everything that has a name is wanted. Ctrl+K.
    void commandsRequested();
    void keysRequested();
    /// A page of the help (widgets/help/helptopics.h).
    void helpWanted(const QString &topic);
    void lookChosen();
    void projectWanted(bool open);

private:
    Workbench &m_workbench;
    ThemeSource &m_theme;
    Settings &m_settings;
    QWidget &m_window;
    KeyDesk *m_keys = nullptr;
    QMenu *m_menu = nullptr;
};

} // namespace mb
