// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/supermodified/simulatorfirmware.h"
#include "families/supermodified/simulatoroptions.h"
#include "transport/seriallink.h"

#include <deque>
#include <functional>

namespace mb::supermodified::simulation {

/// Firmware and motor on a wire and a supply, with faults on demand.
class Unit {
public:
    using Notify = std::function<void(Instant, std::string_view what, double value)>;

    Unit(SerialLink &link, Clock &clock, const UnitOptions &options, Notify notify);
    Unit(const Unit &) = delete;
    Unit &operator=(const Unit &) = delete;

    [[nodiscard]] bool isOutputOn();
    [[nodiscard]] double speed();
    [[nodiscard]] double position();
    [[nodiscard]] double current(); ///< A
    void setPowered(bool powered);
    bool disturb(std::string_view what, double value);

private:
    void receive(std::span<const std::uint8_t> bytes);
    void answer(Firmware::Answer answer);
    void transmit(std::vector<std::uint8_t> bytes);
    void lineError();
    void lookAfter();
    void switched(bool on);
    void loseSupply(Duration time);
    void restart();
    void scheduleFaults();
    [[nodiscard]] bool beforeAction();
    [[nodiscard]] const SimulatedFault *faultFor(std::string_view kind, std::uint64_t number) const;

    SerialLink &m_link;
    Clock &m_clock;
    UnitOptions m_options;
    Notify m_notify;
    Drive m_drive;
    Firmware m_firmware;
    bool m_powered = true;
    bool m_cut = false; ///< by hand: does not return by itself
    std::uint64_t m_sent = 0;
    std::uint64_t m_asked = 0;
    Timer m_reply;
    Timer m_half;
    Timer m_supply;
    Timer m_care;
    std::deque<Timer> m_faults;
    Subscription m_received;
    Subscription m_lineErrors;
};

} // namespace mb::supermodified::simulation
