// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/relayidentification.h"

#include "experiment/figures.h"
#include "model/family.h"
#include "tuning/autotunerun.h"
#include "tuning/currentidentification.h"
#include "tuning/relaycycle.h"

#include <algorithm>
#include <cmath>

namespace mb::tuning {
namespace {

constexpr double strongerPush = 1.6; ///< times what moved it
constexpr double shortPush = 0.6;    ///< of a push that nothing ends
constexpr double roomOfPush = 0.25;  ///< of the travel, that a push goes
constexpr int shortRepeats = 2;
constexpr double relayOverFriction = 5.0; ///< times, that a relay pushes
constexpr double leastRelayOverFriction = 3.0;
constexpr double leastRelay = 0.15; ///< duty
constexpr double mostRelay = 0.4;
constexpr double leastHysteresis = 2.0;  ///< counts
constexpr double mostHysteresis = 16.0;  ///< with which samples that are 5 ms apart hardly make a swing uneven
constexpr double hysteresisShare = 1e-3; ///< of the travel
constexpr double longestSwing = 6.0;     ///< s
constexpr double mostGainDoubt = 0.15;   ///< of the gain
constexpr double mostBackDoubt = 0.05;   ///< of what a count/s takes off the duty
constexpr double mostUneven = 0.1;       ///< of the periods
constexpr double leastAmplitude = 8.0;   ///< counts
constexpr double relayError = 0.05;      ///< of τ, beside that of the gain
constexpr double passesOfLoop = 1.5;     ///< periods of the device's loop

double travelOf(const AutotuneRun &run)
{
    return run.envelope().travel.value_or(1e9);
}

} // namespace

Task<void> RelayIdentification::identify(AutotuneRun &run, double duty)
{
    co_await push(run, duty);
    if (run.isOver())
        co_return {};
    co_await readPushes();
    m_plant.delay += passesOfLoop * run.device().family().loop->cycle;
    co_await swing(run);
    co_return {};
}

/// Of two sizes, as far as there is room; to and fro in turn, so that it stays about its place.
Task<void> RelayIdentification::push(AutotuneRun &run, double duty)
{
    const double stronger = std::min(strongerPush * duty, run.envelope().duty.value_or(1.0));
    for (int again = 0; again < shortRepeats; ++again) {
        for (const double signedDuty : {-stronger, stronger, -duty, duty}) {
            auto pushing = run.push({signedDuty, shortPush, 1, roomOfPush * travelOf(run)});
            m_pushes.push_back(co_await std::move(pushing));
            if (run.isOver())
                co_return {};
        }
    }
    co_return {};
}

/// A push that ends before its speed does tells gain over τ much better than either; where the current is known, what the motor's
/// own voltage takes off the duty tells the gain alone.
Result<void> RelayIdentification::readPushes()
{
    MB_TRY(auto found, tuning::identify(m_pushes));
    m_found = std::move(found);
    m_plant = {m_found.line.gain, m_found.pushes.tau, m_found.pushes.delay, m_found.line.friction, m_found.braking};
    m_doubt = m_found.line.gainError / m_found.line.gain + m_found.pushes.tauError / m_found.pushes.tau;
    const Signal *const current = m_pushes.front().signal("current");
    const auto ohm = current && current->unit == "A" ? fitOhm(m_pushes) : fail(Fault::OutOfRange);
    if (ohm && ohm->back > 0.0 && ohm->backError < std::min(m_doubt, mostBackDoubt) * ohm->back) {
        m_plant.gain = 1.0 / ohm->back;
        m_plant.stallCurrent = ohm->gain;
        m_plant.backDuty = ohm->back;
        m_doubt = ohm->backError / ohm->back;
    }
    return {};
}

Task<void> RelayIdentification::swing(AutotuneRun &run)
{
    const double most = std::min(mostRelay, run.envelope().duty.value_or(1.0));
    m_duty = std::clamp(relayOverFriction * m_plant.friction, std::min(leastRelay, most), most);
    if (m_duty < leastRelayOverFriction * m_plant.friction)
        co_return fail(Fault::Refused,
            say("friction takes %1 duty, and %2 may push: too little for a motor to swing",
                percentText(m_plant.friction), percentText(most)),
            say("allow more duty"));
    const double hysteresis = std::clamp(hysteresisShare * travelOf(run), leastHysteresis, mostHysteresis);
    auto swinging = run.push({m_duty, longestSwing, 1, std::nullopt, hysteresis});
    const Trial swung = co_await std::move(swinging);
    if (run.isOver())
        co_return {};
    co_return conclude(run, swung);
}

Result<void> RelayIdentification::conclude(AutotuneRun &run, const Trial &swung) const
{
    const Signal *const position = swung.signal("position");
    const auto cycle = position && !swung.holds.empty()
        ? readRelay(position->trace.part(swung.holds.front().from, swung.holds.front().to))
        : std::nullopt;
    if (!cycle)
        return fail(Fault::Refused, say("the motor did not swing evenly under a duty that changes its sign"),
            say("allow more travel, so that pushes may last"));
    const auto tau = tauFromRelay(*cycle, m_plant.gain, m_duty, m_plant.friction, m_plant.braking);
    if (!tau)
        return fail(Fault::Refused,
            say("no motor of this gain swings by %1 counts every %2", std::round(cycle->amplitude),
                millisecondsText(cycle->period)),
            say("allow more travel, so that pushes may last"));
    MotorFound found = m_found;
    PlantModel plant = m_plant;
    plant.tau = *tau;
    found.line.gain = plant.gain;
    found.line.gainError = m_doubt * plant.gain;
    found.pushes.tau = *tau;
    found.pushes.tauError = (m_doubt + relayError) * *tau;
    std::vector<Gate> gates = gatesOf(found, m_pushes);
    gates.push_back({"relay",
        say("there was no room for long pushes; under %1 duty to and fro it swings by %2 counts every %3, the periods "
            "differ by %4, at most 10 %",
            percentText(m_duty), std::round(cycle->amplitude), millisecondsText(cycle->period),
            percentText(cycle->scatter)),
        cycle->scatter <= mostUneven && cycle->amplitude >= leastAmplitude, say("allow more travel")});
    gates.push_back({"gain", say("the gain is known within %1, at most 15 %", percentText(m_doubt)),
        m_doubt <= mostGainDoubt, say("allow more travel")});
    return run.take({std::move(found), plant, std::move(gates), std::nullopt});
}

} // namespace mb::tuning
