// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/gainscale.h"

#include "model/family.h"
#include "model/parameterfile.h"
#include "tuning/envelope.h"
#include "tuning/gains.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace mb::tuning {
namespace {

constexpr double leastSteps = 10.0;
constexpr double fineSteps = 50.0;
constexpr double largestDivisor = 1e9;

struct Term {
    std::string_view name;
    double ContinuousGains::*gain;
    double scale; ///< parameter's number for a gain of 1
};

std::string scaleKey(Mode loop, std::string_view gain)
{
    return std::string(toString(loop)) + '.' + std::string(gain) + ".scale";
}

/// Of a device whose scales are calibrated; 0 for what is not known.
double calibratedScale(const DeviceProfile &profile, Mode loop, std::string_view gain)
{
    const double one = profile.calibrated(scaleKey(loop, gain));
    return one > 0.0 ? 1.0 / one : 0.0;
}

std::array<Term, 4> termsOf(const TriedScale &tried)
{
    return {{{"p", &ContinuousGains::p, 1.0 / tried.p}, {"i", &ContinuousGains::i, tried.i > 0.0 ? 1.0 / tried.i : 0.0},
        {"d", &ContinuousGains::d, 1.0 / tried.d}, {"f", &ContinuousGains::f, 0.0}}};
}

std::array<Term, 4> termsOf(const Family &family, const DeviceProfile &profile, Mode loop, double units)
{
    const LoopScale &scale = *family.loop;
    if (scale.calibrated) {
        const double full = scale.fullDuty;
        return {{{"p", &ContinuousGains::p, full * calibratedScale(profile, loop, "p")},
            {"i", &ContinuousGains::i, full * scale.period * calibratedScale(profile, loop, "i")},
            {"d", &ContinuousGains::d, full / scale.period * calibratedScale(profile, loop, "d")},
            {"f", &ContinuousGains::f, 0.0}}};
    }
    const double p = scale.fullDuty / units;
    const double sign = scale.derivativeInverted ? -1.0 : 1.0;
    return {{{"p", &ContinuousGains::p, p}, {"i", &ContinuousGains::i, p * scale.period},
        {"d", &ContinuousGains::d, sign * p / scale.period}, {"f", &ContinuousGains::f, p}}};
}

/// The nearest number that the parameter has; OutOfRange beyond its ends.
Result<std::int64_t> nearest(const Parameter &parameter, double number)
{
    return toRaw(parameter, std::round(number * parameter.one) / parameter.one);
}

/// The largest power of ten with which every gain fits its parameter; 1 where none does.
double divisorFor(const Family &family, const std::function<std::string(std::string_view)> &keyOf,
    const std::array<Term, 4> &terms, const ContinuousGains &gains)
{
    for (double divisor = largestDivisor; divisor > 1.0; divisor /= 10.0) {
        const bool fits = std::all_of(terms.begin(), terms.end(), [&](const Term &term) {
            const auto index = findParameter(family.parameters, keyOf(term.name));
            return !index || nearest(family.parameters[index->value], gains.*term.gain * term.scale * divisor);
        });
        if (fits)
            return divisor;
    }
    return 1.0;
}

Result<void> add(const Family &family, const std::string &key, double number, ScaledGains &into)
{
    const auto index = findParameter(family.parameters, key);
    if (!index)
        return fail(Fault::Unsupported, say("%1 has no %2", family.key, key));
    const auto raw = nearest(family.parameters[index->value], number);
    if (!raw)
        return fail(Fault::OutOfRange, say("%1 would have to be %2, which it cannot be", key, number),
            say("aim for a calmer loop"));
    const Value value = toValue(family.parameters[index->value], *raw);
    into.rows.push_back({key, *raw, std::get<double>(value)});
    into.changes.push_back({*index, *raw});
    return {};
}

Result<void> addGain(const Family &family, const std::string &key, double number, ScaledGains &into)
{
    if (auto added = add(family, key, number, into); !added)
        return added;
    const double steps = std::abs(static_cast<double>(into.rows.back().raw));
    if (number != 0.0 && steps < leastSteps)
        return fail(Fault::OutOfRange,
            say("%1 would be %2 of its smallest steps, too few to mean anything", key, into.rows.back().raw),
            say("take a finer encoder or a calmer loop"));
    if (number != 0.0 && steps < fineSteps)
        into.coarse.push_back(key);
    return {};
}

std::optional<double> numberOf(const KnownGains &numbers, const std::string &key)
{
    const auto found
        = std::find_if(numbers.begin(), numbers.end(), [&key](const auto &known) { return known.first == key; });
    return found == numbers.end() ? std::nullopt : found->second;
}

} // namespace

std::optional<double> loopUnits(const Family &family, Mode loop)
{
    if (!family.loop)
        return std::nullopt;
    if (loop == Mode::Velocity)
        return family.loop->velocityTime;
    if (loop == Mode::Current)
        return family.loop->currentError == "A" ? std::optional(1.0) : std::nullopt;
    return loop == Mode::Position ? std::optional(1.0) : std::nullopt;
}

Result<void> checkScales(const Device &device, Mode loop)
{
    return checkScales(device.family(), device.knowledge().profile(), loop);
}

