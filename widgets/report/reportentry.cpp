// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/report/reportentry.h"

#include "model/identity.h"
#include "widgets/common/clocktext.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/numberformat.h"
#include "widgets/service/verdictof.h"
#include "wire/number.h"

#include <QCoreApplication>

namespace mb {
namespace {

using service::Outcome;

struct EntryText {
    Q_DECLARE_TR_FUNCTIONS(mb::EntryText)
};

GlyphState glyphOf(Outcome outcome)
{
    switch (outcome) {
    case Outcome::Passed: return GlyphState::Done;
    case Outcome::Failed: return GlyphState::Fault;
    case Outcome::Refused: return GlyphState::Warning;
    case Outcome::Open: break;
    }
    return GlyphState::Waiting;
}

QString wordOf(Outcome outcome)
{
    switch (outcome) {
    case Outcome::Passed: return EntryText::tr("passed");
    case Outcome::Failed: return EntryText::tr("failed");
    case Outcome::Refused: return EntryText::tr("refused");
    case Outcome::Open: break;
    }
    return EntryText::tr("not ended");
}

} // namespace

QString ReportEntry::text() const
{
    const QString when = time > 0.0 ? dateAndClockText(momentOf(time)) : EntryText::tr("as it is now");
    return title + QLatin1Char('\n') + when + (about.isEmpty() ? QString() : QStringLiteral(" · ") + about);
}

bool ReportEntry::contains(const QString &search) const
{
    return (text() + QLatin1Char(' ') + words).contains(search, Qt::CaseInsensitive);
}

bool ReportEntry::isSameAs(const ReportEntry &other) const
{
    return kind == other.kind && visit.id == other.visit.id && unit.unit == other.unit.unit
        && wish.trials == other.wish.trials;
}

ReportEntry entryOf(const service::Visit &visit, const Family *family)
{
    ReportEntry entry;
    entry.kind = ReportEntry::Kind::Visit;
    entry.visit = visit;
    entry.glyph = glyphOf(visit.outcome);
    entry.time = visit.time;
    entry.unit.family = family;
    entry.unit.unit = visit.unit;
    entry.unit.selector = visit.device;
    entry.unit.simulated = visit.simulated;
    entry.unit.identity.family = visit.family;
    entry.unit.identity.serial = visit.serial;
    entry.unit.identity.firmware = visit.to.empty() ? visit.from : visit.to;
    entry.unit.identity.address = visit.number.value_or(wholeFrom<int>(partsOf(visit.device).address).value_or(0));
    entry.wish.unit = visit.unit;
    entry.wish.visit = visit.id;
    service::QueueRow row;
    row.visit = visit;
    const QString number = visit.number ? QStringLiteral(" #%1").arg(*visit.number) : QString();
    entry.title = EntryText::tr("%1 %2: %3").arg(nameOf(row) + number, wordOf(visit.outcome), qt(visit.recipe));
    QStringList about;
    if (!visit.to.empty() && visit.to != visit.from)
        about << qt(visit.from) + QStringLiteral(" → ") + qt(visit.to);
    if (!visit.cause.empty())
        about << messageText(visit.cause);
    about << formatValue(visit.seconds, 1, QStringLiteral("s"));
    if (!visit.note.empty())
        about << qt(visit.note);
    entry.about = about.join(QStringLiteral(" · "));
    entry.words = QStringList{qt(visit.serial), qt(visit.device), qt(visit.station), qt(visit.person),
        messageText(visit.remedy), messageText(visit.evidence)}
                      .join(QLatin1Char(' '));
    return entry;
}

} // namespace mb
