// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/failure.h"

namespace mb::console {
namespace {

std::string_view remedyOf(Fault fault)
{
    switch (fault) {
    case Fault::Timeout: return "check its power, the cable and the bit rate; 'motorbenchctl scan' lists what answers";
    case Fault::Refused: return "'motorbenchctl info' shows what state the device is in";
    case Fault::BadReply: return "the device speaks an unknown dialect or the link is disturbed; try again";
    case Fault::BadCheck: return "read it again with 'motorbenchctl get' before relying on it";
    case Fault::LinkLost: return "'motorbenchctl links' shows what can be opened";
    case Fault::OutOfRange:
    case Fault::Unsupported: return "see 'motorbenchctl --help'";
    case Fault::Cancelled: return "run it again to finish";
    case Fault::Unsafe: return "remove the cause before the motor is driven";
    }
    return "";
}

} // namespace

int exitStatusOf(Fault fault)
{
    switch (fault) {
    case Fault::Timeout: return exitSilent;
    case Fault::Refused:
    case Fault::BadReply:
    case Fault::BadCheck:
    case Fault::Cancelled: return exitDevice;
    case Fault::LinkLost: return exitLink;
    case Fault::OutOfRange:
    case Fault::Unsupported: return exitUsage;
    case Fault::Unsafe: return exitSafety;
    }
    return exitDevice;
}

std::string lineOf(const Error &error)
{
    std::string line = error.detail.empty() ? std::string(toString(error.fault)) : error.detail;
    const bool namesRemedy = line.find("; ") != std::string::npos;
    return namesRemedy ? line : line + "; " + std::string(remedyOf(error.fault));
}

} // namespace mb::console
