// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/notebook.h"
#include "app/console/table.h"
#include "app/console/target.h"
#include "app/console/verb.h"
#include "app/folders/account.h"
#include "storage/servicebook.h"
#include "storage/visitjson.h"
#include "wire/number.h"

#include <QDateTime>

#include <cmath>
#include <memory>

namespace mb::console {
namespace {

struct JournalArguments {
    std::string since;
    std::string serial;
    std::string file;
};

/// Unix seconds, or a date with or without a time of day.
Result<std::optional<double>> parseTime(const std::string &text)
{
    if (text.empty())
        return std::optional<double>();
    if (const auto seconds = numberFrom(text))
        return std::optional<double>(*seconds);
    const QDateTime time = QDateTime::fromString(qt(text), Qt::ISODate);
    if (time.isValid())
        return std::optional<double>(static_cast<double>(time.toMSecsSinceEpoch()) * 1e-3);
    return fail(Fault::Usage, say("--since: '%1' is no time", text),
        say("such as 2026-03-01, 2026-03-01T14:30:00, or seconds since 1970"));
}

void print(Console &console, const std::vector<service::Visit> &visits)
{
    Table table({"TIME", "SERIAL", "DEVICE", "RESULT", "STEP", "FROM", "TO", "RECIPE", "STATION", "CAUSE", "NOTE"});
    for (const service::Visit &v : visits)
        table.add({QDateTime::fromMSecsSinceEpoch(std::llround(v.time * 1e3)).toString(Qt::ISODate).toStdString(),
            v.serial.empty() ? v.unit : v.serial, v.device, std::string(toString(v.outcome)),
            std::string(toString(v.step)), v.from, v.to, v.recipe, v.station, v.cause.english(), v.note});
    table.print(console.out());
}

Task<int> journal(Console &console, JournalArguments a)
{
    const auto since = co_await parseTime(a.since);
    if (!a.file.empty() && !a.file.ends_with(".csv"))
        co_return fail(
            Fault::Usage, say("--export: '%1' does not end with .csv", a.file), say("the journal is a table"));
    auto database = co_await openNotebook();
    ServiceBook book(*database, console.clock(), {}, accountName());
    service::VisitFilter filter;
    filter.since = since;
    filter.serial = a.serial;
    const auto visits = co_await book.list(filter);
    if (!a.file.empty()) {
        co_await exportVisits(a.file, visits);
        console.note(std::to_string(visits.size()) + " entries in " + a.file);
    }
    if (console.json())
        console.out().json({{QStringLiteral("entries"), visitRows(visits)}});
    else
        print(console, visits);
    co_return exitDone;
}

} // namespace

Job declareJournal(CLI::App &arguments)
{
    const auto a = std::make_shared<JournalArguments>();
    arguments.add_option("--since", a->since, "A date, a date and time, or seconds since 1970");
    arguments.add_option("--serial", a->serial, "One unit only");
    arguments.add_option("--export", a->file, "Write them to a table, too: .csv");
    return [a](Console &console) { return journal(console, *a); };
}

} // namespace mb::console
