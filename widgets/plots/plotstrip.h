// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/noncopyable.h"
#include "widgets/plots/autorange.h"
#include "widgets/plots/plotdecor.h"
#include "widgets/plots/plotframe.h"
#include "widgets/plots/plottickers.h"

#include <QCoreApplication>
#include <array>

namespace mb {

struct StripStyle {
    QString title;
    double stretch = 1.0;
    bool legend = true; ///< names and swatches above the strip; without them and a title it has a low head
};

/// One strip of a stack of plots: an axis rectangle with two value axes, each of which follows its data or is fixed, and
/// what is drawn around the traces. The rectangle belongs to the plot. GUI thread.
class PlotStrip : NonCopyable {
    Q_DECLARE_TR_FUNCTIONS(PlotStrip)
public:
    using Range = std::pair<double, double>;

    /// All strips of a plot share margins and the labels of time.
    PlotStrip(
        PlotFrame &plot, QCPMarginGroup &margins, const QSharedPointer<TimeTicker> &time, const ThemeSource &theme);

    [[nodiscard]] QCPAxisRect &rect() const { return *m_rect; }
    [[nodiscard]] QCPAxis &keys() const { return *m_rect->axis(QCPAxis::atBottom); }
    [[nodiscard]] QCPAxis &axis(bool second) const
    {
        return *m_rect->axis(second ? QCPAxis::atRight : QCPAxis::atLeft);
    }

    /// In the colours of the theme. The last strip has the labels of time.
    void restyle(const QFont &font, bool last);
    /// Room at the right, in pixels.
    void setRightMargin(int pixels);

    /// Fixed, or following the data again.
    void fix(std::optional<Range> range);
    void zoom(double factor, double y);
    /// Both axes show what lies between two lines of pixels.
    void zoomInto(int bottom, int top);
    /// Follows the data again, from what is shown now.
    void release();
    /// Follows the data again, fitted at once.
    void fit();
    /// What is seen of the data, at `now`: true when the axis is another now.
    bool scale(bool second, std::optional<Range> seen, double now, double least);

    StripStyle style;
    StripDecor decor;

private:
    struct Scale {
        AutoRange automatic;
        std::optional<Range> fixed;
    };

    const ThemeSource &m_theme;
    QCPAxisRect *m_rect = nullptr;
    std::array<Scale, 2> m_scales; ///< left, right
};

} // namespace mb
