// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/failure.h"

#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>

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
    case Fault::OutOfRange: return "'motorbenchctl help VERB' tells what is legal";
    case Fault::Unsupported: return "another family or another link may offer it";
    case Fault::Usage: return "'motorbenchctl help' tells what there is";
    case Fault::Cancelled: return "run it again to finish";
    case Fault::Unsafe: return "remove the cause before the motor is driven";
    }
    return "";
}

/// As JSON spells them (docs/names.md#exit-statuses).
std::string nameOf(Fault fault)
{
    std::string name(fault == Fault::BadCheck ? "bad check" : toString(fault));
    std::replace(name.begin(), name.end(), ' ', '-');
    return name;
}

std::string causeOf(const Error &error)
{
    return error.detail.empty() ? std::string(toString(error.fault)) : error.detail.english();
}

std::string helpOf(const Error &error)
{
    return error.help().empty() ? std::string(remedyOf(error.fault)) : error.help().english();
}

} // namespace

int exitStatusOf(Fault fault, bool sent)
{
    switch (fault) {
    case Fault::Timeout: return exitSilent;
    case Fault::Refused:
    case Fault::BadReply:
    case Fault::BadCheck:
    case Fault::Cancelled: return exitDevice;
    case Fault::LinkLost: return exitLink;
    case Fault::OutOfRange:
    case Fault::Usage:
    case Fault::Unsupported: return sent ? exitDevice : exitUsage;
    case Fault::Unsafe: return exitSafety;
    }
    return exitDevice;
}

std::string lineOf(const Error &error)
{
    return causeOf(error) + "; " + helpOf(error);
}

std::string jsonOf(const Error &error, int status)
{
    const QJsonObject row{
        {QStringLiteral("status"), status},
        {QStringLiteral("fault"), QString::fromStdString(nameOf(error.fault))},
        {QStringLiteral("cause"), QString::fromStdString(causeOf(error))},
        {QStringLiteral("remedy"), QString::fromStdString(helpOf(error))},
    };
    return QJsonDocument(QJsonObject{{QStringLiteral("error"), row}}).toJson(QJsonDocument::Compact).toStdString();
}

} // namespace mb::console
