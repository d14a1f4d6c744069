// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include <QAbstractButton>
#include <QKeyEvent>
#include <QString>

namespace mb {

/// STOP. Acts on press, with any mouse button; never disabled; never in the Tab order.
class StopButton : public QAbstractButton {
    Q_OBJECT
public:
    explicit StopButton(const ThemeSource &theme, QWidget *parent = nullptr);
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

Q_SIGNALS:
    void stopPressed();

protected:
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override { mousePressEvent(event); }
    void keyPressEvent(QKeyEvent *event) override { event->ignore(); }
    void keyReleaseEvent(QKeyEvent *event) override { event->ignore(); }
    void changeEvent(QEvent *event) override;

private:
    const ThemeSource &m_theme;
    QString m_keys;
};

} // namespace mb
