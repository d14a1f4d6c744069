// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/abstractdc/simulatorloops.h"
#include "simulation/canoutbox.h"
#include "simulation/supply.h"

#include <cstdint>
#include <optional>
#include <string_view>

namespace mb::abstractdc::simulation {

/// One drive: its power and its flash, what it hears, and the faults that come at their time.
class Unit {
public:
    using Notify = Shaft::Notify;

    Unit(CanLink &link, Clock &clock, const UnitOptions &options, Notify notify);

    [[nodiscard]] bool isOutputOn() const { return m_shaft.isOutputOn(); }
    [[nodiscard]] double speed();
    [[nodiscard]] double position();
    [[nodiscard]] double current();
    [[nodiscard]] std::optional<std::int64_t> gain(std::string_view key);
    void setPowered(bool powered) { m_supply.set(powered); }
    bool disturb(std::string_view what, double value);

private:
    // Power and faults
    void start();
    void stop();
    void switched(bool on);
    void scheduleFaults();

    // What it hears
    void hear(const CanFrame &frame);
    void dispatch(const CanFrame &frame);
    void onSettings(const CanFrame &frame);
    void onSetPoint(const CanFrame &frame);
    void onLogRequest(const CanFrame &frame);
    void reply(Log log, std::int32_t value);
    [[nodiscard]] std::int32_t positionLog();

    Clock &m_clock;
    UnitOptions m_options;
    Notify m_notify;
    const Dialect &m_dialect;
    SettingsFlash m_flash;
    Shaft m_shaft;
    Loops m_loops;
    FaultPlan m_faults;
    Supply m_supply;
    CanOutbox m_outbox;
    int m_positionLogs = 0;
    bool m_glitchNext = false;
    Subscription m_received;
};

} // namespace mb::abstractdc::simulation
