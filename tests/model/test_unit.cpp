// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/virtualclock.h"
#include "model/unit.h"
#include "support/loosemotor.h"

namespace mb {
namespace {

Identity nodeFour(const std::string &serial = {})
{
    Identity identity;
    identity.family = "supermodified";
    identity.address = 4;
    identity.serial = serial;
    return identity;
}

std::string keyOn(const char *link, const std::string &serial = {})
{
    return unitKeyOf(nodeFour(serial), *LinkAddress::parse(link));
}

TEST(UnitKeys, ArePlacesWhereNoSerialNumberTellsUnitsApartWhateverTheOptionsOfTheLinkAre)
{
    const std::string key = keyOn("serial:/dev/null");
    EXPECT_EQ(unitByOf(key), UnitBy::Place);
    EXPECT_EQ(keyOn("serial:/dev/null?baud=57600&rs485=1"), key);
    EXPECT_NE(keyOn("serial:/dev/zero"), key);
    EXPECT_TRUE(unitSerialIn(key).empty());
    EXPECT_EQ(unitCaveatOf(UnitBy::Place), "this place, not this unit");
}

TEST(UnitKeys, AreTheSerialNumberOnAnyLinkAndSimulatedOnesApart)
{
    const std::string key = keyOn("serial:/dev/null", "A7");
    EXPECT_EQ(key, "supermodified A7");
    EXPECT_EQ(keyOn("serial:/dev/zero", "A7"), key);
    EXPECT_EQ(unitByOf(key), UnitBy::Serial);
    EXPECT_EQ(unitSerialIn(key), "A7");
    const std::string simulated = keyOn("sim:serial", "A7");
    EXPECT_EQ(simulated, "simulated " + key);
    EXPECT_TRUE(isSimulatedUnit(simulated));
    EXPECT_FALSE(isSimulatedUnit(key));
    EXPECT_EQ(unitSerialIn(simulated), "A7");
}

TEST(UnitKeys, OfADeviceAreThoseOfTheLineThatItWasFoundOnWhateverHasItsNameNow)
{
    VirtualClock clock;
    test::LoggedLink link(clock, {Outlet::Form::CanSocket, 7});
    std::string place = "usb-1.2";
    int looks = 0;
    link.settings().identify = [&](const LinkAddress &) {
        ++looks;
        return place;
    };
    ASSERT_TRUE(link.open());
    const test::LooseMotor motor(link, clock);
    const std::string key = unitKeyOf(motor);
    EXPECT_EQ(key, "place usb-1.2 :0");
    const int before = looks;
    link.lose({Fault::LinkLost, say("pulled")});
    place = "usb-1.3";
    EXPECT_EQ(unitKeyOf(motor), key);
    EXPECT_EQ(looks, before) << "the hardware is not asked";
}

TEST(UnitKeys, OfAPlaceHasAnotherNumberOnTheSameLine)
{
    Identity node;
    node.family = "supermodified";
    node.address = 4;
    const std::string before = unitKeyOf(node, "usb-1.2", false);
    node.address = 10;
    EXPECT_EQ(renumberedPlaceKey(before, 10), unitKeyOf(node, "usb-1.2", false));
}

TEST(UnitKeys, WithATagAreThatOfTheUnitAndNotOfItsPlace)
{
    const std::string key = taggedUnitKey(keyOn("serial:/dev/null"), "left arm");
    EXPECT_EQ(key, "tag supermodified left arm");
    EXPECT_EQ(unitByOf(key), UnitBy::Tag);
    EXPECT_EQ(unitTagIn(key), "left arm");
    EXPECT_EQ(taggedUnitKey(keyOn("serial:/dev/zero"), "left arm"), key);
    EXPECT_TRUE(unitCaveatOf(UnitBy::Tag).empty());
}

} // namespace
} // namespace mb
