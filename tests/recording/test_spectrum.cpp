// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/spectrum.h"
#include "signals.h"

#include <gtest/gtest.h>

#include <complex>
#include <numbers>
#include <random>

namespace mb {
namespace {

using namespace test;

std::vector<Point> wave(int count, double frequency, double amplitude, double offset = 0.0)
{
    std::vector<Point> points;
    for (int i = 0; i < count; ++i)
        points.push_back({ms(i), offset + amplitude * std::sin(2.0 * std::numbers::pi * frequency * i / 1000.0)});
    return points;
}

TEST(Spectrum, AWaveHasItsFrequencyAndItsAmplitude)
{
    const auto spectrum = spectrumOf(wave(2000, 50.0, 3.0, 1000.0));
    ASSERT_TRUE(spectrum);
    EXPECT_NEAR(spectrum->rate, 1000.0, 1e-6);
    EXPECT_NEAR(spectrum->resolution, 0.5, 1e-9);
    EXPECT_NEAR(spectrum->frequency(spectrum->peak()), 50.0, 1e-6);
    EXPECT_NEAR(spectrum->amplitude[spectrum->peak()], 3.0, 1e-3);
    EXPECT_EQ(spectrum->amplitude[0], 0.0);
    EXPECT_LT(spectrum->amplitude[200], 1e-3); // 100 Hz
    EXPECT_FALSE(spectrum->shortened);
}

TEST(Spectrum, AgreesWithTheDefinitionForAnyLength)
{
    std::mt19937 random(1);
    std::normal_distribution<double> noise;
    for (const int count : {16, 97, 128, 211}) { // primes, too
        std::vector<Point> points;
        double mean = 0.0;
        for (int i = 0; i < count; ++i) {
            points.push_back({ms(i), noise(random)});
            mean += points.back().value / count;
        }
        const auto spectrum = spectrumOf(points);
        ASSERT_TRUE(spectrum);
        for (int k = 1; k <= count / 2; ++k) {
            std::complex<double> sum;
            for (int i = 0; i < count; ++i) {
                const double turn = 2.0 * std::numbers::pi * i / count;
                sum += (points[static_cast<std::size_t>(i)].value - mean) * 0.5 * (1.0 - std::cos(turn))
                    * std::polar(1.0, -turn * k);
            }
            EXPECT_NEAR(spectrum->amplitude[static_cast<std::size_t>(k)], std::abs(sum) * 2.0 / (count / 2.0), 1e-9);
        }
    }
}

TEST(Spectrum, OnlyWhatConnectsIsTaken)
{
    auto points = wave(1000, 50.0, 1.0);
    points[300].value = std::numeric_limits<double>::quiet_NaN();
    const auto spectrum = spectrumOf(points);
    ASSERT_TRUE(spectrum);
    EXPECT_TRUE(spectrum->shortened);
    EXPECT_EQ(spectrum->from, ms(301));
    EXPECT_EQ(spectrum->to, ms(999));
    EXPECT_NEAR(spectrum->frequency(spectrum->peak()), 50.0, spectrum->resolution);
}

TEST(Spectrum, TooFewSamplesAreRefused)
{
    EXPECT_FALSE(spectrumOf({}));
    EXPECT_FALSE(spectrumOf(wave(15, 1.0, 1.0)));
    EXPECT_FALSE(spectrumOf(std::vector<Point>(100, Point{ms(1), 2.0}))); // all at one time
    EXPECT_TRUE(spectrumOf(wave(16, 1.0, 1.0)));
}

TEST(Spectrum, UnevenTimesAreBroughtToAGrid)
{
    std::mt19937 random(2);
    std::uniform_int_distribution<int> jitter(-200, 200);
    std::vector<Point> points;
    for (int i = 0; i < 4000; ++i) {
        const Instant time = ms(i) + std::chrono::microseconds(jitter(random));
        const double seconds = std::chrono::duration<double>(time.time_since_epoch()).count();
        points.push_back({time, std::sin(2.0 * std::numbers::pi * 20.0 * seconds)});
    }
    const auto spectrum = spectrumOf(points);
    ASSERT_TRUE(spectrum);
    EXPECT_NEAR(spectrum->frequency(spectrum->peak()), 20.0, 0.5);
    EXPECT_NEAR(
        spectrum->amplitude[spectrum->peak()], 1.0, 0.15); // between two lines of the spectrum a little is missing
}

} // namespace
} // namespace mb
