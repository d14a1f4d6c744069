// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"
#include "transport/link.h"

#include <string>
#include <vector>

#include <sys/types.h>

namespace mb {

// The system calls that start a guardian, apart from what is said to it.

struct GuardianProcess {
    pid_t pid = -1;
    int socket = -1; ///< packets; closing it is the end of the guardian, after it has stopped what it watches
};

/// How the guardian finds its line again, and where it leaves what it owes.
struct GuardedLine {
    Outlet outlet;
    std::string folder;   ///< of guardian::DebtBook
    std::string identity; ///< linkIdentity()
    std::string name;     ///< of today: can0, /dev/ttyUSB0, the path of a socket
};

/// Starts `program` for what this outlet leads to, in a session of its own, so that no key of the terminal reaches it. It
/// inherits standard error, its socket, a duplicate of the outlet's descriptor, and nothing else. Fails with Unsafe.
[[nodiscard]] Result<GuardianProcess> startGuardian(const std::string &program, const GuardedLine &line);

/// motorbench-guardian in the folder of the running program.
[[nodiscard]] std::string guardianBesideThisProgram();

/// Forgets those that have ended; what it leaves in the list still runs.
void reap(std::vector<pid_t> &ended);

} // namespace mb
