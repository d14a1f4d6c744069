// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/devicetext.h"

#include "model/axis.h"
#include "model/unit.h"
#include "widgets/common/livetext.h"
#include "widgets/common/numberformat.h"

#include <QCoreApplication>

namespace mb {
namespace {

struct DeviceText {
    Q_DECLARE_TR_FUNCTIONS(DeviceText)
};

} // namespace

QString placeCaveat(std::string_view unit)
{
    return unitByOf(unit) == UnitBy::Place
        ? messageText(say("this place, not this unit: what is kept may be of another")) + QStringLiteral(" · ")
        : QString();
}

QString axesLine(const DeviceView &device)
{
    const auto &all = device.liveness.axes;
    const auto moving = std::ranges::count_if(all, [](const AxisLiveness &axis) { return axis.moving; });
    const int count = device.family->capabilities.axes;
    return moving > 0 ? DeviceText::tr("%1 of %2 axes move").arg(moving).arg(count)
                      : DeviceText::tr("%1 axes").arg(count);
}

bool hasAxes(const Family &family)
{
    return family.capabilities.axes > 1;
}

QString errorText(const Error &error)
{
    const QString detail = messageText(error.message());
    switch (error.fault) {
    case Fault::Timeout: return DeviceText::tr("No answer: %1").arg(detail);
    case Fault::Refused: return DeviceText::tr("The device refused: %1").arg(detail);
    case Fault::BadReply: return DeviceText::tr("Unexpected answer: %1").arg(detail);
    case Fault::BadCheck: return DeviceText::tr("Differs: %1").arg(detail);
    case Fault::LinkLost: return DeviceText::tr("Link lost: %1").arg(detail);
    case Fault::OutOfRange:
    case Fault::NotKept:
    case Fault::Usage: return detail;
    case Fault::Unsupported: return DeviceText::tr("Not possible: %1").arg(detail);
    case Fault::Cancelled: return DeviceText::tr("Cancelled");
    case Fault::Unsafe: return DeviceText::tr("Not done: %1").arg(detail);
    }
    return detail;
}

QString faultText(const Family &family, std::string_view key)
{
    const FaultRow *const row = findFault(family, key);
    const int axis = row ? axisOf(key) : 0;
    const QString label = row ? tableText(row->label) : qt(key);
    return axis > 0 ? DeviceText::tr("axis %1: %2").arg(axis).arg(label) : label;
}

QString modeText(Mode mode)
{
    switch (mode) {
    case Mode::Off: return DeviceText::tr("off");
    case Mode::Duty: return DeviceText::tr("duty");
    case Mode::Velocity: return DeviceText::tr("velocity");
    case Mode::Position: return DeviceText::tr("position");
    case Mode::Current: return DeviceText::tr("current");
    case Mode::Voltage: return DeviceText::tr("voltage");
    case Mode::Follow: return DeviceText::tr("follow");
    case Mode::RampPosition: return DeviceText::tr("profiled position");
    case Mode::RampVelocity: return DeviceText::tr("profiled velocity");
    }
    return {};
}

GlyphState glyphOf(const DeviceView &device)
{
    if (!device.busy.empty())
        return GlyphState::Busy;
    switch (device.identity->state) {
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

GlyphState glyphOf(Severity severity)
{
    switch (severity) {
    case Severity::Good: return GlyphState::Done;
    case Severity::Caution: return GlyphState::Warning;
    case Severity::Danger: return GlyphState::Fault;
    case Severity::Info: break;
    }
    return GlyphState::Volatile;
}

QString givenName(const DeviceView &device)
{
    return device.identity->name == device.family->title ? QString() : qt(device.identity->name);
}

QString bitrateText(const LinkView &link)
{
    return link.bitrate >= 1'000'000 ? DeviceText::tr("%1 Mbit/s").arg(editText(link.bitrate / 1e6))
        : link.bitrate > 0           ? DeviceText::tr("%1 kbit/s").arg(editText(link.bitrate / 1e3))
                                     : QString();
}

QString titleOf(const DeviceView &device)
{
    return QStringLiteral("%1 #%2").arg(qt(device.family->title)).arg(device.identity->address);
}

QString lineOf(const DeviceView &device)
{
    QString word;
    switch (glyphOf(device)) {
    case GlyphState::Busy: word = DeviceText::tr("busy"); break;
    case GlyphState::Duplicate: word = DeviceText::tr("two units, one number"); break;
    case GlyphState::Unassigned: word = DeviceText::tr("no number yet"); break;
    case GlyphState::Bootloader: word = DeviceText::tr("bootloader, needs firmware"); break;
    case GlyphState::Gone: word = DeviceText::tr("no answer"); break;
    case GlyphState::Fault: word = faultText(*device.family, device.liveness.faults.front()); break;
    default: {
        if (hasAxes(*device.family)) {
            word = axesLine(device);
            break;
        }
        if (const QStringList alerts = alertsOf(device); !alerts.isEmpty()) {
            word = alerts.first();
            break;
        }
        const Instant now = device.telemetry->last({}).value_or(Point{}).time;
        const LiveText velocity = liveText(device, "velocity", now);
        word = velocity.isKnown() ? velocity.whole() : DeviceText::tr("online");
        break;
    }
    }
    const QString name = givenName(device);
    return name.isEmpty() ? word : name + QStringLiteral(" · ") + word;
}

QStringList conditionsText(const DeviceView &device)
{
    QStringList clauses;
    for (const StateRow *row : conditionsOf(device.family->states, device.states))
        clauses += tableText(row->clause);
    return clauses;
}

QStringList alertsOf(const DeviceView &device)
{
    QStringList clauses;
    for (const StateRow *row : conditionsOf(device.family->states, device.states)) {
        if (row->kind != StateKind::Rest)
            clauses += tableText(row->clause);
    }
    if (keepsStoppedMove(device))
        clauses += DeviceText::tr("keeps a move");
    return clauses;
}

HealthText healthOf(const DeviceView &device)
{
    if (glyphOf(device) == GlyphState::Gone)
        return {GlyphState::Gone, Tone::Dim, DeviceText::tr("no answer")};
    if (const auto &faults = device.liveness.faults; !faults.empty())
        return {GlyphState::Fault, Tone::Danger, faultText(*device.family, faults.front())};
    if (const QStringList alerts = alertsOf(device); !alerts.isEmpty())
        return {GlyphState::Warning, Tone::Caution, alerts.first()};
    return {GlyphState::Done, Tone::Text, DeviceText::tr("no faults")};
}

bool isOfAxis(const StateRow &row, int axis)
{
    return axis == 0 || axisOf(row.key) == 0 || axisOf(row.key) == axis;
}

QString stateLabel(const StateRow &row)
{
    const int axis = axisOf(row.key);
    return axis > 0 ? DeviceText::tr("axis %1: %2").arg(axis).arg(tableText(row.label)) : tableText(row.label);
}

QString statesText(const DeviceView &device)
{
    QStringList lines;
    for (std::size_t i = 0; i < device.family->states.size(); ++i) {
        const StateRow &row = device.family->states[i];
        const auto on = device.states[StateIndex{static_cast<std::uint16_t>(i)}];
        lines += DeviceText::tr("%1: %2").arg(stateLabel(row),
            !on       ? QString(UnknownMark)
                : *on ? DeviceText::tr("on")
                      : DeviceText::tr("off"));
    }
    return lines.join(QLatin1Char('\n'));
}

QString badgeOf(const DeviceView &device)
{
    if (device.identity->state == DeviceState::Bootloader)
        return DeviceText::tr("boot");
    if (device.identity->state == DeviceState::Duplicate)
        return DeviceText::tr("2 ×");
    return QString::fromStdString(device.identity->dialect);
}

bool keepsStoppedMove(const DeviceView &device)
{
    return device.kept.state == KeptMove::State::Stale;
}

QString tooltipOf(const DeviceView &device)
{
    QStringList lines{QString::fromStdString(device.selector)};
    if (!device.identity->serial.empty())
        lines += DeviceText::tr("Serial number %1").arg(QString::fromStdString(device.identity->serial));
    if (!device.identity->dialect.empty())
        lines += DeviceText::tr("Dialect %1").arg(QString::fromStdString(device.identity->dialect));
    if (!device.identity->detail.empty())
        lines += messageText(device.identity->detail);
    if (!device.mayNotMove.empty())
        lines += messageText(device.mayNotMove);
    lines += conditionsText(device);
    if (keepsStoppedMove(device))
        lines += DeviceText::tr(
            "It keeps a move that was stopped before it began, and would begin it with the next start "
            "on its line. A new move replaces it; switching the unit off clears it.");
    return lines.join(QLatin1Char('\n'));
}

} // namespace mb
