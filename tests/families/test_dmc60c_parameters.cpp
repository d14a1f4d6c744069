// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/channels.h"
#include "families/dmc60c/parameters.h"
#include "model/writeorder.h"

#include <gtest/gtest.h>

#include <set>

namespace mb::dmc60c {
namespace {

const Parameter &row(std::uint8_t id)
{
    const auto index = parameterWithId(id);
    EXPECT_TRUE(index) << int{id};
    return parameterTable()[index ? index->value : 0];
}

std::int64_t defaultRaw(const Parameter &p)
{
    return toRaw(p, p.fallback).value_or(-1);
}

TEST(Dmc60cParameters, AreThe55OfTheReferenceInOrder)
{
    ASSERT_EQ(parameterTable().size(), 55U);
    std::set<int> ids;
    const std::pair<int, int> blocks[] = {{1, 36}, {41, 45}, {51, 57}, {61, 64}, {91, 93}};
    for (const auto &[first, last] : blocks) {
        for (int id = first; id <= last; ++id)
            ids.insert(id);
    }
    std::vector<int> got;
    for (const Parameter &p : parameterTable())
        got.push_back(p.id);
    EXPECT_EQ(got, std::vector<int>(ids.begin(), ids.end()));
}

TEST(Dmc60cParameters, HaveTheReleasedKeys)
{
    const std::pair<std::uint8_t, std::string_view> keys[] = {{1, "limit.forward.switch.normally_closed"},
        {2, "limit.forward.switch.disabled"}, {3, "limit.reverse.switch.normally_closed"},
        {4, "limit.reverse.switch.disabled"}, {5, "limit.forward.soft.threshold"}, {6, "limit.forward.soft.enabled"},
        {7, "limit.reverse.soft.threshold"}, {8, "limit.reverse.soft.enabled"}, {9, "current.adc_multiplier"},
        {10, "slot0.p"}, {11, "slot0.i"}, {12, "slot0.d"}, {13, "slot0.i_zone"}, {14, "slot0.f"},
        {15, "slot0.allowable_error"}, {16, "slot0.ramp"}, {17, "slot0.max_forward"}, {18, "slot0.max_reverse"},
        {19, "slot0.nominal_forward"}, {20, "slot0.nominal_reverse"}, {21, "slot1.p"}, {22, "slot1.i"}, {23, "slot1.d"},
        {24, "slot1.i_zone"}, {25, "slot1.f"}, {26, "slot1.allowable_error"}, {27, "slot1.ramp"},
        {28, "slot1.max_forward"}, {29, "slot1.max_reverse"}, {30, "slot1.nominal_forward"},
        {31, "slot1.nominal_reverse"}, {32, "current_limit.p"}, {33, "current_limit.i"}, {34, "current_limit.d"},
        {35, "current_limit.i_zone"}, {36, "current_limit.f"}, {41, "encoder.position"}, {42, "encoder.clear_on_index"},
        {43, "encoder.clear_on_forward_limit"}, {44, "encoder.clear_on_reverse_limit"}, {45, "encoder.index_rising"},
        {51, "faults.active"}, {52, "faults.sticky"}, {53, "faults.over_current.count"},
        {54, "faults.over_temperature.count"}, {55, "faults.under_voltage.count"}, {56, "faults.gate_driver.count"},
        {57, "faults.communication.count"}, {61, "current_limit.continuous"}, {62, "current_limit.peak"},
        {63, "current_limit.peak_duration"}, {64, "current_limit.enabled"}, {91, "status.analog.period"},
        {92, "status.encoder.period"}, {93, "status.general.period"}};
    ASSERT_EQ(std::size(keys), parameterTable().size());
    for (const auto &[id, key] : keys)
        EXPECT_EQ(row(id).key, key);
}

TEST(Dmc60cParameters, HaveTheRawDefaultsOfTheDataSheet)
{
    const std::pair<std::uint8_t, std::uint32_t> defaults[] = {{9, 0x816}, {17, 0x7FFF}, {18, 0xFFFF8000}, {28, 0x7FFF},
        {29, 0xFFFF8000}, {32, 0x00640000}, {33, 0x003C0000}, {35, 0x014CC888}, {61, 0x00280000}, {62, 0x003C0000},
        {63, 0x1F4}, {91, 100}, {92, 100}, {93, 10}};
    std::set<std::uint16_t> listed;
    for (const auto &[id, raw] : defaults) {
        EXPECT_EQ(static_cast<std::uint32_t>(defaultRaw(row(id))), raw) << int{id};
        listed.insert(id);
    }
    for (const Parameter &p : parameterTable()) {
        if (!listed.contains(p.id)) {
            EXPECT_EQ(defaultRaw(p), 0) << p.key;
        }
    }
}

TEST(Dmc60cParameters, AreNarrowerThanTheWireWhereTheReferenceSaysSo)
{
    EXPECT_EQ(row(61).maximum, 100.0);
    EXPECT_EQ(row(62).minimum, 0.0);
    EXPECT_EQ(row(93).maximum, 50.0) << "followers stop without the general frame";
    EXPECT_EQ(row(91).maximum, 30000.0);
    EXPECT_EQ(row(91).minimum, 1.0);
    EXPECT_EQ(row(18).minimum, -32768.0);
    EXPECT_EQ(row(18).maximum, 0.0);
    EXPECT_EQ(row(17).maximum, 32767.0);
    EXPECT_FALSE(toRaw(row(93), 51));
    for (const double blind : {0.0, -1.0 / 65536.0, -0.0316})
        EXPECT_FALSE(toRaw(row(9), blind)) << "no current would be measured, and none limited";
    EXPECT_FALSE(isLegal(row(9), 0));
    EXPECT_EQ(toRaw(row(9), 1.0 / 65536.0), 1);
    EXPECT_FALSE(toRaw(row(17), 40000));
    EXPECT_EQ(*toRaw(row(10), 2147483647.0 / 65536.0), 2147483647);
}

TEST(Dmc60cParameters, KeepInFlashExactlyWhatTheReferenceSays)
{
    for (const Parameter &p : parameterTable()) {
        const bool keeps = !(p.id >= 41 && p.id <= 45) && p.id != 51 && p.id != 57 && p.id < 91;
        EXPECT_EQ(p.persistent, keeps) << p.key;
    }
}

TEST(Dmc60cParameters, MarkWhatMustNotBeTreatedLikeASetting)
{
    for (const Parameter &p : parameterTable()) {
        const Nature nature = p.id == 41 ? Nature::Live : p.id >= 52 && p.id <= 57 ? Nature::Counter : Nature::Setting;
        EXPECT_EQ(p.nature, nature) << p.key;
        EXPECT_EQ(p.access, p.id == 51 ? Access::ReadOnly : Access::ReadWrite) << p.key;
        EXPECT_FALSE(p.help.empty()) << p.key;
    }
}

TEST(Dmc60cParameters, AreIntegersWhereTheVendorsNamesSuggestFixedPoint)
{
    for (const int id : {13, 15, 16, 24, 26, 27, 35})
        EXPECT_EQ(typeName(row(static_cast<std::uint8_t>(id))), "integer") << id;
    for (const int id : {10, 11, 12, 14, 32, 61})
        EXPECT_EQ(typeName(row(static_cast<std::uint8_t>(id))), "number") << id;
}

TEST(Dmc60cParameters, HaveGainSlotsThatDifferOnlyByNumber)
{
    for (std::uint8_t id = 10; id <= 20; ++id) {
        const Parameter &a = row(id);
        const Parameter &b = row(static_cast<std::uint8_t>(id + 11));
        EXPECT_EQ(a.key.substr(6), b.key.substr(6));
        EXPECT_EQ(a.type, b.type);
        EXPECT_EQ(a.label, b.label);
        EXPECT_EQ(a.fallback, b.fallback);
        EXPECT_NE(a.group, b.group);
    }
}

TEST(Dmc60cParameters, DoNotFindNumbersOutsideTheTable)
{
    for (const int id : {0, 37, 40, 46, 50, 58, 65, 90, 94, 200, 255})
        EXPECT_FALSE(parameterWithId(static_cast<std::uint8_t>(id))) << id;
}

TEST(Dmc60cChannels, AreThoseOfTheProduct)
{
    std::vector<std::pair<std::string_view, std::string_view>> got;
    for (const Channel &c : channelTable())
        got.emplace_back(c.key, c.unit);
    const std::vector<std::pair<std::string_view, std::string_view>> expected{{"position", "counts"},
        {"velocity", "counts/s"}, {"current", "A"}, {"duty", "fraction"}, {"setpoint", ""}, {"error", ""},
        {"bus_voltage", "V"}, {"temperature", "°C"}, {"analog1", "V"}};
    EXPECT_EQ(got, expected);
}

TEST(Dmc60cParameters, ASoftLimitIsWidenedTowardsItsEndWhateverItsSign)
{
    const auto widens = [](std::uint8_t id, std::int64_t from, std::int64_t to) {
        return widensLimit(row(id), {*parameterWithId(id), from, to});
    };
    EXPECT_TRUE(widens(7, 5000, -3000)) << "reverse";
    EXPECT_FALSE(widens(7, -3000, 5000));
    EXPECT_TRUE(widens(5, -5000, 3000)) << "forward";
    EXPECT_FALSE(widens(5, 3000, -5000));
    EXPECT_TRUE(widens(18, -1000, -2000)) << "the greatest reverse duty is an amount";
}

} // namespace
} // namespace mb::dmc60c
