// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/quadquad2drv/protocol.h"
#include "simulation/motormodel.h"

#include <array>
#include <cstdint>
#include <deque>

namespace mb::quadquad2drv::simulation {

/// Of the board's control loop (README.md#gain-scale says that the scale is not documented; these make the default gains step well).
constexpr double loopSeconds = 0.002;

/// Power units per raw gain and count (or count/s), and per pass of the loop for I and D; all times AxisSettings' scale.
namespace gain {
constexpr double positionP = 0.05;
constexpr double positionI = 1e-4;
constexpr double positionD = 0.2;
constexpr double velocityP = 0.01;
constexpr double velocityI = 3.5e-5;
constexpr double velocityD = 1e-5;
} // namespace gain

/// Speed from the edges of a moving window: it ends with 4 · length edges, or with the time limit (README.md#times-4096).
class SpeedWindow {
public:
    void configure(int length, int timeBits);
    void add(double seconds, std::int64_t counts);
    void clear() { m_points.clear(); }
    [[nodiscard]] double speed() const { return m_speed; }

private:
    struct Point {
        double seconds = 0.0;
        std::int64_t counts = 0;
    };
    std::deque<Point> m_points;
    std::int64_t m_edges = 4 * 31;
    double m_longest = 0.67108864;
    double m_speed = 0.0;
};

struct AxisSettings {
    std::uint8_t dataMask = datamask::startUp;
    std::array<std::uint16_t, 4> positionGains{100, 500, 500, 600};
    std::array<std::uint16_t, 3> velocityGains{100, 200, 500};
    std::uint16_t powerLimit = fullPower;
    std::uint32_t velocityLimit = 0; ///< raw; set by the constructor
    std::uint32_t accelerationLimit = 0;
    std::uint8_t input = 0;
    std::uint16_t inputSpacing = 0;
    std::int32_t inputPosition = 0;
    ControlMode mode = ControlMode::Off;
    std::int16_t power = 0;
    std::int32_t positionTarget = 0;
    double velocityTarget = 0.0;
    double rampVelocity = 0.0;     ///< 0: none under way
    double rampAcceleration = 0.0; ///< 0: none
};

/// One channel of the board with its motor: encoder counter, input, limits and the two loops.
class Axis {
public:
    Axis(const MotorParameters &motor, double load);
    /// What the maker does not tell: how much a raw gain is, and which bit of an input means low.
    void setNature(double scale, bool libraryPolarity)
    {
        m_scale = scale;
        m_libraryPolarity = libraryPolarity;
    }

    AxisSettings settings;

    /// One pass of the loop, `seconds` of the board's time from its start.
    void step(double seconds);
    /// RAM is gone, the shaft stays where it is.
    void reset();
    void setHistory(int length, int timeBits) { m_window.configure(length, timeBits); }
    void setMode(ControlMode mode);
    void setCounter(std::int32_t value);
    void setInputLevel(bool high) { m_inputHigh = high; }

    [[nodiscard]] std::int32_t counter() const { return static_cast<std::int32_t>(m_motor.counts() - m_origin); }
    [[nodiscard]] std::int32_t velocity() const;
    /// Reading clears what accumulates (README.md#inputs).
    [[nodiscard]] std::uint8_t takeStatus();
    /// The change since the last call, for relative mode (README.md#stream).
    [[nodiscard]] std::int32_t takeChange();
    [[nodiscard]] double output() const { return m_output; } ///< −8191…8191
    [[nodiscard]] MotorModel &motor() { return m_motor; }
    [[nodiscard]] const MotorModel &motor() const { return m_motor; }

private:
    [[nodiscard]] double positionLoop();
    [[nodiscard]] double velocityLoop();
    [[nodiscard]] double velocityLimit() const;
    [[nodiscard]] double accelerationLimit() const;
    void advanceReference();
    void watchInput();
    void trigger(bool positive);

    MotorModel m_motor;
    double m_scale = 1.0;
    bool m_libraryPolarity = true;
    SpeedWindow m_window;
    std::int64_t m_origin = 0;
    std::int32_t m_lastRead = 0;
    std::uint8_t m_status = 0;
    bool m_inputHigh = true; ///< pulled up, nothing connected
    bool m_wasActive = false;
    double m_reference = 0.0;         ///< counts
    double m_referenceVelocity = 0.0; ///< counts/s
    double m_integral = 0.0;          ///< power units
    double m_lastError = 0.0;
    double m_output = 0.0;
};

} // namespace mb::quadquad2drv::simulation
