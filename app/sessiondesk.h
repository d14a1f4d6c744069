// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/sessionbook.h"
#include "widgets/common/theme.h"
#include "widgets/common/workbench.h"
#include "widgets/start/listcard.h"

namespace mb {

class LinkOwners;
class MainWindow;
class SessionKeeper;
class Welcome;

/// Sessions of this program as its window meets them: the last one comes back, earlier ones are offered on the start page, one
/// that crashed is offered above the pages, and links that another window has are named. Outlives the window.
class SessionDesk : public QObject {
    Q_OBJECT
public:
    /// `folder`: of sessions and crashes, below the user's data.
    SessionDesk(Workbench &workbench, const ThemeSource &theme, const QString &folder);
    ~SessionDesk() override;

    /// For each window that is made; only the first one comes back to where the last session was.
    void attach(MainWindow &window, Welcome &welcome);

private:
    void offerCrashed(MainWindow &window);
    void fillRecent(Welcome &welcome);
    [[nodiscard]] ListCard::Row rowOf(const SessionRecord &record) const;

    Workbench &m_workbench;
    const ThemeSource &m_theme;
    QString m_folder;
    SessionBook m_book;
    LinkOwners *m_owners;
    SessionKeeper *m_keeper = nullptr; ///< of the window that there is now
    qint64 m_begun = 0;
    bool m_first = true;
    std::vector<SessionBook::Entry> m_earlier;
};

/// "today 16:20", "yesterday 16:20", "6 June 16:20".
[[nodiscard]] QString whenText(qint64 unixTime, qint64 now);

} // namespace mb
