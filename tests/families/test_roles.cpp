// SPDX-License-Identifier: GPL-3.0-or-later
// Every family says what the parameters of its loops are: nobody outside of it knows one by its key.
#include "model/family.h"
#include "model/loopparameters.h"
#include "model/registry.h"
#include "model/writeorder.h"

#include <gtest/gtest.h>

#include <set>

namespace mb {
namespace {

void expectRoles(const Family &family, const LoopGains &loop, int axis, int slot)
{
    const auto rows = loopParameters(family, loop, axis, slot);
    EXPECT_EQ(rows.size(), loop.names.size()) << family.key << ", " << loop.prefix;
    std::set<Role> roles;
    for (const ParameterIndex index : rows) {
        const Parameter &parameter = family.parameters[index.value];
        EXPECT_NE(parameter.role, Role::None) << parameter.key;
        EXPECT_TRUE(isLimit(parameter) || roles.insert(parameter.role).second) << parameter.key << " is twofold";
        EXPECT_EQ(roleOf(family, parameter.key), parameter.role);
        EXPECT_EQ(parameterOf(family, loop.mode, axis, slot, parameter.role).has_value(), true) << parameter.key;
    }
    EXPECT_TRUE(roles.contains(Role::Proportional)) << family.key << ", " << loop.prefix;
}

TEST(Roles, EveryLoopIsMadeOfParametersThatSayWhatTheyAre)
{
    for (const Family *family : families()) {
        const Capabilities &can = family->capabilities;
        for (const LoopGains &loop : family->trials ? family->trials->loops : std::span<const LoopGains>()) {
            for (int place = 0; place < can.axes * can.gainSlots; ++place)
                expectRoles(*family, loop, 1 + place % can.axes, place / can.axes);
        }
    }
}

TEST(Roles, OnlyTheSwitchOfALimitAndAPlaceThatBoundsAreInverted)
{
    for (const Family *family : families()) {
        for (const Parameter &parameter : family->parameters)
            EXPECT_TRUE(!parameter.inverted
                || (isLimit(parameter) && (parameter.type == WireType::Boolean || boundsPlace(parameter))))
                << parameter.key;
    }
}

TEST(Roles, WhatNobodyCallsByThisKeyHasNone)
{
    for (const Family *family : families()) {
        EXPECT_EQ(roleOf(*family, "no.such"), Role::None);
        EXPECT_FALSE(parameterOf(*family, Mode::Off, 1, 0, Role::Proportional)) << family->key;
        EXPECT_FALSE(parameterOfAxis(*family, 9, Role::Limit)) << family->key;
    }
}

TEST(DemoUnits, AreThoseThatAFamilyNamesAndNoneWhereItNamesNone)
{
    for (const Family *family : families()) {
        for (const auto unit :
            {&DemoUnits::tuned, &DemoUnits::overshooting, &DemoUnits::inBootloader, &DemoUnits::stoppingShort}) {
            const int named = family->demo ? family->demo->*unit : 0;
            EXPECT_FALSE(isDemoUnit(*family, 0, unit)) << family->key << ": 0 is what is not named";
            EXPECT_EQ(isDemoUnit(*family, named, unit), named != 0) << family->key << ' ' << named;
            EXPECT_FALSE(isDemoUnit(*family, named + 1, unit)) << family->key;
        }
    }
}

} // namespace
} // namespace mb
