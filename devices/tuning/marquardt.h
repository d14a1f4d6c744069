// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/leastsquares.h"

#include <algorithm>
#include <functional>
#include <vector>

namespace mb::tuning {

/// Nonlinear least squares with N unknowns by Levenberg and Marquardt; slopes by differences, so scale the unknowns to about 1.
template <std::size_t N> struct Marquardt {
    using Unknowns = std::array<double, N>;
    /// Fills in what is left over at these unknowns, always as many numbers.
    using Remainder = std::function<void(const Unknowns &, std::vector<double> &)>;

    struct Minimum {
        Unknowns values{};
        Unknowns errors{};    ///< two standard errors
        double squares = 0.0; ///< sum of what is left over
    };

    [[nodiscard]] static Minimum from(Unknowns start, const Remainder &remainder)
    {
        constexpr int mostRounds = 60;
        constexpr double enough = 1e-9; ///< relative gain of a round
        Marquardt at{remainder, start};
        double damping = 1e-2;
        for (int round = 0; round < mostRounds && damping < 1e10; ++round) {
            const auto step = at.solve(damping);
            if (!step)
                break;
            Unknowns next = at.m_values;
            for (std::size_t i = 0; i < N; ++i)
                next[i] += step->values[i];
            const double before = at.m_squares;
            if (!at.moveTo(next)) {
                damping *= 4.0;
                continue;
            }
            damping = std::max(damping / 3.0, 1e-9);
            if (before - at.m_squares < enough * before)
                break;
        }
        Minimum minimum{at.m_values, {}, at.m_squares};
        if (const auto last = at.solve(0.0))
            minimum.errors = last->errors;
        return minimum;
    }

private:
    using Solution = typename LeastSquares<N>::Solution;

    Marquardt(const Remainder &remainder, const Unknowns &start)
        : m_remainder(remainder)
        , m_values(start)
    {
        m_remainder(m_values, m_left);
        m_squares = squaresOf(m_left);
        differentiate();
    }
    [[nodiscard]] static double squaresOf(const std::vector<double> &left)
    {
        double sum = 0.0;
        for (const double value : left)
            sum += value * value;
        return sum;
    }
    void differentiate()
    {
        constexpr double width = 1e-5;
        std::vector<double> beside;
        for (std::size_t i = 0; i < N; ++i) {
            Unknowns values = m_values;
            values[i] += width;
            m_remainder(values, beside);
            m_slopes[i].resize(m_left.size());
            for (std::size_t k = 0; k < m_left.size(); ++k)
                m_slopes[i][k] = (beside[k] - m_left[k]) / width;
        }
    }
    [[nodiscard]] std::optional<Solution> solve(double damping) const
    {
        LeastSquares<N> squares;
        std::array<double, N> sizes{};
        for (std::size_t k = 0; k < m_left.size(); ++k) {
            std::array<double, N> row{};
            for (std::size_t i = 0; i < N; ++i) {
                row[i] = m_slopes[i][k];
                sizes[i] += row[i] * row[i];
            }
            squares.add(row, -m_left[k]);
        }
        for (std::size_t i = 0; damping > 0.0 && i < N; ++i) {
            std::array<double, N> row{};
            row[i] = std::sqrt(damping * std::max(sizes[i], 1e-30));
            squares.add(row, 0.0);
        }
        return squares.solve();
    }
    /// Whether it is better there.
    [[nodiscard]] bool moveTo(const Unknowns &values)
    {
        std::vector<double> left;
        m_remainder(values, left);
        const double squares = squaresOf(left);
        if (!(squares < m_squares))
            return false;
        m_values = values;
        m_left = std::move(left);
        m_squares = squares;
        differentiate();
        return true;
    }

    const Remainder &m_remainder;
    Unknowns m_values;
    std::vector<double> m_left{};
    std::array<std::vector<double>, N> m_slopes{};
    double m_squares = 0.0;
};

} // namespace mb::tuning
