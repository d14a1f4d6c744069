// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/stimulus.h"

#include "model/parameter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace mb::tuning {
namespace {

constexpr std::array<std::pair<Profile, std::string_view>, 6> names{{
    {Profile::Step, "step"},
    {Profile::Square, "square"},
    {Profile::Ramp, "ramp"},
    {Profile::Sine, "sine"},
    {Profile::Chirp, "chirp"},
    {Profile::Prbs, "prbs"},
}};

constexpr double longestHold = 5.0; ///< s; a loop that has not settled then is measured as it is
constexpr double rampTime = 1.0;
constexpr double squarePeriod = 2.0;
constexpr int squareSwings = 2;
constexpr double sinePeriod = 1.0;
constexpr int sineSwings = 6;
constexpr double chirpLow = 0.1;
constexpr double chirpHigh = 15.0;
constexpr double chirpTime = 30.0;
constexpr double prbsBitTime = 0.125;
constexpr int prbsLength = 127;
constexpr double beatsPerSwing = 10.0; ///< a swing of fewer is no sine any more

constexpr std::array<bool, prbsLength> prbsBits = [] {
    std::array<bool, prbsLength> bits{};
    unsigned state = 0x7F;
    for (bool &bit : bits) {
        bit = (state & 1U) != 0;
        state = (state << 1U | ((state >> 6U ^ state >> 5U) & 1U)) & 0x7FU; // x^7 + x^6 + 1
    }
    return bits;
}();

tl::unexpected<Error> tooFine(const Stimulus &stimulus, const Message &what, double seconds, double beat)
{
    return fail(Fault::OutOfRange,
        say("%1: %2 of %3 ms is finer than the device follows, which takes a set-point every %4 ms",
            toString(stimulus.profile), what, std::round(seconds * 1e6) / 1e3, beat * 1e3),
        say("give it a longer time"));
}

Result<Stimulus> checked(const Stimulus &stimulus, double beat)
{
    if (stimulus.time < 2.0 * beat)
        return tooFine(stimulus, say("a time"), stimulus.time, beat);
    switch (stimulus.profile) {
    case Profile::Square:
        if (stimulus.hold() < 2.0 * beat)
            return tooFine(stimulus, say("a half swing"), stimulus.hold(), beat);
        break;
    case Profile::Sine:
        if (stimulus.period < beatsPerSwing * beat)
            return tooFine(stimulus, say("a swing"), stimulus.period, beat);
        break;
    case Profile::Chirp:
        if (stimulus.low * stimulus.time < 1.0)
            return fail(Fault::OutOfRange, say("chirp: %1 s hold no whole swing of %2 Hz", stimulus.time, stimulus.low),
                say("give at least %1 s", 1.0 / stimulus.low));
        break;
    case Profile::Prbs:
        if (stimulus.period < 2.0 * beat)
            return tooFine(stimulus, say("a bit"), stimulus.period, beat);
        break;
    case Profile::Step:
    case Profile::Ramp: break;
    }
    return stimulus;
}

} // namespace

std::string_view toString(Profile profile)
{
    return std::ranges::find_if(names, [&](const auto &entry) { return entry.first == profile; })->second;
}

std::optional<Profile> profileFromString(std::string_view text)
{
    const auto found = std::ranges::find_if(names, [&](const auto &entry) { return entry.second == text; });
    return found == names.end() ? std::nullopt : std::optional(found->first);
}

Result<Stimulus> Stimulus::make(Profile profile, double from, double to, std::optional<double> seconds, double beat)
{
    Stimulus stimulus;
    stimulus.profile = profile;
    stimulus.from = from;
    stimulus.to = to;
    switch (profile) {
    case Profile::Step:
        stimulus.time = seconds.value_or(longestHold);
        stimulus.ends = !seconds;
        break;
    case Profile::Ramp: stimulus.time = seconds.value_or(rampTime); break;
    case Profile::Square:
        stimulus.time = seconds.value_or(squareSwings * squarePeriod);
        stimulus.period = stimulus.time / squareSwings;
        break;
    case Profile::Sine:
        stimulus.time = seconds.value_or(sineSwings * sinePeriod);
        stimulus.period = stimulus.time / sineSwings;
        break;
    case Profile::Chirp:
        stimulus.time = seconds.value_or(chirpTime);
        stimulus.low = chirpLow;
        stimulus.high = std::min(chirpHigh, 0.1 / beat);
        break;
    case Profile::Prbs:
        stimulus.time = seconds.value_or(prbsLength * prbsBitTime);
        stimulus.period = stimulus.time / prbsLength;
        break;
    }
    return checked(stimulus, beat);
}

double Stimulus::at(double t) const
{
    if (t < 0.0 || t >= length())
        return from;
    const double middle = (from + to) / 2.0;
    const double half = (from - to) / 2.0;
    switch (profile) {
    case Profile::Step: return to;
    case Profile::Ramp: return t < time ? from + (to - from) * t / time : to;
    case Profile::Square: return std::fmod(t, period) < period / 2.0 ? to : from;
    case Profile::Sine: return middle + half * std::cos(2.0 * std::numbers::pi * t / period);
    case Profile::Chirp: {
        const double growth = std::log(high / low) / time;
        const double phase = 2.0 * std::numbers::pi * low * std::expm1(growth * t) / growth;
        return middle + half * std::cos(phase);
    }
    case Profile::Prbs: return prbsBit(static_cast<int>(t / period)) ? to : from;
    }
    return from;
}

double Stimulus::length() const
{
    return profile == Profile::Ramp && !ends ? time + rampTime : time; // what it reached is held
}

std::vector<double> Stimulus::edges() const
{
    if (profile == Profile::Step)
        return {0.0};
    std::vector<double> found;
    for (double t = 0.0; profile == Profile::Square && t < time - period / 2.0; t += period)
        found.push_back(t);
    return found;
}

bool Stimulus::glides() const
{
    return profile == Profile::Ramp || profile == Profile::Sine || profile == Profile::Chirp;
}

bool prbsBit(int index)
{
    return prbsBits[static_cast<std::size_t>(index % prbsLength)];
}

} // namespace mb::tuning
