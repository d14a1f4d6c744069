// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/dmc60c/simulatoroptions.h"
#include "families/dmc60c/simulatoroutbox.h"
#include "families/dmc60c/simulatorvendor.h"

#include <deque>
#include <memory>

namespace mb::dmc60c::simulation {

/// One controller: supply, resets, session, what it hears and when it says it.
class Unit final : private Board {
public:
    using Notify = std::function<void(Instant, std::string_view, double)>;

    Unit(CanLink &link, Clock &clock, const UnitOptions &options, Notify notify);
    ~Unit() override;

    [[nodiscard]] bool isOutputOn();
    [[nodiscard]] double speed();
    [[nodiscard]] double position();
    void setPowered(bool powered);
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
    struct Stall {
        Duration time;
        std::function<void()> then;
    };

    void listen();
    void scheduleFaults();
    void scheduleFault(const SimulatedFault &fault);
    void at(double seconds, std::function<void()> work);

    void losePower(bool returns);
    void start();
    void startBootloader();
    void startApplication();
    void leave(Stage next);
    void resetBySelf();
    void loseBus();

    void receive(const CanFrame &frame);
    [[nodiscard]] bool isAddressed(const CanFrame &frame) const;
    void hear();
    void handle(const CanFrame &frame);
    void handleForNumber(std::uint32_t message, const CanFrame &frame);
    void drain();
    void overhear(const CanFrame &frame);
    void enumerate();
    void sendEnumeration();
    void control(const CanFrame &frame);
    void heartbeatMissed();
    void readParameter(std::uint8_t id);
    void writeParameter(std::uint8_t id, std::uint32_t raw);
    void answer(std::uint8_t id, std::uint32_t raw, ParameterStatus status);
    [[nodiscard]] bool isAcceptable(const Row &row, std::uint32_t raw) const;
    void configChanged(std::function<void()> then);
    void writeConfig(std::function<void()> then);

    void startStatus();
    void stopStatus();
    void armStatus(std::uint8_t period, Instant due);
    void sendStatusFrame(std::uint8_t period, Instant due);
    [[nodiscard]] Timer &statusTimer(std::uint8_t period);
    [[nodiscard]] Duration period(std::uint8_t id) const { return std::chrono::milliseconds(m_ram.parameters.raw(id)); }

    void runStall();
    void endStall();
    [[nodiscard]] Duration replyDelay();
    void sendReply(std::uint32_t message, std::span<const std::uint8_t> bytes);
    void notify(Instant time, std::string_view what, double value);

    [[nodiscard]] bool isInBootloader() const override { return m_stage == Stage::Bootloader; }
    void sendStatus(CommandStatus status, std::uint8_t terminal, std::size_t bytes) override;
    void sendData(std::span<const std::uint8_t> bytes) override;
    void stall(Duration time, std::function<void()> then) override;
    void restart(bool stay) override;
    [[nodiscard]] ConfigImage &config() override { return m_ram; }
    void commitConfig() override;
    [[nodiscard]] ApplicationFlash &application() override { return m_application; }
    [[nodiscard]] CrcVariant crcVariant() const override { return m_options.crc; }
    [[nodiscard]] bool failsDuring(int page) override;
    void note(std::string_view what, double value) override { notify(m_clock.now(), what, value); }

    CanLink &m_link;
    Clock &m_clock;
    UnitOptions m_options;
    Notify m_notify;
    std::mt19937_64 m_random;

    ApplicationFlash m_application;
    ConfigImage m_flash;
    ConfigImage m_ram;
    Rig m_rig;
    Drive m_drive;
    VendorPort m_vendor;
    Outbox m_outbox;

    Stage m_stage = Stage::Off;
    bool m_takenAway = false; ///< by setPowered(false)
    bool m_stay = false;
    std::optional<CommandStatus> m_announce; ///< after the reset
    std::uint16_t m_session = 0;
    std::optional<std::uint16_t> m_nextSession;
    bool m_busOff = false;
    std::uint64_t m_addressed = 0;
    std::deque<Stall> m_stalls;
    std::deque<CanFrame> m_fifo;
    bool m_heartbeatMissed = false;
    std::optional<Instant> m_configChanged;

    Timer m_startTimer;
    Timer m_enumTimer;
    Timer m_heartbeat;
    Timer m_stallTimer;
    Timer m_configTimer;
    Timer m_busTimer;
    Timer m_general;
    Timer m_encoder;
    Timer m_analog;
    std::vector<std::unique_ptr<Timer>> m_faultTimers;
    Subscription m_received;
    Subscription m_traffic;
    Subscription m_stateChanged;
};

} // namespace mb::dmc60c::simulation
