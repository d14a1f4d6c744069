// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/console.h"
#include "wire/candumplog.h"

#include <string>
#include <string_view>

namespace mb::console {

/// Prints frames with what the families make of them: the lines of `decode`, and of `monitor --json`.
class FrameLines {
public:
    /// `dialect`: for families that have several, empty for their usual one.
    FrameLines(Console &console, std::string dialect);
    void print(Duration time, std::string_view link, const CanFrame &frame);

private:
    [[nodiscard]] std::optional<DecodedFrame> decode(const CanFrame &frame) const;
    void printJson(
        Duration time, std::string_view link, const CanFrame &frame, const std::optional<DecodedFrame> &decoded);
    void printText(
        Duration time, std::string_view link, const CanFrame &frame, const std::optional<DecodedFrame> &decoded);

    Console &m_console;
    std::string m_dialect;
};

} // namespace mb::console
