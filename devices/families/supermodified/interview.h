// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/supermodified/node.h"
#include "model/identity.h"

namespace mb::supermodified {

/// What the gets of README.md#scan say about a node that answers.
struct Interview {
    std::optional<Dialect> dialect; ///< nothing when it refuses to tell
    std::optional<std::uint8_t> mask;
    bool levelOne = false; ///< its error level makes every reading fail (README.md#error-level)
    /// What bounds its moves; nothing when it did not tell.
    std::optional<std::int64_t> gainP;
    std::optional<std::int64_t> profileVelocity;
    std::optional<std::int64_t> profileAcceleration;
};

/// Asks with gets only, and notes the node in the roster of the line. Timeout when it does not answer any more. The line outlives the task.
[[nodiscard]] Task<Interview> interview(Line &line, Node node);

/// The row of a scan.
[[nodiscard]] Identity identityOf(const Roster &roster, const Node &node, const Interview &interview);
/// Mask of a node as identityOf() told it; nothing where it was not read.
[[nodiscard]] std::optional<std::uint8_t> maskOf(const Identity &identity);
/// The other way round: what a row says about how to reach the node.
[[nodiscard]] Node nodeOf(const Identity &identity, const SerialLink &link);

} // namespace mb::supermodified
