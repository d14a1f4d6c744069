// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/quadquad2drv/axissense.h"
#include "families/quadquad2drv/orderqueue.h"
#include "families/quadquad2drv/settingrequests.h"
#include "model/setpoint.h"

#include <array>

namespace mb::quadquad2drv {

/// OutOfRange, Unsupported: what the board cannot do.
[[nodiscard]] Result<void> checkSetPoint(const SetPoint &setPoint);
/// What a limit of the axis, where it is known, will make of it; empty: nothing. Of a checked one.
[[nodiscard]] Message cautionOf(const SetPoint &setPoint, const ParameterStore &known);

/// What each axis (0…3) was told to do, which the board does not say; set-points become orders. Engine thread.
class AxisDrives {
public:
    /// All outlive it.
    AxisDrives(
        Clock &clock, Telemetry &telemetry, const AxisSense &sense, SettingRequests &settings, OrderQueue &orders)
        : m_clock(clock)
        , m_telemetry(telemetry)
        , m_sense(sense)
        , m_settings(settings)
        , m_orders(orders)
    {
    }

    /// Takes a checked set-point; fails with why the motion before it ended.
    [[nodiscard]] Result<void> command(const SetPoint &setPoint);
    /// All axes are told to stop.
    void stop();
    /// The board was reset.
    void forget() { m_drives = {}; }
    [[nodiscard]] ControlMode controlMode(int axis) const { return m_drives[static_cast<std::size_t>(axis)].mode; }
    [[nodiscard]] bool isDriven(int axis) const { return controlMode(axis) != ControlMode::Off; }
    [[nodiscard]] Mode mode(int axis) const;

private:
    struct Drive {
        ControlMode mode = ControlMode::Off;
        bool shifted = false; ///< Readings::velocityTargetShifted when the mode was taken: never changed in motion
        std::optional<SetPoint> profile{}; ///< of a ramp under way, which is sent once
        bool isLeaving = false;            ///< told to be off, which the board has not accepted yet
    };
    void enter(int axis, ControlMode mode, bool profiled);
    void sendTarget(int axis, const SetPoint &setPoint);
    void record(int axis, std::optional<double> target);

    Clock &m_clock;
    Telemetry &m_telemetry;
    const AxisSense &m_sense;
    SettingRequests &m_settings;
    OrderQueue &m_orders;
    std::array<Drive, axes> m_drives;
};

} // namespace mb::quadquad2drv
