// SPDX-License-Identifier: GPL-3.0-or-later
// What the board does not tell, found out by experiment: gain scales against the simulator's true ones, readings of inputs and
// velocity targets. In virtual time.
#include "quadquad2drvboard.h"

#include "families/quadquad2drv/calibrations.h"
#include "families/quadquad2drv/codec.h"
#include "families/quadquad2drv/gainfit.h"
#include "families/quadquad2drv/parameters.h"
#include "families/quadquad2drv/simulatoraxis.h"
#include "model/parametertransfer.h"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace mb::quadquad2drv {
namespace {

struct ScaleCase {
    const char *name;
    const char *unit;
    double scale;
    int axis;
};

class QuadQuad2DrvScales : public testing::TestWithParam<ScaleCase> { };

TEST_P(QuadQuad2DrvScales, AreFoundWithinTheirTolerance)
{
    const ScaleCase &row = GetParam();
    Board bench(row.unit);
    Operation operation(bench.clock, say("scales"));
    const Instant begin = bench.clock.now();
    const auto report = bench.find(withPower(0.25, row.axis), operation);
    for (const LogLine &line : operation.status().log)
        std::cout << line.text << '\n';
    ASSERT_TRUE(report) << report.error().text();
    const auto compare = [&](std::string_view key, double truth, double tolerance) {
        const double error = bench.kept(key) / (truth * row.scale) - 1.0;
        std::cout << row.name << ", " << key << ": " << bench.kept(key) << ", true " << truth * row.scale << ", error "
                  << 100.0 * error << " % (limit " << 100.0 * tolerance << ")\n";
        EXPECT_LT(std::abs(error), tolerance) << key;
    };
    compare(calibration::velocityP, simulation::gain::velocityP, 0.01);
    compare(calibration::velocityI, simulation::gain::velocityI, 0.05);
    compare(calibration::positionP, simulation::gain::positionP, 0.03);
    compare(calibration::positionI, simulation::gain::positionI, 0.05);
    compare(calibration::positionD, simulation::gain::positionD, 0.1);
    std::cout << row.name << ": " << std::chrono::duration<double>(bench.clock.now() - begin).count() << " s\n";
    EXPECT_FALSE(bench.board().isOutputOn());
}

INSTANTIATE_TEST_SUITE_P(Boards, QuadQuad2DrvScales,
    testing::Values(ScaleCase{"as simulated", "quadquad2drv:0", 1.0, 1},
        ScaleCase{"five times", "quadquad2drv:0,scale=5", 5.0, 1},
        ScaleCase{"a third", "quadquad2drv:0,scale=0.3", 0.3, 4},
        ScaleCase{"another motor", "quadquad2drv:0,scale=0.7", 0.7, 3}),
    [](const auto &row) {
        std::string name = row.param.name;
        std::replace(name.begin(), name.end(), ' ', '_');
        return name;
    });

TEST(QuadQuad2DrvExperiment, NeverAsksForMorePowerThanItWasAllowed)
{
    Board bench("quadquad2drv:0");
    Operation operation(bench.clock, say("scales"));
    ASSERT_TRUE(bench.find(withPower(0.2), operation));
    EXPECT_TRUE(bench.hasSent(setPowerLimit(1, 1638)));
    for (const Bytes &packet : bench.sent) {
        if (packet[2] == static_cast<std::uint8_t>(PacketId::SetPower) && packet.size() == 7) {
            const auto power = static_cast<std::int16_t>(packet[4] | packet[5] << 8U);
            EXPECT_LE(std::abs(power), 1639);
        }
        if (packet[2] == static_cast<std::uint8_t>(PacketId::SetPowerLimit)) {
            EXPECT_LE(packet[4] | packet[5] << 8U, 2048);
        }
    }
}

TEST(QuadQuad2DrvExperiment, WithoutAnAxisOrAPowerBetweenNothingAndAllNothingIsSent)
{
    Board bench("quadquad2drv:0");
    struct Row {
        double power;
        int axis;
    };
    for (const Row &row : {Row{0.0, 1}, {-0.1, 1}, {1.001, 1}, {std::nan(""), 1}, {0.25, 0}, {0.25, 5}}) {
        bench.sent.clear();
        Operation operation(bench.clock, say("scales"));
        const auto report = bench.find(withPower(row.power, row.axis), operation);
        ASSERT_FALSE(report) << row.power << ' ' << row.axis;
        EXPECT_EQ(report.error().fault, Fault::OutOfRange);
        for (const Bytes &packet : bench.sent)
            EXPECT_TRUE(packet[2] % 2 == 1 || packet[2] == 2) << "packet " << static_cast<int>(packet[2]) << " asks";
    }
}

TEST(QuadQuad2DrvExperiment, PutsGainsLimitsAndHistoryBackWhenItEnds)
{
    Board bench("quadquad2drv:0");
    NoProgress progress;
    ASSERT_TRUE(run(bench.clock,
        writeParameters(*bench.device,
            {{indexOf(0, AxisParameter::VelocityP), 77}, {indexOf(0, AxisParameter::LimitPower), 4000},
                {indexOf(BoardParameter::HistoryLength), 20}},
            progress)));
    Operation operation(bench.clock, say("scales"));
    ASSERT_TRUE(bench.find(withPower(0.25), operation));
    const auto lastOf = [&bench](PacketId id) {
        const auto found = std::find_if(bench.sent.rbegin(), bench.sent.rend(),
            [id](const Bytes &packet) { return packet.size() > 3 && packet[2] == static_cast<std::uint8_t>(id); });
        return found == bench.sent.rend() ? Bytes() : *found;
    };
    EXPECT_EQ(lastOf(PacketId::SetVelocityGains), setVelocityGains(1, {77, 200, 500}));
    EXPECT_EQ(lastOf(PacketId::SetPositionGains), setPositionGains(1, {100, 500, 500, 600}));
    EXPECT_EQ(lastOf(PacketId::SetPowerLimit), setPowerLimit(1, 4000));
    EXPECT_EQ(run(bench.clock, bench.device->read(indexOf(BoardParameter::HistoryLength))), 20);
}

TEST(QuadQuad2DrvExperiment, CancelledInTheMiddleItStopsTheMotorAndPutsTheGainsBack)
{
    Board bench("quadquad2drv:0");
    bench.renew();
    Operation operation(bench.clock, say("scales"));
    std::optional<Fault> end;
    operation.run<ExperimentReport>(findGainScales(*bench.device, bench.stream(), withPower(0.25), operation),
        [&end](const Result<ExperimentReport> &result) { end = result ? Fault::BadCheck : result.error().fault; });
    ASSERT_TRUE(
        bench.clock.runUntil([&] { return operation.status().done >= 2 && bench.board().isOutputOn(); }, 10min));
    ASSERT_TRUE(operation.cancel());
    bench.clock.advance(50ms);
    EXPECT_EQ(end, Fault::Cancelled);
    EXPECT_FALSE(bench.board().isOutputOn());
    bench.clock.advance(500ms);
    EXPECT_TRUE(bench.device->knowledge().profile().calibration.empty()) << "nothing half-known is kept";
    const auto last = std::find_if(bench.sent.rbegin(), bench.sent.rend(),
        [](const Bytes &packet) { return packet[2] == static_cast<std::uint8_t>(PacketId::SetVelocityGains); });
    ASSERT_NE(last, bench.sent.rend());
    EXPECT_EQ(*last, setVelocityGains(1, {100, 200, 500}));
}

TEST(QuadQuad2DrvExperiment, DoesNotBeginWhereNobodyRenewsTheLease)
{
    Board bench("quadquad2drv:0");
    Operation operation(bench.clock, say("scales"));
    std::optional<Error> end;
    operation.run<ExperimentReport>(findGainScales(*bench.device, bench.stream(), withPower(0.25), operation),
        [&end](const Result<ExperimentReport> &result) { end = result ? Error{} : result.error(); });
    ASSERT_TRUE(bench.clock.runUntil([&end] { return end.has_value(); }, 10s));
    EXPECT_EQ(end->fault, Fault::Unsafe);
    EXPECT_NE(end->detail.english().find("nobody renewed"), std::string::npos) << end->detail;
    EXPECT_FALSE(bench.hasSent(setPower(1, 0))) << "nor is its motor held";
}

TEST(QuadQuad2DrvExperiment, AnEncoderThatCountsBackwardsIsFoundBeforeAnyLoopIsClosed)
{
    Board bench("quadquad2drv:0,fault=encoder-reversed");
    Operation operation(bench.clock, say("scales"));
    const auto report = bench.find(withPower(0.25), operation);
    ASSERT_FALSE(report);
    EXPECT_EQ(report.error().fault, Fault::Unsafe);
    EXPECT_NE(report.error().text().find("counts against the power"), std::string::npos) << report.error().text();
    for (const Bytes &packet : bench.sent) {
        if (packet[2] == static_cast<std::uint8_t>(PacketId::SetControlMode)) {
            EXPECT_LE(packet[4], static_cast<std::uint8_t>(ControlMode::Power));
        }
    }
}

TEST(QuadQuad2DrvExperiment, AMotorThatDoesNotTurnIsRefused)
{
    Board bench("quadquad2drv:0");
    ASSERT_TRUE(bench.board().disturb("stall", 1.0));
    Operation operation(bench.clock, say("scales"));
    const auto report = bench.find(withPower(0.25), operation);
    ASSERT_FALSE(report);
    EXPECT_NE(report.error().text().find("did not turn"), std::string::npos) << report.error().text();
}

/// A load on one side: at the least power the motor turns some 212 counts/s, and 11 more or less for each 0.001 N·m.
TEST(QuadQuad2DrvExperiment, AMotorThatIsAFifthFasterOneWayThanTheOtherIsRefused)
{
    for (const auto &[torque, isRefused] : {std::pair{0.003, false}, {0.005, true}}) {
        Board bench("quadquad2drv:0");
        ASSERT_TRUE(bench.board().disturb("load-torque", torque));
        Operation operation(bench.clock, say("scales"));
        const auto report = bench.find(withPower(0.25), operation);
        const std::string why = report ? std::string() : report.error().text();
        EXPECT_EQ(why.find("turns differently in both directions") != std::string::npos, isRefused) << why;
    }
}

TEST(QuadQuad2DrvExperiment, ABoardThatWantsItsVelocityTargetShiftedIsTold)
{
    Board bench("quadquad2drv:0,target=shifted");
    Operation operation(bench.clock, say("scales"));
    const auto report = bench.find(withPower(0.25), operation);
    ASSERT_FALSE(report);
    EXPECT_NE(report.error().text().find("times 4096"), std::string::npos) << report.error().text();
    ASSERT_TRUE(bench.device->knowledge().calibrate(calibration::targetShift, calibration::shiftedTarget));
    bench.clock.advance(1s); // what the first has changed is put back
    Operation again(bench.clock, say("scales"));
    const auto found = bench.find(withPower(0.25), again);
    ASSERT_TRUE(found) << found.error().text();
    EXPECT_NEAR(bench.kept(calibration::velocityP), simulation::gain::velocityP, 0.02 * simulation::gain::velocityP);
}

TEST(QuadQuad2DrvExperiment, TheStatusBitTellsWhichReadingOfTheInputsIsRight)
{
    for (const bool library : {true, false}) {
        for (const int answer : {0, 1}) {
            Board bench(library ? "quadquad2drv:0" : "quadquad2drv:0,inputs=datasheet");
            ASSERT_TRUE(bench.board().disturb("input2", answer == 0 ? 1.0 : 0.0));
            ExperimentOptions options;
            options.axis = 2;
            options.answer = answer;
            NoProgress progress;
            const auto report = run(bench.clock, findInputReading(*bench.device, bench.stream(), options, progress));
            ASSERT_TRUE(report) << report.error().text();
            EXPECT_EQ(
                bench.kept(calibration::inputReading), library ? calibration::asLibrary : calibration::asDataSheet);
            bench.clock.advance(100ms);
            EXPECT_TRUE(bench.hasSent(setInputMode(2, {}))) << "disabled again, as it was";
        }
    }
}

TEST(QuadQuad2DrvExperiment, APolarityMeansTheSameOnBothKindsOfBoards)
{
    for (const bool library : {true, false}) {
        Board bench(library ? "quadquad2drv:0" : "quadquad2drv:0,inputs=datasheet");
        ASSERT_TRUE(bench.device->knowledge().calibrate(
            calibration::inputReading, library ? calibration::asLibrary : calibration::asDataSheet));
        NoProgress progress;
        ASSERT_TRUE(run(bench.clock,
            writeParameters(*bench.device,
                {{indexOf(0, AxisParameter::InputPosition), 500}, {indexOf(0, AxisParameter::InputPolarity), 1},
                    {indexOf(0, AxisParameter::InputEdge), 1}, {indexOf(0, AxisParameter::InputMode), 1}},
                progress)));
        ASSERT_TRUE(bench.board().disturb("input1", 0.0)); // to ground: active low, and the counter is set
        bench.clock.advance(200ms);
        EXPECT_EQ(run(bench.clock, bench.device->read(indexOf(0, AxisParameter::Counter))), 500) << library;
    }
}

TEST(QuadQuad2DrvExperiment, AnotherReadingWritesTheInputsAgain)
{
    Board bench("quadquad2drv:0");
    NoProgress progress;
    ASSERT_TRUE(
        run(bench.clock, writeParameters(*bench.device, {{indexOf(0, AxisParameter::InputMode), 1}}, progress)));
    bench.sent.clear();
    ASSERT_TRUE(bench.device->knowledge().calibrate(calibration::inputReading, calibration::asDataSheet));
    bench.clock.advance(200ms);
    EXPECT_TRUE(bench.hasSent(setInputMode(1, {0x09, 0, 0}))) << "active high, as the data sheet says it";
}

TEST(QuadQuad2DrvExperiment, OnlyTheListedReadingsAreLegal)
{
    Board bench("quadquad2drv:0");
    EXPECT_EQ(bench.device->knowledge().calibrate(calibration::targetShift, 5.0).error().fault, Fault::OutOfRange);
    EXPECT_TRUE(bench.device->knowledge().calibrate(calibration::targetShift, 12.0));
}

TEST(QuadQuad2DrvExperiment, AVelocityTargetIsPlainUntilItsSettingSaysOtherwiseAndNeverChangesInMotion)
{
    Board bench("quadquad2drv:0");
    SetPoint setPoint;
    setPoint.mode = Mode::Velocity;
    setPoint.target = 1000.0;
    ASSERT_TRUE(bench.stream().start(setPoint, 60s));
    bench.clock.advance(200ms);
    EXPECT_TRUE(bench.hasSent(setVelocityTarget(1, 1000.0, {.velocityTargetShifted = false})));
    ASSERT_TRUE(bench.device->knowledge().calibrate(calibration::targetShift, calibration::shiftedTarget));
    bench.clock.advance(500ms);
    EXPECT_FALSE(bench.hasSent(setVelocityTarget(1, 1000.0, {.velocityTargetShifted = true})));
    bench.stream().stop();
    bench.clock.advance(500ms);
    ASSERT_TRUE(bench.stream().start(setPoint, 60s));
    bench.clock.advance(200ms);
    EXPECT_TRUE(bench.hasSent(setVelocityTarget(1, 1000.0, {.velocityTargetShifted = true})));
}

TEST(QuadQuad2DrvGainFit, ALineThroughPowersGivesGainAndFriction)
{
    const auto plant = fitPlant({{1000.0, 600.0, 0.1}, {2000.0, 1600.0, 0.1}, {500.0, 0.0, 0.0}});
    ASSERT_TRUE(plant);
    EXPECT_NEAR(plant->gain, 1.0, 1e-9);
    EXPECT_NEAR(plant->friction, 400.0, 1e-6);
    EXPECT_NEAR(plant->lag, 0.1, 1e-9);
    EXPECT_FALSE(fitPlant({{1000.0, 600.0, 0.1}}));
    EXPECT_TRUE(fitPlant({{1000.0, 0.4, 0.1}, {2000.0, 0.9, 0.1}})) << "however slowly";
    EXPECT_FALSE(fitPlant({{1000.0, 600.0, 0.1}, {1500.0, 100.0, 0.1}, {2000.0, 1600.0, 0.1}}));
}

/// A run of `plant` from rest with constant power, sampled every 10 ms: exact.
Track trackOf(const Plant &plant, double power, double seconds)
{
    Track track;
    const double fastest = plant.speedAt(power);
    for (int i = 0; i <= static_cast<int>(seconds * 100.0); ++i) {
        const double t = i / 100.0;
        track.seconds.push_back(t);
        track.counts.push_back(fastest * (t - plant.lag * (1.0 - std::exp(-t / plant.lag))));
    }
    return track;
}

TEST(QuadQuad2DrvGainFit, TheScaleOfAKnownMotorIsFoundToAFewThousandths)
{
    const Plant plant{2.0, 300.0, 0.08};
    const double power = 2000.0;
    const Track track = trackOf(plant, power, 1.5);
    for (const double scale : {0.25, 1.0, 8.0}) {
        const Drive drive{std::vector<double>(track.size(), power / scale), {}, 8191.0};
        const auto fit = fitScale(plant, track, drive);
        ASSERT_TRUE(fit) << fit.error().text();
        EXPECT_NEAR(fit->scale, scale, 0.004 * scale);
        EXPECT_GT(fit->samples, 100);
    }
    // a part of the power is of a gain that is known already
    const Drive shared{std::vector<double>(track.size(), 100.0), std::vector<double>(track.size(), 1500.0), 8191.0};
    const auto fit = fitScale(plant, track, shared);
    ASSERT_TRUE(fit) << fit.error().text();
    EXPECT_NEAR(fit->scale, 5.0, 0.08);
}

TEST(QuadQuad2DrvGainFit, ASpeedNeedsThreeSamplesAndCountsThoseAtBothEnds)
{
    Track track;
    for (int i = 0; i < 5; ++i) {
        track.seconds.push_back(i);
        track.counts.push_back(i < 4 ? 10.0 * i : 1000.0);
    }
    EXPECT_EQ(track.speed(0.5, 2.5), 0.0) << "two samples";
    EXPECT_NEAR(track.speed(1.0, 3.0), 10.0, 1e-9) << "three, with those at the ends";
    EXPECT_GT(track.speed(1.0, 4.0), 100.0);
    EXPECT_EQ(track.way(), 1000.0);
    EXPECT_EQ(track.end(), 4.0);
    EXPECT_EQ(Track().way(), 0.0);
    EXPECT_EQ(Track().end(), 0.0);
}

TEST(QuadQuad2DrvGainFit, ScalesThatDoNotAgreeAreRefused)
{
    EXPECT_TRUE(agreed({1.0, 1.02, 0.98}, 0.05));
    EXPECT_FALSE(agreed({1.0, 1.2}, 0.05));
    EXPECT_FALSE(agreed({1.0, -1.0}, 5.0));
    EXPECT_FALSE(agreed({}, 0.05));
}

} // namespace
} // namespace mb::quadquad2drv
