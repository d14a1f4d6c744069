// SPDX-License-Identifier: GPL-3.0-or-later
// Gains in duty and seconds as the integers of each family, and back.
#include "families/quadquad2drv/calibrations.h"
#include "model/family.h"
#include "model/loopparameters.h"
#include "tests/tuning/experimentbench.h"
#include "tuning/gainscale.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace mb::tuning {
namespace {

using test::ExperimentBench;

constexpr double perRadian = 4096.0 / (2.0 * std::numbers::pi);
const TriedScale triedByHand{.p = 1e-4, .d = 1e-6, .cycle = 1e-3, .i = 2e-5};

/// A loop with gains whose numbers somebody has worked out by hand.
struct GoldenGains {
    const char *link;
    const char *family;
    int address;
    Mode loop;
    int slot;
    ContinuousGains gains;
    std::vector<std::pair<std::string, double>> raw; ///< of a divided loop times its divisor
    std::optional<TriedScale> tried{};
};

/// The first five are those of the data sheets and of the references.
std::vector<GoldenGains> goldenGains()
{
    return {{"sim:can", "dmc60c", 5, Mode::Velocity, 0, {0.002 / perRadian, 0.01 / perRadian, 0.0, 0.0018 / perRadian},
                {{"slot0.p", 65882}, {"slot0.i", 165}, {"slot0.d", 0}, {"slot0.f", 59294}}},
        {"sim:can", "dmc60c", 5, Mode::Position, 1, {0.1 / perRadian, 0.5 / perRadian, 0.01 / perRadian, 0.0},
            {{"slot1.p", 329410}, {"slot1.i", 824}, {"slot1.d", 65881963}}},
        // half of full duty at 20 A is 819.175; the vendor's own example cuts off what is rounded here: 0x03332CCC
        {"sim:can", "dmc60c", 5, Mode::Current, 0, {0.003, 3.3, 0.0, 0.5 / 20.0},
            {{"slot0.p", 6442254}, {"slot0.i", 3543240}, {"slot0.f", 0x03332CCD}}},
        {"sim:can", "abstractdc", 3, Mode::Position, 0, {0.8 / 255.0, 4.0 / 255.0, 0.02 / 255.0, 0.0},
            {{"position.p", 0.8}, {"position.i", 0.004}, {"position.d", -20.0}}},
        {"sim:can", "abstractdc", 3, Mode::Velocity, 0, {1.2 / 255.0, 6.0 / 255.0, 0.0, 0.0},
            {{"velocity.p", 1.2}, {"velocity.i", 0.006}, {"velocity.d", 0.0}}},
        {"sim:spi", "quadquad2drv", 0, Mode::Velocity, 0, {0.001, 0.005, 0.0, 0.0},
            {{"ch1.velocity.p", 819}, {"ch1.velocity.i", 2340}}},
        {"sim:spi", "quadquad2drv", 0, Mode::Position, 0, {0.01, 0.02, 0.0001, 0.0},
            {{"ch1.position.p", 1638}, {"ch1.position.i", 3276}, {"ch1.position.d", 2048}}},
        {"sim:serial", "supermodified", 4, Mode::Position, 0, {0.05, 0.02, 0.0016, 0.0},
            {{"gain.p", 500}, {"gain.i", 1000}, {"gain.d", 1600}}, triedByHand}};
}

/// The scales of its bench, rounded.
void calibrate(Device &device)
{
    using namespace quadquad2drv;
    for (const auto &[key, scale] : {std::pair(calibration::velocityP, 0.01), std::pair(calibration::velocityI, 3.5e-5),
             std::pair(calibration::positionP, 0.05), std::pair(calibration::positionI, 1e-4),
             std::pair(calibration::positionD, 0.2)})
        ASSERT_TRUE(device.family().key != "quadquad2drv" || device.knowledge().calibrate(key, scale));
}

const ScaledGains::Row *rowOf(const ScaledGains &gains, std::string_view key)
{
    const auto found
        = std::find_if(gains.rows.begin(), gains.rows.end(), [key](const auto &row) { return row.key == key; });
    return found == gains.rows.end() ? nullptr : &*found;
}

/// With zeros for what a slot has beside them.
KnownGains numbersOf(const Family &family, const GoldenGains &row, const ScaledGains &gains)
{
    KnownGains numbers;
    const LoopGains &loop = *loopOf(family, row.loop);
    for (const std::string_view name : loop.names) {
        const std::string key = gainKey(family, std::string(loop.prefix) + std::string(name), 1, row.slot);
        const ScaledGains::Row *const known = rowOf(gains, key);
        numbers.emplace_back(key, known ? known->number : 0.0);
    }
    return numbers;
}

TEST(Acceptance, A08_GoldenGainsOfEveryFamilyAndLoop)
{
    for (const GoldenGains &row : goldenGains()) {
        const ExperimentBench bench(row.link, row.family, row.address);
        calibrate(*bench.device);
        const auto scaled = scaleGains(*bench.device, row.loop, 1, row.slot, row.gains, row.tried);
        ASSERT_TRUE(scaled) << row.family << ' ' << toString(row.loop) << ": " << scaled.error().text();
        const auto divided = std::find_if(scaled->rows.begin(), scaled->rows.end(),
            [](const ScaledGains::Row &one) { return one.role == Role::Divisor; });
        const double divisor = divided == scaled->rows.end() ? 1.0 : divided->number;
        std::printf("A8 %s %s:", row.family, std::string(toString(row.loop)).c_str());
        for (const auto &[key, golden] : row.raw) {
            const ScaledGains::Row *const made = rowOf(*scaled, key);
            ASSERT_NE(made, nullptr) << key;
            EXPECT_EQ(static_cast<double>(made->raw), std::round(golden * divisor)) << key;
            std::printf(" %s %lld", key.c_str(), static_cast<long long>(made->raw));
        }
        std::printf("%s\n", divisor == 1.0 ? "" : (", over " + std::to_string(std::llround(divisor))).c_str());
    }
}

/// The worst of all families, loops and gains, in steps of the integer; and back it is what was made.
TEST(Acceptance, A08_AGainComesBackWithinHalfAStepOfItsInteger)
{
    double worst = 0.0;
    for (const GoldenGains &row : goldenGains()) {
        const ExperimentBench bench(row.link, row.family, row.address);
        calibrate(*bench.device);
        const Family &family = bench.device->family();
        for (const double factor : {0.19, 0.37, 1.0, 1.73, 2.9}) {
            const ContinuousGains asked{
                factor * row.gains.p, factor * row.gains.i, factor * row.gains.d, factor * row.gains.f};
            const auto scaled = scaleGains(*bench.device, row.loop, 1, row.slot, asked, row.tried);
            ASSERT_TRUE(scaled) << row.family << ' ' << factor << ": " << scaled.error().text();
            KnownGains numbers = numbersOf(family, row, *scaled);
            const auto back
                = gainsMadeBy(family, bench.device->knowledge().profile(), row.loop, 1, row.slot, numbers, row.tried);
            ASSERT_TRUE(back) << row.family;
            for (const auto &[role, gain] : {std::pair(Role::Proportional, &ContinuousGains::p),
                     std::pair(Role::Integral, &ContinuousGains::i), std::pair(Role::Derivative, &ContinuousGains::d),
                     std::pair(Role::FeedForward, &ContinuousGains::f)}) {
                const auto made = std::find_if(scaled->rows.begin(), scaled->rows.end(),
                    [wanted = role](const ScaledGains::Row &one) { return one.role == wanted; });
                if (made == scaled->rows.end() || made->raw == 0) {
                    EXPECT_EQ(asked.*gain, 0.0) << row.family;
                    continue;
                }
                const double step = std::abs(scaled->made.*gain / static_cast<double>(made->raw));
                const double off = std::abs(asked.*gain - scaled->made.*gain) / step;
                EXPECT_LE(off, 0.5 + 1e-6) << row.family << ' ' << made->key;
                EXPECT_NEAR(back->made.*gain, scaled->made.*gain, 1e-9 * std::abs(scaled->made.*gain)) << made->key;
                worst = std::max(worst, off);
            }
            numbers.front().second.reset();
            EXPECT_FALSE(
                gainsMadeBy(family, bench.device->knowledge().profile(), row.loop, 1, row.slot, numbers, row.tried))
                << "one is not known";
        }
    }
    std::printf("A8 a gain is at most %.3f steps from what was asked for\n", worst);
    EXPECT_GT(worst, 0.2) << "they were exact by chance";
}

TEST(GainScale, RefusesAGainOfTooFewSteps)
{
    ExperimentBench bench;
    const auto gains = scaleGains(*bench.device, Mode::Velocity, 1, 0, {1e-10, 0.0, 0.0, 0.0});
    ASSERT_FALSE(gains);
    EXPECT_EQ(gains.error().fault, Fault::OutOfRange);
}

} // namespace
} // namespace mb::tuning
