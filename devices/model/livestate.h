// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace mb {

/// Position in the state table of a family; never mixed with a channel or a parameter.
struct StateIndex {
    std::uint16_t value = 0;
    friend auto operator<=>(const StateIndex &, const StateIndex &) = default;
};

enum class StateKind : std::uint8_t {
    Condition, ///< its user should know while it is on: a limit that holds
    Switch,    ///< a condition too: a limit switch that holds
    Rest,      ///< a condition too, and how a motor is while nobody drives it: a halt. No news to who drives it
    Input,     ///< the level of a pin; may change with every frame
};

/// One row of Family::states: what its devices tell of themselves that is either so or not, besides faults
/// (Liveness::faults). The most important come first. All texts are English literals, marked for translation ("table").
struct StateRow {
    std::string_view key;    ///< stable: limit.forward.switch, halted, input.encoder.a; of an axis: "ch1.input"
    std::string_view label;  ///< what it is: "Forward limit switch"
    std::string_view clause; ///< what is so while it is on: "forward limit switch holds"; empty for an input
    StateKind kind = StateKind::Condition;
};

[[nodiscard]] constexpr std::optional<StateIndex> findState(std::span<const StateRow> table, std::string_view key)
{
    for (std::size_t i = 0; i < table.size(); ++i) {
        if (table[i].key == key)
            return StateIndex{static_cast<std::uint16_t>(i)};
    }
    return std::nullopt;
}

/// What a device tells now, for each row of its family's table: true, false, or nothing while it has not said. A value of two
/// words.
class LiveStates {
public:
    static constexpr std::size_t most = 32;

    [[nodiscard]] constexpr std::optional<bool> operator[](StateIndex index) const
    {
        const std::uint32_t bit = 1U << index.value;
        return (m_known & bit) == 0U ? std::nullopt : std::optional<bool>((m_on & bit) != 0U);
    }
    constexpr void set(StateIndex index, bool on)
    {
        const std::uint32_t bit = 1U << index.value;
        m_known |= bit;
        m_on = on ? m_on | bit : m_on & ~bit;
    }
    constexpr void forget(StateIndex index)
    {
        m_known &= ~(1U << index.value);
        m_on &= m_known;
    }
    [[nodiscard]] constexpr bool isOn(StateIndex index) const { return (*this)[index].value_or(false); }

    friend constexpr bool operator==(const LiveStates &, const LiveStates &) = default;

private:
    std::uint32_t m_known = 0;
    std::uint32_t m_on = 0;
};

/// Every row has a label and a key of its own, a condition its clause, and no condition comes behind an input.
template <std::size_t N> consteval bool checkStates(const std::array<StateRow, N> &table)
{
    for (std::size_t i = 0; i < N; ++i) {
        const bool input = table[i].kind == StateKind::Input;
        if (table[i].key.empty() || table[i].label.empty() || table[i].clause.empty() != input)
            return false;
        if (findState(table, table[i].key)->value != i)
            return false;
        if (i > 0 && !input && table[i - 1].kind == StateKind::Input)
            return false;
    }
    return N <= LiveStates::most;
}

/// Rows of conditions that are on, most important first.
[[nodiscard]] std::vector<const StateRow *> conditionsOf(std::span<const StateRow> table, const LiveStates &states);

} // namespace mb
