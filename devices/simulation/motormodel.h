// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <numbers>
#include <optional>
#include <span>
#include <string_view>

namespace mb {

/// Two heat stores, winding and housing: J/K and K/W (docs/names.md#motor-model).
struct MotorThermal {
    double winding = 0.0;
    double windingToHousing = 0.0;
    double housing = 0.0;
    double housingToAir = 0.0;
};

/// A motor with its gear, SI units on the rotor side unless it says otherwise (docs/names.md#motor-model).
struct MotorParameters {
    std::string_view name; ///< of `motor=`
    std::string_view title;
    double nominalVoltage = 12.0;        ///< V
    double stallTorque = 0.0;            ///< N·m, at the output
    double stallCurrent = 0.0;           ///< A
    double freeCurrent = 0.0;            ///< A
    double freeSpeed = 0.0;              ///< rpm, at the output
    double gearRatio = 1.0;              ///< rotor turns per output turn
    double inductance = 0.0;             ///< H
    double inertia = 0.0;                ///< kg·m², the rotor's
    int countsPerTurn = 4096;            ///< encoder, per rotor turn
    std::optional<MotorThermal> thermal; ///< stays at air temperature without

    // Derived: one constant for torque and voltage, so that no energy comes from nowhere; what is missing of the
    // vendor's stall torque is a loss that grows with torque.
    double resistance = 0.0; ///< Ohm at 25 °C
    double constant = 0.0;   ///< V·s/rad and N·m/A at 25 °C
    double friction = 0.0;   ///< N·m while moving
    double viscosity = 0.0;  ///< N·m·s/rad
    double torqueLoss = 0.0; ///< fraction of the torque
    double breakaway = 0.0;  ///< N·m at rest

    // Of the motors that tests are meant to fail on:
    double backlash = 0.0;  ///< rad of the rotor, between it and its load as a mass of its own; 0: one mass
    double slipSpeed = 0.0; ///< rad/s in which friction falls from `breakaway` (Stribeck); 0: at the first move

    [[nodiscard]] constexpr double rotorFreeSpeed() const ///< rad/s
    {
        return freeSpeed * 2.0 * std::numbers::pi / 60.0 * gearRatio;
    }
};

/// cim, 775pro, rs775, 25d, 25dlp, n20.
[[nodiscard]] std::span<const MotorParameters> motors();
/// One of them, or one with what no model of a tuning has: cim-backlash, 25d-backlash (two masses), cim-slip, 25d-slip (friction
/// that falls with speed). nullptr when there is no such motor.
[[nodiscard]] const MotorParameters *motorByName(std::string_view name);

/// Battery and bridge between the duty and the motor.
struct MotorSupply {
    double voltage = 12.0;           ///< V, open circuit
    double resistance = 0.02;        ///< Ohm, of battery and cables
    double bridgeResistance = 0.005; ///< Ohm
};

/// What the bridge does: at zero duty Drive and Brake both short the motor, Coast opens the circuit.
enum class Bridge : std::uint8_t { Drive, Brake, Coast };

/// The simulator's brushed motor with an averaged bridge, battery sag, stick and slip, load-dependent loss, heat and
/// encoder. Steps are exact for constant duty and friction (docs/names.md#motor-model), at most 100 µs each; for device loops every
/// multiple of that does. Deterministic, without time and noise of its own.
class MotorModel {
public:
    /// `loadFactor`: inertia of rotor and load together over the rotor's own, ≥ 1.
    explicit MotorModel(const MotorParameters &parameters, double loadFactor = 1.0, MotorSupply supply = {});

    /// `duty` −1…1 (clamped); it counts with Drive only. `seconds` ≥ 0.
    void step(double duty, Bridge bridge, double seconds);

