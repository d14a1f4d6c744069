// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/plots/traceplottable.h"

namespace mb {

/// A horizontal line with words at its right end: "peak limit 60 A".
struct PlotLimit {
    double value = 0.0;
    QString text;
    TraceRole role = TraceRole::Neutral;
};

/// A horizontal band behind the traces: "±2 % band".
struct PlotBand {
    double lower = 0.0;
    double upper = 0.0;
    QString text;
    Tone tone = Tone::Ok;
};

/// A stretch of time behind the traces: "duty at limit, 107 ms".
struct PlotSpan {
    double from = 0.0;
    double to = 0.0;
    QString text;
    TraceRole role = TraceRole::Current;
};

/// Words at a point of a trace, with a thin leader: "B settles 286 ms". Offset in units of the theme.
struct PlotNote {
    double key = 0.0;
    double value = 0.0;
    QString text;
    QPointF offset{12, -12};
    bool strong = false;
};

/// A note of the user at a time, through all strips.
struct PlotMark {
    double key = 0.0;
    QString text;
};

/// The newest value of a trace at the right edge.
struct ValueTag {
    QString text;
    double value = 0.0;
    TraceLook look;
    bool second = false; ///< on the second axis
};

/// The level of a trigger in its strip, with a handle at the left end.
struct TriggerLine {
    double level = 0.0;
    QString text; ///< "trigger ↑ 20 A, 0.5 s before"
    bool second = false;
};

/// One entry of the line above a strip.
struct HeadEntry {
    QString name;
    TraceLook look;
};

/// Units of the theme that unit, title and legend of a strip take above it.
constexpr int headHeight = 20;

/// Everything of one strip that is not a trace. Filled by PlotStack, drawn by the two items below.
struct StripDecor {
    QString title;
    QString unit;
    QString secondUnit; ///< of the axis at the right; empty without one
    int secondRoom = 0; ///< pixels that the labels of that axis take in every strip
    int headGap = 0;    ///< pixels between the head and the strip
    QString keyUnit;    ///< "s" at the right end of a relative time axis, last strip only
    QString watermark;
    std::vector<HeadEntry> entries;
    std::vector<PlotLimit> limits;
    std::vector<PlotBand> bands;
    std::vector<PlotSpan> spans;
    std::vector<PlotNote> notes;
    std::vector<ValueTag> tags;
    std::vector<PlotMark> marks;
    std::optional<TriggerLine> trigger;
    std::vector<std::pair<double, double>> gaps;
    std::vector<const TracePlottable *> curves; ///< against the left scale, in notes' way; empty: they may cover them
    bool first = false; ///< of the stack: gaps are labelled here, beside them when they are too narrow

    /// All of one kind: PlotLimit, PlotBand, PlotSpan or PlotNote.
    template <typename Annotation> [[nodiscard]] std::vector<Annotation> &all()
    {
        if constexpr (std::is_same_v<Annotation, PlotLimit>)
            return limits;
        else if constexpr (std::is_same_v<Annotation, PlotBand>)
            return bands;
        else if constexpr (std::is_same_v<Annotation, PlotSpan>)
            return spans;
        else
            return notes;
    }
};

/// Words at a gap, where they have room.
struct GapLabel {
    QRectF place;
    QString text;
};
/// The labels of all gaps of a strip, at its foot. What would overlap becomes one label with the count and the sum.
[[nodiscard]] std::vector<GapLabel> gapLabels(
    const StripDecor &decor, const QCPAxis &keys, const QRectF &box, const QFontMetrics &metrics, const Theme &theme);
/// A place for words of this size near where they are wanted, inside `box` and clear of `taken`: there, or lines above or below.
/// Nothing where there is none: the words give way.
[[nodiscard]] std::optional<QRectF> freePlace(
    const QRectF &wanted, const QRectF &box, const std::vector<QRectF> &taken);

/// Words in a strip: those of `limits`, `bands` and so on, by their place in the list.
struct StripWord {
    enum class Kind { Mark, Limit, Trigger, Note, Band, Span };
    Kind kind = Kind::Limit;
    std::size_t index = 0;
    QRectF place;
};
/// Where each of them stands, so that none covers another or a gap's label: near what it names, else on another side of it or some
/// lines away. Those that have no place give way, the last kinds first.
[[nodiscard]] std::vector<StripWord> stripWords(
    const StripDecor &decor, const QCPAxisRect &rect, const QFont &caption, const Theme &theme);

/// Behind the traces: watermark, bands, spans, gaps.
class StripBackdrop : public QCPAbstractItem {
    Q_OBJECT
public:
    StripBackdrop(QCPAxisRect &rect, const ThemeSource &theme, const StripDecor &decor);
    double selectTest(const QPointF &, bool, QVariant * = nullptr) const override { return -1; }

protected:
    void draw(QCPPainter *painter) override;

private:
    void drawWatermark(QCPPainter &painter, const QRectF &box) const;
    void drawBands(QCPPainter &painter, const QRectF &box) const;
    void drawSpans(QCPPainter &painter, const QRectF &box) const;
    void drawGaps(QCPPainter &painter, const QRectF &box) const;

