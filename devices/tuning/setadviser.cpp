// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/setadviser.h"

#include "experiment/envelope.h"
#include "experiment/gains.h"
#include "model/family.h"
#include "model/loopparameters.h"

#include <algorithm>
#include <cmath>

namespace mb::tuning {
namespace {

constexpr double largeBand = 0.02; ///< of the step, that friction alone may keep P from
constexpr double slowRamp = 0.5;   ///< of the response

using State = SetAdvice::State;

/// The loop's parameter with this role; empty where it has none.
std::string keyOf(const ProposalBasis &basis, Role role)
{
    const auto index = parameterOf(basis.family, basis.loop, basis.axis, basis.slot, role);
    return index ? std::string(basis.family.parameters[index->value].key) : std::string();
}

SetAdvice about(const ProposalBasis &basis, Cause cause, Role role, double number, double limit)
{
    return {cause, State::Fine, number, limit, keyOf(basis, role), role, {}};
}

/// As it will be once the set is written.
std::optional<double> afterwards(const Proposal &proposal, const KnownGains &now, const std::string &key)
{
    for (const ScaledGains::Row &row : proposal.gains.rows) {
        if (row.key == key)
            return row.number;
    }
    const auto found = std::ranges::find_if(now, [&](const auto &entry) { return entry.first == key; });
    return found == now.end() ? std::nullopt : found->second;
}

/// s of the step, that F and I give back as overshoot; 0: none, or one of them is not there.
double conflictOf(const ProposalBasis &basis, const Proposal &proposal, const ContinuousGains &gains)
{
    return gains.f > 0.0 && gains.i > 0.0 ? conflictArea(basis.plant, gains, proposal.design.response, proposal.step)
                                          : 0.0;
}

SetAdvice onFeedForward(const ProposalBasis &basis, const Proposal &proposal, const KnownGains &now)
{
    SetAdvice advice = about(basis, Cause::FeedForward, Role::FeedForward, 0.0, 0.0);
    if (basis.loop != Mode::Velocity || advice.key.empty())
        return advice;
    advice.number = conflictOf(basis, proposal, proposal.gains.made);
    if (advice.number > 0.0) {
        advice.state = State::Notable;
        return advice;
    }
    const auto before = gainsMadeBy(basis.family, basis.profile, basis.loop, basis.axis, basis.slot, now, basis.scale);
    const double given = before ? conflictOf(basis, proposal, before->made) : 0.0;
    if (given > 0.0) {
        advice.state = State::Fixed;
        advice.number = given;
    }
    return advice;
}

SetAdvice onDeadband(const ProposalBasis &basis, const Proposal &proposal, const KnownGains &now)
{
    SetAdvice advice = about(basis, Cause::Deadband, Role::LeastForward, deadband(basis.plant, proposal.gains.made),
        largeBand * std::abs(proposal.step));
    const bool helps = afterwards(proposal, now, advice.key).value_or(0.0) != 0.0;
    if (basis.loop != Mode::Position || advice.number <= advice.limit || helps) // others would never rest with it
        return advice;
    advice.state = State::Notable;
    const double duty
        = std::round(helpOverFriction * basis.plant.friction * (basis.family.loop ? basis.family.loop->fullDuty : 0.0));
    for (const auto &[role, sign] : {std::pair(Role::LeastForward, 1.0), std::pair(Role::LeastReverse, -1.0)}) {
        if (const std::string key = keyOf(basis, role); !key.empty() && duty > 0.0)
            advice.changes.emplace_back(key, sign * duty);
    }
    return advice;
}

SetAdvice onNoise(const ProposalBasis &basis, const Proposal &proposal)
{
    const double period = basis.scale ? basis.scale->cycle : basis.family.loop ? basis.family.loop->cycle : 0.0;
    SetAdvice advice = about(basis, Cause::DerivativeNoise, Role::Derivative, 0.0, LoopBounds().derivativeShare);
    if (basis.loop == Mode::Position && period > 0.0)
        advice.number = std::abs(proposal.gains.made.d) / period;
    if (advice.number > advice.limit)
        advice.state = State::Notable;
    return advice;
}

SetAdvice onResolution(const ProposalBasis &basis, const Proposal &proposal)
{
    SetAdvice advice = about(basis, Cause::Resolution, Role::None, 0.0, leastGainSteps);
    for (const ScaledGains::Row &row : proposal.gains.rows) {
        const Role role = roleOf(basis.family, row.key);
        const double steps = std::abs(static_cast<double>(row.raw));
        if (!isGain(role) || steps == 0.0 || (!advice.key.empty() && steps >= advice.number))
            continue;
        advice.number = steps;
        advice.key = row.key;
        advice.role = role;
    }
    if (!advice.key.empty() && advice.number < leastGainSteps)
        advice.state = State::Notable;
    return advice;
}

SetAdvice onRamp(const ProposalBasis &basis, const Proposal &proposal, const KnownGains &now)
{
    SetAdvice advice = about(basis, Cause::Ramp, Role::Ramp, 0.0, slowRamp * proposal.design.response);
    if (advice.key.empty() || !basis.family.loop)
        return advice;
    const auto ramp = afterwards(proposal, now, advice.key);
    if (!ramp)
        advice.state = State::Unread;
    else if (*ramp > 0.0)
        advice.number = basis.family.loop->period * basis.family.loop->fullDuty / *ramp;
    if (advice.number > advice.limit) {
        advice.state = State::Notable;
        advice.changes = {{advice.key, 0.0}};
    }
    return advice;
}

} // namespace

std::vector<SetAdvice> adviseOnSet(const ProposalBasis &basis, const Proposal &proposal, const KnownGains &now)
{
    std::vector<SetAdvice> all{onFeedForward(basis, proposal, now)};
    if (basis.loop != Mode::Current)
        all.push_back(onDeadband(basis, proposal, now));
    all.push_back(onNoise(basis, proposal));
    all.push_back(onResolution(basis, proposal));
    all.push_back(onRamp(basis, proposal, now));
    return all;
}

} // namespace mb::tuning
