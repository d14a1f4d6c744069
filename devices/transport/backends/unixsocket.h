// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"

#include <cstdint>
#include <string>
#include <vector>

namespace mb {

/// A connected, close-on-exec stream socket; LinkLost with cause and remedy.
[[nodiscard]] Result<int> connectUnixSocket(const std::string &path);
/// A listening, non-blocking stream socket. Replaces a socket that nobody serves any more; LinkLost when somebody does, or
/// when the path is something else.
[[nodiscard]] Result<int> listenOnUnixSocket(const std::string &path);
/// Puts what has come at the end of `in`; false when the other end has gone. Nothing is no end: who shares the socket may have read it.
[[nodiscard]] bool receiveFrom(int descriptor, std::vector<std::uint8_t> &in);
/// What a client is told by a full backlog, or by a server that hangs up on it before any answer.
[[nodiscard]] Error busySocket(const std::string &path);

} // namespace mb
