// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/table.h"

#include "app/console/output.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace mb::console {
namespace {

/// Characters, not bytes: units have ° and ².
std::size_t widthOf(const std::string &text)
{
    return static_cast<std::size_t>(
        std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

} // namespace

std::string brief(double value)
{
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.4g", value);
    return text.data();
}

Table::Table(std::vector<std::string> header)
    : m_widths(header.size(), 0)
{
    add(std::move(header));
}

void Table::add(std::vector<std::string> cells)
{
    cells.resize(m_widths.size());
    for (std::size_t i = 0; i < cells.size(); ++i) {
        cells[i] = onOneLine(cells[i]);
        if (cells[i].empty())
            cells[i].assign(1, '-');
        m_widths[i] = std::max(m_widths[i], widthOf(cells[i]));
    }
    m_rows.push_back(std::move(cells));
}

void Table::print(Output &out) const
{
    for (const auto &cells : m_rows) {
        std::string line;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            line += cells[i];
            if (i + 1 < cells.size())
                line.append(m_widths[i] - widthOf(cells[i]) + 2, ' ');
        }
        out.line(line);
    }
}

} // namespace mb::console
