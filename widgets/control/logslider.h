// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include <QSlider>

namespace mb {

/// One decade down and one up around a centre, logarithmic: for gains, of which only the ratio matters. ← → 2 %,
/// with Shift 0.2 %, with Ctrl 20 %; the wheel 2 % a click. Off while the value is 0.
class LogSlider : public QSlider {
    Q_OBJECT
public:
    explicit LogSlider(const ThemeSource &theme, QWidget *parent = nullptr);

    /// Where the tick stands and the sign comes from: the value before it is changed by hand.
    void setCentre(double centre);
    [[nodiscard]] double centre() const { return m_centre; }
    /// Shows a value without telling anybody.
    void showNumber(double number);
    [[nodiscard]] double number() const;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

Q_SIGNALS:
    /// By hand; many while dragging.
    void numberChosen(double number);
    /// Let go, or one key or click of the wheel is done.
    void choiceEnded();

protected:
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;

private:
    [[nodiscard]] double margin() const { return m_theme.theme().u(8); }
    [[nodiscard]] double xOf(int position) const;
    void moveTo(double x);
    void multiply(double factor);

    const ThemeSource &m_theme;
    double m_centre = 0.0;
};

} // namespace mb
