// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/motormodel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace mb {

namespace {

constexpr double longestStep = 100e-6;           // s
constexpr double restSpeed = 0.05;               // rad/s, below which friction may hold the rotor
constexpr double airTemperature = 25.0;          // °C
constexpr double copperCoefficient = 0.00393;    // 1/K
constexpr double magnetCoefficient = -0.002;     // 1/K
constexpr double kilogramCentimetre = 0.0980665; // N·m

/// The rows of docs/names.md#motor-model hold what vendors print; the rest follows from it as derived there.
constexpr MotorParameters derive(MotorParameters p)
{
    const double speed = p.rotorFreeSpeed();
    p.resistance = p.nominalVoltage / p.stallCurrent;
    p.constant = (p.nominalVoltage - p.resistance * p.freeCurrent) / speed;
    const double noLoad = p.constant * p.freeCurrent;
    p.friction = 0.8 * noLoad;
    p.viscosity = 0.2 * noLoad / speed;
    p.breakaway = 1.2 * p.friction;
    const double efficiency = p.stallTorque / (p.gearRatio * p.constant * p.stallCurrent);
    p.torqueLoss = std::max(0.0, 1.0 - efficiency * p.stallCurrent / (p.stallCurrent - p.freeCurrent));
    return p;
}

constexpr MotorParameters row(std::string_view name, std::string_view title, double stallTorque, double stallCurrent,
    double freeCurrent, double freeSpeed, double gearRatio, double inductance, double inertia, int countsPerTurn,
    std::optional<MotorThermal> thermal = std::nullopt)
{
    MotorParameters p;
    p.name = name;
    p.title = title;
    p.stallTorque = stallTorque;
    p.stallCurrent = stallCurrent;
    p.freeCurrent = freeCurrent;
    p.freeSpeed = freeSpeed;
    p.gearRatio = gearRatio;
    p.inductance = inductance;
    p.inertia = inertia;
    p.countsPerTurn = countsPerTurn;
    p.thermal = thermal;
    return derive(p);
}

constexpr double kgcm = kilogramCentimetre;
constexpr std::array<MotorParameters, 6> table{
    row("cim", "CIM", 2.42, 133, 2.7, 5310, 1.0, 60e-6, 7.75e-5, 4096, MotorThermal{55, 0.9, 420, 2.2}),
    row("775pro", "775pro", 0.71, 134, 0.7, 18730, 1.0, 25e-6, 1.2e-5, 4096, MotorThermal{20, 1.6, 140, 4}),
    row("rs775", "RS775-125", 0.28, 18, 1.6, 5800, 1.0, 900e-6, 2.0e-5, 4096),
    row("25d", "Pololu 25D HP12 46.85:1", 15 * kgcm, 5.0, 0.30, 220, 46.85, 1.1e-3, 5.5e-7, 48,
        MotorThermal{4, 8, 30, 14}),
    row("25dlp", "Pololu 25D LP12 74.83:1", 7.1 * kgcm, 0.9, 0.06, 75, 74.83, 6.0e-3, 5.5e-7, 48),
    row("n20", "Pololu N20 HPCB12 75.81:1", 1.0 * kgcm, 0.75, 0.08, 450, 75.81, 5.0e-3, 1.4e-8, 12),
};

constexpr double contactFrequency = 500.0; // rad/s, of rotor and load against each other's teeth
constexpr double contactDamping = 0.3;
constexpr double slipBreakaway = 2.5; // times the friction while moving
constexpr double slipShare = 0.02;    // of the free speed

constexpr MotorParameters withBacklash(MotorParameters motor, std::string_view name, double outputDegrees)
{
    motor.name = name;
    motor.backlash = outputDegrees * std::numbers::pi / 180.0 * motor.gearRatio;
    return motor;
}

constexpr MotorParameters withSlip(MotorParameters motor, std::string_view name)
{
    motor.name = name;
    motor.breakaway = slipBreakaway * motor.friction;
    motor.slipSpeed = slipShare * motor.rotorFreeSpeed();
    return motor;
}

constexpr std::array<MotorParameters, 4> awkward{
    withBacklash(table[0], "cim-backlash", 20.0),
    withBacklash(table[3], "25d-backlash", 2.0),
    withSlip(table[0], "cim-slip"),
    withSlip(table[3], "25d-slip"),
};

} // namespace

std::span<const MotorParameters> motors()
{
    return table;
}

const MotorParameters *motorByName(std::string_view name)
{
    for (const std::span<const MotorParameters> known : {motors(), std::span<const MotorParameters>(awkward)}) {
        for (const MotorParameters &motor : known) {
            if (motor.name == name)
                return &motor;
        }
    }
    return nullptr;
}

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
    heat(seconds);
}

void MotorModel::drive(double duty, double seconds)
{
    m_duty = duty;
    const Circuit circuit{duty * m_supply.voltage,
        resistanceNow() + m_supply.bridgeResistance + duty * duty * m_supply.resistance, constantNow()};
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
    if (std::abs(constantNow() * m_speed) > m_supply.voltage) {
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

void MotorModel::heat(double seconds)
{
    if (!m_parameters.thermal)
        return;
    const MotorThermal &thermal = *m_parameters.thermal;
    const double flow = (m_winding - m_housing) / thermal.windingToHousing;
    m_winding += seconds * (resistanceNow() * m_current * m_current - flow) / thermal.winding;
    m_housing += seconds * (flow - (m_housing - airTemperature) / thermal.housingToAir) / thermal.housing;
}

bool MotorModel::isHeld(double torque) const
{
    return m_locked
        || (std::abs(m_speed) < restSpeed && std::abs(torque - m_load) <= m_friction * m_parameters.breakaway);
}

double MotorModel::directionOf(double torque) const
{
    return std::copysign(1.0, std::abs(m_speed) < restSpeed ? torque - m_load : m_speed);
}

double MotorModel::resistanceNow() const
{
    return m_parameters.resistance * (1.0 + copperCoefficient * (m_winding - airTemperature));
}

double MotorModel::constantNow() const
{
    return m_parameters.constant * (1.0 + magnetCoefficient * (m_winding - airTemperature));
}

std::int64_t MotorModel::counts() const
{
    if (m_deadCount)
        return *m_deadCount;
    return static_cast<std::int64_t>(std::floor(m_encoderOrigin + m_encoderSign * countPosition()));
}

void MotorModel::setEncoderReversed(bool reversed)
{
    const double sign = reversed ? -1.0 : 1.0;
    m_encoderOrigin += (m_encoderSign - sign) * countPosition();
    m_encoderSign = sign;
}

void MotorModel::setEncoderDead(bool dead)
{
    if (dead != m_deadCount.has_value())
        m_deadCount = dead ? std::optional(counts()) : std::nullopt;
}

bool MotorModel::disturb(std::string_view what, double value)
{
    if (what == "load-torque")
        setLoadTorque(value);
    else if (what == "stall")
        setLocked(value != 0.0);
    else if (what == "bus-voltage")
        setSupplyVoltage(value);
    else if (what == "bus-resistance")
        m_supply.resistance = value;
    else if (what == "friction")
        m_friction = value;
    else if (what == "backlash")
        setBacklash(value);
    else if (what == "encoder-counts")
        m_parameters.countsPerTurn = static_cast<int>(value);
    else if (what == "winding-temperature")
        setTemperature(value);
    else if (what == "encoder-dead")
        setEncoderDead(value != 0.0);
    else if (what == "encoder-reversed")
        setEncoderReversed(value != 0.0);
    else
        return false;
    return true;
}

} // namespace mb
