// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include <optional>

class QKeyEvent;

namespace mb {

/// Stops on the press of Esc or Pause, anywhere in the program, and of Space unless words can be typed
/// where the focus is (acceptsLetters()), whatever else is held; in a ScanField Space is text only while a scanner types. Install on the
/// application: it sees keys before dialogs, editors, shortcuts and a drag of the pointer do.
class StopKeys : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

Q_SIGNALS:
    void stopPressed(const QString &key);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    [[nodiscard]] bool isText(const QKeyEvent &key) const;
    void announce(const QKeyEvent &key, const QString &name);
    void comeFirst();

    bool m_queued = false;                ///< comeFirst() is to come
    unsigned long m_announced = 0;        ///< time stamp of the last press told
    std::optional<unsigned long> m_typed; ///< that of the last key that types something
};

} // namespace mb
