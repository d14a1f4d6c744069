// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/experimentplan.h"

#include "experiment/envelope.h"
#include "experiment/gains.h"
#include "experiment/motiontimes.h"
#include "model/axis.h"
#include "model/family.h"
#include "model/loopparameters.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/numberformat.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace mb {
namespace {

struct ExperimentText {
    Q_DECLARE_TR_FUNCTIONS(mb::ExperimentText)
};

constexpr double ofEnvelope = 0.4; ///< of the narrowest bound, for a first stimulus
constexpr double ofBench = 0.04;   ///< of what no simulated motor reaches
constexpr double gentleDuty = 0.2;

std::optional<double> liveOf(const DeviceView &device, int axis, std::string_view key, Instant now)
{
    const bool several = device.family->capabilities.axes > 1;
    return liveValue(device, axisKey(several ? axis : 0, key), now);
}

/// Counted from its start where the experiment begins with that.
double originOf(const DeviceView &device, const ExperimentWish &wish, Instant now)
{
    const bool counted = wish.mode == Mode::Position && device.family->capabilities.zeroPosition;
    return counted ? 0.0 : liveOf(device, wish.axis, "position", now).value_or(0.0);
}

tuning::EnvelopeFacts factsOf(const DeviceView &device, int axis)
{
    const bool several = device.family->capabilities.axes > 1;
    const auto channel
        = device.telemetry ? device.telemetry->find(axisKey(several ? axis : 0, "current")) : std::nullopt;
    const bool scaled = channel && device.telemetry->channels()[channel->value].unit == "A";
    return {device.selector, device.link.starts_with("sim:"), scaled};
}

Envelope itsOwn(const DeviceView &device, const ExperimentWish &wish, Instant now)
{
    return tuning::ownLimits(*device.family, *device.parameters, wish.axis, wish.slot, originOf(device, wish, now),
        triable(*device.family, wish.gains));
}

Envelope ownOf(const DeviceView &device, const ExperimentWish &wish, Instant now)
{
    const Envelope own = itsOwn(device, wish, now);
    const Envelope bench = device.link.starts_with("sim:") ? device.family->trials->bench : Envelope();
    Envelope known;
    for (const EnvelopeBound &each : envelopeBounds) {
        const auto bound = each.value;
        const auto asked = wish.limits.*bound;
        const auto its = own.*bound ? own.*bound : bench.*bound;
        known.*bound = asked && own.*bound ? std::min(*asked, *(own.*bound)) : asked ? asked : its;
    }
    return known;
}

/// Two significant digits, downwards: a number that people would choose.
double rounded(double value)
{
    if (value == 0.0 || !std::isfinite(value))
        return 0.0;
    const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 1.0);
    return std::trunc(value / unit + 1e-9) * unit;
}

QString insideText(
    const tuning::Stimulus &stimulus, const ExperimentWish &wish, const Envelope &envelope, const DisplayUnits &units)
{
    const ShownUnit unit = shownUnit(wish.mode, units);
    const double most = std::max(std::abs(stimulus.from), std::abs(stimulus.to)) * unit.scale;
    std::optional<double> Envelope::*const kind = wish.mode == Mode::Velocity ? &Envelope::speed
        : wish.mode == Mode::Current                                          ? &Envelope::current
                                                                              : &Envelope::duty;
    const double bound = wish.mode == Mode::Position ? 0.0 : (envelope.*kind).value_or(0.0);
    const QString seconds = ExperimentText::tr("at most %1 s")
                                .arg(formatNumber(tuning::longestSeconds(stimulus.length(), wish.stimulus.repeat), 1));
    if (bound <= 0.0)
        return ExperimentText::tr("inside the envelope · %1").arg(seconds);
    return ExperimentText::tr("inside the envelope · %1 of %2 · %3")
        .arg(formatSignificant(most, 5), formatSignificant(bound * unit.scale, 5) + QChar(0x00A0) + unit.text, seconds);
}

} // namespace

std::vector<ParameterChange> triable(const Family &family, const std::vector<ParameterChange> &changes)
{
    std::vector<ParameterChange> some;
    std::copy_if(changes.begin(), changes.end(), std::back_inserter(some),
        [&family](const ParameterChange &change) { return tuning::checkTried(family, change.index).has_value(); });
    return some;
}

