// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/trace.h"

#include <array>
#include <optional>
#include <vector>

namespace mb::tuning {

struct Line {
    double offset = 0.0;
    double slope = 0.0;
    [[nodiscard]] double at(double x) const { return offset + slope * x; }
};
/// Least squares; level through the mean where all x are equal.
[[nodiscard]] Line fitLine(const std::vector<double> &x, const std::vector<double> &y);

/// a + b·x + c·x²
struct Parabola {
    double a = 0.0;
    double b = 0.0;
    double c = 0.0;
};
/// Least squares through the samples of `trace` in [centre − half, centre + half] from number `begin` on, x = t − centre;
/// nothing for fewer than three of them.
[[nodiscard]] std::optional<Parabola> fitParabola(const Trace &trace, double centre, double half, std::size_t begin);

/// The same around centres that only grow: a sample comes once and goes once, however wide it is.
class MovingParabola {
public:
    /// The trace outlives it.
    MovingParabola(const Trace &trace, double half, std::size_t begin);
    [[nodiscard]] std::optional<Parabola> fit(double centre);
    /// How often it has looked at a sample.
    [[nodiscard]] std::size_t looks() const { return m_looks; }

private:
    void add(std::size_t from, std::size_t to, double sign);
    void shift(double by);

    const Trace &m_trace;
    const double m_half;
    double m_centre = 0.0;
    std::size_t m_from;
    std::size_t m_to;        ///< behind the last
    std::size_t m_moves = 0; ///< since the sums were made
    std::size_t m_looks = 0;
    std::array<double, 5> m_s{}; ///< Σ x^0 … Σ x^4, x in half widths
    std::array<double, 3> m_r{}; ///< Σ y x^0 … Σ y x^2
};

/// The values of a trace, those from number `begin` on by a local parabola of this half width; it never looks before `begin`.
[[nodiscard]] std::vector<double> smoothed(const Trace &trace, std::size_t begin, double half);
/// The top of the parabola around sample `at`, if it has one within reach that is no farther above the samples there than they lie apart.
[[nodiscard]] std::optional<double> vertexNear(const Trace &trace, std::size_t at, std::size_t begin, double reach);

} // namespace mb::tuning
