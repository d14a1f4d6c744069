// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/abstractdc/protocol.h"
#include "wire/canframe.h"

#include <array>
#include <optional>

/// The host's half of the wire: requests are encoded, replies are decoded. Pure functions. Offsets are 0…99; values are
/// two's complement, low byte first, whatever the document's drawing says (README.md#byte-order).
namespace mb::abstractdc {

/// The dialect must be able to say the loop (`Dialect::codeOf`).
[[nodiscard]] CanFrame encodeSetPoint(const Dialect &dialect, int offset, Loop loop, std::int32_t value);
[[nodiscard]] CanFrame encodeSettings(const Dialect &dialect, int offset, Loop loop, Field field, std::int32_t value);
[[nodiscard]] CanFrame encodeSave(const Dialect &dialect, int offset, Loop loop);
/// The dialect must have the log.
[[nodiscard]] CanFrame encodeLogRequest(const Dialect &dialect, int offset, Log log);

/// README.md#no-watchdog: each firmware ignores the other's length, so both together stop a drive of any dialect that can be stopped.
[[nodiscard]] std::array<CanFrame, 2> stopFrames(int offset);

struct LogReply {
    Log log = Log::Position;
    std::int32_t value = 0;
};
/// The answer of the drive with this offset. A voltage log without offset fits every drive: whoever asked last is meant.
[[nodiscard]] std::optional<LogReply> decodeLog(const Dialect &dialect, int offset, const CanFrame &frame);
/// Identifier of the answer.
[[nodiscard]] std::uint32_t replyId(const Dialect &dialect, int offset, Log log);

/// A frame of another host to this drive: its loop (None when it stops it).
[[nodiscard]] std::optional<Loop> decodeSetPoint(const Dialect &dialect, int offset, const CanFrame &frame);
struct SettingsFrame {
    Loop loop = Loop::None;
    Field field = Field::P;
    std::int32_t value = 0;
};
[[nodiscard]] std::optional<SettingsFrame> decodeSettings(const Dialect &dialect, int offset, const CanFrame &frame);
/// The loop whose settings it saves.
[[nodiscard]] std::optional<Loop> decodeSave(const Dialect &dialect, int offset, const CanFrame &frame);

/// Bit times of a request and its answer, worst case of stuffing (README.md#rates).
constexpr int roundTripBits = 65 + 95;

} // namespace mb::abstractdc
