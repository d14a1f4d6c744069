// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/foresight.h"

#include "experiment/seconds.h"
#include "model/family.h"

#include <algorithm>
#include <cmath>

namespace mb::tuning {
namespace {

constexpr double ofEnvelope = 0.4; ///< of the narrowest bound, for a first stimulus
constexpr double ofBench = 0.04;   ///< of what no simulated motor reaches
constexpr double gentleDuty = 0.2;

/// Two significant digits, downwards.
double chosenNumber(double value)
{
    if (value == 0.0 || !std::isfinite(value))
        return 0.0;
    const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 1.0);
    return std::trunc(value / unit + 1e-9) * unit;
}

} // namespace

Result<Stimulus> stimulusWithin(
    const Family &family, const Envelope &envelope, const ExperimentPlan &plan, const StartPlace &start)
{
    const double from = plan.from.value_or(plan.mode == Mode::Position ? start.position : 0.0);
    MB_TRY(const auto stimulus,
        Stimulus::make(plan.profile, from, plan.to, plan.seconds, inSeconds(family.capabilities.commandPeriod)));
    if (stimulus.from == stimulus.to)
        return fail(Fault::OutOfRange, say("there is no way from %1 to itself", from), say("give another target"));
    MB_TRY_VOID(checkInside(envelope, plan.mode, stimulus, plan.repeat, start.origin, start.gone));
    return stimulus;
}

std::optional<double> usualTarget(const Family &family, Mode mode, const Envelope &known, double here, double turn)
{
    const Envelope &bench = family.trials->bench;
    const auto part = [&](std::optional<double> Envelope::*bound) {
        return *(known.*bound) * (known.*bound == bench.*bound ? ofBench : ofEnvelope);
    };
    switch (mode) {
    case Mode::Velocity: // a step and back of some two seconds must have room, too
        if (known.speed)
            return chosenNumber(std::min(part(&Envelope::speed), known.travel.value_or(1e12) / 20.0));
        break;
    case Mode::Position:
        return std::round(here) + chosenNumber(std::min(known.travel.value_or(turn), turn) * ofEnvelope);
    case Mode::Current:
        if (known.current)
            return chosenNumber(part(&Envelope::current));
        break;
    case Mode::Duty: return std::min(gentleDuty, known.duty.value_or(1.0));
    default: break;
    }
    return std::nullopt;
}

Keep usualKeep(const Family &family, std::span<const ParameterStore::Entry> entries, const DeviceProfile &profile,
    const std::vector<ParameterChange> &gains)
{
    const bool isBlind = std::ranges::any_of(gains, [&](const ParameterChange &change) {
        const Parameter &row = family.parameters[change.index.value];
        const bool isKnown = change.index.value < entries.size() && entries[change.index.value].raw;
        return row.access == Access::WriteOnly && (!isKnown || profile.lost.contains(std::string(row.key)));
    });
    return isBlind ? Keep::Always : Keep::WhenDone;
}

} // namespace mb::tuning
