// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/decoded.h"
#include "tinker/protocol.h"
#include "wire/canframe.h"

#include <optional>

namespace mb::tinker {

struct Status {
    std::int32_t position = 0; ///< counts
    double duty = 0.0;         ///< fraction
    bool stalled = false;
    bool endSwitch = false;
};
struct Here {
    bool loader = false;
    int major = 0;
    int minor = 0;
};
struct ParameterValue {
    std::uint8_t number = 0;
    std::int32_t raw = 0;
};

[[nodiscard]] CanFrame ask(Message message, int address);
[[nodiscard]] CanFrame drive(int address, Drive mode, std::int32_t value);
[[nodiscard]] CanFrame readParameter(int address, std::uint8_t number);
[[nodiscard]] CanFrame writeParameter(int address, ParameterValue value);
[[nodiscard]] CanFrame piece(int address, std::uint16_t at, std::span<const std::uint8_t> four);

/// Nothing for a frame that is not exactly this message of this address.
[[nodiscard]] bool isFrom(const CanFrame &frame, Message message, int address, int size);
[[nodiscard]] std::optional<Status> statusOf(const CanFrame &frame, int address);
[[nodiscard]] std::optional<Here> hereOf(const CanFrame &frame, int address);
[[nodiscard]] std::optional<ParameterValue> valueOf(const CanFrame &frame, int address);

/// Family::decodeCan.
[[nodiscard]] std::optional<DecodedFrame> decode(const CanFrame &frame, std::string_view dialect);

} // namespace mb::tinker
