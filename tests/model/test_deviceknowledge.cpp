// SPDX-License-Identifier: GPL-3.0-or-later
// What this program knows of a device that the device cannot tell: what is legal, what is kept, and who hears of it.
#include "async/virtualclock.h"
#include "support/loosemotor.h"

#include <limits>

namespace mb {
namespace {

using namespace std::chrono_literals;

constexpr Choice knownReadings[] = {{0, "first"}, {12, "second"}};
constexpr Calibration knownCalibrations[]
    = {{"amperes", "A", "Amperes", "help", -2.0, 5.0}, {"reading", "", "Reading", "help", 0.0, 0.0, knownReadings}};
constexpr DialectChoice knownDialects[] = {{"A", "old", "It starts."}, {"B", "new", "It stops."}};
constexpr std::array<Parameter, 3> knownRows{{
    {"gain", 1, WireType::Int32, 1.0, "", 0.0, 100.0, 0.0, Access::WriteOnly, true, Nature::Setting, "Group", "Gain",
        "help"},
    {"limit", 2, WireType::Int32, 1.0, "", 0.0, 100.0, 0.0, Access::ReadWrite, true, Nature::Setting, "Group", "Limit",
        "help"},
    {"secret", 3, WireType::Int32, 1.0, "", 0.0, 100.0, 0.0, Access::WriteOnly, true, Nature::Setting, "Group",
        "Secret", "help"},
}};
constexpr ParameterIndex knownGain{0};
constexpr ParameterIndex knownLimit{1};
constexpr ParameterIndex knownSecret{2};

constexpr Family knownFamily = [] {
    Family family = test::looseFamily;
    family.calibrations = knownCalibrations;
    family.dialects = knownDialects;
    family.parameters = knownRows;
    return family;
}();

class Knowledge : public testing::Test {
protected:
    Knowledge()
    {
        kept = knowledge.changed().add([this] { ++saves; });
        told = knowledge.applied().add([this] { ++applications; });
    }
    /// Whether the call is to be kept, and whether others must follow it.
    template <class Call> void expectTold(const char *what, int saved, int applied, const Call &call)
    {
        saves = applications = 0;
        call();
        EXPECT_EQ(saves, saved) << what;
        EXPECT_EQ(applications, applied) << what;
    }

