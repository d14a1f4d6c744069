// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace mb::guardian {

using Bytes = std::vector<std::uint8_t>;

/// One message to a motor as it is written to the descriptor, and what proves it. See StopStep in devices/model/stopscript.h.
struct Step {
    Bytes bytes;
    Bytes reply; ///< searched for in what comes afterwards; empty: nothing is waited for
    Bytes mask;  ///< as long as `reply`
    std::chrono::milliseconds wait{50};
    int attempts = 1;

    friend bool operator==(const Step &, const Step &) = default;
};

using Script = std::vector<Step>;

/// What the program says to its guardian. One packet of a SOCK_SEQPACKET pair each.
struct Order {
    enum class Kind : std::uint8_t {
        Watch,  ///< stop this device by `script` if I fall silent; answered by Standing
        Renew,  ///< I live; answered by Standing
        Forget, ///< the device is known to stand
        Stop,   ///< stop it now
    };
    Kind kind = Kind::Renew;
    std::uint32_t id = 0; ///< of the device, chosen by the program
    std::string name;     ///< of the device, for the log; of Watch
    Script script;        ///< of Watch

    friend bool operator==(const Order &, const Order &) = default;
};

/// What the guardian says.
struct Report {
    enum class Kind : std::uint8_t {
        Standing, ///< I have descriptor and script
        Acted,    ///< I sent the stop; the device is not watched any more
        Refused,  ///< the order makes no sense
    };
    Kind kind = Kind::Standing;
    std::uint32_t id = 0;
    bool confirmed = false; ///< of Acted: the device answered, where it can
    bool proved = false;    ///< of Acted: it can, and did

    friend bool operator==(const Report &, const Report &) = default;
};

/// Longest packet of either kind.
inline constexpr std::size_t largestMessage = 8192;

[[nodiscard]] Bytes encode(const Order &order);
[[nodiscard]] Bytes encode(const Report &report);
/// Nothing when it is not exactly one legal order: waits of 1 to 500 ms, 1 to 100 attempts, a mask as long as its reply,
/// something to send in each step, a script in Watch and only there.
[[nodiscard]] std::optional<Order> decodeOrder(std::span<const std::uint8_t> packet);
[[nodiscard]] std::optional<Report> decodeReport(std::span<const std::uint8_t> packet);

} // namespace mb::guardian
