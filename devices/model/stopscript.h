// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "wire/canframe.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace mb {

class Link;

/// One message that a guardian sends, and the answer that proves it.
///
/// Without a `reply` it is sent `attempts` times. With one it is sent until the answer came, `attempts` times at most, and then
/// the script goes on anyway. Bytes that come are searched for the reply, whatever stands before it; what came before the
/// message was sent does not count.
struct StopStep {
    std::optional<CanFrame> frame;        ///< on a CAN link
    std::vector<std::uint8_t> bytes;      ///< on the others: a packet, or one transfer; neither: only the wait
    std::vector<std::uint8_t> reply;      ///< bytes of the answer; empty: none is waited for. Not on CAN links
    std::vector<std::uint8_t> replyMask;  ///< bits of `reply` that count; empty: all, else as long as it
    std::chrono::milliseconds wait{50};   ///< for the answer, or between two sends without one; 1 … 500
    int attempts = 1;                     ///< 1 … 100
    std::optional<CanFrame> replyFrame{}; ///< on a CAN link: identifier and length of the answer, whatever is in it
    std::chrono::milliseconds taken{};    ///< of a half-duplex line by the answer, for who does not hear it; 0: `wait`
    bool forAll = false;                  ///< every device of the link obeys it, those that others drive too
};

/// Stops one device without knowing anything of it. Data, so that a process that outlives this one can carry it out; it may
/// come in the middle of a frame or of an exchange, so a protocol that can lose it repeats it. All steps together stay under
/// 200 ms when the device answers. Sending it to a device that stands must do no harm.
struct StopScript {
    std::vector<StopStep> steps;

    [[nodiscard]] bool isEmpty() const { return steps.empty(); }
};

/// Every message once, now, before what waits on the link. Waits for no answer.
void sendScript(Link &link, const StopScript &script);

} // namespace mb
