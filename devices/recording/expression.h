// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mb {

/// A formula over signals, such as `d5_velocity - d7_velocity` or `average(derivative(d5_position), 0.1)`. The operators
/// and functions are those of muParser (+ − * / ^, comparisons, ?:, sin … abs, min, max, sqrt, exp, ln), besides:
///   derivative(x)        change of x a second, from one sample to the next
///   integral(x)          trapezoids, 0 at the beginning and after each gap
///   average(x, seconds)  moving average over the last so many seconds
/// Evaluated sample by sample in order of time; it remembers what these three need.
class Expression {
public:
    /// `names`: the signals that may be used. OutOfRange with the place and the cause when the text makes no sense.
    [[nodiscard]] static Result<Expression> parse(std::string_view text, const std::vector<std::string> &names);
    Expression(Expression &&other) noexcept;
    Expression &operator=(Expression &&other) noexcept;
    ~Expression();

    /// Which of the names are used, in the order of the list, each once.
    [[nodiscard]] const std::vector<std::size_t> &used() const;
    /// `values` are those of used(), in its order. Not a number where one is missing, where a derivative has no sample
    /// before it, and where the formula has no value (1/0).
    [[nodiscard]] double evaluate(double seconds, std::span<const double> values);
    /// After a gap: derivatives, integrals and averages begin anew.
    void restart();

private:
    struct Formula;
    struct Compiler;
    explicit Expression(std::unique_ptr<Formula> formula);
    std::unique_ptr<Formula> m_formula;
};

} // namespace mb
