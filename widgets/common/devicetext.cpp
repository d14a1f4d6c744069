// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/devicetext.h"

#include "widgets/common/numberformat.h"

#include <QCoreApplication>

namespace mb {
namespace {

QString tr(const char *text)
{
    return QCoreApplication::translate("DeviceText", text);
}

} // namespace

QString tableText(std::string_view english)
{
    return QCoreApplication::translate("table", std::string(english).c_str());
}

QString errorText(const Error &error)
{
    const QString detail = QCoreApplication::translate("error", error.detail.c_str());
    switch (error.fault) {
    case Fault::Timeout: return QCoreApplication::translate("DeviceText", "No answer: %1").arg(detail);
    case Fault::Refused: return QCoreApplication::translate("DeviceText", "The device refused: %1").arg(detail);
    case Fault::BadReply: return QCoreApplication::translate("DeviceText", "Unexpected answer: %1").arg(detail);
    case Fault::BadCheck: return QCoreApplication::translate("DeviceText", "Differs: %1").arg(detail);
    case Fault::LinkLost: return QCoreApplication::translate("DeviceText", "Link lost: %1").arg(detail);
    case Fault::OutOfRange: return detail;
    case Fault::Unsupported: return QCoreApplication::translate("DeviceText", "Not possible: %1").arg(detail);
    case Fault::Cancelled: return QCoreApplication::translate("DeviceText", "Cancelled");
    case Fault::Unsafe: return QCoreApplication::translate("DeviceText", "Not done: %1").arg(detail);
    }
    return detail;
}

QString faultText(std::string_view key)
{
    if (key == "over_current")
        return QCoreApplication::translate("DeviceText", "over-current");
    if (key == "over_temperature")
        return QCoreApplication::translate("DeviceText", "over-temperature");
    if (key == "under_voltage")
        return QCoreApplication::translate("DeviceText", "under-voltage");
    if (key == "gate_driver")
        return QCoreApplication::translate("DeviceText", "gate driver");
    if (key == "communication")
        return QCoreApplication::translate("DeviceText", "communication");
    return qt(key);
}

QString modeText(Mode mode)
{
    switch (mode) {
    case Mode::Off: return QCoreApplication::translate("DeviceText", "off");
    case Mode::Duty: return QCoreApplication::translate("DeviceText", "duty");
    case Mode::Velocity: return QCoreApplication::translate("DeviceText", "velocity");
    case Mode::Position: return QCoreApplication::translate("DeviceText", "position");
    case Mode::Current: return QCoreApplication::translate("DeviceText", "current");
    case Mode::Voltage: return QCoreApplication::translate("DeviceText", "voltage");
    case Mode::Follow: return QCoreApplication::translate("DeviceText", "follow");
    case Mode::RampPosition: return QCoreApplication::translate("DeviceText", "profiled position");
    case Mode::RampVelocity: return QCoreApplication::translate("DeviceText", "profiled velocity");
    }
    return {};
}

GlyphState glyphOf(const DeviceView &device)
{
    if (!device.busy.empty())
        return GlyphState::Busy;
    switch (device.identity.state) {
    case DeviceState::Duplicate: return GlyphState::Duplicate;
    case DeviceState::Unassigned: return GlyphState::Unassigned;
    case DeviceState::Bootloader: return GlyphState::Bootloader;
    case DeviceState::Online: break;
    }
    if (!device.liveness.heard)
        return GlyphState::Gone;
    if (!device.liveness.faults.empty())
        return GlyphState::Fault;
    return device.liveness.moving ? GlyphState::Moving : GlyphState::Online;
}

QString titleOf(const DeviceView &device)
{
    return QStringLiteral("%1 #%2").arg(qt(device.family->title)).arg(device.identity.address);
}

QString lineOf(const DeviceView &device)
{
    QString word;
    switch (glyphOf(device)) {
    case GlyphState::Busy: word = QCoreApplication::translate("DeviceText", "busy"); break;
    case GlyphState::Duplicate: word = QCoreApplication::translate("DeviceText", "two units, one number"); break;
    case GlyphState::Unassigned: word = QCoreApplication::translate("DeviceText", "no number yet"); break;
    case GlyphState::Bootloader: word = QCoreApplication::translate("DeviceText", "bootloader, needs firmware"); break;
    case GlyphState::Gone: word = QCoreApplication::translate("DeviceText", "no answer"); break;
    case GlyphState::Fault: word = faultText(device.liveness.faults.front()); break;
    default: {
        const auto velocity = liveValue(device, "velocity", device.telemetry->last({}).value_or(Point {}).time);
        word = velocity ? formatValue(*velocity, 0, QCoreApplication::translate("DeviceText", "counts/s")) : tr("online");
        break;
    }
    }
    const QString name = QString::fromStdString(device.identity.name);
    return name.isEmpty() ? word : name + QStringLiteral(" · ") + word;
}

QString badgeOf(const DeviceView &device)
{
    if (device.identity.state == DeviceState::Bootloader)
        return QCoreApplication::translate("DeviceText", "boot");
    if (device.identity.state == DeviceState::Duplicate)
        return QCoreApplication::translate("DeviceText", "2 ×");
    return QString::fromStdString(device.identity.dialect);
}

QString tooltipOf(const DeviceView &device)
{
    QStringList lines {QString::fromStdString(device.selector)};
    if (!device.identity.serial.empty())
        lines += QCoreApplication::translate("DeviceText", "Serial number %1").arg(QString::fromStdString(device.identity.serial));
    if (!device.identity.detail.empty())
        lines += QCoreApplication::translate("error", device.identity.detail.c_str());
    if (!device.mayNotMove.empty())
        lines += QCoreApplication::translate("error", device.mayNotMove.c_str());
    return lines.join(QLatin1Char('\n'));
}

std::optional<double> liveValue(const DeviceView &device, std::string_view channel, Instant now, Duration staleAfter)
{
    const auto index = device.telemetry->find(channel);
    if (!index)
        return std::nullopt;
    const auto last = device.telemetry->last(*index);
    if (!last || last->isGap() || now - last->time > staleAfter)
        return std::nullopt;
    return last->value;
}

} // namespace mb
