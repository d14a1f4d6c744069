// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/footprint.h"

#include <fstream>

#include <unistd.h>

namespace mb {

std::int64_t residentBytes()
{
    std::ifstream statm("/proc/self/statm");
    std::int64_t total = 0;
    std::int64_t resident = 0;
    statm >> total >> resident;
    return statm ? resident * ::sysconf(_SC_PAGESIZE) : 0;
}

} // namespace mb
