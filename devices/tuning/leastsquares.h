// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace mb::tuning {

/// Normal equations of a small linear fit with N unknowns, filled row by row.
template <std::size_t N> class LeastSquares {
public:
    using Row = std::array<double, N>;

    void add(const Row &row, double value)
    {
        for (std::size_t i = 0; i < N; ++i) {
            for (std::size_t k = 0; k < N; ++k)
                m_matrix[i][k] += row[i] * row[k];
            m_right[i] += row[i] * value;
        }
        m_squares += value * value;
        ++m_count;
    }

    struct Solution {
        Row values{};
        Row errors{};          ///< two standard errors, from what is left over
        double residual = 0.0; ///< sum of squares
    };

    /// Nothing where the rows do not tell the unknowns apart.
    [[nodiscard]] std::optional<Solution> solve() const
    {
        const auto inverse = inverted();
        if (!inverse)
            return std::nullopt;
        Solution solution;
        solution.residual = m_squares;
        for (std::size_t i = 0; i < N; ++i) {
            for (std::size_t k = 0; k < N; ++k)
                solution.values[i] += (*inverse)[i][k] * m_right[k];
            solution.residual -= solution.values[i] * m_right[i];
        }
        solution.residual = std::max(solution.residual, 0.0);
        const double freedom = m_count > N ? static_cast<double>(m_count - N) : 1.0;
        for (std::size_t i = 0; i < N; ++i)
            solution.errors[i] = 2.0 * std::sqrt(std::max((*inverse)[i][i], 0.0) * solution.residual / freedom);
        return solution;
    }

private:
    using Matrix = std::array<Row, N>;

    /// Gauss–Jordan, with the columns scaled to one size.
    [[nodiscard]] std::optional<Matrix> inverted() const
    {
        Row scale{};
        Matrix a = m_matrix;
        Matrix b{};
        for (std::size_t i = 0; i < N; ++i) {
            if (!(a[i][i] > 0.0))
                return std::nullopt;
            scale[i] = 1.0 / std::sqrt(a[i][i]);
            b[i][i] = 1.0;
        }
        for (std::size_t i = 0; i < N; ++i) {
            for (std::size_t k = 0; k < N; ++k)
                a[i][k] *= scale[i] * scale[k];
        }
        for (std::size_t column = 0; column < N; ++column) {
            std::size_t pivot = column;
            for (std::size_t row = column; row < N; ++row) {
                if (std::abs(a[row][column]) > std::abs(a[pivot][column]))
                    pivot = row;
            }
            if (std::abs(a[pivot][column]) < 1e-12)
                return std::nullopt;
            std::swap(a[pivot], a[column]);
            std::swap(b[pivot], b[column]);
            const double by = 1.0 / a[column][column];
            for (std::size_t k = 0; k < N; ++k) {
                a[column][k] *= by;
                b[column][k] *= by;
            }
            for (std::size_t row = 0; row < N; ++row) {
                const double factor = a[row][column];
                for (std::size_t k = 0; row != column && k < N; ++k) {
                    a[row][k] -= factor * a[column][k];
                    b[row][k] -= factor * b[column][k];
                }
            }
        }
        for (std::size_t i = 0; i < N; ++i) {
            for (std::size_t k = 0; k < N; ++k)
                b[i][k] *= scale[i] * scale[k];
        }
        return b;
    }

    Matrix m_matrix{};
    Row m_right{};
    double m_squares = 0.0;
    std::size_t m_count = 0;
};

} // namespace mb::tuning
