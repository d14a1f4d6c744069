// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/supermodified/frame.h"
#include "families/supermodified/simulatordrive.h"
#include "families/supermodified/simulatorsettings.h"

#include <deque>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

namespace mb::supermodified::simulation {

/// The firmware without time and wire: bytes in, the bytes of one answer out. Receives as the device does: no resynchronisation,
/// errors in a queue that replaces the next answer and keeps the command from being executed (README.md#one-request).
class Firmware {
public:
    struct Answer {
        std::vector<std::uint8_t> bytes;
        Duration busy{}; ///< before it is sent
    };

    Firmware(Dialect dialect, Drive &drive, const Eeprom &eeprom);

    /// What was in RAM is gone; id, mask and rate are those of the EEPROM.
    void restart(Instant now);
    /// One byte from the line; an answer when it completed a frame for this node.
    [[nodiscard]] std::optional<Answer> take(std::uint8_t byte, Instant now);
    /// Queues an error, or a warning where the level says so.
    void report(std::uint8_t code);
    /// Half a frame waits for its rest; dropped by the newest firmware.
    [[nodiscard]] bool isReceiving() const { return !m_received.empty(); }
    void dropHalf();

    [[nodiscard]] int baudrate() const { return m_baudrate; }
    /// The motor goes on as it was, and nobody is heard any more.
    std::function<void(std::string_view what, double value)> died; ///< crashed (byte count), hung (command)
    /// Whether asking the encoder while the motor is started can hang it (README.md#hang).
    void setHangs(bool hangs) { m_hangs = hangs; }
    /// Counts of the analog inputs, 10 bits.
    std::array<std::uint16_t, analogInputs> analog{512, 512, 512, 512};
    /// Levels of the digital pins, DIO1 in bit 0; nothing is on them.
    std::uint8_t inputs = 0x0F;
    /// Frames of this node (its own id) since it was made: what the fault `power` counts.
    std::function<bool()> beforeAction; ///< false: the supply just went

private:
    using Data = std::span<const std::uint8_t>;
    [[nodiscard]] std::optional<Answer> takeFrame();
    [[nodiscard]] bool accepts(std::uint8_t to) const;
    void execute(std::uint8_t command, Data data, std::vector<std::uint8_t> &reply);
    void set(std::uint8_t command, Data data);
    void move(std::uint8_t command, Data data, bool buffered);
    void act(std::uint8_t command);
    [[nodiscard]] bool hangsIn(std::uint8_t command) const;
    void die(std::string_view what, double value);
    void get(std::uint8_t command, std::vector<std::uint8_t> &reply);
    void doMove();
    [[nodiscard]] bool isKnown(std::uint8_t command) const;
    [[nodiscard]] std::size_t expected(std::uint8_t command) const;
    void checkStored(bool good);
    [[nodiscard]] bool isStarted();
    [[nodiscard]] bool isThird() const { return m_dialect == Dialect::D3; }
    [[nodiscard]] std::size_t speedSize() const { return m_dialect == Dialect::D1 ? 2 : 4; }
    [[nodiscard]] std::size_t placeSize() const { return isThird() ? 8 : 4; }

    struct Buffered {
        std::uint8_t command = 0;
        std::vector<std::uint8_t> data;
    };

    Dialect m_dialect;
    Drive &m_drive;
    Settings m_settings;
    int m_node = factoryNode;
    int m_baudrate = 115200;
    std::uint8_t m_outputs = 0;
    std::vector<std::uint8_t> m_received;
    std::deque<std::uint8_t> m_errors;
    std::deque<std::uint8_t> m_warnings;
    std::optional<Buffered> m_buffered;
    Duration m_busy{};
    bool m_dead = false;
    bool m_hangs = true;
    Instant m_now{};
};

} // namespace mb::supermodified::simulation
