// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/noncopyable.h"
#include "transport/link.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace mb {

/// One decoded frame of `decode` and the Bus page. Names are those of the protocol's tables.
struct DecodedField {
    std::string_view name;
    double value = 0.0;
    std::string_view unit;
    std::string_view word{}; ///< what this value is called: "velocity" of a mode; empty: it is a number
};
struct DecodedFrame {
    std::string_view family;
    std::string_view message;
    int address = 0;
    bool control = false; ///< makes motors move: sending one by hand needs a confirmation
    std::vector<DecodedField> fields;
};

/// Some bytes that passed a serial link: a whole frame, or what is none.
struct DecodedBytes {
    Duration time{}; ///< of the chunk that completed it
    Direction direction = Direction::Received;
    std::vector<std::uint8_t> bytes;
    std::optional<DecodedFrame> frame; ///< nothing: no frame of this family
};

/// Finds the frames of one family in what passes one serial link; keeps what it needs of earlier bytes, each direction for
/// itself (a request tells how its answer reads). Pure: no clock, no link.
class ByteDecoder : NonCopyable {
public:
    virtual ~ByteDecoder() = default;

    /// Takes a chunk as it passed and appends what is certain now: every byte comes out once, in the order of its direction.
    virtual void take(
        Duration time, Direction direction, std::span<const std::uint8_t> chunk, std::vector<DecodedBytes> &out)
        = 0;
    /// Nothing more comes: appends what still waited for the rest of a frame.
    virtual void finish(std::vector<DecodedBytes> &out) = 0;
};

} // namespace mb
