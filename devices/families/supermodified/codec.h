// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"
#include "families/supermodified/frame.h"

#include <array>
#include <optional>
#include <span>
#include <string_view>

/// The host's half of the protocol: requests are encoded, replies decoded. Pure functions without state.
namespace mb::supermodified {

/// The data of a message: of the request of a set, of the reply to a get. Little-endian, two's complement.
enum class Format : std::uint8_t {
    Absent, ///< this dialect has no such command
    None,
    U8,
    U16,
    U32,
    I16,
    I32,
    I64,
    Analog,    ///< four U16
    Codes,     ///< 0…8 error or warning codes
    Reactions, ///< 20 bytes, 0…2 each; as a number two bits each, the first lowest
};

[[nodiscard]] std::size_t sizeOf(Format format);

/// One row of the tables in README.md#frames.
struct CommandForm {
    Command command = Command::Stop;
    std::string_view name;
    std::string_view field; ///< of its value
    std::string_view unit;
    std::array<Format, 3> formats{}; ///< D1, D2, D3
    bool control = false;            ///< makes a motor move or changes how it moves
    bool stored = false;             ///< writes EEPROM before it answers

    [[nodiscard]] Format formatIn(Dialect dialect) const { return formats.at(static_cast<std::size_t>(dialect)); }
    /// D3 uses two ids of D1 and D2 for something else.
    [[nodiscard]] std::string_view nameOf(Format format) const;
};
[[nodiscard]] std::span<const CommandForm> messages();
/// nullptr for a command that no dialect has.
[[nodiscard]] const CommandForm *messageOf(std::uint8_t command);
[[nodiscard]] Format formatOf(Command command, Dialect dialect);

// Requests, host to node

/// A get, a broadcast, or a set without data.
[[nodiscard]] Frame request(int node, int host, Command command);
/// A set with data. Unsupported when the dialect has no such command, OutOfRange, with the legal range in the detail, when
/// the value does not fit its width.
[[nodiscard]] Result<Frame> request(int node, int host, Command command, Dialect dialect, std::int64_t value);

// Replies, node to host

/// Whether `reply` comes from `node` to `host` and answers `command`: with its id, or with an error frame.
[[nodiscard]] bool answers(const Frame &reply, int node, int host, Command command);
/// The number in a payload of this format; nothing when its length is not the format's.
[[nodiscard]] std::optional<std::int64_t> valueOf(std::span<const std::uint8_t> payload, Format format);
[[nodiscard]] std::optional<std::array<std::uint16_t, analogInputs>> analogOf(std::span<const std::uint8_t> payload);
/// The codes of an error frame, oldest first; nothing when it is none, or holds other than 1…8.
[[nodiscard]] std::optional<std::span<const std::uint8_t>> codesOf(const Frame &reply);

// Dialects: README.md#dialects

/// What the length of a reply to GetPosition tells: D3, or D1 or D2.
[[nodiscard]] std::optional<bool> isThirdGeneration(const Frame &positionReply);
/// Of D1 and D2, by the reply to GetVelocity.
[[nodiscard]] std::optional<Dialect> dialectByVelocity(const Frame &velocityReply);
[[nodiscard]] std::string_view toString(Dialect dialect);
[[nodiscard]] std::optional<Dialect> dialectFrom(std::string_view text);

// Error codes: README.md#errors

struct CodeName {
    std::uint8_t code = 0;
    std::string_view key;  ///< motor_stalled, …; stable, for JSON
    std::string_view text; ///< English, for people
};
[[nodiscard]] std::span<const CodeName> codeNames();
/// "the motor stalled (01)"; an unknown code as its number.
[[nodiscard]] Message codeText(std::uint8_t code);
[[nodiscard]] Message codesText(std::span<const std::uint8_t> codes);

} // namespace mb::supermodified