Result<void> checkScales(const Family &family, const DeviceProfile &profile, Mode loop)
{
    if (!family.loop || !family.loop->calibrated)
        return {};
    for (const Calibration &row : family.calibrations) {
        const bool ofThisLoop = row.key.starts_with(std::string(toString(loop)) + '.') && row.key.ends_with(".scale");
        if (ofThisLoop && profile.calibrated(row.key) <= 0.0)
            return fail(Fault::OutOfRange, say("what a raw gain of this board puts out is not known (%1)", row.key),
                say("find its gain scales first: Overview, Find the gain scales"));
    }
    return {};
}

Result<ScaledGains> scaleGains(const Device &device, Mode loop, int axis, int slot, const ContinuousGains &gains,
    const std::optional<TriedScale> &tried)
{
    return scaleGains(device.family(), device.knowledge().profile(), loop, axis, slot, gains, tried);
}

Result<ScaledGains> scaleGains(const Family &family, const DeviceProfile &profile, Mode loop, int axis, int slot,
    const ContinuousGains &gains, const std::optional<TriedScale> &tried)
{
    const LoopGains *const parameters = loopOf(family, loop);
    const auto units = loopUnits(family, loop);
    if (!parameters || (!units && !tried))
        return fail(Fault::Unsupported, say("what a gain of %1 means in this loop is not known", family.title),
            say("tune it by hand with 'motorbenchctl step'"));
    if (auto known = checkScales(family, profile, loop); !known)
        return fail(known.error());
    const auto terms = tried ? termsOf(*tried) : termsOf(family, profile, loop, *units);
    const auto keyOf = [&](std::string_view name) {
        return gainKey(family, std::string(parameters->prefix) + std::string(name), axis, slot);
    };
    const double divisor = family.loop && family.loop->divided ? divisorFor(family, keyOf, terms, gains) : 1.0;
    ScaledGains scaled;
    for (const std::string_view name : parameters->names) {
        const std::string key = keyOf(name);
        if (name == "divisor") {
            if (auto added = add(family, key, divisor, scaled); !added)
                return fail(added.error());
            continue;
        }
        for (const Term &term : terms) {
            if (term.name != name)
                continue;
            if (auto added = addGain(family, key, gains.*term.gain * term.scale * divisor, scaled); !added)
                return fail(added.error());
            if (term.scale != 0.0)
                scaled.made.*term.gain = scaled.rows.back().number / (term.scale * divisor);
        }
    }
    return scaled;
}

KnownGains knownGains(
    const Family &family, Mode loop, int axis, int slot, std::span<const ParameterStore::Entry> entries)
{
    KnownGains known;
    const LoopGains *const parameters = loopOf(family, loop);
    if (!parameters)
        return known;
    for (const std::string_view name : parameters->names) {
        const std::string key = gainKey(family, std::string(parameters->prefix) + std::string(name), axis, slot);
        const auto index = findParameter(family.parameters, key);
        if (!index)
            continue;
        const ParameterStore::Entry entry
            = index->value < entries.size() ? entries[index->value] : ParameterStore::Entry();
        std::optional<double> number;
        if (entry.raw && entry.state != ParameterState::Unknown && entry.state != ParameterState::Failed) {
            const Value value = toValue(family.parameters[index->value], *entry.raw);
            if (const double *const plain = std::get_if<double>(&value))
                number = *plain;
        }
        known.emplace_back(key, number);
    }
    return known;
}

bool isSameSet(const ScaledGains &a, const ScaledGains &b)
{
    return std::equal(a.rows.begin(), a.rows.end(), b.rows.begin(), b.rows.end(),
        [](const auto &one, const auto &other) { return one.key == other.key && one.raw == other.raw; });
}

std::optional<ScaledGains> gainsMadeBy(const Family &family, const DeviceProfile &profile, Mode loop, int axis,
    int slot, const KnownGains &numbers, const std::optional<TriedScale> &tried)
{
    const LoopGains *const parameters = loopOf(family, loop);
    const auto units = loopUnits(family, loop);
    if (!parameters || (!units && !tried) || !checkScales(family, profile, loop))
        return std::nullopt;
    const auto terms = tried ? termsOf(*tried) : termsOf(family, profile, loop, *units);
    const auto keyOf = [&](std::string_view name) {
        return gainKey(family, std::string(parameters->prefix) + std::string(name), axis, slot);
    };
    const bool isDivided = family.loop && family.loop->divided;
    const double divisor = isDivided ? numberOf(numbers, keyOf("divisor")).value_or(0.0) : 1.0;
    if (divisor <= 0.0)
        return std::nullopt;
    ScaledGains made;
    for (const std::string_view name : parameters->names) {
        const std::string key = keyOf(name);
        const auto index = findParameter(family.parameters, key);
        const auto number = numberOf(numbers, key);
        const auto raw = index && number ? toRaw(family.parameters[index->value], *number) : Result<std::int64_t>();
        if (!index || !number || !raw)
            return std::nullopt;
        made.rows.push_back({key, *raw, *number});
        made.changes.push_back({*index, *raw});
        const auto term
            = std::find_if(terms.begin(), terms.end(), [name](const Term &known) { return known.name == name; });
        if (term == terms.end())
            continue;
        if (term->scale == 0.0 && *number != 0.0)
            return std::nullopt;
        made.made.*(term->gain) = term->scale != 0.0 ? *number / (term->scale * divisor) : 0.0;
    }
    return made;
}

} // namespace mb::tuning
