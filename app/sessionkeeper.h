// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/sessionbook.h"
#include "widgets/common/diskthread.h"
#include "widgets/common/workbench.h"

#include <QTimer>

namespace mb {

class MainWindow;

/// Writes down what the window has open as it changes, so that it is there after a crash, and opens it again. Lives as long as
/// the window; the book outlives it. GUI thread.
class SessionKeeper : public QObject {
    Q_OBJECT
public:
    /// For so long after its links were opened the selection of a session is taken up, unless somebody chooses, arms or turns the page.
    static constexpr Duration patience = std::chrono::seconds(20);

    SessionKeeper(MainWindow &window, Workbench &workbench, SessionBook &book, qint64 begun);

    /// Opens the links of a session, and goes to its device and page once it answers.
    void restore(const SessionRecord &record);
    /// The same without opening anything.
    void comeBack(const SessionRecord &record);
    /// Writes soon, and before it goes; `ended`: the window is closed.
    void save(bool ended);
    [[nodiscard]] SessionRecord present() const;

private:
    void follow();
    void takeUp();
    [[nodiscard]] qint64 unixNow() const;

    MainWindow &m_window;
    Workbench &m_workbench;
    SessionBook &m_book;
    qint64 m_begun;
    SessionRecord m_written;
    SessionRecord m_wanted; ///< its device is waited for
    Instant m_wantedAt{};
    bool m_told = false; ///< that it cannot be written
    QTimer m_time;
    DiskThread m_disk;
};

/// Name of a page in a session.
[[nodiscard]] QString pageName(int page);

} // namespace mb
