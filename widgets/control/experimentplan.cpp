// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/experimentplan.h"

#include "experiment/foresight.h"
#include "experiment/gains.h"
#include "experiment/motiontimes.h"
#include "model/axis.h"
#include "model/family.h"
#include "model/loopparameters.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/livetext.h"
#include "widgets/common/numberformat.h"

#include <QCoreApplication>

#include <cmath>

namespace mb {
namespace {

struct ExperimentText {
    Q_DECLARE_TR_FUNCTIONS(mb::ExperimentText)
};

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
        tuning::triable(*device.family, wish.gains));
}

Envelope ownOf(const DeviceView &device, const ExperimentWish &wish, Instant now)
{
    return tuning::knownBounds(*device.family, factsOf(device, wish.axis), wish.limits, itsOwn(device, wish, now));
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
    plan.gains = tuning::triable(*device.family, wish.gains);
    plan.keep = tuning::usualKeep(*device.family, *device.parameters, *device.profile, plan.gains);
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
    check.inForce = ownOf(device, wish, now);
    if (const auto possible = tuning::checkPlan(family, probe); !possible) {
        check.words = errorText(possible.error());
        return check;
    }
    const double here = originOf(device, wish, now);
    const Mode bounded = wish.loop.value_or(wish.mode);
    const auto envelope
        = tuning::resolve(family, factsOf(device, wish.axis), bounded, wish.limits, itsOwn(device, wish, now));
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
    if (plan.from.value_or(wish.mode == Mode::Position ? here : 0.0) == plan.to) {
        check.words = ExperimentText::tr("It is there already; enter another place to go to.");
        return check;
    }
    const auto stimulus = tuning::stimulusWithin(family, *envelope, plan, {here, here, 0.0});
    check.good = stimulus.has_value();
    check.words = stimulus ? insideText(*stimulus, wish, *envelope, units) : errorText(stimulus.error());
    return check;
}

StimulusChoice usualStimulus(
    const DeviceView &device, const ExperimentWish &wish, const DisplayUnits &units, Instant now)
{
    StimulusChoice choice = wish.stimulus;
    if (!device.family->trials)
        return choice;
    if (const auto to = tuning::usualTarget(*device.family, wish.mode, ownOf(device, wish, now),
            originOf(device, wish, now), units.countsPerRevolution))
        choice.to = *to;
    return choice;
}

} // namespace mb
