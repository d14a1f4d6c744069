// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/message.h"
#include "wire/canframe.h"

#include <cstdint>
#include <optional>
#include <string_view>

namespace mb {

/// What a CAN controller still takes part in (ISO 11898-1, fault confinement).
enum class BusState {
    Active,
    Warning, ///< an error counter is at 96 or above
    Passive, ///< at 128 or above: it may no longer destroy frames of others
    BusOff,  ///< the transmit counter passed 255: it is not on the bus any more
};

[[nodiscard]] std::string_view toString(BusState state);

/// What an error frame of the kernel says (linux/can/error.h).
struct CanErrorReport {
    std::optional<BusState> state; ///< the state the controller is in now, when the frame tells
    bool noAcknowledge = false;    ///< nobody acknowledged a frame of ours
    bool arbitrationLost = false;  ///< `arbitrationBit` has the bit, 0 when the controller does not say
    bool protocol = false;         ///< `violation` and `place` say what and where
    bool overrun = false;          ///< the controller's receive buffer overflowed: at least one frame is lost
    bool transmitOverrun = false;
    bool transmitTimeout = false;
    bool transceiver = false; ///< wiring, as far as the transceiver can tell: `wiring`
    bool busError = false;
    bool restarted = false; ///< after bus-off
    int arbitrationBit = 0;
    std::uint8_t violation = 0;        ///< bits of data[2]
    std::uint8_t place = 0;            ///< code of data[3]
    std::uint8_t wiring = 0;           ///< code of data[4]
    std::optional<int> transmitErrors; ///< error counters of the controller, 0…255
    std::optional<int> receiveErrors;

    friend bool operator==(const CanErrorReport &, const CanErrorReport &) = default;
};

/// Decodes an error frame; `frame.error` is set. A class of the frame that is unknown is passed over.
[[nodiscard]] CanErrorReport decodeError(const CanFrame &frame);
/// For people, in one clause: "stuff error in the data, 130 transmit errors, error-passive".
[[nodiscard]] Message describe(const CanErrorReport &report);

} // namespace mb