    QCPAxisRect &m_rect;
    const ThemeSource &m_theme;
    const StripDecor &m_decor;
};

/// In front of the traces and around the strip: unit, title, legend, limits, notes, value tags.
class StripFace : public QCPAbstractItem {
    Q_OBJECT
public:
    StripFace(QCPAxisRect &rect, const ThemeSource &theme, const StripDecor &decor);
    double selectTest(const QPointF &, bool, QVariant * = nullptr) const override { return -1; }
    /// Room that the tags need at the right, from their widest text.
    static int tagWidth(const Theme &theme, const QFont &body, const QString &widest);

protected:
    void draw(QCPPainter *painter) override;

private:
    void drawHead(QCPPainter &painter, const QRectF &box) const;
    void drawKeyUnit(QCPPainter &painter, const QRectF &box) const;
    void drawLimits(QCPPainter &painter, const QRectF &box) const;
    void drawTags(QCPPainter &painter, const QRectF &box) const;
    void drawMarks(QCPPainter &painter, const QRectF &box) const;
    void drawTrigger(QCPPainter &painter, const QRectF &box) const;
    void drawWords(QCPPainter &painter) const;
    void drawNote(QCPPainter &painter, const PlotNote &note, const QRectF &place) const;
    void drawFlag(QCPPainter &painter, const PlotMark &mark, const QRectF &place) const;
    QFont caption() const;

    QCPAxisRect &m_rect;
    const ThemeSource &m_theme;
    const StripDecor &m_decor;
};

/// The line under all strips: what time means at the left, rate and loss at the right.
class PlotFoot : public QCPLayoutElement {
    Q_OBJECT
public:
    PlotFoot(QCustomPlot &plot, const ThemeSource &theme);
    void setTexts(const QString &left, const QString &right, bool loss);
    QString left() const { return m_left; }
    QString right() const { return m_right; }
    QSize minimumOuterSizeHint() const override;
    QSize maximumOuterSizeHint() const override;

protected:
    void draw(QCPPainter *painter) override;

private:
    const ThemeSource &m_theme;
    QString m_left;
    QString m_right;
    bool m_loss = false;
};

/// Tick labels with a true minus and grouped thousands.
class NumberTicker : public QCPAxisTicker {
public:
    NumberTicker() { setTickCount(4); }

protected:
    /// Finer where a round step would leave fewer than two labels.
    double getTickStep(const QCPRange &range) override;
    QString getTickLabel(double tick, const QLocale &locale, QChar formatChar, int precision) override;
};

/// Time as seconds from an origin, or as the time of day when the Unix time of key 0 is known.
class TimeTicker : public QCPAxisTicker {
public:
    TimeTicker() { setTickCount(8); }
    void setClock(std::optional<double> unixAtZero) { m_unixAtZero = unixAtZero; }
    QString text(double key, double step) const;

protected:
    double getTickStep(const QCPRange &range) override;
    QString getTickLabel(double tick, const QLocale &locale, QChar formatChar, int precision) override;

private:
    std::optional<double> m_unixAtZero;
    double m_step = 1.0;
};

} // namespace mb
