// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/motorencoder.h"
#include "simulation/motorheat.h"
#include "simulation/motorparameters.h"

#include <cstdint>
#include <numbers>
#include <string_view>

namespace mb {

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
    [[nodiscard]] double temperature() const { return m_heat.winding(); }        ///< °C, winding
    [[nodiscard]] double housingTemperature() const { return m_heat.housing(); } ///< °C
    [[nodiscard]] bool isStuck() const { return m_stuck; }                       ///< held by friction or locked

    /// What the encoder counts: whole counts, as it is mounted, or as it stood when it died.
    [[nodiscard]] std::int64_t counts() const { return m_encoder.counts(countPosition()); }
    /// Counts per second, and the exact position in counts, of the shaft itself.
    [[nodiscard]] double countSpeed() const { return m_speed * countsPerRadian(); }
    [[nodiscard]] double countPosition() const { return m_angle * countsPerRadian(); }

    /// N·m at the output, against positive rotation (a weight on a rope).
    void setLoadTorque(double torque);
    /// Fault: the shaft cannot turn.
    void setLocked(bool locked) { m_locked = locked; }
    /// Fault: the encoder counts the other way round from here on.
    void setEncoderReversed(bool reversed) { m_encoder.setReversed(reversed, countPosition()); }
    /// Fault: the encoder stays where it is.
    void setEncoderDead(bool dead) { m_encoder.setDead(dead, countPosition()); }
    /// What Simulator::disturb() can do to any motor: "load-torque" (N·m), "stall" (0 or 1), "bus-voltage" (V), "bus-resistance"
    /// (Ohm, of battery and cables), "friction" (times what the motor has), "backlash" (rad of the rotor), "turn" (rad of the
    /// rotor, on by hand with its load), "encoder-counts" (of a rotor turn), "winding-temperature" (°C), "encoder-dead", "encoder-reversed"
    /// (0 or 1); false for anything else.
    bool disturb(std::string_view what, double value);

private:
    struct Circuit;

    /// rad of the rotor that its load is free in. The load is where the rotor is.
    void setBacklash(double angle);
    void turn(double angle);
    void stepOnce(double duty, Bridge bridge, double seconds);
    void drive(double duty, double seconds);
    void slip(const Circuit &circuit, double friction, double seconds);
    void coast(double seconds);
    void dragLoad(double seconds);
    [[nodiscard]] bool isTwoMasses() const { return m_parameters.backlash > 0.0; }
    /// N·m, moving, without what grows with the torque.
    [[nodiscard]] double frictionNow() const;
    [[nodiscard]] bool isHeld(double torque) const;
    [[nodiscard]] double directionOf(double torque) const;
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
    MotorHeat m_heat;
    MotorEncoder m_encoder;
    bool m_locked = false;
    bool m_stuck = true;
};

} // namespace mb
