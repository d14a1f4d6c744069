// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"
#include "transport/linkaddress.h"

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mb {

/// What `scan` reports; the first that holds.
enum class DeviceState { Duplicate, Unassigned, Bootloader, Online };

[[nodiscard]] std::string_view toString(DeviceState state);

/// What is known of one controller without talking to it again. Empty text and nothing mean unknown.
struct Identity {
    std::string family;
    int address = 0;
    std::optional<int> session; ///< tells devices of one address apart, where the protocol has one
    std::string name;
    std::string serial;
    DeviceState state = DeviceState::Online;
    std::string firmware; ///< "1.23"
    std::string bootloader;
    std::string dialect;
    Message detail; ///< one sentence for people: what is unusual, and the remedy
    std::vector<std::pair<std::string, std::string>> descriptors; ///< in the device's order, key and text

    friend bool operator==(const Identity &, const Identity &) = default;
};

/// `LINK/FAMILY:ADDRESS[@SESSION]` of docs/names.md#selectors. The device part follows the last `/`.
struct DeviceSelector {
    LinkAddress link;
    std::string family;
    int address = 0;
    std::optional<int> session;

    [[nodiscard]] static Result<DeviceSelector> parse(std::string_view text);
    [[nodiscard]] std::string text() const;
};

/// The parts of a selector as text. They are not checked: the device may be gone, the link another computer's.
struct SelectorParts {
    std::string_view link;    ///< empty where it names none
    std::string_view device;  ///< all that follows the link: `dmc60c:5`, `dmc60c:5@0007`
    std::string_view address; ///< `5`
    std::string_view session; ///< `@0007`; empty: it names none
};
[[nodiscard]] SelectorParts partsOf(std::string_view selector);

/// The selector that finds this device again; with the session only where the address alone is not enough.
[[nodiscard]] DeviceSelector selectorOf(const LinkAddress &link, const Identity &identity);

} // namespace mb
