// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/dmc60c/simulatorenumeration.h"
#include "families/dmc60c/simulatorheartbeat.h"
#include "families/dmc60c/simulatoroptions.h"
#include "families/dmc60c/simulatorparameterport.h"
#include "families/dmc60c/simulatorvendor.h"
#include "simulation/supply.h"

namespace mb::dmc60c::simulation {

/// One controller: supply, resets, and what it hears.
class Unit final : private Board {
public:
    using Notify = std::function<void(Instant, std::string_view, double)>;

    Unit(CanLink &link, Clock &clock, const UnitOptions &options, Notify notify);

    [[nodiscard]] bool isOutputOn() { return drive().isOutputOn(); }
    [[nodiscard]] double speed() { return drive().rig().speed(); }
    [[nodiscard]] double position() { return drive().rig().position(); }
    [[nodiscard]] double current() { return drive().rig().current(); } ///< A
    void setPowered(bool powered) { m_supply.set(powered); }
    [[nodiscard]] std::vector<std::uint8_t> flash() const { return m_application.bytes(); }
    bool disturb(std::string_view what, double value);

private:
    enum class Stage {
        Off,
        Starting, ///< deaf and mute
        Bootloader,
        Application,
        Dead, ///< there is nothing that could run
    };
    /// What the next start begins with.
    struct Order {
        bool stay = false;                     ///< in the bootloader
        std::optional<CommandStatus> announce; ///< to be said then
    };

    /// As it is now.
    [[nodiscard]] Drive &drive();
    void listen(CanLink &link);
    void scheduleFaults();

    void switched(bool on);
    void start();
    void startBootloader();
    void startApplication();
    void leave(Stage next);
    void resetBySelf();
    void loseBus();

    void receive(const CanFrame &frame);
    void handle(const CanFrame &frame);
    void handleForNumber(std::uint32_t message, const CanFrame &frame);
    void takeMasterStatus(const CanFrame &frame);
    [[nodiscard]] bool sendEnumeration();
    void sendReply(std::uint32_t message, std::span<const std::uint8_t> bytes);
    void notify(Instant time, std::string_view what, double value);

    [[nodiscard]] bool isInBootloader() const override { return m_stage == Stage::Bootloader; }
    void sendStatus(CommandStatus status, std::uint8_t terminal, std::size_t bytes) override;
    void sendData(std::span<const std::uint8_t> bytes) override;
    void restart(bool stay) override;
    [[nodiscard]] bool failsDuring(int page) override;
    void note(std::string_view what, double value) override { notify(m_clock.now(), what, value); }

    Clock &m_clock;
    UnitOptions m_options;
    Notify m_notify;
    std::mt19937_64 m_random;
    ApplicationFlash m_application;
    Processor m_processor;
    ConfigMemory m_memory;
    Drive m_drive;
    VendorPort m_vendor;
    FaultPlan m_faults;
    CanOutbox m_outbox;
    StatusSender m_status;
    ParameterPort m_parameters;
    Enumeration m_enumeration;
    Heartbeat m_heartbeat;
    Stage m_stage = Stage::Off;
    Order m_order;
    Supply m_supply;
    Timer m_startTimer;
    std::array<Subscription, 3> m_heard; ///< frames, others' frames, the state of the link
};

} // namespace mb::dmc60c::simulation
