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

/// Everything of one strip that is not a trace. Filled by PlotStack, drawn by StripBackdrop and StripFace.
struct StripDecor {
    QString title;
    QString unit;
    QString secondUnit;      ///< of the axis at the right; empty without one
    int secondAxisWidth = 0; ///< pixels that the labels of that axis take in every strip
    int headGap = 0;         ///< pixels between the head and the strip
    QString keyUnit;         ///< "s" at the right end of a time axis whose labels are seconds, last strip only
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

} // namespace mb
