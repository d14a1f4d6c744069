// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace mb::console {

class Output;

/// Four significant digits.
[[nodiscard]] std::string brief(double value);

/// Columns for people: as wide as their longest cell, two blanks apart. Empty cells show a dash.
class Table {
public:
    explicit Table(std::vector<std::string> header);
    void add(std::vector<std::string> cells);
    void print(Output &out) const;

private:
    std::vector<std::vector<std::string>> m_rows;
    std::vector<std::size_t> m_widths;
};

} // namespace mb::console
