// SPDX-License-Identifier: GPL-3.0-or-later
// Between two writes of a batch a drive is never livelier than both before and after it.
#include "model/family.h"
#include "model/writeorder.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

namespace mb {
namespace {

Parameter orderedRow(
    const char *key, Role role, WireType type = WireType::Int32, Nature nature = Nature::Setting, double minimum = 0.0)
{
    Parameter p;
    p.key = key;
    p.role = role;
    p.type = type;
    p.nature = nature;
    p.minimum = minimum;
    p.maximum = 1000.0;
    return p;
}

enum Row : std::uint16_t { Threshold, Enabled, SwitchOff, P, I, D, Name, Position, Highest, Lowest, Steepest, Rows };

const std::array<Parameter, Rows> table{orderedRow("limit.current", Role::Limit),
    orderedRow("limit.enabled", Role::Limit, WireType::Boolean),
    inverted(orderedRow("limit.forward", Role::Limit, WireType::Boolean)), orderedRow("velocity.p", Role::Proportional),
    orderedRow("velocity.i", Role::Integral), orderedRow("velocity.d", Role::Derivative),
    orderedRow("input.period", Role::None), orderedRow("position", Role::None, WireType::Int32, Nature::Live),
    orderedRow("limit.highest", Role::Limit, WireType::Int32, Nature::Setting, -1000.0),
    inverted(orderedRow("limit.lowest", Role::Limit, WireType::Int32, Nature::Setting, -1000.0)),
    noneAtZero(orderedRow("limit.acceleration", Role::Limit))};

/// The more of it, the livelier; what does not matter is 0.
std::int64_t lively(std::uint16_t index, std::int64_t raw)
{
    switch (index) {
    case Threshold:
    case SwitchOff:
    case P:
    case I: return std::abs(raw);
    case Steepest: return raw == 0 ? 1000 : std::abs(raw);
    case Highest: return raw;
    case Lowest:
    case Enabled: return -raw;
    case D: return -std::abs(raw);
    default: return 0;
    }
}

using State = std::array<std::int64_t, Rows>;

bool isNoLivelier(const State &state, const State &than)
{
    for (std::uint16_t i = 0; i < Rows; ++i) {
        if (lively(i, state.at(i)) > lively(i, than.at(i)))
            return false;
    }
    return true;
}

std::string textOf(const std::vector<ParameterChange> &changes)
{
    std::string text;
    for (const ParameterChange &change : changes)
        text += std::string(table.at(change.index.value).key) + "=" + std::to_string(change.raw) + " ";
    return text;
}

State anyState(std::mt19937 &random)
{
    State state{};
    for (std::uint16_t i = 0; i < Rows; ++i) {
        const bool isSwitch = table.at(i).type == WireType::Boolean;
        state.at(i) = std::uniform_int_distribution<std::int64_t>(isSwitch ? 0 : -9, isSwitch ? 1 : 9)(random);
    }
    return state;
}

TEST(WriteOrder, IsNeverLivelierInBetweenThanBothEnds)
{
    Family family{};
    family.parameters = table;
    std::mt19937 random(7);
    for (int round = 0; round < 2000; ++round) {
        const State before = anyState(random);
        const State after = anyState(random);
        ParameterStore known(table);
        std::vector<ParameterChange> changes;
        for (std::uint16_t i = 0; i < Rows; ++i) {
            known.setRead({i}, before.at(i));
            if (before.at(i) != after.at(i))
                changes.push_back({{i}, after.at(i)});
        }
        std::shuffle(changes.begin(), changes.end(), random);
        arrangeForWriting(family, known, changes);
        State state = before;
        for (const ParameterChange &change : changes) {
            state.at(change.index.value) = change.raw;
            EXPECT_TRUE(isNoLivelier(state, before) || isNoLivelier(state, after))
                << "at " << table.at(change.index.value).key << " of " << textOf(changes);
        }
        EXPECT_EQ(state, after);
    }
}

TEST(WriteOrder, ALimitIsWidenedByWhatLetsTheMotorDoMore)
{
    const auto widens = [](Row which, std::optional<std::int64_t> from, std::int64_t to) {
        StagedChange change;
        change.index = ParameterIndex{which};
        change.from = from;
        change.to = to;
        return widensLimit(table[which], change);
    };
    EXPECT_TRUE(widens(Threshold, 5, 6));
    EXPECT_TRUE(widens(Threshold, 5, -6)) << "it is the amount that counts";
    EXPECT_FALSE(widens(Threshold, 5, 5));
    EXPECT_FALSE(widens(Threshold, 5, 4));
    EXPECT_FALSE(widens(Threshold, 5, -5));
    EXPECT_FALSE(widens(Threshold, std::nullopt, 6)) << "nobody knows";
    EXPECT_TRUE(widens(Enabled, 1, 0));
    EXPECT_FALSE(widens(Enabled, 0, 1));
    EXPECT_FALSE(widens(Enabled, 0, 0));
    EXPECT_FALSE(widens(Enabled, std::nullopt, 0));
    EXPECT_TRUE(widens(SwitchOff, 0, 1));
    EXPECT_FALSE(widens(SwitchOff, 1, 0));
    EXPECT_FALSE(widens(P, 1, 2)) << "no limit";
    EXPECT_TRUE(widens(Highest, -500, 300)) << "where it is counts, not the amount";
    EXPECT_FALSE(widens(Highest, 300, -500));
    EXPECT_TRUE(widens(Lowest, 500, -300));
    EXPECT_FALSE(widens(Lowest, -300, 500));
    EXPECT_TRUE(widens(Steepest, 5, 6));
    EXPECT_FALSE(widens(Steepest, 5, 4));
    EXPECT_TRUE(widens(Steepest, 5, 0)) << "0 is no limit";
    EXPECT_FALSE(widens(Steepest, 0, 900)) << "a limit where there was none";
    EXPECT_FALSE(widens(Steepest, std::nullopt, 0)) << "nobody knows";
}

TEST(WriteOrder, ALimitThatGoesIsAmongTheLastAlsoWhereNobodyKnowsWhatWas)
{
    EXPECT_EQ(writeRank(table[Steepest], {{Steepest}, std::nullopt, 0}), 5);
    EXPECT_EQ(writeRank(table[Steepest], {{Steepest}, std::nullopt, 7}), 0);
}

TEST(WriteOrder, EveryKindOfChangeHasItsPlaceBetweenTheOthers)
{
    const auto rank = [](Row which, std::optional<std::int64_t> from, std::int64_t to) {
        return writeRank(table[which], {{which}, from, to});
    };
    EXPECT_EQ(rank(Threshold, 5, 4), 0);
    EXPECT_EQ(rank(Enabled, 0, 1), 1);
    EXPECT_EQ(rank(I, 5, 4), 2);
    EXPECT_EQ(rank(P, 5, 4), 3);
    EXPECT_EQ(rank(D, 4, 5), 4);
    EXPECT_EQ(rank(Threshold, 4, 5), 5);
    EXPECT_EQ(rank(Enabled, 1, 0), 6);
    EXPECT_EQ(rank(Name, 4, 5), 7);
    EXPECT_EQ(rank(D, 5, 4), 8);
    EXPECT_EQ(rank(P, 4, 5), 9);
    EXPECT_EQ(rank(I, 4, 5), 10);
    EXPECT_EQ(rank(Position, 4, 5), 11);
    EXPECT_EQ(rank(P, std::nullopt, 1), 9) << "it may be more";
    EXPECT_EQ(rank(P, -5, 4), 3) << "the amount counts";
}

TEST(WriteOrder, SetsLimitsBeforeGainsWhereNothingIsKnown)
{
    Family family{};
    family.parameters = table;
    const ParameterStore known(table);
    std::vector<ParameterChange> changes{{{Position}, 5}, {{I}, 1}, {{P}, 2}, {{Name}, 3}, {{Threshold}, 4}};
    arrangeForWriting(family, known, changes);
    EXPECT_EQ(textOf(changes), "limit.current=4 input.period=3 velocity.p=2 velocity.i=1 position=5 ");
}

TEST(WriteOrder, IsThatOfTheFamilyWhereItHasOne)
{
    Family family{};
    family.parameters = table;
    family.arrange = [](const ParameterStore &, std::vector<ParameterChange> &changes) {
        std::reverse(changes.begin(), changes.end());
    };
    std::vector<ParameterChange> changes{{{P}, 2}, {{Name}, 3}, {{I}, 4}};
    arrangeForWriting(family, ParameterStore(table), changes);
    EXPECT_EQ(textOf(changes), "velocity.i=4 input.period=3 velocity.p=2 ");
}

} // namespace
} // namespace mb
