// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/service/verdictof.h"

#include "model/setpoint.h"
#include "service/figuretext.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/numberformat.h"
#include "widgets/common/pagekeys.h"

#include <QCoreApplication>

#include <algorithm>
#include <limits>

namespace mb {
namespace {

using service::QueueRow;
using service::RowState;

struct BenchText {
    Q_DECLARE_TR_FUNCTIONS(mb::BenchText)
};

constexpr std::size_t mostFacts = 6;
constexpr int fewestForARate = 5; ///< units; three that are done in a minute say nothing of an hour

bool hasEnded(RowState state)
{
    return state == RowState::Passed || state == RowState::Failed || state == RowState::Refused;
}

/// Begun, and ended before anything was judged: it goes on where it was when it is tested again.
bool isCutOff(const QueueRow &row)
{
    return row.state == RowState::Skipped && !row.visit.id.empty();
}

bool hasVerdict(const QueueRow &row)
{
    return hasEnded(row.state) || isCutOff(row);
}

/// One that went on after a cut was opened long before.
double endOf(const service::Visit &visit)
{
    return visit.steps.empty() ? visit.time + visit.seconds : visit.steps.back().time;
}

/// A cause begins small where it stands behind the name of a unit; alone it is a sentence.
QString asSentence(QString text)
{
    if (!text.isEmpty())
        text.front() = text.front().toUpper();
    return text;
}

QString boundsOf(const service::TestValue &value)
{
    if (!value.high || value.key == service::figure::encoder)
        return {};
    const QString high = quantityText(service::figureNumber(value.key, *value.high));
    return value.low ? BenchText::tr("%1 … %2").arg(quantityText(service::figureNumber(value.key, *value.low)), high)
                     : BenchText::tr("at most %1").arg(high);
}

QString valueOf(const service::TestValue &value)
{
    if (!value.value)
        return UnknownMark;
    if (value.key == service::figure::encoder)
        return *value.value != 0.0 ? BenchText::tr("yes") : BenchText::tr("no");
    return quantityText(service::figureNumber(value.key, *value.value));
}

/// Nothing had to be done to it.
bool hadEverything(const service::Visit &visit)
{
    return visit.outcome == service::Outcome::Passed && !visit.to.empty() && visit.from == visit.to && !visit.unproved
        && !visit.parameters && visit.test.empty() && !visit.number;
}

QString versionsOf(const service::Visit &visit)
{
    return visit.from == visit.to || visit.to.empty() ? qt(visit.from)
                                                      : qt(visit.from) + QStringLiteral(" → ") + qt(visit.to);
}

std::vector<Verdict::Fact> factsOf(const service::Visit &visit)
{
    std::vector<Verdict::Fact> facts;
    if (!visit.from.empty() || !visit.to.empty())
        facts.push_back({BenchText::tr("firmware"), versionsOf(visit),
            visit.to.empty()             ? QString()
                : visit.unproved         ? BenchText::tr("written, not proved")
                : visit.from == visit.to ? BenchText::tr("was there already")
                                         : BenchText::tr("it answers with it")});
    if (visit.parameters)
        facts.push_back({BenchText::tr("parameters"), BenchText::tr("%1 equal").arg(*visit.parameters),
            BenchText::tr("read back")});
    if (visit.snapshot)
        facts.push_back({BenchText::tr("backup"), BenchText::tr("kept"), BenchText::tr("before the first write")});
    for (const service::TestValue &value : visit.test)
        facts.push_back({messageText(service::figureName(value.key)), valueOf(value),
            value.unusual ? BenchText::tr("unusual, %1").arg(boundsOf(value)) : boundsOf(value)});
    if (facts.size() > mostFacts)
        facts.resize(mostFacts);
    return facts;
}

Verdict::Kind kindOf(RowState state)
{
    switch (state) {
    case RowState::Passed: return Verdict::Kind::Passed;
    case RowState::Failed: return Verdict::Kind::Failed;
    case RowState::Refused: return Verdict::Kind::Refused;
    case RowState::Running: return Verdict::Kind::Working;
    case RowState::Skipped: return Verdict::Kind::LeftOut;
    case RowState::Waiting: break;
    }
    return Verdict::Kind::Waiting;
}

QString linksOf(const ServiceView &view)
{
    QStringList links;
    for (const std::string &link : view.links)
        links << qt(link);
    return links.join(QStringLiteral(", "));
}

/// Of the next unit, while units are served.
QString whenItStarts(const ServiceView &view)
{
    return view.pausing ? BenchText::tr("Paused: no unit starts before the queue goes on.")
                        : BenchText::tr("It starts by itself when it answers on %1.").arg(linksOf(view));
}

Verdict waiting(const ServiceView &view)
{
    Verdict verdict;
    if (!view.trouble.empty()) {
        verdict.kind = Verdict::Kind::Refused;
        verdict.cause = messageText(view.trouble);
    } else if (view.running) {
        verdict.next = BenchText::tr("Connect a unit");
        verdict.hint = whenItStarts(view);
    } else {
        verdict.next = BenchText::tr("Open a recipe, then Start");
    }
    return verdict;
}

const QueueRow *running(const ServiceView &view)
{
    const auto found = std::ranges::find(view.rows, RowState::Running, &QueueRow::state);
    return found == view.rows.end() ? nullptr : &**found;
}

} // namespace

const QueueRow *lastEnded(const ServiceView &view, const SetAside &setAside)
{
    if (running(view))
        return nullptr;
    const QueueRow *last = nullptr;
    for (const QueueRow &row : view.rows) {
        const bool seen = setAside.contains({row.id, row.visit.id, row.tries});
        if (hasVerdict(row) && !seen && (!last || endOf(row.visit) >= endOf(last->visit)))
            last = &row;
    }
    return last;
}

void setAllAside(const ServiceView &view, SetAside &setAside)
{
    for (const QueueRow &row : view.rows) {
        if (hasVerdict(row))
            setAside.insert({row.id, row.visit.id, row.tries});
    }
}

QString nameOf(const QueueRow &row)
{
    return row.visit.serial.empty() ? qt(row.visit.device) : qt(row.visit.serial);
}

namespace {

QString nextOf(const ServiceView &view, const QueueRow &row, Verdict::Kind kind, const QWidget &page, bool hasRecipe)
{
    const bool isOpen = kind == Verdict::Kind::Failed || isCutOff(row);
    if (isOpen && (!view.finishing || hasRecipe)) {
        return view.finishing ? BenchText::tr("Start serves it once more")
                              : wordsOfKeys(page, BenchText::tr("%1 tests again · %2 sets it aside"),
                                  {QStringLiteral("F5"), QStringLiteral("F8")});
    }
    return view.running ? BenchText::tr("Unplug, connect next") : BenchText::tr("Safe to unplug");
}

/// One dim line below what to do next.
QString hintOf(const ServiceView &view, const QueueRow &row, Verdict::Kind kind)
{
    const bool numbers = view.matter && view.matter->recipe.number && row.visit.step < service::Step::Number;
    if (kind == Verdict::Kind::Failed)
        return numbers && !row.visit.number ? BenchText::tr("No number was written to it this time.") : QString();
    if (view.running)
        return isCutOff(row) ? QString() : whenItStarts(view);
    return BenchText::tr("Start serves the next unit.");
}

} // namespace

Verdict verdictOf(const ServiceView &view, const SetAside &setAside, const QWidget &page, bool hasRecipe)
{
    const QueueRow *row = running(view);
    if (!row && (view.running || view.trouble.empty()))
        row = lastEnded(view, setAside);
    if (!row)
        return waiting(view);
    Verdict verdict;
    verdict.kind = kindOf(row->state);
    verdict.unit = nameOf(*row);
    verdict.number = row->visit.number ? QStringLiteral("#%1").arg(*row->visit.number) : QString();
    verdict.seconds = row->visit.seconds;
    verdict.facts = factsOf(row->visit);
    if (verdict.kind == Verdict::Kind::Working) {
        verdict.step = view.announced > 0 ? BenchText::tr("The motor turns in a moment") : messageText(row->what);
        verdict.share = row->total > 0 ? static_cast<double>(row->done) / row->total : 0.0;
        verdict.next = isWaitingForArm(view, *row) ? BenchText::tr("Hold Arm to go on")
            : mayUnplug(*row)                      ? BenchText::tr("Safe to unplug")
                                                   : BenchText::tr("Do not unplug");
        return verdict;
    }
    verdict.cause = asSentence(messageText(row->visit.cause));
    verdict.remedy = asSentence(messageText(row->visit.remedy));
    verdict.next = nextOf(view, *row, verdict.kind, page, hasRecipe);
    verdict.hint
        = view.running || hasRecipe ? hintOf(view, *row, verdict.kind) : BenchText::tr("Open a recipe, then Start");
    return verdict;
}

bool isWaitingForArm(const ServiceView &view, const QueueRow &row)
{
    return view.waitsForArm() && row.state == RowState::Running && row.visit.step == service::Step::Test;
}

bool mayUnplug(const QueueRow &row)
{
    return row.mayInterrupt && (row.state != RowState::Running || row.visit.step != service::Step::Test);
}

QString wordOf(const QueueRow &row)
{
    switch (row.state) {
    case RowState::Passed: return BenchText::tr("passed");
    case RowState::Failed: return BenchText::tr("failed");
    case RowState::Refused: return BenchText::tr("refused");
    case RowState::Running: return BenchText::tr("running");
    case RowState::Skipped: return BenchText::tr("left out");
    case RowState::Waiting: return BenchText::tr("waiting");
    }
    return {};
}

QString lineOf(const QueueRow &row)
{
    const service::Visit &visit = row.visit;
    switch (row.state) {
    case RowState::Passed: return versionsOf(visit);
    case RowState::Failed:
    case RowState::Refused:
    case RowState::Skipped: return messageText(visit.cause);
    case RowState::Running: return messageText(row.what);
    case RowState::Waiting: break;
    }
    return {};
}

std::optional<double> unitsAnHour(const ServiceView &view)
{
    constexpr double hour = 3600.0;
    double first = std::numeric_limits<double>::infinity();
    double last = 0.0;
    int ended = 0;
    for (const QueueRow &row : view.rows) {
        if (!hasEnded(row.state) || hadEverything(row.visit) || row.visit.time <= 0.0)
            continue;
        first = std::min(first, row.visit.time);
        last = std::max(last, row.visit.time + row.visit.seconds);
        ++ended;
    }
    return ended >= fewestForARate && last > first ? std::optional(ended * hour / (last - first)) : std::nullopt;
}

std::optional<double> meanSeconds(const ServiceView &view)
{
    double sum = 0.0;
    int count = 0;
    for (const QueueRow &row : view.rows) {
        if (row.state != RowState::Passed || hadEverything(row.visit))
            continue;
        sum += row.visit.seconds;
        ++count;
    }
    return count > 0 ? std::optional(sum / count) : std::nullopt;
}

QString motionOf(const service::SelfTest &test)
{
    const QString unit = QLatin1Char(' ') + qt(unitOf(test.loop));
    const QString target = formatSignificant(test.to, 4) + unit;
    QStringList words{test.from
            ? BenchText::tr("%1 from %2 to %3").arg(modeText(test.loop), formatSignificant(*test.from, 4), target)
            : BenchText::tr("%1 to %2").arg(modeText(test.loop), target)};
    if (test.limits.duty)
        words << BenchText::tr("duty at most %1 %").arg(formatSignificant(*test.limits.duty * 100.0, 2));
    if (test.limits.speed)
        words << BenchText::tr("speed at most %1 counts/s").arg(formatSignificant(*test.limits.speed, 4));
    if (test.limits.travel)
        words << BenchText::tr("travel at most %1 counts").arg(formatSignificant(*test.limits.travel, 4));
    return words.join(QStringLiteral(", "));
}

} // namespace mb
