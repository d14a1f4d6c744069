// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/sourcetree.h"

namespace mb {

std::string inSourceTree(const std::string &relative)
{
    return MOTORBENCH_SOURCE_DIR "/" + relative;
}

} // namespace mb
