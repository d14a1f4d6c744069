// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "telemetry/linecolumns.h"

#include <cstdint>
#include <vector>

namespace mb {

/// What History::columns() answered last, kept by a reader who asks again and again for a window that moves: only
/// columns that are new since, or not full yet, are computed. One for each trace of a picture.
class ColumnWindow {
public:
    [[nodiscard]] const std::vector<Point> &points() const { return m_points; }

    /// The columns of `width` that [from, to] falls in. `generation` says which recording the tape holds: it moves when
    /// that is cleared, and what was kept is forgotten.
    void show(const SampleTape &tape, const LineBreaks &breaks, std::uint64_t generation, Micros width, Micros from,
        Micros to);
    /// There is nothing to be seen.
    void showNothing();

private:
    /// Writes what is still right, with the columns before it, and yields from where on the answer has to be completed.
    [[nodiscard]] Micros reuse(LineColumns &columns, Micros start, Micros stop);

    std::vector<Point> m_points;
    std::vector<Point> m_before; ///< the answer before, while the new one is made
    const SampleTape *m_tape = nullptr;
    std::uint64_t m_generation = 0;
    Micros m_width = 0;
    Micros m_from = 0; ///< columns from here
    Micros m_to = 0;   ///< to here are there and will not change
};

} // namespace mb