tuning::ExperimentPlan planOf(const DeviceView &device, const ExperimentWish &wish)
{
    tuning::ExperimentPlan plan;
    plan.mode = wish.mode;
    plan.axis = wish.axis;
    plan.slot = wish.slot;
    plan.from = wish.stimulus.from;
    plan.to = wish.stimulus.to.value_or(0.0);
    plan.profile = wish.stimulus.profile;
    plan.seconds = wish.stimulus.seconds;
    plan.repeat = wish.stimulus.repeat;
    plan.limits = wish.limits;
    plan.gains = triable(*device.family, wish.gains);
    const bool blind = std::ranges::any_of(plan.gains, [&device](const ParameterChange &change) {
        const Parameter &row = device.family->parameters[change.index.value];
        const bool known
            = change.index.value < device.parameters->size() && (*device.parameters)[change.index.value].raw;
        return row.access == Access::WriteOnly && (!known || device.profile->lost.count(std::string(row.key)) > 0);
    });
    plan.keep = blind ? tuning::Keep::Always : tuning::Keep::WhenDone;
    return plan;
}

ExperimentCheck checkExperiment(
    const DeviceView &device, const ExperimentWish &wish, const DisplayUnits &units, Instant now)
{
    ExperimentCheck check;
    const Family &family = *device.family;
    const auto plan = planOf(device, wish);
    auto probe = plan;
    if (!wish.stimulus.to)
        probe.to = 1.0;
    if (!family.trials || (wish.mode != Mode::Duty && !loopOf(family, wish.mode))) {
        check.words = ExperimentText::tr("This mode has no loop that can be tried; Live drives it.");
        return check;
    }
    check.possible = true;
    if (const auto possible = tuning::checkPlan(family, probe); !possible) {
        check.words = errorText(possible.error());
        check.inForce = ownOf(device, wish, now);
        return check;
    }
    const double here = originOf(device, wish, now);
    const Mode bounded = wish.loop.value_or(wish.mode);
    const auto envelope
        = tuning::resolve(family, factsOf(device, wish.axis), bounded, wish.limits, itsOwn(device, wish, now));
    check.inForce = envelope ? *envelope : ownOf(device, wish, now);
    if (!envelope) {
        check.missing
            = ExperimentText::tr("Nothing bounds the motor: enter travel, duty, and what else is empty here.");
        check.words = wish.limitsFault.isEmpty() ? check.missing : wish.limitsFault;
        return check;
    }
    if (!wish.limitsFault.isEmpty()) {
        check.words = wish.limitsFault;
        return check;
    }
    if (!wish.stimulus.to) {
        check.words = ExperimentText::tr("Enter where the loop is to go.");
        return check;
    }
    const double from = plan.from.value_or(wish.mode == Mode::Position ? here : 0.0);
    const auto stimulus = tuning::Stimulus::make(plan.profile, from, plan.to, plan.seconds,
        std::chrono::duration<double>(family.capabilities.commandPeriod).count());
    const auto inside = stimulus ? tuning::checkInside(*envelope, wish.mode, *stimulus, plan.repeat, here)
                                 : Result<void>(fail(stimulus.error()));
    check.good = inside && from != plan.to;
    check.words = !inside ? errorText(inside.error())
        : from == plan.to ? ExperimentText::tr("It is there already; enter another place to go to.")
                          : insideText(*stimulus, wish, *envelope, units);
    return check;
}

StimulusChoice usualStimulus(
    const DeviceView &device, const ExperimentWish &wish, const DisplayUnits &units, Instant now)
{
    StimulusChoice choice = wish.stimulus;
    if (!device.family->trials)
        return choice;
    const Envelope known = ownOf(device, wish, now);
    const Envelope &bench = device.family->trials->bench;
    const auto part = [&](std::optional<double> Envelope::*bound) {
        return *(known.*bound) * (known.*bound == bench.*bound ? ofBench : ofEnvelope);
    };
    switch (wish.mode) {
    case Mode::Velocity:
        if (known.speed) // a step and back of some two seconds must have room, too
            choice.to = rounded(std::min(part(&Envelope::speed), known.travel.value_or(1e12) / 20.0));
        break;
    case Mode::Position: {
        const double here = std::round(originOf(device, wish, now));
        choice.to = here
            + rounded(
                std::min(known.travel.value_or(units.countsPerRevolution), units.countsPerRevolution) * ofEnvelope);
        break;
    }
    case Mode::Current:
        if (known.current)
            choice.to = rounded(part(&Envelope::current));
        break;
    case Mode::Duty: choice.to = std::min(gentleDuty, known.duty.value_or(1.0)); break;
    default: break;
    }
    return choice;
}

} // namespace mb
