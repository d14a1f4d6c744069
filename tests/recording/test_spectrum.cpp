// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/spectrum.h"
#include "signals.h"

#include <gtest/gtest.h>

#include <complex>
#include <functional>
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
    ASSERT_TRUE(spectrum->peak());
    EXPECT_NEAR(spectrum->frequency(*spectrum->peak()), 50.0, 1e-6);
    EXPECT_NEAR(spectrum->amplitude[*spectrum->peak()], 3.0, 1e-3);
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
        double weights = 0.0;
        double mean = 0.0;
        double slope = 0.0;
        double squares = 0.0;
        const auto place = [count](int i) { return static_cast<double>(i) / count - 0.5; };
        for (int i = 0; i < count; ++i) {
            points.push_back({ms(i), noise(random)});
            const double weight = 0.5 * (1.0 - std::cos(2.0 * std::numbers::pi * i / count));
            weights += weight;
            mean += weight * points.back().value;
            slope += weight * place(i) * points.back().value;
            squares += weight * place(i) * place(i);
        }
        const auto spectrum = spectrumOf(points);
        ASSERT_TRUE(spectrum);
        for (int k = 1; k <= count / 2; ++k) {
            std::complex<double> sum;
            for (int i = 0; i < count; ++i) {
                const double turn = 2.0 * std::numbers::pi * i / count;
                sum += (points[static_cast<std::size_t>(i)].value - mean / weights - slope / squares * place(i)) * 0.5
                    * (1.0 - std::cos(turn)) * std::polar(1.0, -turn * k);
            }
            EXPECT_NEAR(spectrum->amplitude[static_cast<std::size_t>(k)], std::abs(sum) * 2.0 / (count / 2.0), 1e-9);
        }
    }
}

TEST(Spectrum, WhatHasNoFrequencyHasNoPeak)
{
    const auto made = [](const std::function<double(double)> &of) {
        std::vector<Point> points;
        for (int i = 0; i < 4000; ++i)
            points.push_back({ms(i), of(i / 1000.0)});
        return spectrumOf(points).value();
    };
    std::mt19937 random(3);
    std::normal_distribution<double> noise;
    const std::vector<std::pair<const char *, std::function<double(double)>>> shapes{
        {"silence", [](double) { return 0.0; }},
        {"a constant", [](double) { return 1234.5; }},
        {"a ramp", [](double t) { return 60'000.0 * t + 7.0; }},
        {"a step", [](double t) { return t < 1.3 ? 0.0 : 60'000.0; }},
        {"a step of a loop", [](double t) { return t < 1.3 ? 0.0 : 60'000.0 * (1.0 - std::exp((1.3 - t) / 0.05)); }},
        {"a step and the one back", [](double t) { return t < 1.3 || t > 2.2 ? 0.0 : 60'000.0; }},
        {"noise", [&](double) { return noise(random); }},
    };
    for (const auto &[name, shape] : shapes) {
        const auto spectrum = made(shape);
        EXPECT_FALSE(spectrum.peak()) << name << ": " << spectrum.frequency(spectrum.peak().value_or(0)) << " Hz";
    }
}

TEST(Spectrum, ARippleIsFoundBesideAStepThatIsThirtyTimesLarger)
{
    auto points = wave(4000, 37.0, 600.0);
    for (std::size_t i = 1300; i < points.size(); ++i)
        points[i].value += 20'000.0;
    const auto spectrum = spectrumOf(points);
    ASSERT_TRUE(spectrum && spectrum->peak());
    EXPECT_NEAR(spectrum->frequency(*spectrum->peak()), 37.0, spectrum->resolution);
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
    ASSERT_TRUE(spectrum->peak());
    EXPECT_NEAR(spectrum->frequency(*spectrum->peak()), 50.0, spectrum->resolution);
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
    ASSERT_TRUE(spectrum->peak());
    EXPECT_NEAR(spectrum->frequency(*spectrum->peak()), 20.0, 0.5);
    EXPECT_NEAR(
        spectrum->amplitude[*spectrum->peak()], 1.0, 0.15); // between two lines of the spectrum a little is missing
}

} // namespace
} // namespace mb
