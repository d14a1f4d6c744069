// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "families/dmc60c/simulatorloop.h"
#include "families/dmc60c/simulatorrig.h"
#include "families/dmc60c/simulatorstatus.h"

#include <functional>
#include <span>
#include <string_view>
#include <vector>

namespace mb::dmc60c::simulation {

/// CANCTRL0, 2.11.
struct ControlWord {
    ControlMode mode = ControlMode::NoDrive;
    int slot = 0;
    bool overrideNeutral = false;
    bool brake = false;
    bool reverseSensor = false;
    bool reverseMotor = false;
    bool overrideLimits = false;
    bool forwardLimitOff = false;
    bool reverseLimitOff = false;
    std::int32_t target = 0; ///< 24 bits; duty has its 16, follower the master's number
    std::int32_t ramp = 0;

    [[nodiscard]] static ControlWord decode(std::span<const std::uint8_t> bytes);
};

enum class VelocityWindow { Rolling, Block };

/// The application's motor side: measures, decides and drives every 500 µs (README.md#stopping). It computes nothing until
/// somebody asks: advance() catches up, and skips the time in which nothing could happen.
class Drive {
public:
    using Notify = std::function<void(Instant, std::string_view, double)>;

    Drive(Rig &rig, ParameterBank &bank, VelocityWindow window, Notify notify);

    /// All passes up to `now`.
    void advance(Instant now);
    /// The application starts: halted, neutral, position 0.
    void start(Instant now, bool brakeButton);
    /// The bridge opens and the loop ends: reset, bootloader, or no supply.
    void end(Instant now);
    void command(const ControlWord &word, Instant now);
    /// No control frame for too long, or bus loss; ends the overrides of frames if `busLost`.
    void halt(Instant now, bool busLost);
    void masterHeard(std::int32_t duty, Instant now);
    /// Something outside changed: parameters, switches, supply.
    void wake() { m_quietPasses = 0; }
    /// Fault bits that do not come from the loop: gate driver, communication.
    void setOutsideFault(std::uint32_t bit, bool present, Instant now);

    [[nodiscard]] bool isHalted() const { return m_halted; }
    /// Running: closed loops even at 0, open loops when they drive.
    [[nodiscard]] bool isOutputOn() const { return m_outputOn; }
    [[nodiscard]] bool isDisabled() const { return !m_running || m_halted || m_faulted; }
    [[nodiscard]] int master() const;
    [[nodiscard]] std::int32_t position() const { return static_cast<std::int32_t>(m_position); }
    void setPosition(std::int32_t counts) { m_position = static_cast<std::uint32_t>(counts); }

    [[nodiscard]] GeneralState general() const;
    [[nodiscard]] EncoderState encoder() const;
    [[nodiscard]] AnalogState analog();

private:
    void physics(Instant until);
    void pass(Instant at);
    [[nodiscard]] bool isIdle() const;
    void sense();
    void clearPosition(std::int64_t before, std::int64_t after);
    void readLimits();
    void checkFaults(Instant at);
    void raise(std::uint32_t bits, Instant at);
    [[nodiscard]] std::int32_t demand(Instant at);
    [[nodiscard]] std::int32_t closedLoop();
    [[nodiscard]] std::int32_t compensated();
    [[nodiscard]] bool isClosedLoop() const;
    [[nodiscard]] bool isFollowing() const { return m_command.mode == ControlMode::Follower; }
    [[nodiscard]] std::int32_t present() const;
    void apply(std::int32_t duty, Instant at);
    [[nodiscard]] std::int64_t velocityNow();

    Rig &m_rig;
    ParameterBank &m_bank;
    VelocityWindow m_window;
    Notify m_notify;

    Instant m_nextPass{};
    Instant m_physicsAt{};
    bool m_advancing = false;
    bool m_running = false;
    bool m_halted = true;
    bool m_faulted = false;
    bool m_outputOn = false;
    bool m_brakeButton = true;
    ControlWord m_command;
    std::int32_t m_duty = 0;
    std::int64_t m_error = 0;
    Pid m_pid;
    CurrentLimiter m_limiter;
    LimitPin m_forward;
    LimitPin m_reverse;

    std::int64_t m_lastCounts = 0;
    std::uint32_t m_position = 0;
    std::int64_t m_counter = 0;          ///< like the position, but never written
    std::vector<std::int64_t> m_history; ///< of m_counter, 100 ms
    std::size_t m_historyAt = 0;
    std::int32_t m_velocity = 0;
    std::int64_t m_current = 0; ///< 16.16 A
    std::int32_t m_masterDuty = 0;
    Instant m_masterAt{};

    std::uint32_t m_faults = 0;
    std::uint32_t m_outsideFaults = 0;
    Instant m_faultUntil{};
    int m_lowPasses = 0;
    int m_overCurrentPasses = 0;
    int m_quietPasses = 0;
};

} // namespace mb::dmc60c::simulation
