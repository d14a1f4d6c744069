// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/result.h"

namespace mb {

std::string_view toString(Fault fault)
{
    switch (fault) {
    case Fault::Timeout: return "timeout";
    case Fault::Refused: return "refused";
    case Fault::BadReply: return "bad reply";
    case Fault::BadCheck: return "check failed";
    case Fault::LinkLost: return "link lost";
    case Fault::OutOfRange: return "out of range";
    case Fault::Unsupported: return "unsupported";
    case Fault::Cancelled: return "cancelled";
    case Fault::Unsafe: return "unsafe";
    }
    return "unknown";
}

} // namespace mb
