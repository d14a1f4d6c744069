// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/visitsection.h"

#include "model/family.h"
#include "report/htmltext.h"
#include "report/metricwords.h"
#include "service/recipe.h"

#include <algorithm>
#include <cmath>

namespace mb {
namespace {

using service::Outcome;
using service::TestValue;
using service::Visit;

/// What the key of a self-test is called, and its unit: without a bus voltage everything is measured in shares of the duty.
QString keyText(const std::string &key, const Family *family)
{
    const bool volts = !family || findChannel(family->channels, "bus_voltage");
    if (key == service::figure::resistance)
        return ReportText::tr("Resistance R, Ω");
    if (key == service::figure::friction)
        return volts ? ReportText::tr("Friction, V") : ReportText::tr("Friction, share of duty");
    if (key == service::figure::gain)
        return volts ? ReportText::tr("Gain 1/Ke, counts/s per V") : ReportText::tr("Gain, counts/s at full duty");
    if (key == service::figure::encoder)
        return ReportText::tr("Encoder counts both ways");
    return escaped(metricWords(key).name);
}

/// A metric as in the tables of trials; of the motor, three digits in the unit that keyText() names.
QString figureOf(const std::string &key, const std::optional<double> &value)
{
    return service::isFigure(key) ? figure(value, 3) : metricText(key, value);
}

QString valueText(const TestValue &value)
{
    if (value.key == service::figure::encoder)
        return value.value.value_or(0.0) != 0.0 ? ReportText::tr("yes") : ReportText::tr("no");
    return figureOf(value.key, value.value);
}

QString limitsText(const TestValue &value)
{
    if (value.key == service::figure::encoder || !value.high)
        return {};
    const QString high = figureOf(value.key, value.high);
    return value.low ? figureOf(value.key, value.low) + QStringLiteral(" … ") + high : QStringLiteral("≤ ") + high;
}

std::optional<double> valueOf(const Visit &visit, const std::string &key)
{
    const auto found = std::ranges::find(visit.test, key, &TestValue::key);
    return found == visit.test.end() ? std::nullopt : found->value;
}

/// The newest before the last one that measured it.
const Visit *earlierOf(const ReportUnit &unit, const std::string &key)
{
    for (std::size_t i = unit.visits.size(); i-- > 1;) {
        if (valueOf(unit.visits[i - 1], key))
            return &unit.visits[i - 1];
    }
    return nullptr;
}

QString testHtml(const ReportUnit &unit)
{
    const Visit &last = unit.visits.back();
    HtmlTable table(QStringLiteral("lrrrl"),
        {ReportText::tr("Self-test"), ReportText::tr("Value"), ReportText::tr("Limits"), ReportText::tr("Before"),
            ReportText::tr("Change")});
    for (const TestValue &value : last.test) {
        const Visit *const earlier = earlierOf(unit, value.key);
        const auto before = earlier ? valueOf(*earlier, value.key) : std::nullopt;
        QString change = value.key == service::figure::encoder ? QString() : changeText(value.value, before);
        if (!change.isEmpty())
            change = ReportText::tr("%1 since %2").arg(change, timeText(earlier->time).left(10));
        table.add({keyText(value.key, unit.family),
            value.passed ? valueText(value) : strong(valueText(value), "danger"), limitsText(value),
            before && value.key != service::figure::encoder ? figureOf(value.key, before) : QString(), change});
    }
    return table.isEmpty() ? QString() : table.html();
}

QString phrased(const Report &report, const Message &text)
{
    return escaped(worded(report.phrase, text));
}

QString firmwareText(const Visit &visit)
{
    const QString before = visit.from.empty() ? QStringLiteral("–") : escaped(visit.from);
    return visit.to.empty() || visit.to == visit.from ? before : before + QStringLiteral(" → ") + escaped(visit.to);
}

} // namespace

QString resultHtml(Outcome outcome)
{
    switch (outcome) {
    case Outcome::Passed: return strong(ReportText::tr("PASS"), "ok");
    case Outcome::Failed: return strong(ReportText::tr("FAIL"), "danger");
    case Outcome::Refused: return strong(ReportText::tr("Refused"), "caution");
    case Outcome::Open: break;
    }
    return strong(ReportText::tr("Not finished"), "caution");
}

QString changeText(std::optional<double> now, std::optional<double> before)
{
    if (!now || !before || *before == 0.0)
        return {};
    const auto percent = std::lround((*now - *before) / std::abs(*before) * 100.0);
    const QString sign = percent < 0 ? QStringLiteral("−") : QStringLiteral("+");
    return sign + QString::number(std::abs(percent)) + QStringLiteral(" %");
}

QString lastVisitHtml(const ReportUnit &unit, const Report &report)
{
    if (unit.visits.empty())
        return {};
    const Visit &visit = unit.visits.back();
    HtmlTable left(QStringLiteral("ll"), {});
    left.add({ReportText::tr("Result"), resultHtml(visit.outcome)});
    left.add({ReportText::tr("Recipe"), strong(escaped(visit.recipe))});
    left.add({ReportText::tr("Served"),
        strong(timeText(visit.time) + QStringLiteral(", ") + escaped(visit.station) + QStringLiteral(", ")
            + escaped(visit.person))});
    HtmlTable right(QStringLiteral("ll"), {});
    right.add({ReportText::tr("Firmware"), strong(firmwareText(visit))});
    if (visit.number)
        right.add({ReportText::tr("Number given"), strong(QString::number(*visit.number))});
    if (visit.parameters)
        right.add({ReportText::tr("Parameters of the recipe"),
            strong(ReportText::tr("%n in the unit, read back", nullptr, *visit.parameters))});
    QString html = heading(2, ReportText::tr("Service")) + beside(left.html(), right.html());
    if (!visit.cause.empty())
        html += paragraph(phrased(report, joined(visit.cause, visit.remedy)), "danger");
    if (!visit.note.empty())
        html += paragraph(escaped(visit.note));
    return html + testHtml(unit);
}

QString visitsHtml(const ReportUnit &unit, const Report &report)
{
    if (unit.visits.size() < 2)
        return {};
    HtmlTable table(QStringLiteral("lllll"),
        {ReportText::tr("Time"), ReportText::tr("Recipe"), ReportText::tr("Result"), ReportText::tr("Firmware"),
            ReportText::tr("Cause or note")});
    for (std::size_t i = unit.visits.size(); i-- > 0;) {
        const Visit &visit = unit.visits[i];
        table.add({timeText(visit.time), escaped(visit.recipe), resultHtml(visit.outcome), firmwareText(visit),
            visit.cause.empty() ? escaped(visit.note) : phrased(report, visit.cause)});
    }
    return heading(2, ReportText::tr("Every service of this unit")) + table.html();
}

} // namespace mb
