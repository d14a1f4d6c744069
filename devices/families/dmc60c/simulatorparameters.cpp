// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/simulatorparameters.h"

#include <algorithm>

namespace mb::dmc60c::simulation {
namespace {

constexpr std::int64_t least = -2147483648LL;
constexpr std::int64_t most = 2147483647LL;
constexpr std::uint32_t rawReverse = 0xFFFF8000U;

constexpr Row flag(std::uint8_t id, bool persistent = true)
{
    return {id, Rule::Unsigned, persistent, 0, 1, 0};
}
constexpr Row any(std::uint8_t id, std::uint32_t fallback = 0, bool persistent = true)
{
    return {id, Rule::Signed, persistent, least, most, fallback};
}
constexpr Row ranged(std::uint8_t id, std::int64_t low, std::int64_t high, std::uint32_t fallback)
{
    return {id, Rule::Signed, true, low, high, fallback};
}
constexpr Row counter(std::uint8_t id, bool persistent)
{
    return {id, Rule::Counter, persistent, 0, 0, 0};
}
constexpr Row period(std::uint8_t id, std::int64_t high, std::uint32_t fallback)
{
    return {id, Rule::Unsigned, false, 1, high, fallback};
}

constexpr std::array table{
    flag(1),
    flag(2),
    flag(3),
    flag(4),
    any(5),
    flag(6),
    any(7),
    flag(8),
    any(9, 0x816),
    any(10),
    any(11),
    any(12),
    ranged(13, 0, most, 0),
    any(14),
    ranged(15, 0, most, 0),
    ranged(16, 0, most, 0),
    ranged(17, 0, 32767, 0x7FFF),
    ranged(18, -32768, 0, rawReverse),
    ranged(19, 0, 32767, 0),
    ranged(20, -32768, 0, 0),
    any(21),
    any(22),
    any(23),
    ranged(24, 0, most, 0),
    any(25),
    ranged(26, 0, most, 0),
    ranged(27, 0, most, 0),
    ranged(28, 0, 32767, 0x7FFF),
    ranged(29, -32768, 0, rawReverse),
    ranged(30, 0, 32767, 0),
    ranged(31, -32768, 0, 0),
    any(32, 0x640000),
    any(33, 0x3C0000),
    any(34),
    ranged(35, 0, most, 0x14CC888),
    any(36),
    any(41, 0, false),
    flag(42, false),
    flag(43, false),
    flag(44, false),
    flag(45, false),
    Row{51, Rule::ReadOnly, false, 0, 0, 0},
    counter(52, true),
    counter(53, true),
    counter(54, true),
    counter(55, true),
    counter(56, true),
    counter(57, false),
    any(61, 0x280000),
    any(62, 0x3C0000),
    Row{63, Rule::Unsigned, true, 0, 65535, 500},
    flag(64),
    period(91, 30000, 100),
    period(92, 30000, 100),
    period(93, 50, 10),
};
static_assert(table.size() == 55);

} // namespace

std::span<const Row> rows()
{
    return table;
}

const Row *findRow(std::uint8_t id)
{
    const auto row = std::ranges::find(table, id, &Row::id);
    return row == table.end() ? nullptr : &*row;
}

ParameterBank::ParameterBank()
{
    for (const Row &row : table)
        m_raw[row.id] = row.fallback;
}

void ParameterBank::forgetVolatile()
{
    for (const Row &row : table) {
        if (!row.persistent)
            m_raw[row.id] = row.fallback;
    }
}

} // namespace mb::dmc60c::simulation
