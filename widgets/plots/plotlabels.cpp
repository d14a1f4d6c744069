// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plotlabels.h"

#include "widgets/common/clamped.h"
#include "widgets/common/numberformat.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace mb {
namespace {

struct GapText {
    Q_DECLARE_TR_FUNCTIONS(GapText)
};

/// Gaps that share one label.
struct Cluster {
    double left = 0.0; ///< pixels
    double right = 0.0;
    double seconds = 0.0;
    int count = 0;
};

QString textOf(const Cluster &cluster)
{
    const QString length = formatDuration(cluster.seconds);
    return cluster.count == 1 ? GapText::tr("gap %1").arg(length)
                              : GapText::tr("%1 gaps, %2").arg(cluster.count).arg(length);
}

} // namespace

std::vector<GapLabel> gapLabels(
    const StripDecor &decor, const QCPAxis &keys, const QRectF &box, const QFontMetrics &metrics, const Theme &theme)
{
    const double air = theme.u(6);
    const double high = metrics.height() + theme.u(4);
    std::vector<GapLabel> labels;
    if (box.height() < metrics.height() * 2)
        return labels;
    std::vector<Cluster> clusters;
    for (const auto &[from, to] : decor.gaps) {
        const double left = std::max(keys.coordToPixel(from), box.left());
        const double right = std::min(keys.coordToPixel(to), box.right());
        if (right > left)
            clusters.push_back({left, right, to - from, 1});
    }
    std::ranges::sort(clusters, [](const Cluster &a, const Cluster &b) { return a.left < b.left; });
    const auto placed = [&](const Cluster &cluster) {
        const double wide = metrics.horizontalAdvance(textOf(cluster)) + theme.u(10);
        const bool inside = cluster.right - cluster.left >= wide;
        const double x = inside ? (cluster.left + cluster.right - wide) / 2 : cluster.right + air;
        return QRectF(x, box.bottom() - high - theme.u(8), wide, high);
    };
    std::vector<Cluster> merged;
    for (const Cluster &next : clusters) {
        if (!merged.empty() && placed(merged.back()).right() + air > placed(next).left()) {
            merged.back().right = std::max(merged.back().right, next.right);
            merged.back().seconds += next.seconds;
            ++merged.back().count;
        } else {
            merged.push_back(next);
        }
    }
    for (const Cluster &cluster : merged) {
        const QRectF place = placed(cluster);
        const bool inside = place.left() >= cluster.left && place.right() <= cluster.right;
        const bool clear = labels.empty() || place.left() > labels.back().place.right();
        if (clear && place.right() < box.right() && (inside || decor.first))
            labels.push_back({place, textOf(cluster)});
    }
    return labels;
}

std::optional<QRectF> freePlace(const QRectF &wanted, const QRectF &box, const std::vector<QRectF> &taken)
{
    const auto isFree = [&](const QRectF &place) {
        return place.top() >= box.top() && place.bottom() <= box.bottom()
            && std::ranges::none_of(taken, [&](const QRectF &other) { return other.intersects(place); });
    };
    for (const double lines : {0.0, 1.0, -1.0, 2.0, -2.0, 3.0, -3.0, 4.0, -4.0, 5.0, -5.0}) {
        const QRectF place = wanted.translated(0, lines * wanted.height());
        if (isFree(place))
            return place;
    }
    return std::nullopt;
}

