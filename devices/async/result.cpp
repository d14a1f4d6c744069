// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/result.h"

namespace mb {

Message Error::help() const
{
    return command.empty() ? remedy : remedy.empty() ? Message::verbatim(command) : say("%1: %2", remedy, command);
}

Message Error::message() const
{
    return joined(detail, help());
}

Error Error::about(const MessageArgument &what) const
{
    Error error = *this;
    error.detail = Message::composed("%1: %2", {what, detail});
    return error;
}

std::string_view toString(Fault fault)
{
    switch (fault) {
    case Fault::Timeout: return "timeout";
    case Fault::Refused: return "refused";
    case Fault::BadReply: return "bad reply";
    case Fault::BadCheck: return "check failed";
    case Fault::LinkLost: return "link lost";
    case Fault::OutOfRange: return "out of range";
    case Fault::NotKept: return "not kept";
    case Fault::Usage: return "usage";
    case Fault::Unsupported: return "unsupported";
    case Fault::Cancelled: return "cancelled";
    case Fault::Unsafe: return "unsafe";
    }
    return "unknown";
}

} // namespace mb