    VirtualClock clock;
    test::LoggedLink link{clock, {Outlet::Form::CanSocket, 7}};
    test::LooseMotor motor{link, clock, knownFamily};
    DeviceKnowledge &knowledge = motor.knowledge();
    Subscription kept;
    Subscription told;
    int saves = 0;
    int applications = 0;
};

TEST_F(Knowledge, WhatChangesIsKeptAndOnlyWhatOthersFollowIsToldToThem)
{
    expectTold("a calibration", 1, 1, [this] { EXPECT_TRUE(knowledge.calibrate("amperes", 0.5)); });
    expectTold("a dialect", 1, 1, [this] { EXPECT_TRUE(knowledge.setDialect("B")); });
    expectTold("an assumption", 1, 0, [this] { knowledge.assume(knownGain, 5); });
    expectTold("lost settings", 1, 0, [this] { knowledge.settingsLost(); });
    expectTold("another unit", 1, 0, [this] { knowledge.unitExchanged(); });
    expectTold("a counter", 1, 0, [this] { knowledge.setCounter("saves", 7); });
    expectTold("a verdict", 1, 0, [this] { knowledge.setVerdict("direction", DirectionVerdict::Reversed); });
    expectTold("what a file kept", 0, 1, [this] { knowledge.setProfile({}); });
    expectTold("what is refused", 0, 0, [this] {
        EXPECT_FALSE(knowledge.calibrate("amperes", 5.1));
        EXPECT_FALSE(knowledge.setDialect("C"));
    });
}

TEST_F(Knowledge, ACalibrationIsWithinItsRangeAndAChoiceIsOneOfTheListed)
{
    for (const double good : {-2.0, 0.0, 5.0}) {
        EXPECT_TRUE(knowledge.calibrate("amperes", good));
        EXPECT_EQ(knowledge.profile().calibrated("amperes"), good);
    }
    for (const double bad : {-2.0001, 5.0001, std::numeric_limits<double>::quiet_NaN(),
             std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()})
        EXPECT_EQ(knowledge.calibrate("amperes", bad).error().fault, Fault::OutOfRange);
    EXPECT_EQ(knowledge.profile().calibrated("amperes"), 5.0) << "what was refused changes nothing";
    EXPECT_TRUE(knowledge.calibrate("amperes", std::nullopt));
    EXPECT_EQ(knowledge.profile().calibrated("amperes", 9.0), 9.0) << "unknown";
    EXPECT_EQ(knowledge.calibrate("volts", 1.0).error().fault, Fault::Unsupported);
    EXPECT_FALSE(knowledge.calibrate("reading", 5.0));
    EXPECT_EQ(knowledge.calibrate("reading", 5.0).error().text(), knowledge.calibrate("reading", 1.0).error().text());
    EXPECT_NE(knowledge.calibrate("reading", 5.0).error().text().find("0 (first), 12 (second)"), std::string::npos);
}

TEST_F(Knowledge, WhatIsAssumedIsWrittenUntilAResetAndAgainOnceItIsWritten)
{
    EXPECT_FALSE(knowledge.holdsSettings());
    knowledge.assume(knownGain, 5);
    knowledge.assume(knownSecret, 6);
    EXPECT_TRUE(knowledge.holdsSettings());
    EXPECT_EQ(motor.parameters().entry(knownGain).raw, 5);
    EXPECT_EQ(knowledge.profile().written.at("gain"), 5);
    knowledge.settingsLost();
    EXPECT_FALSE(knowledge.holdsSettings());
    EXPECT_FALSE(motor.parameters().entry(knownGain).raw);
    EXPECT_EQ(knowledge.profile().lost.size(), 2U);
    EXPECT_EQ(knowledge.profile().written.at("gain"), 5) << "to be written again";
    knowledge.assume(knownGain, 7);
    EXPECT_TRUE(knowledge.holdsSettings());
    EXPECT_EQ(knowledge.profile().lost, std::set<std::string>{"secret"});
}

TEST_F(Knowledge, WhatAStoreHasForgottenIsAssumedAgainButNotWhatIsLostAndNobodyIsTold)
{
    knowledge.assume(knownGain, 5);
    knowledge.assume(knownSecret, 6);
    knowledge.doubt(knownSecret);
    motor.parameters().forgetAll();
    expectTold("reassuming", 0, 0, [this] { knowledge.reassume(); });
    EXPECT_EQ(motor.parameters().entry(knownGain).raw, 5);
    EXPECT_EQ(motor.parameters().entry(knownGain).state, ParameterState::Assumed);
    EXPECT_FALSE(motor.parameters().entry(knownSecret).raw);
}

TEST_F(Knowledge, OfAFileOnlyLegalValuesOfWriteOnlyParametersThatNoResetTookAreBelieved)
{
    DeviceProfile file;
    file.written = {{"gain", 100}, {"limit", 50}, {"secret", 6}, {"gone", 3}};
    file.lost = {"secret"};
    knowledge.setProfile(file);
    EXPECT_EQ(motor.parameters().entry(knownGain).raw, 100);
    EXPECT_FALSE(motor.parameters().entry(knownLimit).raw) << "that one can be asked";
    EXPECT_FALSE(motor.parameters().entry(knownSecret).raw);
    EXPECT_EQ(knowledge.profile(), file);
    file.written["secret"] = 101;
    file.lost.clear();
    knowledge.setProfile(file);
    EXPECT_FALSE(motor.parameters().entry(knownSecret).raw) << "out of its range";
}

TEST_F(Knowledge, AProvenDialectStaysAndAChosenOneIsShownWithItsWarning)
{
    Identity seen;
    seen.dialect = "A";
    seen.detail = say("answered");
    EXPECT_EQ(knowledge.probed(seen), seen);
    EXPECT_EQ(knowledge.probed({}).dialect, "A") << "a scan that could not prove it takes nothing away";
    EXPECT_EQ(knowledge.probed({}).detail, "answered");
    Identity boot;
    boot.state = DeviceState::Bootloader;
    EXPECT_EQ(knowledge.probed(boot).dialect, "") << "something else runs";

    ASSERT_TRUE(knowledge.setDialect("B"));
    EXPECT_EQ(knowledge.shown({}).dialect, "B");
    EXPECT_EQ(knowledge.shown({}).detail, "Dialect B was chosen by hand, none was proven. It stops.");
    EXPECT_EQ(knowledge.probed(seen).dialect, "B");
    EXPECT_EQ(knowledge.probed(seen).detail, "Dialect B was chosen by hand, the unit answered as A. It stops.");
    ASSERT_TRUE(knowledge.setDialect("A"));
    EXPECT_EQ(knowledge.shown({}).detail, "answered") << "as it answered";
    ASSERT_TRUE(knowledge.setDialect(""));
    EXPECT_EQ(knowledge.shown({}).dialect, "A");
    EXPECT_EQ(knowledge.setDialect("C").error().help(), "it has A, B");
}

} // namespace
} // namespace mb
