// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/unfinished.h"

#include <QPointer>
#include <QTimer>

#include <optional>

class QAbstractButton;
class QMessageBox;

namespace mb {

class Arming;

/// Lets the window go only when nothing is cut by it. Asks about what is unfinished, cancels what may be cancelled, waits out what must
/// not be cut, until jobs have ended and experiments have put back what they changed, and until every motor that this program has moved,
/// or has told to stop before, was seen to stop.
class Closing : public QObject {
    Q_OBJECT
public:
    /// How long a motor has to be seen still before the user is asked.
    static constexpr Duration patience = std::chrono::seconds(3);
    /// How long a job has to end, and an experiment for what it puts back. What is left then is owed to the unit, and asked about at the
    /// next start.
    static constexpr Duration longestJob = std::chrono::seconds(10);

    Closing(Workbench &workbench, Arming &arming, QWidget &window);

    /// Of a close event: whether the window may go now. If not, it is closed from here later, or not at all.
    [[nodiscard]] bool mayClose();
    /// The window has to go, and nobody is there to ask: every question counts as answered with what goes on.
    void end();
    /// It is about to go.
    [[nodiscard]] bool isEnding() const { return m_state != State::Open; }
    /// Of a window that end() took away: devices that this program moved and that were not seen to stop; empty for none.
    [[nodiscard]] const QStringList &unstopped() const { return m_unstopped; }

private:
    enum class State { Open, Asking, Ending, Free };

    void askOrBegin();
    [[nodiscard]] QString detailOf(const std::vector<Unfinished> &all) const;
    void askAboutMotors();
    /// The button that goes on.
    [[nodiscard]] QAbstractButton &ask(const QString &question, const QString &what, const QString &go);
    void begin();
    void follow();
    void followQuestion();
    void keepOpen();
    void leave();
    [[nodiscard]] QStringList turning() const;

    Workbench &m_workbench;
    Arming &m_arming;
    QWidget &m_window;
    State m_state = State::Open;
    QTimer m_look;                           ///< an engine that hangs tells of no change
    std::optional<Unfinished::Kind> m_about; ///< what was asked about last
    std::vector<DeviceId> m_moved;           ///< to be seen stopped
    Instant m_since{};
    bool m_within = false; ///< the close event is being answered
    bool m_asks = true;
    QStringList m_unstopped;
    QPointer<QMessageBox> m_question;
};

} // namespace mb
