// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/motormodel.h"

#include <algorithm>
#include <cmath>

namespace mb {
namespace {

constexpr double longestStep = 100e-6; // s
constexpr double restSpeed = 0.05;     // rad/s, below which friction may hold the rotor

constexpr double contactFrequency = 500.0; // rad/s, of rotor and load against each other's teeth
constexpr double contactDamping = 0.3;

} // namespace

/// Motor and source while the bridge conducts, constant over a step.
struct MotorModel::Circuit {
    double voltage;
    double resistance; ///< battery sag included: R + Rds + u²·Rb
    double constant;
};

MotorModel::MotorModel(const MotorParameters &parameters, double loadFactor, MotorSupply supply)
    : m_parameters(parameters)
    , m_supply(supply)
    , m_loadFactor(std::max(loadFactor, 1.0))
{
    setBacklash(parameters.backlash);
}

void MotorModel::setBacklash(double angle)
{
    m_parameters.backlash = m_loadFactor > 1.0 ? angle : 0.0;
    m_inertia = m_parameters.inertia * (isTwoMasses() ? 1.0 : m_loadFactor);
    m_load = isTwoMasses() ? 0.0 : m_weight;
    m_loadSpeed = m_speed;
    m_loadAngle = m_angle;
}

void MotorModel::turn(double angle)
{
    m_angle += angle;
    m_loadAngle += angle;
}

void MotorModel::setLoadTorque(double torque)
{
    m_weight = torque / m_parameters.gearRatio;
    if (!isTwoMasses())
        m_load = m_weight;
}

double MotorModel::frictionNow() const
{
    const MotorParameters &motor = m_parameters;
    const double speed = motor.slipSpeed > 0.0 ? m_speed / motor.slipSpeed : 0.0;
    const double more = motor.slipSpeed > 0.0 ? (motor.breakaway - motor.friction) * std::exp(-speed * speed) : 0.0;
    return m_friction * (motor.friction + more);
}

/// The load turns freely within the backlash, and pushes back like a stiff spring that does not pull at its ends.
void MotorModel::dragLoad(double seconds)
{
    const double inertia = m_parameters.inertia * (m_loadFactor - 1.0);
    const double both = m_parameters.inertia * inertia / (m_parameters.inertia + inertia);
    const double apart = m_angle - m_loadAngle;
    const double beyond = apart - std::clamp(apart, -0.5 * m_parameters.backlash, 0.5 * m_parameters.backlash);
    const double spring = both * contactFrequency * contactFrequency;
    const double damper = 2.0 * contactDamping * contactFrequency * both;
    double torque = beyond != 0.0 ? spring * beyond + damper * (m_speed - m_loadSpeed) : 0.0;
    if (torque * beyond < 0.0)
        torque = 0.0;
    m_load = torque;
    m_loadSpeed += seconds * (torque - m_weight) / inertia;
    m_loadAngle += seconds * m_loadSpeed;
}

void MotorModel::step(double duty, Bridge bridge, double seconds)
{
    if (!(seconds > 0.0))
        return;
    const double count = std::ceil(seconds / longestStep - 1e-9);
    const double part = seconds / count;
    for (double done = 0.0; done < count; done += 1.0)
        stepOnce(duty, bridge, part);
}

void MotorModel::stepOnce(double duty, Bridge bridge, double seconds)
{
    if (bridge == Bridge::Coast)
        coast(seconds);
    else
        drive(bridge == Bridge::Drive ? std::clamp(duty, -1.0, 1.0) : 0.0, seconds);
    if (isTwoMasses())
        dragLoad(seconds);
    if (m_parameters.thermal)
        m_heat.step(*m_parameters.thermal, m_heat.resistance(m_parameters.resistance) * m_current * m_current, seconds);
}

void MotorModel::drive(double duty, double seconds)
{
    m_duty = duty;
    const Circuit circuit{duty * m_supply.voltage,
        m_heat.resistance(m_parameters.resistance) + m_supply.bridgeResistance + duty * duty * m_supply.resistance,
        m_heat.constant(m_parameters.constant)};
    const double torque = circuit.constant * m_current;
    m_stuck = isHeld(torque);
    if (m_stuck) {
        const double steady = circuit.voltage / circuit.resistance;
        m_speed = 0.0;
        m_current = steady + (m_current - steady) * std::exp(-circuit.resistance * seconds / m_parameters.inductance);
        return;
    }
    const double friction = frictionNow() + m_parameters.torqueLoss * std::abs(torque);
    slip(circuit, directionOf(torque) * friction + m_load, seconds);
}

/// The exact step of current and speed (docs/names.md#motor-model): x⁺ = x∞ + e^{Ah}(x − x∞), by the closed form of the 2×2
/// exponential.
void MotorModel::slip(const Circuit &circuit, double friction, double seconds)
{
    const double k = circuit.constant;
    const double b = m_parameters.viscosity;
    const double a11 = -circuit.resistance / m_parameters.inductance;
    const double a12 = -k / m_parameters.inductance;
    const double a21 = k / m_inertia;
    const double a22 = -b / m_inertia;
    const double determinant = a11 * a22 - a12 * a21;
    const double mean = 0.5 * (a11 + a22);
    const double square = mean * mean - determinant;
    const double q = std::sqrt(std::abs(square));
    double even = 1.0;    // cosh or cos
    double odd = seconds; // sinh/q or sin/q
    if (q * seconds > 1e-9) {
        even = square > 0.0 ? std::cosh(q * seconds) : std::cos(q * seconds);
        odd = (square > 0.0 ? std::sinh(q * seconds) : std::sin(q * seconds)) / q;
    }
    const double decay = std::exp(mean * seconds);
    const double steadySpeed = (k * circuit.voltage - circuit.resistance * friction) / (k * k + circuit.resistance * b);
    const double steadyCurrent = (circuit.voltage - k * steadySpeed) / circuit.resistance;
    const double i = m_current - steadyCurrent;
    const double w = m_speed - steadySpeed;
    const double nextI = decay * ((even + odd * (a11 - mean)) * i + odd * a12 * w);
    const double nextW = decay * (odd * a21 * i + (even + odd * (a22 - mean)) * w);
    m_angle += steadySpeed * seconds + (a11 * (nextW - w) - a21 * (nextI - i)) / determinant;
    m_current = nextI + steadyCurrent;
    const double speed = nextW + steadySpeed;
    m_speed = m_speed * speed < 0.0 ? 0.0 : speed; // turned round: the next step asks whether it sticks
}

/// No current, unless the motor turns so fast that the body diodes conduct.
void MotorModel::coast(double seconds)
{
    if (std::abs(m_heat.constant(m_parameters.constant) * m_speed) > m_supply.voltage) {
        drive(std::copysign(1.0, m_speed), seconds);
        if (m_current * m_speed > 0.0)
            m_current = 0.0;
        return;
    }
    m_duty = 0.0;
    m_current = 0.0;
    m_stuck = isHeld(0.0);
    if (m_stuck) {
        m_speed = 0.0;
        return;
    }
    const double b = m_parameters.viscosity;
    const double steady = -(directionOf(0.0) * frictionNow() + m_load) / b;
    const double excess = m_speed - steady;
    const double left = std::exp(-b * seconds / m_inertia);
    m_angle += steady * seconds + excess * (1.0 - left) * m_inertia / b;
    const double speed = steady + excess * left;
    m_speed = m_speed * speed < 0.0 ? 0.0 : speed;
}

bool MotorModel::isHeld(double torque) const
{
    const double moving
        = frictionNow() + m_parameters.torqueLoss * std::abs(torque); // what turns no shaft but holds it
    return m_locked
        || (std::abs(m_speed) < restSpeed
            && std::abs(torque - m_load) <= std::max(m_friction * m_parameters.breakaway, moving));
}

double MotorModel::directionOf(double torque) const
{
    return std::copysign(1.0, std::abs(m_speed) < restSpeed ? torque - m_load : m_speed);
}

bool MotorModel::disturb(std::string_view what, double value)
{
    if (what == "load-torque")
        setLoadTorque(value);
    else if (what == "stall")
        setLocked(value != 0.0);
    else if (what == "bus-voltage")
        m_supply.voltage = value;
    else if (what == "bus-resistance")
        m_supply.resistance = value;
    else if (what == "friction")
        m_friction = value;
    else if (what == "backlash")
        setBacklash(value);
    else if (what == "turn")
        turn(value);
    else if (what == "encoder-counts")
        m_parameters.countsPerTurn = static_cast<int>(value);
    else if (what == "winding-temperature")
        m_heat.set(value);
    else if (what == "encoder-dead")
        setEncoderDead(value != 0.0);
    else if (what == "encoder-reversed")
        setEncoderReversed(value != 0.0);
    else
        return false;
    return true;
}

} // namespace mb
