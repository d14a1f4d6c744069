// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/firmware/queuelines.h"

#include "model/family.h"
#include "model/identity.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/numberformat.h"
#include "widgets/service/verdictof.h"

#include <QCoreApplication>

#include <algorithm>
#include <map>

namespace mb {
namespace {

using service::QueueRow;
using service::RowState;
using service::Step;

struct QueueText {
    Q_DECLARE_TR_FUNCTIONS(mb::QueueText)
};

double secondsSince(Instant then, Instant now)
{
    return std::max(0.0, std::chrono::duration<double>(now - then).count());
}

QString secondsText(double seconds)
{
    return formatValue(seconds, 1, QStringLiteral("s"));
}

double shareOf(const QueueRow &row)
{
    return row.total > 0 ? std::clamp(static_cast<double>(row.done) / row.total, 0.0, 1.0) : 0.0;
}

/// How long a step takes beside the others, on a DMC60C.
double lengthOf(Step step)
{
    switch (step) {
    case Step::Firmware: return 10.0;
    case Step::Test: return 5.0;
    case Step::Proof: return 3.0;
    case Step::Parameters:
    case Step::Number: return 1.0;
    default: return 0.5;
    }
}

/// Of all its steps. Whole only once it has passed: what proves it comes last.
double wholeShare(const QueueRow &row, const service::RecipeMatter *matter)
{
    const auto isDone = [matter](Step step) {
        switch (step) {
        case Step::Firmware: return !matter || matter->recipe.firmware.has_value();
        case Step::Parameters: return !matter || matter->recipe.parameters.has_value();
        case Step::Test: return !matter || matter->recipe.test.has_value();
        case Step::Number: return !matter || matter->recipe.number.has_value();
        case Step::Done: return false;
        default: return true;
        }
    };
    constexpr double most = 0.99;
    double steps = 0.0;
    double ended = 0.0;
    for (const Step step :
        {Step::Preflight, Step::Backup, Step::Firmware, Step::Parameters, Step::Test, Step::Number, Step::Proof}) {
        steps += isDone(step) || step == row.visit.step ? lengthOf(step) : 0.0;
        ended += isDone(step) && step < row.visit.step ? lengthOf(step) : 0.0;
    }
    const double now = shareOf(row) * lengthOf(row.visit.step);
    return row.state == RowState::Passed ? 1.0 : std::min((ended + now) / steps, most);
}

int percentOf(const QueueRow &row, const service::RecipeMatter *matter)
{
    return static_cast<int>(wholeShare(row, matter) * 100.0);
}

QString nameOf(const DeviceView &device)
{
    const QString name = givenName(device);
    return QStringLiteral("#%1").arg(device.identity->address) + (name.isEmpty() ? QString() : QLatin1Char(' ') + name);
}

/// Of a unit that is gone: the last that the journal knows of it.
QString placeOf(const service::Visit &visit)
{
    const SelectorParts parts = partsOf(visit.device);
    return QLatin1Char('#') + qt(parts.address) + qt(parts.session);
}

QString versionsOf(const std::string &from, const std::string &to)
{
    const QString before = from.empty() ? QueueText::tr("none") : qt(from);
    return to.empty() || to == from ? before : before + QStringLiteral(" → ") + qt(to);
}

void describePassed(QueueLine &line, const service::Visit &visit)
{
    line.glyph = GlyphState::Done;
    line.done = 100;
    line.tone = visit.unproved ? Tone::Caution : Tone::Ok;
    line.step = visit.unproved ? QueueText::tr("written, not proved") : QueueText::tr("verified");
    if (visit.parameters)
        line.result = QueueText::tr("%1 parameters equal").arg(*visit.parameters);
    else if (visit.unproved)
        line.result = QueueText::tr("answers with %1, as before").arg(qt(visit.to));
    else if (!visit.to.empty() && visit.from == visit.to)
        line.result = QueueText::tr("already %1").arg(qt(visit.to));
    else
        line.result = QueueText::tr("read back after the restart");
}

void describeOpen(QueueLine &line, const QueueRow &row, const service::RecipeMatter *matter, Instant now)
{
    switch (row.state) {
    case RowState::Running:
        line.glyph = GlyphState::Busy;
        line.step = row.what.empty() ? stepText(row.visit.step) : messageText(row.what);
        line.done = percentOf(row, matter);
        line.time = secondsText(secondsSince(row.startedAt, now));
        line.result = mayUnplug(row) ? QueueText::tr("safe to unplug, resumes") : QueueText::tr("do not unplug");
        line.tone = mayUnplug(row) ? Tone::Dim : row.mayInterrupt ? Tone::Caution : Tone::Danger;
        break;
    case RowState::Waiting:
        line.glyph = GlyphState::Waiting;
        line.step = row.visit.id.empty() ? QueueText::tr("waiting") : QueueText::tr("cut off, goes on");
        line.result = row.visit.id.empty() ? QString() : messageText(row.what);
        line.tone = Tone::Caution;
        line.done = 0;
        break;
    default:
        line.glyph = GlyphState::Volatile;
        line.step = row.visit.id.empty() ? QueueText::tr("left out") : QueueText::tr("cut off");
        line.result = messageText(row.visit.cause);
        line.tone = Tone::Dim;
        break;
    }
}

void describe(QueueLine &line, const QueueRow &row, const service::RecipeMatter *matter, Instant now)
{
    const service::Visit &visit = row.visit;
    switch (row.state) {
    case RowState::Passed: describePassed(line, visit); break;
    case RowState::Failed:
        line.glyph = GlyphState::Fault;
        line.step = QueueText::tr("failed: %1").arg(stepText(visit.step));
        line.done = percentOf(row, matter);
        line.result = messageText(visit.cause);
        line.tone = Tone::Danger;
        break;
    case RowState::Refused:
        line.glyph = GlyphState::Fault;
        line.step = QueueText::tr("refused before start");
        line.result = messageText(visit.cause);
        line.tone = Tone::Danger;
        return;
    case RowState::Running:
    case RowState::Waiting:
    case RowState::Skipped: describeOpen(line, row, matter, now); return;
    }
    line.time = secondsText(visit.seconds);
}

QueueLine lineOfRow(const QueueRow &row, const DeviceView *device, const std::string &version,
    const service::RecipeMatter *matter, Instant now)
{
    QueueLine line;
    line.device = device ? device->id : DeviceId{};
    line.row = row.id;
    line.state = row.state;
    line.serial = qt(row.visit.serial);
    line.title = device ? titleOf(*device) : qt(row.visit.device);
    line.name = device ? nameOf(*device) : placeOf(row.visit);
    line.link = qt(row.link);
    const bool ended = row.state == RowState::Passed || row.state == RowState::Failed;
    const bool untouched = row.state == RowState::Refused || row.state == RowState::Skipped;
    line.firmware = versionsOf(row.visit.from, ended || untouched ? row.visit.to : version);
    describe(line, row, matter, now);
    return line;
}

QueueLine lineOfDevice(const DeviceView &device, const std::string &version)
{
    QueueLine line;
    line.device = device.id;
    line.glyph = glyphOf(device);
    line.serial = qt(device.identity->serial);
    line.title = titleOf(device);
    line.name = nameOf(device);
    line.link = qt(device.link);
    line.firmware = versionsOf(device.identity->firmware, version);
    line.tone = Tone::Caution;
    if (device.identity->state == DeviceState::Duplicate)
        line.result = QueueText::tr("number taken twice");
    else if (device.identity->state == DeviceState::Bootloader)
        line.result = QueueText::tr("in its bootloader");
    else if (device.liveness.moving)
        line.result = QueueText::tr("motor is moving");
    else if (device.liveness.foreignMaster)
        line.result = QueueText::tr("another master drives it");
    return line;
}

/// Boards without numbers are called the same on every link.
void tellApart(std::vector<QueueLine> &lines)
{
    std::map<QString, std::set<QString>> links;
    for (const QueueLine &line : lines)
        links[line.title].insert(line.link);
    for (QueueLine &line : lines) {
        if (links[line.title].size() < 2)
            line.link.clear();
    }
}

} // namespace

std::vector<QueueLine> queueLines(
    const ServiceView &view, const Snapshot &shot, const Family *family, const std::string &version, Instant now)
{
    std::vector<QueueLine> lines;
    std::set<DeviceId> queued;
    const std::string &served = view.matter ? view.matter->imageVersion : version;
    for (const QueueRow &row : view.rows) {
        const DeviceView *device = shot.device(row.device);
        lines.push_back(lineOfRow(row, device, served, view.matter.get(), now));
        if (family && device && device->family != family)
            lines.back().device = {};
        if (device)
            queued.insert(device->id);
        if (isWaitingForArm(view, row)) {
            lines.back().glyph = GlyphState::Waiting;
            lines.back().result = QueueText::tr("hold Arm in the header");
            lines.back().tone = Tone::Caution;
        }
    }
    for (const DeviceView &device : shot.devices) {
        if (family && device.family == family && queued.count(device.id) == 0)
            lines.push_back(lineOfDevice(device, version));
    }
    tellApart(lines);
    return lines;
}

QueueTotals totalsOf(const ServiceView &view, Instant now)
{
    QueueTotals totals;
    totals.mean = meanSeconds(view);
    std::map<std::string, double> left;
    double parts = 0.0;
    for (const QueueRow &row : view.rows) {
        if (row.state == RowState::Skipped)
            continue;
        ++totals.units;
        totals.passed += row.state == RowState::Passed;
        totals.failed += row.state == RowState::Failed;
        totals.refused += row.state == RowState::Refused;
        totals.running += row.state == RowState::Running;
        totals.waiting += row.state == RowState::Waiting;
        if (row.state == RowState::Running)
            parts += wholeShare(row, view.matter.get());
        if (row.state == RowState::Waiting)
            left[row.link] += totals.mean.value_or(0.0);
        if (row.state == RowState::Running)
            left[row.link] += std::max(0.0, totals.mean.value_or(0.0) - secondsSince(row.startedAt, now));
    }
    totals.ended = totals.passed + totals.failed + totals.refused;
    totals.share = totals.units > 0 ? (totals.ended + parts) / totals.units : 0.0;
    if (!totals.mean)
        return totals;
    for (const auto &[link, seconds] : left)
        totals.secondsLeft = std::max(totals.secondsLeft.value_or(0.0), seconds);
    return totals;
}

QString stepText(Step step)
{
    switch (step) {
    case Step::Preflight: return QueueText::tr("Preflight");
    case Step::Backup: return QueueText::tr("Backup");
    case Step::Firmware: return QueueText::tr("Firmware");
    case Step::Parameters: return QueueText::tr("Parameters");
    case Step::Test: return QueueText::tr("Self-test");
    case Step::Number: return QueueText::tr("Number");
    case Step::Proof: return QueueText::tr("Comparison and proof");
    case Step::Done: return QueueText::tr("Done");
    }
    return {};
}

} // namespace mb
