// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "families/dmc60c/simulatorfaults.h"
#include "families/dmc60c/simulatorlimits.h"
#include "families/dmc60c/simulatorloop.h"
#include "families/dmc60c/simulatorsensing.h"

#include <functional>
#include <string_view>

namespace mb::dmc60c::simulation {

/// The application's motor side: decides and drives every 500 µs (README.md#stopping), by what it measures. It computes nothing until
/// somebody asks: advance() catches up, and skips the time in which nothing could happen.
class Drive {
public:
    using Notify = std::function<void(Instant, std::string_view, double)>;

    /// The bank outlives it.
    Drive(Rig rig, ParameterBank &bank, VelocityWindow window, Notify notify);

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

    /// Running: closed loops even at 0, open loops when they drive.
    [[nodiscard]] bool isOutputOn() const { return m_outputOn; }
    [[nodiscard]] bool isDisabled() const { return !m_running || m_halted || m_faults.holdsBridge(); }
    [[nodiscard]] int master() const { return m_running && isFollowing() ? m_command.target : 0; }
    [[nodiscard]] std::int32_t position() const { return m_sensing.position(); }
    void setPosition(std::int32_t counts) { m_sensing.setPosition(counts); }

    [[nodiscard]] GeneralState general() const;
    [[nodiscard]] EncoderState encoder() const { return m_sensing.encoder(); }
    [[nodiscard]] AnalogState analog();
    [[nodiscard]] Rig &rig() { return m_rig; }

private:
    void physics(Instant until);
    void pass(Instant at);
    [[nodiscard]] bool isIdle() const;
    [[nodiscard]] std::int32_t demand(Instant at);
    [[nodiscard]] std::int32_t closedLoop();
    [[nodiscard]] std::int32_t compensated();
    [[nodiscard]] bool isClosedLoop() const;
    [[nodiscard]] bool isFollowing() const { return m_command.mode == ControlMode::Follower; }
    [[nodiscard]] std::int32_t present() const;
    void apply(std::int32_t duty, Instant at);

    /// What the unit that this one follows has said last.
    struct Master {
        std::int32_t duty = 0;
        Instant at{};
    };

    Rig m_rig;
    ParameterBank &m_bank;
    Notify m_notify;
    Sensing m_sensing;
    Limits m_limits;
    FaultMonitor m_faults;
    Instant m_nextPass{};
    Instant m_physicsAt{};
    bool m_advancing = false;
    bool m_running = false;
    bool m_halted = true;
    bool m_outputOn = false;
    bool m_brakeButton = true;
    ControlWord m_command;
    std::int32_t m_duty = 0;
    std::int64_t m_error = 0;
    Pid m_pid;
    CurrentLimiter m_limiter;
    Master m_master;
    int m_quietPasses = 0;
};

} // namespace mb::dmc60c::simulation
