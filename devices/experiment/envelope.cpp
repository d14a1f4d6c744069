// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/envelope.h"

#include "experiment/motiontimes.h"
#include "model/axis.h"
#include "model/family.h"
#include "model/loopparameters.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mb::tuning {
namespace {

constexpr double wayStep = 0.01; ///< s, in which the way of a stimulus is summed up

std::optional<double> narrower(std::optional<double> a, std::optional<double> b)
{
    if (!a || !b)
        return a ? a : b;
    return std::min(*a, *b);
}

using Entries = std::span<const ParameterStore::Entry>;

/// In force now, as far as it is known.
std::optional<double> numberOf(const Family &family, Entries entries, const std::string &key)
{
    const auto index = findParameter(family.parameters, key);
    if (!index || index->value >= entries.size() || !entries[index->value].raw)
        return std::nullopt;
    const Value value = toValue(family.parameters[index->value], *entries[index->value].raw);
    if (const bool *on = std::get_if<bool>(&value))
        return *on ? 1.0 : 0.0;
    const double *number = std::get_if<double>(&value);
    return number ? std::optional(*number) : std::nullopt;
}

/// Read where that can be; else it is as last written.
Task<void> refresh(Device &device, std::string key)
{
    const auto index = findParameter(device.family().parameters, key);
    if (index && device.parameters().parameter(*index).access != Access::WriteOnly && device.offers(*index))
        co_await device.read(*index);
    co_return {};
}

void apply(Envelope &envelope, const DeviceLimit &limit, double value, double position, std::optional<double> &other)
{
    switch (limit.bounds) {
    case DeviceLimit::Bounds::Speed: envelope.speed = value; break;
    case DeviceLimit::Bounds::Current: envelope.current = value; break;
    case DeviceLimit::Bounds::Duty: envelope.duty = std::abs(value); break;
    case DeviceLimit::Bounds::Position:
        if (other) // both sides are closed
            envelope.travel = std::max(0.0, std::min(*other, std::abs(value - position)));
        other = std::abs(value - position);
        break;
    }
}

std::string together(const std::vector<std::string> &options)
{
    std::string list;
    for (const std::string &option : options)
        list += (list.empty() ? "" : " and ") + option;
    return list;
}

tl::unexpected<Error> outside(const Message &what, double value, double limit)
{
    const auto rounded = [](double number) { return std::round(number * 1000.0) / 1000.0; };
    return fail(Fault::OutOfRange,
        say("%1 %2 is outside the envelope, which ends at %3", what, rounded(value), rounded(limit)),
        say("take a smaller step or widen it"));
}

/// Of a loop that follows at once, which is at X before each stimulus and after it.
double wayOf(const Stimulus &stimulus, int repeat, double gone)
{
    const double atStart = stimulus.from * secondsAtStart(0.0, stimulus.length(), repeat);
    double way = 0.0;
    double farthest = std::abs(gone);
    for (double t = 0.0; t < stimulus.length(); t += wayStep) {
        way += stimulus.at(t) * wayStep;
        for (const double before : {0.0, atStart})
            farthest = std::max(farthest, std::abs(gone + before + way * repeat));
    }
    return farthest;
}

} // namespace

std::optional<ChannelIndex> axisChannel(const Device &device, std::string_view key, int axis)
{
    if (device.family().capabilities.axes > 1) {
        if (const auto own = device.telemetry()->find(axisKey(axis, key)))
            return own;
    }
    return device.telemetry()->find(key);
}

bool hasCurrentScale(const Device &device, int axis)
{
    const auto channel = axisChannel(device, "current", axis);
    return channel && device.telemetry()->channels()[channel->value].unit == "A";
}

std::string_view measuredOf(Mode mode)
{
    if (mode == Mode::Position)
        return "position";
    return mode == Mode::Current ? "current" : "velocity";
}

bool isClosedLoop(Mode mode)
{
    return mode == Mode::Position || mode == Mode::Velocity || mode == Mode::Current;
}

