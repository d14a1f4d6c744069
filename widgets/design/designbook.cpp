// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/design/designbook.h"

#include "widgets/common/devicetext.h"
#include "widgets/control/tunechoices.h"

#include <algorithm>

namespace mb {

DesignPlace DesignBook::place() const
{
    return {m_selection.device(), m_selection.motor(), m_kept.loop};
}

DesignChoice DesignBook::choice() const
{
    const auto found = m_kept.choices.find(place());
    return found == m_kept.choices.end() ? DesignChoice() : found->second;
}

double DesignBook::countsPerRevolution(const DeviceView &view) const
{
    return TuneChoices::countsPerRevolution(m_workbench, view, place().axis);
}

const tuning::TuneReport *DesignBook::report() const
{
    const auto found = m_kept.reports.find(place());
    return found == m_kept.reports.end() ? nullptr : &found->second;
}

/// What was stopped before it had sets of its own leaves those that were there, but not where its model is not believed.
void DesignBook::keep(const DesignPlace &place, tuning::TuneReport report)
{
    const auto before = m_kept.reports.find(place);
    const bool isBelieved = std::ranges::all_of(report.gates, &tuning::Gate::passed);
    if (before != m_kept.reports.end() && report.proposals.empty() && isBelieved) {
        report.motor = before->second.motor;
        report.plant = before->second.plant;
        report.scale = before->second.scale;
        report.gates = before->second.gates;
        report.proposals = before->second.proposals;
        report.envelope = before->second.envelope;
    }
    m_kept.reports[place] = std::move(report);
}

std::vector<tuning::FrequencyPoint> DesignBook::response() const
{
    const auto found = m_kept.responses.find({place().device, place().axis});
    return found == m_kept.responses.end() ? std::vector<tuning::FrequencyPoint>() : found->second.points;
}

void DesignBook::keepResponse(const DesignPlace &place, const tuning::FrequencyResponse &response)
{
    m_kept.responses[{place.device, place.axis}] = response;
}

QString DesignBook::whyNot(const DeviceView &view) const
{
    if (view.identity->state == DeviceState::Bootloader)
        return tr("%1 waits in its bootloader.").arg(titleOf(view));
    if (!view.family->trials)
        return tr("This family has no loop that can be tuned.");
    tuning::TunePlan wanted;
    wanted.loop = m_kept.loop;
    wanted.axis = place().axis;
    const auto possible = tuning::checkTuning(*view.family, wanted);
    return possible ? QString() : errorText(possible.error());
}

tuning::TunePlan DesignBook::plan() const
{
    tuning::TunePlan plan;
    plan.loop = m_kept.loop;
    plan.axis = place().axis;
    const DesignChoice now = choice();
    plan.aim = now.own ? tuning::Aim::Normal : now.aim;
    plan.slot = now.slot;
    if (now.own) {
        plan.response = now.response;
        plan.ms = now.ms;
    }
    return plan;
}

tuning::ProposalBasis DesignBook::basisOf(const DeviceView &view, const Envelope &inForce) const
{
    return {*view.family, view.profile, m_kept.loop, place().axis, choice().slot, report()->plant, inForce,
        report()->scale, report()->taking, *view.parameters};
}

} // namespace mb
