// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/gainscale.h"

#include "model/family.h"
#include "model/loopparameters.h"
#include "model/parameterfile.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mb::tuning {
namespace {

constexpr double leastSteps = 10.0;
constexpr double largestDivisor = 1e9;

struct Term {
    Role role;
    double ContinuousGains::*gain;
    double scale; ///< parameter's number for a gain of 1
};
using Terms = std::array<Term, 4>;

/// What a gain of 1 of each is as a parameter's number; 0: not known, or the loop has none.
Terms termsOf(double p, double i, double d, double f)
{
    return {{{Role::Proportional, &ContinuousGains::p, p}, {Role::Integral, &ContinuousGains::i, i},
        {Role::Derivative, &ContinuousGains::d, d}, {Role::FeedForward, &ContinuousGains::f, f}}};
}

const Term *termOf(const Terms &terms, Role role)
{
    const auto found = std::ranges::find(terms, role, &Term::role);
    return found == terms.end() ? nullptr : &*found;
}

/// Of a device whose scales are calibrated; 0 for what is not known.
double calibratedScale(const Family &family, const DeviceProfile &profile, Mode loop, Role gain)
{
    for (const Calibration &row : family.calibrations) {
        const double one = row.loop == loop && row.gain == gain ? profile.calibrated(row.key) : 0.0;
        if (one > 0.0)
            return 1.0 / one;
    }
    return 0.0;
}

Terms termsOf(const TriedScale &tried)
{
    return termsOf(1.0 / tried.p, tried.i > 0.0 ? 1.0 / tried.i : 0.0, 1.0 / tried.d, 0.0);
}

Terms termsOf(const Family &family, const DeviceProfile &profile, Mode loop, double units)
{
    const LoopScale &scale = *family.loop;
    if (scale.calibrated) {
        const double full = scale.fullDuty;
        const auto one = [&](Role gain) { return calibratedScale(family, profile, loop, gain); };
        return termsOf(full * one(Role::Proportional), full * scale.period * one(Role::Integral),
            full / scale.period * one(Role::Derivative), 0.0);
    }
    const double p = scale.fullDuty / units;
    const double sign = scale.derivativeInverted ? -1.0 : 1.0;
    return termsOf(p, p * scale.period, sign * p / scale.period, p);
}

/// The nearest number that the parameter has; OutOfRange beyond its ends.
Result<std::int64_t> nearest(const Parameter &parameter, double number)
{
    return toRaw(parameter, std::round(number * parameter.one) / parameter.one);
}

/// The largest power of ten with which every gain fits its parameter; 1 where none does.
double divisorFor(
    const Family &family, const std::vector<ParameterIndex> &rows, const Terms &terms, const ContinuousGains &gains)
{
    for (double divisor = largestDivisor; divisor > 1.0; divisor /= 10.0) {
        const bool fits = std::ranges::all_of(rows, [&](ParameterIndex index) {
            const Parameter &parameter = family.parameters[index.value];
            const Term *const term = termOf(terms, parameter.role);
            return !term || nearest(parameter, gains.*term->gain * term->scale * divisor);
        });
        if (fits)
            return divisor;
    }
    return 1.0;
}

Result<void> add(const Family &family, ParameterIndex index, double number, ScaledGains &into)
{
    const Parameter &parameter = family.parameters[index.value];
    const std::string key(parameter.key);
    const auto raw = nearest(parameter, number);
    if (!raw)
        return fail(Fault::OutOfRange, say("%1 would have to be %2, which it cannot be", key, number),
            say("aim for a calmer loop"));
    const Value value = toValue(parameter, *raw);
    into.rows.push_back({key, *raw, std::get<double>(value), parameter.role});
    into.changes.push_back({index, *raw});
    return {};
}

Result<void> addGain(const Family &family, ParameterIndex index, double number, ScaledGains &into)
{
    MB_TRY_VOID(add(family, index, number, into));
    const std::string key(family.parameters[index.value].key);
    const double steps = std::abs(static_cast<double>(into.rows.back().raw));
    if (number != 0.0 && steps < leastSteps)
        return fail(Fault::OutOfRange,
            say("%1 would be %2 of its smallest steps, too few to mean anything", key, into.rows.back().raw),
            say("take a finer encoder or a calmer loop"));
    return {};
}

std::optional<double> numberOf(const KnownGains &numbers, std::string_view key)
{
    const auto found = std::ranges::find_if(numbers, [&](const auto &entry) { return entry.first == key; });
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
        if (row.loop == loop && isGain(row.gain) && profile.calibrated(row.key) <= 0.0)
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
    MB_TRY_VOID(checkScales(family, profile, loop));
    const auto terms = tried ? termsOf(*tried) : termsOf(family, profile, loop, *units);
    const auto rows = loopParameters(family, *parameters, axis, slot);
    if (rows.empty())
        return fail(Fault::Unsupported,
            say("%1 has no %2", family.key,
                gainKey(family, std::string(parameters->prefix) + std::string(parameters->names.front()), axis, slot)));
    const double divisor = family.loop && family.loop->divided ? divisorFor(family, rows, terms, gains) : 1.0;
    ScaledGains scaled;
    for (const ParameterIndex index : rows) {
        const Role role = family.parameters[index.value].role;
        if (role == Role::Divisor) {
            MB_TRY_VOID(add(family, index, divisor, scaled));
        } else if (const Term *const term = termOf(terms, role)) {
            MB_TRY_VOID(addGain(family, index, gains.*term->gain * term->scale * divisor, scaled));
            if (term->scale != 0.0)
                scaled.made.*term->gain = scaled.rows.back().number / (term->scale * divisor);
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
    return std::ranges::equal(a.rows, b.rows,
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
    const bool isDivided = family.loop && family.loop->divided;
    const auto by = isDivided ? parameterOf(family, loop, axis, slot, Role::Divisor) : std::nullopt;
    const double divisor
        = isDivided ? numberOf(numbers, by ? family.parameters[by->value].key : "").value_or(0.0) : 1.0;
    const auto rows = loopParameters(family, *parameters, axis, slot);
    if (divisor <= 0.0 || rows.size() < parameters->names.size())
        return std::nullopt;
    ScaledGains made;
    for (const ParameterIndex index : rows) {
        const Parameter &parameter = family.parameters[index.value];
        const auto number = numberOf(numbers, parameter.key);
        const auto raw = number ? toRaw(parameter, *number) : Result<std::int64_t>();
        if (!number || !raw)
            return std::nullopt;
        made.rows.push_back({std::string(parameter.key), *raw, *number, parameter.role});
        made.changes.push_back({index, *raw});
        const Term *const term = termOf(terms, parameter.role);
        if (!term)
            continue;
        if (term->scale == 0.0 && *number != 0.0)
            return std::nullopt;
        made.made.*(term->gain) = term->scale != 0.0 ? *number / (term->scale * divisor) : 0.0;
    }
    return made;
}

} // namespace mb::tuning
