// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mb {

/// What travels on a link: frames, bytes, or full-duplex transfers.
enum class LinkKind { Can, Serial, Spi };

[[nodiscard]] std::string_view toString(LinkKind kind);

/// `SCHEME:PATH?KEY=VALUE&…` of docs/names.md#links: `sim:can?loss=0.1`, `socketcan:can0`, `serial:/dev/ttyUSB0?baud=57600`.
struct LinkAddress {
    std::string scheme;
    std::string path;
    std::vector<std::pair<std::string, std::string>> options; ///< in the order given; `fault` may repeat

    /// Fails with OutOfRange: no scheme, unknown scheme, empty path where one is needed, an option without a value, or one that is there twice (but `fault`).
    [[nodiscard]] static Result<LinkAddress> parse(std::string_view text);
    [[nodiscard]] std::string text() const;
    /// The part people read: `sim:can`, `can0`, `ttyUSB0`.
    [[nodiscard]] std::string shortName() const;
    [[nodiscard]] std::optional<std::string_view> option(std::string_view key) const;
    [[nodiscard]] bool isSimulated() const { return scheme == "sim"; }
    /// Nothing can be sent: what is found there can be watched, no more.
    [[nodiscard]] bool isRecording() const { return scheme == "replay"; }
    /// Unsupported where it is one: nobody is there who could answer.
    [[nodiscard]] Result<void> takesOrders() const;

    friend bool operator==(const LinkAddress &, const LinkAddress &) = default;
};

/// Of an address as text; false where it is none.
[[nodiscard]] bool isSimulatedLink(std::string_view address);
/// Of the link that an address names; a path that stands for all simulated links counts as CAN.
[[nodiscard]] LinkKind kindOf(const LinkAddress &address);

} // namespace mb
