// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace mb {

/// Keeps the wheel from changing what it only passes over: scrolling a panel must not steer a motor. Watched widgets obey
/// the wheel once they have the focus, which the wheel itself does not give.
class CalmWheel : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;
    /// Every combo box and slider inside.
    void watch(QWidget &panel);

protected:
    bool eventFilter(QObject *object, QEvent *event) override;
};

} // namespace mb
