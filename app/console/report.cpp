// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/report.h"
#include "app/console/notebook.h"
#include "app/console/optionwords.h"
#include "app/console/parameterrows.h"
#include "app/console/target.h"
#include "app/console/verb.h"
#include "app/console/windowprogram.h"
#include "async/outputfile.h"
#include "async/seconds.h"
#include "model/unit.h"
#include "storage/reportmatter.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <memory>
#include <sys/mman.h>
#include <unistd.h>

namespace mb::console {
namespace {

constexpr std::string_view trialPrefix = "trial:";
constexpr int mostTrialNumber = 2'000'000'000;

struct ReportArguments {
    std::vector<std::string> subjects;
    std::string out;
    std::string size = "report";
};

/// What is written of a unit, by the word of --size.
struct Size {
    std::string_view word;
    QString (*html)(const Report &report);
};
constexpr std::array<Size, 3> sizes{
    {{reportSizes[0], htmlOf}, {reportSizes[1], cardHtmlOf}, {reportSizes[2], labelHtmlOf}}};

struct Wish {
    std::optional<Target> target;
    ReportWish matter;
    bool pdf = false;
    const Size *size = nullptr;
};

Result<Wish> check(const Console &console, const ReportArguments &a)
{
    Wish wish;
    if (a.subjects.empty() || a.out.empty())
        return fail(Fault::Usage, say("report needs a device or trials, and a file"),
            say("name LINK/FAMILY:ADDRESS or trial:N, and add --out FILE, a .pdf or .html"));
    wish.pdf = a.out.ends_with(".pdf") || a.out.ends_with(".PDF");
    if (!wish.pdf && !a.out.ends_with(".html") && !a.out.ends_with(".htm") && !a.out.ends_with(".HTML"))
        return fail(Fault::Usage, say("--out '%1' is no report", a.out), say("give a name that ends in .pdf or .html"));
    const auto size = std::ranges::find(sizes, a.size, &Size::word);
    if (size == sizes.end())
        return fail(Fault::Usage, say("--size '%1' is none", a.size), say("there are report, card and label"));
    wish.size = &*size;
    for (const std::string &subject : a.subjects) {
        if (subject.starts_with(trialPrefix)) {
            MB_TRY(const auto number, parseInteger("trial", subject.substr(trialPrefix.size()), 1, mostTrialNumber));
            wish.matter.trials.push_back(number);
            continue;
        }
        MB_TRY(auto target, parseTarget(console, subject));
        if (wish.target)
            return fail(Fault::Usage, say("a report is about one device"), say("write one for each"));
        wish.target = std::move(target);
    }
    if (wish.target && !wish.matter.trials.empty())
        return fail(Fault::Usage, say("a report is about a device or about trials"), say("leave one of them out"));
    return wish;
}

/// Who it is, and every parameter that it tells.
Task<ReportUnit> readUnit(Console &console, Target target)
{
    Device *const device = co_await connect(console, target);
    ReportUnit unit;
    unit.family = &device->family();
    unit.selector = device->selector();
    unit.unit = unitKeyOf(*device);
    unit.simulated = device->link().address().isSimulated();
    if (needsApplication(*device)) {
        co_await noteOwed(console, *device);
        const std::vector<TransferOutcome> outcomes = co_await readKept(console, *device, readable(*device));
        if (const auto error = firstError(*device, outcomes))
            co_return fail(*error);
        const auto entries = device->parameters().entries();
        unit.parameters.assign(entries.begin(), entries.end());
    }
    unit.identity = device->identity();
    co_return unit;
}

Result<Report> gather(Console &console, Database &database, ReportWish wish, std::optional<ReportUnit> unit)
{
    TrialBook book(database, console.clock());
    if (unit)
        wish.unit = unit->unit;
    MB_TRY(auto units, reportUnits(book, console.families(), wish));
    if (unit && !units.empty())
        units.front().describe(*unit);
    Report report;
    report.time = unixSeconds(console.clock());
    report.program = "MotorBench " MOTORBENCH_VERSION;
    report.units = std::move(units);
    return report;
}

/// The text goes over in memory: nothing is left behind, whatever happens.
Error print(const QByteArray &html, const std::string &out, bool json)
{
    const int memory = ::memfd_create("report", 0);
    const auto written = memory < 0 ? -1 : ::write(memory, html.constData(), static_cast<std::size_t>(html.size()));
    if (written != html.size())
        return {Fault::OutOfRange, say("the report cannot be handed over: %1", std::strerror(errno)), {}};
    std::vector<std::string> words{"--report", "/proc/self/fd/" + std::to_string(memory), "--out", out};
    if (json)
        words.emplace_back("--json");
    return becomeWindow(std::move(words));
}

Task<int> report(Console &console, ReportArguments a)
{
    const auto wish = co_await check(console, a);
    auto file = std::make_unique<OutputFile>(a.out);
    if (auto opened = file->open(); !opened) // before anything is asked for
        co_return fail(opened.error());
    const auto database = co_await openNotebook();
    std::optional<ReportUnit> unit;
    if (wish.target) {
        unit = co_await readUnit(console, *wish.target);
        console.onlyAsk();
    }
    const auto gathered = co_await gather(console, *database, wish.matter, std::move(unit));
    const bool served
        = std::ranges::any_of(gathered.units, [](const ReportUnit &each) { return !each.visits.empty(); });
    if (wish.size->html == labelHtmlOf && !served)
        co_return fail(Fault::OutOfRange, say("this unit was never served, so there is nothing to label"),
            say("serve it first: 'motorbenchctl service'"));
    const QByteArray html = wish.size->html(gathered).toUtf8();
    if (wish.pdf) {
        file.reset();
        co_return fail(print(html, a.out, console.json()));
    }
    file->write({html.constData(), static_cast<std::size_t>(html.size())});
    co_await file->commit();
    co_return exitDone;
}

} // namespace

Job declareReport(CLI::App &arguments)
{
    const auto a = std::make_shared<ReportArguments>();
    arguments.add_option("subject", a->subjects, "LINK/FAMILY:ADDRESS, or trial:N of the notebook, one or more");
    arguments.add_option("--out", a->out, "The report: .pdf or .html");
    arguments.add_option("--size", a->size, "report: all that is known; card: one page a unit; label: 62 x 29 mm");
    return [a](Console &console) { return report(console, *a); };
}

} // namespace mb::console
