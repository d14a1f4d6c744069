// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/console.h"
#include "files/qttext.h"

#include <QJsonObject>

#include <string>
#include <string_view>
#include <vector>

namespace mb::console {

/// A device as named on the command line, before anything is opened.
struct Target {
    DeviceSelector selector;
    const Family *family = nullptr;
    bool mayBeSilent = false; ///< Session::connect
};

/// OutOfRange: not a selector, an unknown family, an address that none of it has, or one that is not found on this kind of link.
[[nodiscard]] Result<Target> parseTarget(const Console &console, std::string_view text);
[[nodiscard]] Result<const Family *> parseFamily(std::span<const Family *const> families, std::string_view key);
[[nodiscard]] bool serves(const Family &family, LinkKind kind);
/// The links that a list of addresses stands for, `sim:` expanded.
[[nodiscard]] Result<std::vector<LinkAddress>> parseLinks(
    const Console &console, const std::vector<std::string> &texts);

/// Opens the link and finds the device. Where a reset takes every setting it is asked whether one came, and that is noted. A selector that fits several units is wrong usage, not an error of the device.
[[nodiscard]] Task<Device *> connect(Console &console, Target target);
/// The same in a session that lives on another time.
[[nodiscard]] Task<Device *> connectIn(Console &console, Session &session, Target target);
/// Refused while the device waits in its bootloader, where it has neither parameters nor a motor; Unsupported for a recording.
[[nodiscard]] Result<void> needsApplication(const Device &device);

/// Says what of a recording is left out, or may not be whole.
void noteRemark(Console &console, Link &link);
/// Says what a reset took of what was written to it, and how to write it again.
void noteLost(Console &console, const Device &device);
/// A row of `scan`; `name`: UnitNames.
[[nodiscard]] QJsonObject scanRow(const Device &device, const std::string &name);

/// "did you mean X?" when one of `known` is near, else `otherwise`, which lists them.
[[nodiscard]] Message suggestion(
    std::string_view wrong, const std::vector<std::string_view> &known, std::string otherwise);
/// "a, b, c".
[[nodiscard]] std::string joined(const std::vector<std::string_view> &words);
/// OutOfRange where `text`, which is called `name`, is no UTF-8, or a control character of it would end a line or move a cursor.
[[nodiscard]] Result<void> checkName(std::string_view name, const std::string &text);
/// A finite number inside [low, high]; OutOfRange names the argument.
[[nodiscard]] Result<double> parseNumber(std::string_view name, const std::string &text, double low, double high);
/// The same as a target in the unit of this mode: a position is so many counts.
[[nodiscard]] Result<double> parseModeNumber(
    std::string_view name, const std::string &text, Mode mode, double low, double high);
[[nodiscard]] Result<int> parseInteger(std::string_view name, const std::string &text, int low, int high);
/// Of one that may be left out.
[[nodiscard]] Result<int> integerOr(int usual, std::string_view name, const std::string &text, int low, int high);
/// Of --for: nothing when it is not given.
[[nodiscard]] Result<std::optional<Duration>> parseSpan(const std::string &text);

} // namespace mb::console
