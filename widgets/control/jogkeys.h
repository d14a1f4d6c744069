// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/setpoint.h"

#include <QObject>

#include <functional>
#include <optional>

class QWidget;

namespace mb {

class Arming;

/// J and K move the armed motor forwards and backwards for as long as they are held, never longer: a release, a lost focus or
/// a page that is hidden stops it. Nothing happens while something moves already, or when letters belong to a field.
class JogKeys : public QObject {
    Q_OBJECT
public:
    /// What a jog sends, forwards or backwards; nothing when the page has no motor for it.
    using SetPointOf = std::function<std::optional<SetPoint>(bool forwards)>;

    JogKeys(Arming &arming, QWidget &page, SetPointOf setPointOf);

    [[nodiscard]] bool isHeld() const { return m_held != 0; }
    /// A tenth of a second of the same, for a button.
    void nudge(bool forwards);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    bool press(int key);
    void release();

    Arming &m_arming;
    SetPointOf m_setPointOf;
    int m_held = 0;
};

} // namespace mb
