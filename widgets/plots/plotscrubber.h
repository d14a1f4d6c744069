// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/plots/plotstack.h"

#include <QWidget>

namespace mb {

/// The whole session in one line under the plot, with a box around what is seen: drag it, or click, to scroll back;
/// the right end is the present. Looked at anew once a second, whatever the plot does.
class PlotScrubber : public QWidget {
    Q_OBJECT
public:
    PlotScrubber(const ThemeSource &theme, PlotStack &stack, QWidget *parent);

    /// What is drawn; nothing clears it. `first`: where the session begins.
    void setSource(std::shared_ptr<const TraceSource> source, const TraceLook &look);
    void setSession(double first, double now);
    /// Call it on a tick: repaints only when something to see has moved.
    void follow();

protected:
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    QSize sizeHint() const override;

private:
    [[nodiscard]] QRectF band() const;
    [[nodiscard]] double x(double key) const;
    [[nodiscard]] double keyOf(double x) const;
    [[nodiscard]] QRectF box() const;
    void showAround(double key);
    void drawEnvelope(QPainter &painter) const;
    void drawTimes(QPainter &painter) const;

    const ThemeSource &m_theme;
    PlotStack &m_stack;
    std::shared_ptr<const TraceSource> m_source;
    TraceLook m_look;
    double m_first = 0.0;
    double m_now = 1.0;
    double m_fetchedAt = -1e9;
    std::vector<PlotPoint> m_points;
    QRectF m_drawnBox;
    double m_grip = 0.0; ///< of the box, from its middle, in seconds
};

} // namespace mb