    [[nodiscard]] const MotorParameters &parameters() const { return m_parameters; }
    [[nodiscard]] double current() const { return m_current; } ///< A, through the motor
    [[nodiscard]] double supplyCurrent() const
    {
        return m_duty * m_current;
    }                                                      ///< A, negative while it charges the battery
    [[nodiscard]] double speed() const { return m_speed; } ///< rad/s, rotor
    [[nodiscard]] double angle() const { return m_angle; } ///< rad, rotor
    [[nodiscard]] double busVoltage() const { return m_supply.voltage - m_supply.resistance * supplyCurrent(); } ///< V
    [[nodiscard]] double temperature() const { return m_winding; }        ///< °C, winding
    [[nodiscard]] double housingTemperature() const { return m_housing; } ///< °C
    [[nodiscard]] bool isStuck() const { return m_stuck; }                ///< held by friction or locked

    /// What the encoder counts: whole counts, as it is mounted, or as it stood when it died.
    [[nodiscard]] std::int64_t counts() const;
    /// Counts per second, and the exact position in counts, of the shaft itself.
    [[nodiscard]] double countSpeed() const { return m_speed * countsPerRadian(); }
    [[nodiscard]] double countPosition() const { return m_angle * countsPerRadian(); }

    void setSupplyVoltage(double volts) { m_supply.voltage = volts; }
    /// N·m at the output, against positive rotation (a weight on a rope).
    void setLoadTorque(double torque);
    /// rad of the rotor that its load is free in. The load is where the rotor is.
    void setBacklash(double angle);
    /// Fault: the shaft cannot turn.
    void setLocked(bool locked) { m_locked = locked; }
    /// Fault: the encoder counts the other way round from here on.
    void setEncoderReversed(bool reversed);
    /// Fault: the encoder stays where it is.
    void setEncoderDead(bool dead);
    /// What Simulator::disturb() can do to any motor: "load-torque" (N·m), "stall" (0 or 1), "bus-voltage" (V), "bus-resistance"
    /// (Ohm, of battery and cables), "friction" (times what the motor has), "backlash" (rad of the rotor), "encoder-counts"
    /// (of a rotor turn), "winding-temperature" (°C), "encoder-dead", "encoder-reversed" (0 or 1); false for anything else.
    bool disturb(std::string_view what, double value);
    void setTemperature(double celsius) { m_winding = m_housing = celsius; }

private:
    struct Circuit;

    void stepOnce(double duty, Bridge bridge, double seconds);
    void drive(double duty, double seconds);
    void slip(const Circuit &circuit, double friction, double seconds);
    void coast(double seconds);
    void dragLoad(double seconds);
    [[nodiscard]] bool isTwoMasses() const { return m_parameters.backlash > 0.0; }
    /// N·m, moving, without what grows with the torque.
    [[nodiscard]] double frictionNow() const;
    void heat(double seconds);
    [[nodiscard]] bool isHeld(double torque) const;
    [[nodiscard]] double directionOf(double torque) const;
    [[nodiscard]] double resistanceNow() const;
    [[nodiscard]] double constantNow() const;
    [[nodiscard]] double countsPerRadian() const { return m_parameters.countsPerTurn / (2.0 * std::numbers::pi); }

    MotorParameters m_parameters;
    MotorSupply m_supply;
    double m_loadFactor = 1.0;
    double m_friction = 1.0; ///< times the motor's own
    double m_inertia = 0.0;  ///< that the rotor is fixed to
    double m_weight = 0.0;   ///< N·m on the load
    double m_load = 0.0;     ///< N·m on the rotor: the weight, or what touches in the backlash
    double m_loadSpeed = 0.0;
    double m_loadAngle = 0.0;
    double m_duty = 0.0;
    double m_current = 0.0;
    double m_speed = 0.0;
    double m_angle = 0.0;
    double m_winding = 25.0;
    double m_housing = 25.0;
    bool m_locked = false;
    bool m_stuck = true;
    double m_encoderSign = 1.0;
    double m_encoderOrigin = 0.0; ///< counts
    std::optional<std::int64_t> m_deadCount;
};

} // namespace mb
