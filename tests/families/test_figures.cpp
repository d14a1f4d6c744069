// SPDX-License-Identifier: GPL-3.0-or-later
// The figures of each family that the whole program goes by, as its README.md and docs/names.md have them: one row to compare.
#include "model/family.h"
#include "model/registry.h"
#include "model/trialtraits.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <sstream>

namespace mb {
namespace {

const Family &familyNamed(std::string_view key)
{
    return *findFamily(families(), key);
}

std::string capabilitiesOf(const Family &family)
{
    const Capabilities &can = family.capabilities;
    std::ostringstream text;
    const auto flag = [&text](const char *name, bool holds) {
        if (holds)
            text << name << ' ';
    };
    flag("readback", can.readback);
    flag("watchdog", can.watchdog);
    flag("version", can.versionOnWire);
    flag("identify", can.identify);
    flag("rename", can.rename);
    flag("renumber", can.renumber);
    flag("restart", can.restart);
    flag("relative", can.relativeMoves);
    flag("buffered", can.bufferedMoves);
    flag("stores-at-once", can.storesAtOnce);
    flag("keeps", can.keepsSettings);
    flag("zero", can.zeroPosition);
    for (const Mode mode : can.output.ramp)
        text << "ramp-" << toString(mode) << ' ';
    flag("brake", can.output.brake);
    flag("directions", can.output.directions);
    flag("limits", can.output.limits);
    flag("free-rates", can.freeRates);
    flag("profile", can.commandsProfile);
    text << "| first power " << can.firstPower << ", supply " << can.lowestSupply << ", profile " << can.fastestProfile
         << ' ' << can.steepestProfile << ", axes " << can.axes << ", slots " << can.gainSlots << ", period "
         << can.commandPeriod.count() << ", limit " << can.commandLimit.count() << ", stores "
         << can.storesAfter.count() << ", scan " << can.scanLimit.count() << ", last " << can.lastAddress << ' '
         << can.lastFollowed;
    return text.str();
}

std::string trialsOf(const Family &family)
{
    const TrialTraits &trials = *family.trials;
    std::ostringstream text;
    text << "within " << *trials.bench.travel << ' ' << *trials.bench.speed << ' ' << *trials.bench.current << ' '
         << *trials.bench.duty << ", rate " << trials.rate << ' ' << trials.currentRate << ", raw " << trials.raw.cycle
         << ' ' << trials.raw.fullDuty << ' ' << trials.raw.integral << ", nudge " << trials.nudge << ' '
         << trials.nudgeTravel << ", hottest " << trials.hottest << ", bus " << trials.lowestBus << ' '
         << trials.highestBus;
    for (const LoopGains &loop : trials.loops)
        text << "; " << toString(loop.mode) << (loop.proportional ? " P" : "");
    constexpr std::array bounds{"position", "speed", "current", "duty"};
    for (const DeviceLimit &limit : trials.limits)
        text << "; " << bounds.at(static_cast<std::size_t>(limit.bounds)) << ' ' << limit.key << ' ' << limit.one
             << (limit.enabled.empty() ? "" : " by ") << limit.enabled;
    return text.str();
}

std::string loopOf(const Family &family)
{
    const LoopScale &loop = *family.loop;
    std::ostringstream text;
    text << "full " << loop.fullDuty << ", period " << loop.period << ", cycle " << loop.cycle << ", step "
         << loop.integralStep << ", velocity " << loop.velocityTime << ' ' << loop.velocityWindow
         << (loop.divided ? ", divided" : "") << (loop.derivativeInverted ? ", inverted" : "")
         << (loop.calibrated ? ", calibrated" : "");
    return text.str();
}

std::string ratesOf(const Family &family)
{
    std::ostringstream text;
    for (const ChannelRate &rate : family.watched)
        text << rate.channel << ' ' << rate.hertz << ' ';
    return text.str();
}

TEST(FamilyFigures, WhatADeviceCan)
{
    EXPECT_EQ(capabilitiesOf(familyNamed("dmc60c")),
        "readback watchdog version identify rename renumber restart keeps ramp-duty ramp-voltage brake directions "
        "limits | first power 0, supply 11, profile "
        "0 0, axes 1, slots 2, period 20, limit 100, stores 15, scan 500, last 63 255");
    EXPECT_EQ(capabilitiesOf(familyNamed("supermodified")),
        "readback renumber relative buffered stores-at-once keeps zero free-rates | first power 0, supply 0, profile 0 "
        "0, axes 1, slots 1, period 20, limit 250, stores 0, scan 30000, last 127 255");
    EXPECT_EQ(capabilitiesOf(familyNamed("abstractdc")),
        "keeps ramp-duty free-rates | first power 0, supply 0, profile 0 0, axes 1, slots 1, period 20, limit 250, "
        "stores 0, scan 500, last 99 255");
    EXPECT_EQ(capabilitiesOf(familyNamed("quadquad2drv")),
        "readback version restart free-rates profile | first power 0.25, supply 0, profile 100000 1e+06, axes 4, slots "
        "1, period 50, limit 250, stores 0, scan 500, last 0 255");
}

TEST(FamilyFigures, WhatATrialMustKnow)
{
    EXPECT_EQ(trialsOf(familyNamed("dmc60c")),
        "within 2e+07 1.5e+06 150 1, rate 200 1000, raw 0 0 1, nudge 0 0, hottest 85, bus 6 28; velocity; position; "
        "current; position limit.forward.soft.threshold 1 by limit.forward.soft.enabled; position "
        "limit.reverse.soft.threshold 1 by limit.reverse.soft.enabled; current current_limit.continuous 1 by "
        "current_limit.enabled; duty slot#.max_forward 32767");
    EXPECT_EQ(trialsOf(familyNamed("supermodified")),
        "within 1e+06 1e+06 5 1, rate 100 0, raw 0.001024 65280 256, nudge 20 60, hottest 80, bus 0 1000; position; "
        "current limit.current 1000");
    EXPECT_EQ(trialsOf(familyNamed("abstractdc")),
        "within 5e+06 500000 150 1, rate 100 0, raw 0 0 1, nudge 0 0, hottest 80, bus 0 1000; velocity; position; "
        "current P");
    EXPECT_EQ(trialsOf(familyNamed("quadquad2drv")),
        "within 1e+06 100000 10 1, rate 100 0, raw 0 0 1, nudge 0 0, hottest 80, bus 0 1000; velocity; position; "
        "duty limit.power 1; speed limit.velocity 1");
}

TEST(FamilyFigures, WhatItsGainsMean)
{
    EXPECT_EQ(loopOf(familyNamed("dmc60c")), "full 32767, period 0.0005, cycle 0.0005, step 0, velocity 0.1 0");
    EXPECT_EQ(loopOf(familyNamed("abstractdc")),
        "full 255, period 0.001, cycle 0.02004, step 1, velocity 1 0.02004, divided, inverted");
    EXPECT_EQ(
        loopOf(familyNamed("quadquad2drv")), "full 8191, period 0.002, cycle 0.002, step 0, velocity 1 0, calibrated");
    EXPECT_FALSE(familyNamed("supermodified").loop) << "nobody knows";
}

/// What one of a parameter's unit is on the wire, where it is not one.
TEST(FamilyFigures, WhatAParameterCountsIn)
{
    const auto scalesOf = [](std::string_view key) {
        std::map<double, int> rows;
        for (const Parameter &row : familyNamed(key).parameters)
            ++rows[row.one];
        std::ostringstream text;
        for (const auto &[one, count] : rows)
            text << one << " x " << count << "; ";
        return text.str();
    };
    for (const Parameter &row : familyNamed("dmc60c").parameters)
        EXPECT_EQ(row.one, row.type == WireType::Fixed16x16 ? 65536.0 : 1.0) << row.key;
    EXPECT_EQ(scalesOf("supermodified"), "1 x 15; ");
    EXPECT_EQ(scalesOf("abstractdc"), "1 x 13; ");
    EXPECT_EQ(scalesOf("quadquad2drv"), "1 x 60; 4096 x 8; 8191 x 4; ") << "two limits of each axis, and its power";
}

TEST(FamilyFigures, WhichParametersStayWithoutPowerBelongToTheUnitOrWaitForARestart)
{
    const auto flagsOf = [](std::string_view key) {
        std::string fleeting;
        std::string own;
        std::string later;
        for (const Parameter &row : familyNamed(key).parameters) {
            const std::string name = ' ' + std::string(row.key);
            fleeting += row.persistent ? "" : name;
            own += row.belongsToUnit ? name : "";
            later += row.afterRestart ? name : "";
        }
        return "fleeting:" + fleeting + "; own:" + own + "; later:" + later;
    };
    EXPECT_EQ(flagsOf("supermodified"),
        "fleeting: io.outputs; own: node.id; later: limit.current.duration node.id node.mask uart.baud");
    EXPECT_EQ(flagsOf("abstractdc"), "fleeting:; own:; later:");
    EXPECT_EQ(flagsOf("dmc60c"),
        "fleeting: encoder.position encoder.clear_on_index encoder.clear_on_forward_limit "
        "encoder.clear_on_reverse_limit "
        "encoder.index_rising faults.active faults.communication.count status.analog.period status.encoder.period "
        "status.general.period; own: current.adc_multiplier; later:");
    for (const Parameter &row : familyNamed("quadquad2drv").parameters)
        EXPECT_FALSE(row.persistent) << row.key << ": a board keeps nothing";
}

TEST(FamilyFigures, HowOftenAMotionIsLookedAt)
{
    EXPECT_EQ(ratesOf(familyNamed("dmc60c")), "velocity 100 position 100 current 50 ");
    EXPECT_EQ(ratesOf(familyNamed("supermodified")), "velocity 100 position 100 current 50 ");
    EXPECT_EQ(ratesOf(familyNamed("abstractdc")), "velocity 100 position 100 current 50 ");
    EXPECT_EQ(ratesOf(familyNamed("quadquad2drv")), "ch1.position 500 ");
}

TEST(FamilyFigures, WhatItsUserMayTell)
{
    const auto rowsOf = [](std::string_view key) {
        std::ostringstream text;
        for (const Calibration &row : familyNamed(key).calibrations) {
            text << row.key << ' ' << row.minimum << ' ' << row.maximum << ' ' << row.unit;
            for (const Choice &choice : row.choices)
                text << " =" << choice.raw;
            text << "; ";
        }
        return text.str();
    };
    EXPECT_EQ(rowsOf("dmc60c"), "");
    EXPECT_EQ(rowsOf("supermodified"), "amperes_per_count 1e-06 1000 A; ");
    EXPECT_EQ(rowsOf("abstractdc"),
        "counts_per_revolution 1 1e+09 counts; amperes_per_count 1e-06 1000 A; degrees_per_count 1e-06 1000 °C; ");
    EXPECT_EQ(rowsOf("quadquad2drv"),
        "velocity_target_shift 0 12  =0 =12; input_reading 0 1  =0 =1; velocity.p.scale 1e-09 1e+06 ; "
        "velocity.i.scale 1e-09 1e+06 ; position.p.scale 1e-09 1e+06 ; position.i.scale 1e-09 1e+06 ; "
        "position.d.scale 1e-09 1e+06 ; ");
}

TEST(FamilyFigures, AHandMayFirstSetThisInEachMode)
{
    for (const auto &[mode, usual] : {std::pair{Mode::Off, 0.0}, {Mode::Duty, 1.0}, {Mode::Velocity, 1e5},
             {Mode::Position, 40960.0}, {Mode::Current, 20.0}, {Mode::Voltage, 12.0}, {Mode::Follow, 0.0},
             {Mode::RampPosition, 40960.0}, {Mode::RampVelocity, 1e5}})
        EXPECT_EQ(usualRange({}, mode), usual) << toString(mode);
    constexpr ModeRange own[] = {{Mode::Velocity, 500.0}, {Mode::Duty, 0.5}};
    EXPECT_EQ(usualRange(own, Mode::Duty), 0.5);
    EXPECT_EQ(usualRange(own, Mode::Velocity), 500.0);
    EXPECT_EQ(usualRange(own, Mode::Current), 20.0);
}

} // namespace
} // namespace mb
