// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/linkload.h"

#include <limits>

namespace mb {

double loadOf(const LinkView &link)
{
    return link.kind == LinkKind::Can || link.bitrate > 0 ? link.load : std::numeric_limits<double>::quiet_NaN();
}

} // namespace mb