namespace {

/// Places words one after the other; what was placed before stays.
class Placing {
public:
    Placing(const StripDecor &decor, const QCPAxisRect &rect, const QFont &caption, const Theme &theme)
        : m_decor(decor)
        , m_keys(*rect.axis(QCPAxis::atBottom))
        , m_left(*rect.axis(QCPAxis::atLeft))
        , m_right(*rect.axis(QCPAxis::atRight))
        , m_box(rect.rect())
        , m_theme(theme)
        , m_caption(caption)
        , m_metrics(caption)
        , m_rect(rect)
    {
        for (const GapLabel &gap : gapLabels(decor, m_keys, m_box, m_metrics, theme))
            m_taken.push_back(gap.place);
        for (const TracePlottable *curve : decor.curves)
            layOut(*curve, m_left);
    }
    std::vector<StripWord> words()
    {
        marks();
        limits();
        trigger();
        notes();
        bands();
        spans();
        return std::move(m_words);
    }

private:
    [[nodiscard]] QSizeF sizeOf(const QString &text) const
    {
        return {m_metrics.horizontalAdvance(text) + 2.0, static_cast<double>(m_metrics.height())};
    }
    [[nodiscard]] QRectF between(QRectF wanted) const
    {
        wanted.moveRight(std::min(wanted.right(), m_box.right() - 2));
        wanted.moveLeft(std::max(wanted.left(), m_box.left() + 2));
        return wanted;
    }
    void take(StripWord::Kind kind, std::size_t index, const std::optional<QRectF> &place)
    {
        if (!place)
            return;
        m_taken.push_back(*place);
        m_words.push_back({kind, index, *place});
    }
    /// What is drawn of a curve, as boxes of a pixel column or so.
    void layOut(const TracePlottable &curve, const QCPAxis &values)
    {
        const std::vector<PlotPoint> &points = curve.points();
        for (std::size_t i = 1; i < points.size(); ++i) {
            const PlotPoint &a = points[i - 1];
            const PlotPoint &b = points[i];
            const QRectF box(QPointF(m_keys.coordToPixel(a.key), values.coordToPixel(a.value)),
                QPointF(m_keys.coordToPixel(b.key), values.coordToPixel(b.value)));
            if (std::isfinite(box.top()) && std::isfinite(box.bottom()))
                m_drawn.push_back(box.normalized().adjusted(-2, -2, 2, 2));
        }
    }
    [[nodiscard]] auto covered(const QRectF &place) const
    {
        return std::ranges::count_if(m_drawn, [&](const QRectF &drawn) { return drawn.intersects(place); });
    }
    /// As freePlace(), and where it hides as little as can be of the curves; near what it names before far from it.
    [[nodiscard]] std::optional<QRectF> clearPlace(const QRectF &wanted, const std::vector<double> &shifts) const
    {
        std::optional<QRectF> best;
        double least = 0.0;
        for (const double shift : shifts) {
            for (int lines = -7; lines <= 7; ++lines) {
                const QRectF place = between(wanted.translated(shift, lines * wanted.height() * 0.75));
                const bool inside = place.top() >= m_box.top() && place.bottom() <= m_box.bottom();
                if (!inside || !freePlace(place, place, m_taken))
                    continue;
                const auto hidden = static_cast<double>(covered(place));
                const double far = QLineF(wanted.center(), place.center()).length() / (2.0 * wanted.height());
                const double cost = (hidden > 0.0 ? 2.5 + hidden * 0.05 : 0.0) + far;
                if (!best || cost < least) {
                    best = place;
                    least = cost;
                }
            }
        }
        return best;
    }
    [[nodiscard]] std::vector<QRectF> allCurves()
    {
        std::vector<QRectF> boxes;
        m_drawn.swap(boxes);
        for (const QCPAbstractPlottable *plottable : m_rect.plottables()) {
            const auto *curve = qobject_cast<const TracePlottable *>(plottable);
            if (curve && curve->realVisibility())
                layOut(*curve, *curve->valueAxis());
        }
        m_drawn.swap(boxes);
        return boxes;
    }
    /// Above or below a line, at its right end or at its left or between them: where no curve runs through the words.
    void beside(StripWord::Kind kind, std::size_t index, const QString &text, double y, bool rightFirst)
    {
        const QSizeF size = sizeOf(text);
        const double left = m_box.left() + m_theme.u(14);
        const double room = m_box.right() - m_theme.u(4) - size.width() - left;
        const std::vector<QRectF> curves = allCurves();
        std::optional<QRectF> best;
        double least = 0.0; // pixels of curves that are hidden: one long line may be many short pieces
        for (const double share : {0.0, 1.0, 0.25, 0.5, 0.75}) {
            for (const double top : {y - size.height() - 1, y + 1}) {
                const QRectF place(QPointF(left + (rightFirst ? 1.0 - share : share) * room, top), size);
                const bool inside = place.top() >= m_box.top() && place.bottom() <= m_box.bottom();
                if (!inside || !freePlace(place, place, m_taken))
                    continue;
                const double hidden
                    = std::accumulate(curves.begin(), curves.end(), 0.0, [&](double sum, const QRectF &curve) {
                          const QRectF common = curve.intersected(place);
                          return sum + common.width() * common.height();
                      });
                if (!best || hidden < least) {
                    best = place;
                    least = hidden;
                }
            }
        }
        take(kind, index, best);
    }
    void marks()
    {
        for (std::size_t i = 0; m_decor.first && i < m_decor.marks.size(); ++i) {
            const double x = m_keys.coordToPixel(m_decor.marks[i].key);
            if (x < m_box.left() || x > m_box.right())
                continue;
            const QSizeF size = sizeOf(m_decor.marks[i].text) + QSizeF(m_theme.u(8), m_theme.u(4));
            QRectF flag(QPointF(x, m_box.top() + m_theme.u(20)), size);
            if (flag.right() > m_box.right())
                flag.moveRight(x);
            take(StripWord::Kind::Mark, i, freePlace(flag, m_box, m_taken));
        }
    }
    void limits()
    {
        for (std::size_t i = 0; i < m_decor.limits.size(); ++i) {
            const double y = m_left.coordToPixel(m_decor.limits[i].value);
            if (y >= m_box.top() && y <= m_box.bottom())
                beside(StripWord::Kind::Limit, i, m_decor.limits[i].text, y, true);
        }
    }
    void trigger()
    {
        if (!m_decor.trigger)
            return;
        const double y = (m_decor.trigger->second ? m_right : m_left).coordToPixel(m_decor.trigger->level);
        beside(StripWord::Kind::Trigger, 0, m_decor.trigger->text, clamped(y, m_box.top(), m_box.bottom()), false);
    }
    void notes()
    {
        for (std::size_t i = 0; i < m_decor.notes.size(); ++i) {
            const PlotNote &note = m_decor.notes[i];
            const QPointF at(m_keys.coordToPixel(note.key), m_left.coordToPixel(note.value));
            if (at.x() < m_box.left() || at.x() > m_box.right())
                continue;
            QFont font = note.strong ? m_theme.font(TextRole::Emphasis, m_caption) : m_caption;
            font.setPointSizeF(m_caption.pointSizeF());
            const QSizeF size(QFontMetricsF(font).horizontalAdvance(note.text) + 2, m_metrics.height());
            QRectF text(at + QPointF(m_theme.u(note.offset.x()), m_theme.u(note.offset.y())), size);
            text = between(text);
            text.moveBottom(clamped(text.bottom(), m_box.top() + text.height(), m_box.bottom()));
            const double other = 2 * (at.x() - text.center().x()); // the same at the left of the point
            const double wide = text.width();
            take(StripWord::Kind::Note, i,
                m_drawn.empty()
                    ? freePlace(text, m_box, m_taken)
                    : clearPlace(text, {0.0, other, 0.5 * other, 0.4 * wide, 0.8 * wide, other - 0.4 * wide}));
        }
    }
    void bands()
    {
        for (std::size_t i = 0; i < m_decor.bands.size(); ++i) {
            QRectF text(QPointF(), sizeOf(m_decor.bands[i].text));
            text.moveBottomRight(
                {m_box.left() + m_box.width() * 0.62, m_left.coordToPixel(m_decor.bands[i].upper) - m_theme.u(2)});
            const double step = m_box.width() * 0.15;
            take(StripWord::Kind::Band, i,
                m_drawn.empty() ? freePlace(between(text), m_box, m_taken)
                                : clearPlace(text, {0.0, step, -step, 2 * step, -2 * step}));
        }
    }
    void spans()
    {
        for (std::size_t i = 0; i < m_decor.spans.size(); ++i) {
            const PlotSpan &span = m_decor.spans[i];
            const double from = m_keys.coordToPixel(span.from);
            if (span.text.isEmpty() || from > m_box.right() || m_keys.coordToPixel(span.to) < m_box.left())
                continue;
            QRectF text(QPointF(), sizeOf(span.text));
            text.moveBottomLeft({from + m_theme.u(4), m_box.bottom() - m_theme.u(4)});
            take(StripWord::Kind::Span, i, freePlace(between(text), m_box, m_taken));
        }
    }

    const StripDecor &m_decor;
    const QCPAxis &m_keys;
    const QCPAxis &m_left;
    const QCPAxis &m_right;
    const QRectF m_box;
    const Theme &m_theme;
    const QFont m_caption;
    const QFontMetrics m_metrics;
    const QCPAxisRect &m_rect;
    std::vector<QRectF> m_taken;
    std::vector<QRectF> m_drawn; ///< curves that words keep clear of
    std::vector<StripWord> m_words;
};

} // namespace

std::vector<StripWord> stripWords(
    const StripDecor &decor, const QCPAxisRect &rect, const QFont &caption, const Theme &theme)
{
    return Placing(decor, rect, caption, theme).words();
}

} // namespace mb
