// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/noncopyable.h"
#include "families/supermodified/simulatorfirmware.h"
#include "families/supermodified/simulatoroptions.h"
#include "simulation/faultplan.h"
#include "simulation/supply.h"
#include "transport/seriallink.h"

#include <functional>

namespace mb::supermodified::simulation {

/// Firmware and motor on a wire and a supply, with faults on demand.
class Unit : NonCopyable {
public:
    using Notify = std::function<void(Instant, std::string_view what, double value)>;

    Unit(SerialLink &link, Clock &clock, const UnitOptions &options, Notify notify);

    [[nodiscard]] bool isOutputOn() { return drive().isOn(); }
    [[nodiscard]] double speed() { return drive().encoder().shaftSpeed(); }
    [[nodiscard]] double position() { return drive().encoder().shaftPosition(); }
    [[nodiscard]] double current() { return drive().motor().current(); } ///< A
    void setPowered(bool powered) { m_supply.set(powered); }
    bool disturb(std::string_view what, double value);

private:
    /// As it is now.
    [[nodiscard]] Drive &drive();
    void receive(std::span<const std::uint8_t> bytes);
    void answer(Firmware::Answer answer);
    void transmit(std::vector<std::uint8_t> bytes);
    void lineError();
    void lookAfter();
    void switched(bool on);
    void fed(bool on);
    void restart();
    void scheduleFaults();
    [[nodiscard]] bool beforeAction();

    SerialLink &m_link;
    Clock &m_clock;
    UnitOptions m_options;
    Notify m_notify;
    Drive m_drive;
    Firmware m_firmware;
    FaultPlan m_faults;
    Supply m_supply;
    Timer m_reply;
    Timer m_half;
    Timer m_care;
    Subscription m_received;
    Subscription m_lineErrors;
};

} // namespace mb::supermodified::simulation
