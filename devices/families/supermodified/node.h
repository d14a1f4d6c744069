// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/supermodified/line.h"

#include <functional>
#include <optional>

namespace mb::supermodified {

/// How to reach one node.
struct Node {
    int id = factoryNode;
    int baudrate = 57600;
    std::optional<Dialect> dialect; ///< nothing before it is known; only gets are allowed then
};

/// A get, or a set without data.
[[nodiscard]] Line::Request asking(const Node &node, Command command);
/// A set with data; OutOfRange, or Unsupported by this dialect.
[[nodiscard]] Result<Line::Request> setting(const Node &node, Command command, std::int64_t value);
/// To all nodes of the line, without answer.
[[nodiscard]] Line::Request telling(const Node &node, Command command);

/// Gets every error code that a node reports instead of an answer.
using CodeSink = std::function<void(std::span<const std::uint8_t>)>;

/// One exchange with a node: repeated on a time-out and after an error frame, which only means that something went wrong
/// earlier and this command was not executed. Timeout after the last try; Refused when the node goes on refusing. Not for
/// relative moves, which must not be repeated on a time-out. The line outlives the task.
[[nodiscard]] Task<Frame> converse(Line &line, Line::Request request, CodeSink codes, int tries = patientTries);

} // namespace mb::supermodified
