// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>

namespace mb::quadquad2drv {

/// A literal as a template argument, so that "ch1.position.p" … "ch4.position.p" are made of one row.
template <std::size_t N> struct Literal {
    constexpr Literal(const char (&text)[N]) // NOLINT(google-explicit-constructor): a template argument converts
    {
        std::copy_n(text, N, data);
    }
    char data[N]{};
};

} // namespace mb::quadquad2drv
