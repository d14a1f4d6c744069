// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include <QBasicTimer>
#include <QWidget>
#include <deque>
#include <optional>
#include <utility>

namespace mb {

/// The last seconds of one value as a small filled line; at most 240 points, repainted at most ten times a second.
/// NaN is a gap. Costs nothing while hidden.
class Sparkline : public QWidget {
    Q_OBJECT
public:
    Sparkline(const ThemeSource &theme, TraceRole role, QWidget *parent = nullptr);

    /// How many points the whole width holds (2 … 240). Fewer points leave room at the left.
    void setCapacity(int points);
    void setValues(std::deque<double> values);
    /// What it shows is another quantity now.
    void setRole(TraceRole role);
    /// Smallest and largest value shown, for the caption "1 198 … 1 570 rpm".
    std::optional<std::pair<double, double>> range() const;
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;
    void timerEvent(QTimerEvent *event) override;

private:
    void touched();
    void paintRun(QPainter &painter, const QPolygonF &run, bool filled) const;

    const ThemeSource &m_theme;
    TraceRole m_role;
    std::deque<double> m_values;
    std::size_t m_capacity = 100;
    bool m_dirty = false;
    QBasicTimer m_tick;
};

} // namespace mb
