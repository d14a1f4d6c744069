// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/quadquad2drv/simulatorcommands.h"
#include "families/quadquad2drv/simulatoroutbox.h"
#include "families/quadquad2drv/simulatorreader.h"
#include "simulation/faultplan.h"
#include "simulation/supply.h"
#include "transport/spilink.h"

#include <functional>
#include <list>
#include <vector>

namespace mb::quadquad2drv::simulation {

struct BoardOptions {
    std::array<std::string, axes> motors;
    std::array<double, axes> loads{5.0, 5.0, 5.0, 9.0};
    std::array<std::uint8_t, 3> version{1, 3, 1}; ///< major, minor, protocol
    std::optional<LinkAddress> boot;              ///< the bootloader's serial line
    bool inBootloader = false;                    ///< starts there
    double gainScale = 1.0;                       ///< on the simulator's own
    bool libraryPolarity = true;                  ///< else polarity and edge are as the data sheet says
    bool shiftedTarget = false;                   ///< velocity targets are expected times 4096
    bool jumper = false; ///< AUX1–AUX2 closed while the application runs: the next start enters the bootloader
    std::vector<SimulatedFault> faults;
    std::uint64_t seed = 1;

    [[nodiscard]] static Result<BoardOptions> parse(const SimulatedUnit &unit);
};

/// The board: runs the loop, sends replies and stream packets, raises its ready line, and the faults that come at their time.
class Board final : public SpiSlave {
public:
    using Notify = std::function<void(std::string_view what, double value)>;

    Board(SpiSlaveLink &link, Clock &clock, const BoardOptions &options, Notify notify);
    ~Board() override;

    void transfer(std::span<const std::uint8_t> mosi, std::span<std::uint8_t> miso) override;
    [[nodiscard]] bool isReady() const override { return !m_out.isEmpty(); }
    /// A pulse on the reset line.
    void reset() override;

    /// Hears of each start of the processor (supply, reset) with true, and of the supply's end with false.
    void setStartListener(std::function<void(bool started)> listener) { m_startListener = std::move(listener); }
    void setPowered(bool powered) { m_supply.set(powered); }
    /// This line of firmware came; whether the supply went with it.
    [[nodiscard]] bool failsWithLine(int line);
    /// No application answers while the bootloader runs.
    void setRunning(bool running);
    void setVersion(std::array<std::uint8_t, 3> version) { m_commands.version = version; }
    [[nodiscard]] std::array<std::uint8_t, 3> version() const { return m_commands.version; }
    [[nodiscard]] Axis &axis(int index) { return *m_axes[static_cast<std::size_t>(index)]; }
    [[nodiscard]] const Axis &axis(int index) const { return *m_axes[static_cast<std::size_t>(index)]; }

private:
    using Bytes = std::vector<std::uint8_t>;

    [[nodiscard]] Instant next(Instant due, Duration period) const;
    [[nodiscard]] bool answers() const { return m_supply.isOn() && m_running && m_clock.now() >= m_awake; }
    void loop();
    void begin();
    void restart();
    void execute(const Bytes &packet);
    void send(std::uint8_t id, const Bytes &payload);
    void stream();
    void armStream();
    void scheduleFaults();
    void deliver(Bytes packet);
    void switched(bool on);
    void noteOutput();

    SpiSlaveLink &m_link;
    Clock &m_clock;
    Notify m_notify;
    std::function<void(bool)> m_startListener;
    Axes m_axes;
    Commands m_commands;
    RequestReader m_reader;
    Outbox m_out;
    std::uint8_t m_elapsed = 0;
    bool m_running = true;
    bool m_outputOn = false;
    Instant m_begun{};
    Instant m_due{};   ///< of the loop's next pass
    Instant m_awake{}; ///< the application answers from here on
    Timer m_loop;
    Timer m_stream;
    FaultPlan m_faults;
    Supply m_supply;
    std::list<Timer> m_late; ///< packets that a fault delays
};

} // namespace mb::quadquad2drv::simulation
