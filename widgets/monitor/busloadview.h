// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/linkload.h"
#include "widgets/common/theme.h"

#include <QWidget>

#include <deque>

class QLabel;

namespace mb {

/// How full a bus was: one point each half second, the last minute.
class BusLoadView : public QWidget {
    Q_OBJECT
public:
    static constexpr std::size_t points = LinkLoads::points;

    explicit BusLoadView(const ThemeSource &theme, QWidget *parent = nullptr);
    /// Fractions 0 … 1, oldest first.
    void setLoads(const std::deque<double> &loads);
    [[nodiscard]] double peak() const;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    /// Percent at the left, seconds below.
    void paintScales(QPainter &painter, const QRectF &box) const;
    void paintLoad(QPainter &painter, const QRectF &box) const;
    [[nodiscard]] int top() const;

    const ThemeSource &m_theme;
    std::deque<double> m_loads;
};

} // namespace mb
