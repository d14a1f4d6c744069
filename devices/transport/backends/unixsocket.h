// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"

#include <string>

namespace mb {

/// A connected, close-on-exec stream socket; LinkLost with cause and remedy.
[[nodiscard]] Result<int> connectUnixSocket(const std::string &path);
/// A listening, non-blocking stream socket. Replaces a socket that nobody serves any more; LinkLost when somebody does, or
/// when the path is something else.
[[nodiscard]] Result<int> listenOnUnixSocket(const std::string &path);
/// What a client is told by a full backlog, or by a server that hangs up on it before any answer.
[[nodiscard]] Error busySocket(const std::string &path);

} // namespace mb
