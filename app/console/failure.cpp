// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/failure.h"

#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>

namespace mb::console {
namespace {

/// Where the error itself knows no better. `verb`: that was run; empty before it is known.
std::string remedyOf(Fault fault, std::string_view verb)
{
    switch (fault) {
    case Fault::Timeout: return "check its power, the cable and the bit rate; 'motorbenchctl scan' lists what answers";
    case Fault::Refused: return "'motorbenchctl info' shows what state the device is in";
    case Fault::BadReply: return "the device speaks an unknown dialect or the link is disturbed; try again";
    case Fault::BadCheck: return "read it again with 'motorbenchctl get' before relying on it";
    case Fault::LinkLost: return "'motorbenchctl links' shows what can be opened";
    case Fault::OutOfRange:
        return "'motorbenchctl help" + (verb.empty() ? std::string() : ' ' + std::string(verb))
            + "' tells what is legal";
    case Fault::NotKept: return "see to the rights and the room of its folder";
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
    if (fault == Fault::NotKept)
        return "refused"; // their list is closed
    std::string name(fault == Fault::BadCheck ? "bad check" : toString(fault));
    std::replace(name.begin(), name.end(), ' ', '-');
    return name;
}

std::string causeOf(const Error &error)
{
    return error.detail.empty() ? std::string(toString(error.fault)) : error.detail.english();
}

std::string helpOf(const Error &error, std::string_view verb)
{
    return error.help().empty() ? remedyOf(error.fault, verb) : error.help().english();
}

} // namespace

int exitStatusOf(Fault fault, bool sent)
{
    switch (fault) {
    case Fault::Timeout: return exitSilent;
    case Fault::Refused:
    case Fault::BadReply:
    case Fault::BadCheck:
    case Fault::NotKept:
    case Fault::Cancelled: return exitDevice;
    case Fault::LinkLost: return exitLink;
    case Fault::OutOfRange:
    case Fault::Usage:
    case Fault::Unsupported: return sent ? exitDevice : exitUsage;
    case Fault::Unsafe: return exitSafety;
    }
    return exitDevice;
}

std::string lineOf(const Error &error, std::string_view verb)
{
    return causeOf(error) + "; " + helpOf(error, verb);
}

Error asUsage(const Error &error)
{
    return {Fault::Usage, error.detail, Message::verbatim(helpOf(error, {}))};
}

std::string jsonOf(const Error &error, int status, std::string_view verb)
{
    const QJsonObject row{
        {QStringLiteral("status"), status},
        {QStringLiteral("fault"), QString::fromStdString(nameOf(error.fault))},
        {QStringLiteral("cause"), QString::fromStdString(causeOf(error))},
        {QStringLiteral("remedy"), QString::fromStdString(helpOf(error, verb))},
    };
    return QJsonDocument(QJsonObject{{QStringLiteral("error"), row}}).toJson(QJsonDocument::Compact).toStdString();
}

} // namespace mb::console
