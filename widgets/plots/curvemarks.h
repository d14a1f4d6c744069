// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"
#include "widgets/plots/qcustomplotkeywords.h"

#include <vector>

namespace mb {

/// Something that stands in a plot beside its curves, in the values of its axes.
struct CurveMark {
    enum class Kind {
        Band,    ///< from `y` to `to`, over the whole width
        Beyond,  ///< hatched from `x` to the right edge, with a line at `x`
        Upright, ///< a dotted line at `x`
        Level,   ///< a dashed line at `y`
        Span,    ///< a thick line at `x` from `y` to `to`
        Ring,    ///< at a point
        Words    ///< beside a point, inside the plot and clear of other words
    };
    Kind kind = Kind::Words;
    double x = 0.0;
    double y = 0.0;
    double to = 0.0;
    QString text{};
    Qt::Alignment side = Qt::AlignRight | Qt::AlignTop; ///< of the point, where its words stand
    bool strong = false;
    Tone tone = Tone::Text;
};

/// The marks of one plot, as items that follow its axes. GUI thread; the plot owns it.
class CurveMarks : public QObject {
    Q_OBJECT
public:
    CurveMarks(QCustomPlot &plot, const ThemeSource &theme);

    /// In place of those before, in the colours of now.
    void set(std::vector<CurveMark> marks, const QFont &body);
    [[nodiscard]] const std::vector<CurveMark> &marks() const { return m_marks; }

private:
    void add(const CurveMark &mark);
    void addLine(const CurveMark &mark, const QPen &pen);
    void addWords(const CurveMark &mark);
    void arrange();

    QCustomPlot &m_plot;
    const ThemeSource &m_theme;
    QFont m_body;
    std::vector<CurveMark> m_marks;
    std::vector<QCPAbstractItem *> m_items;
    std::vector<std::pair<CurveMark, QCPItemText *>> m_words;
};

} // namespace mb
