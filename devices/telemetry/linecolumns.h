// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "telemetry/linebreaks.h"
#include "telemetry/point.h"
#include "telemetry/sampletape.h"

#include <vector>

namespace mb {

/// Writes what a line through samples looks like on columns of one width: all samples of a column with four or fewer,
/// else the first, the least, the greatest and the last, in time order, and a gap where the line is broken between two
/// points. Tape and breaks stay as they are meanwhile.
class LineColumns {
public:
    LineColumns(const SampleTape &tape, const LineBreaks &breaks, Micros width, std::vector<Point> &out);

    /// A pixel rounded down to seven significant bits of whole microseconds.
    [[nodiscard]] static Micros widthOf(Micros from, Micros to, int pixels);
    /// Of the column that `time` falls in: a whole multiple of the width.
    [[nodiscard]] static Micros startOf(Micros time, Micros width);

    /// The columns of [start, stop), and the one sample before them when nothing has been written yet.
    void cover(Micros start, Micros stop);
    /// The one sample after what cover() covered last.
    void close();

private:
    void column(TapePosition from, TapePosition to);
    void add(TapePosition position);
    /// A point that the line goes on to, whatever lies between.
    void join(TapePosition position) { m_out.push_back(m_tape.pointAt(position)); }
    /// Positions come in order, so the search goes on where it was.
    [[nodiscard]] bool isBroken(TapePosition position);

    const SampleTape &m_tape;
    const LineBreaks &m_breaks;
    Micros m_width;
    std::vector<Point> &m_out;
    LineBreaks::Iterator m_break;
    TapePosition m_after = 0;
};

} // namespace mb