Envelope ownLimits(const Family &family, Entries entries, int axis, int slot, double position,
    const std::vector<ParameterChange> &changes)
{
    std::vector<ParameterStore::Entry> inForce(entries.begin(), entries.end());
    for (const ParameterChange &change : changes) {
        if (change.index.value < inForce.size())
            inForce[change.index.value].raw = change.raw;
    }
    Envelope envelope;
    std::optional<double> otherSide;
    for (const DeviceLimit &limit : family.trials->limits) {
        const bool on = limit.enabled.empty()
            || numberOf(family, inForce, gainKey(family, limit.enabled, axis, slot)).value_or(0.0) != 0.0;
        const auto value = on ? numberOf(family, inForce, gainKey(family, limit.key, axis, slot)) : std::nullopt;
        if (value)
            apply(envelope, limit, *value / limit.one, position, otherSide);
    }
    return envelope;
}

Task<Envelope> readOwnLimits(Device &device, int axis, int slot, double position, std::vector<ParameterChange> changes)
{
    const Family &family = device.family();
    for (const DeviceLimit &limit : family.trials->limits) {
        for (const std::string_view key : {limit.enabled, limit.key})
            co_await refresh(device, gainKey(family, key, axis, slot));
    }
    co_return ownLimits(family, device.parameters().entries(), axis, slot, position, changes);
}

Result<void> checkBound(const EnvelopeBound &bound, double value)
{
    if (isBound(bound, value))
        return {};
    return fail(Fault::OutOfRange, say("'%1' must be above 0 and at most %2", bound.key, bound.most),
        say("where it is left out the unit's own limit serves"));
}

EnvelopeFacts factsOf(const Device &device, int axis)
{
    return {device.selector(), device.link().address().isSimulated(), hasCurrentScale(device, axis)};
}

QJsonObject limitsToJson(const Envelope &limits)
{
    QJsonObject object;
    for (const EnvelopeBound &bound : envelopeBounds) {
        if (const auto value = limits.*bound.value)
            object.insert(QLatin1String(bound.key), *value);
    }
    return object;
}

Envelope limitsFrom(const QJsonObject &object)
{
    Envelope limits;
    for (const EnvelopeBound &bound : envelopeBounds) {
        const double value = object.value(QLatin1String(bound.key)).toDouble();
        if (isBound(bound, value))
            limits.*bound.value = value;
    }
    return limits;
}

Envelope knownBounds(const Family &family, const EnvelopeFacts &facts, const Envelope &asked, const Envelope &own)
{
    Envelope envelope = facts.simulated ? family.trials->bench : Envelope();
    for (const auto &[key, bound, most] : envelopeBounds) {
        if (const auto found = narrower(asked.*bound, own.*bound))
            envelope.*bound = found;
    }
    if (!facts.currentScale)
        envelope.current.reset();
    return envelope;
}

Result<Envelope> resolve(
    const Family &family, const EnvelopeFacts &facts, Mode mode, const Envelope &asked, const Envelope &own)
{
    const Envelope envelope = knownBounds(family, facts, asked, own);
    std::vector<std::string> missing;
    if (!envelope.travel)
        missing.emplace_back("--travel");
    if (!envelope.speed && mode == Mode::Velocity)
        missing.emplace_back("--speed");
    if (!envelope.duty)
        missing.emplace_back("--duty");
    if (!envelope.current && facts.currentScale)
        missing.emplace_back("--current");
    if (missing.empty())
        return envelope;
    return fail(Fault::OutOfRange, say("%1 has no such limit of its own, so nothing bounds the motor", facts.selector),
        say("give %1", together(missing)));
}

Result<void> checkInside(
    const Envelope &envelope, Mode mode, const Stimulus &stimulus, int repeat, double origin, double gone)
{
    const double most = std::max(std::abs(stimulus.from), std::abs(stimulus.to));
    const double none = std::numeric_limits<double>::infinity();
    const double travel = envelope.travel.value_or(none);
    if (mode == Mode::Duty && most > envelope.duty.value_or(1.0))
        return outside(say("duty"), most, *envelope.duty);
    if (mode == Mode::Current && most > envelope.current.value_or(none))
        return outside(say("current"), most, *envelope.current);
    if (mode == Mode::Velocity && most > envelope.speed.value_or(none))
        return outside(say("speed"), most, *envelope.speed);
    double farthest = mode == Mode::Velocity ? wayOf(stimulus, repeat, gone) : 0.0;
    if (mode == Mode::Position)
        farthest = std::max(std::abs(stimulus.from - origin), std::abs(stimulus.to - origin));
    return farthest > travel ? outside(say("travel"), farthest, travel) : Result<void>();
}

} // namespace mb::tuning
