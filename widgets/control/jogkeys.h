// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/setpoint.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <functional>
#include <optional>

class QKeyEvent;
class QWidget;

namespace mb {

class Arming;

/// J and K move the armed motor forwards and backwards for as long as they are held, never longer: a release, whatever
/// else is held and whatever is open, a focus that leaves the page, or a page that is hidden stops it. Nothing happens while
/// something moves already, or when letters belong to a field.
class JogKeys : public QObject {
    Q_OBJECT
public:
    /// What a jog sends, forwards or backwards; nothing when the page has no motor for it.
    using SetPointOf = std::function<std::optional<SetPoint>(bool forwards)>;

    JogKeys(Arming &arming, QWidget &page, SetPointOf setPointOf);

    [[nodiscard]] bool isHeld() const { return m_held != 0; }
    /// As a key that goes down, for a button.
    void hold(bool forwards);
    /// As the key that comes up; one that was held for less than a tenth of a second moves for as long.
    void letGo();

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    bool press(int key);
    bool pageKey(const QKeyEvent &key);
    void release();
    void followFocus(const QWidget *now);

    Arming &m_arming;
    QWidget &m_page;
    SetPointOf m_setPointOf;
    int m_held = 0;
    QElapsedTimer m_since;
    QTimer m_nudge;
};

} // namespace mb
