// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/unitsection.h"

#include "files/qttext.h"
#include "model/family.h"
#include "model/unit.h"
#include "report/htmltext.h"

#include <algorithm>
#include <cmath>

namespace mb {
namespace {

constexpr int cardRows = 10; ///< of parameters on a card

void addFact(HtmlTable &table, const QString &name, const std::string &value)
{
    if (!value.empty())
        table.add({name, strong(escaped(value))});
}

QString phrased(const Report &report, std::string_view text)
{
    return escaped(worded(report.phrase, Message::label(text)));
}

} // namespace

QString nameOf(const ReportUnit &unit)
{
    const QString title = unit.family ? qt(unit.family->title) : qt(unit.identity.family);
    return title + QStringLiteral(" ") + QString::number(unit.identity.address);
}

QString identityHtml(const ReportUnit &unit, const Report &report)
{
    const Identity &identity = unit.identity;
    HtmlTable left(QStringLiteral("ll"), {});
    addFact(left, ReportText::tr("Family"), unit.family ? std::string(unit.family->title) : identity.family);
    addFact(left, ReportText::tr("Address"), std::to_string(identity.address));
    addFact(left, ReportText::tr("Name"), identity.name);
    addFact(left, ReportText::tr("Serial number"), identity.serial);
    addFact(left, ReportText::tr("Connected at"), unit.selector);
    HtmlTable right(QStringLiteral("ll"), {});
    addFact(right, ReportText::tr("Firmware"), identity.firmware);
    addFact(right, ReportText::tr("Bootloader"), identity.bootloader);
    addFact(right, ReportText::tr("Dialect"), identity.dialect);
    const auto versions = unit.family ? unit.family->versionEntries : std::span<const std::string_view>();
    for (const auto &[key, text] : identity.descriptors) {
        const bool told
            = text == identity.name || text == identity.serial || std::ranges::find(versions, key) != versions.end();
        if (!text.empty() && !told)
            right.add({phrased(report, key).replace(QLatin1Char('_'), QLatin1Char(' ')), strong(escaped(text))});
    }
    if (unitByOf(unit.unit) == UnitBy::Tag)
        addFact(right, ReportText::tr("Tag"), std::string(unitTagIn(unit.unit)));
    else if (unitByOf(unit.unit) == UnitBy::Place)
        addFact(
            right, ReportText::tr("Known by"), ReportText::tr("its place; another unit may stand there").toStdString());
    return beside(left.html(), right.html());
}

QString changedParametersHtml(const ReportUnit &unit, const Report &report)
{
    QStringList shown;
    int changed = 0;
    for (std::size_t i = 0; unit.family && i < unit.parameters.size() && i < unit.family->parameters.size(); ++i) {
        const Parameter &parameter = unit.family->parameters[i];
        const auto &raw = unit.parameters[i].raw;
        const std::int64_t fallback = std::llround(parameter.fallback * parameter.one);
        if (!raw || unit.parameters[i].state == ParameterState::Failed || parameter.nature != Nature::Setting
            || *raw == fallback || ++changed > cardRows)
            continue;
        shown << escaped(parameter.key) + QLatin1Char(' ') + strong(escaped(shownText(parameter, *raw)), "accent")
                + QLatin1Char(' ') + phrased(report, parameter.unit);
    }
    if (changed == 0)
        return {};
    QString html = heading(2, ReportText::tr("Parameters that differ from their default"))
        + paragraph(shown.join(QStringLiteral(" · ")));
    if (changed > cardRows)
        html += paragraph(ReportText::tr("The first %1 of %2.").arg(cardRows).arg(changed), "dim");
    return html;
}

QString parametersHtml(const ReportUnit &unit, const Report &report)
{
    if (!unit.family || unit.parameters.empty())
        return {};
    HtmlTable table(QStringLiteral("lrrl"),
        {ReportText::tr("Parameter"), ReportText::tr("Value"), ReportText::tr("Default"), ReportText::tr("Unit")});
    int differing = 0;
    int known = 0;
    for (std::size_t i = 0; i < unit.parameters.size() && i < unit.family->parameters.size(); ++i) {
        const Parameter &parameter = unit.family->parameters[i];
        const auto &raw = unit.parameters[i].raw;
        if (!raw || unit.parameters[i].state == ParameterState::Failed)
            continue;
        ++known;
        const std::int64_t fallback = std::llround(parameter.fallback * parameter.one);
        const bool differs = *raw != fallback && parameter.nature == Nature::Setting;
        differing += differs ? 1 : 0;
        const QString value = escaped(shownText(parameter, *raw));
        table.add({phrased(report, parameter.label) + QStringLiteral(" <span class=\"key\">") + escaped(parameter.key)
                + QStringLiteral("</span>"),
            differs ? strong(value, "accent") : value,
            parameter.nature == Nature::Setting ? escaped(shownText(parameter, fallback)) : QString(),
            phrased(report, parameter.unit)});
    }
    if (known == 0)
        return {};
    return heading(2, ReportText::tr("Parameters"))
        + paragraph(
            ReportText::tr("%1 of %2 differ from their default and are set in bold.").arg(differing).arg(known), "dim")
        + table.html();
}

} // namespace mb
