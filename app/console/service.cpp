// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/linkrows.h"
#include "app/console/servicedesk.h"
#include "app/console/target.h"
#include "app/console/verb.h"
#include "app/folders/account.h"
#include "async/sleep.h"
#include "model/leaserenewal.h"
#include "storage/visitjson.h"

#include <algorithm>
#include <cmath>
#include <list>
#include <memory>

namespace mb::console {
namespace {

constexpr int mostUnits = 100'000;

struct ServiceArguments {
    std::string recipe;
    std::vector<std::string> links;
    std::string units;
    bool resume = false;
    std::string station;
    std::string journal;
};

struct ServicePlan {
    service::RecipeMatter matter;
    std::vector<LinkAddress> links;
    std::optional<int> units;
};

/// Those that were named; else the CAN interfaces that are up, as scan has it.
Result<std::vector<LinkAddress>> linksOf(const Console &console, const ServiceArguments &a, const Family &family)
{
    MB_TRY(const auto named, parseLinks(console, a.links));
    std::vector<LinkAddress> links;
    for (const LinkAddress &link : named) {
        MB_TRY_VOID(link.takesOrders());
        if (serves(family, kindOf(link)))
            links.push_back(link);
        else if (!link.isSimulated())
            return fail(Fault::Usage, say("%1 is not found on %2", family.key, link.text()),
                say("name a link of the kind %1", toString(family.links.front())));
    }
    if (a.links.empty()) {
        for (const LinkListing &listing : allLinks(console)) {
            if (listing.link.scheme == "socketcan" && listing.openable && serves(family, LinkKind::Can))
                links.push_back(listing.link);
        }
    }
    if (links.empty())
        return fail(Fault::Usage, say("there is no link to look for %1 on", family.key),
            say("name one, such as %1", "socketcan:can0"));
    return links;
}

Result<ServicePlan> check(const Console &console, const ServiceArguments &a)
{
    auto matter = service::loadRecipe(a.recipe, console.families());
    if (!matter)
        return fail(matter.error().fault, matter.error().detail,
            matter.error().remedy.empty() ? say("mend the recipe") : matter.error().remedy);
    ServicePlan plan{std::move(*matter), {}, {}};
    MB_TRY(auto links, linksOf(console, a, *plan.matter.recipe.family));
    plan.links = std::move(links);
    if (!a.units.empty()) {
        MB_TRY(const auto units, parseInteger("--units", a.units, 1, mostUnits));
        plan.units = units;
    }
    return plan;
}

/// A family without serial numbers has its addresses.
const std::string &nameOf(const service::Visit &visit)
{
    return !visit.serial.empty() ? visit.serial : !visit.unit.empty() ? visit.unit : visit.device;
}

std::string textOf(const service::Visit &visit)
{
    std::string text = std::string(toString(visit.outcome)) + "  " + nameOf(visit) + "  " + visit.device;
    if (!visit.to.empty())
        text += "  " + (visit.from == visit.to ? "" : (visit.from.empty() ? "?" : visit.from) + " → ") + visit.to;
    text += "  " + numberText(std::round(visit.seconds * 10.0) / 10.0) + " s";
    if (!visit.cause.empty())
        text += "  at " + std::string(toString(visit.step)) + ": " + joined(visit.cause, visit.remedy).english();
    return text;
}

/// One queue from its start to its summary.
class Service {
public:
    Service(Console &console, ServiceDesk &desk, const ServicePlan &plan, service::QueueOptions options)
        : m_console(console)
        , m_permit(console)
        , m_queue(console.clock(), plan.matter, {desk.journal(), &desk.settings(), &desk.trials(), &m_permit, {}},
              std::move(options))
        , m_progress(console)
        , m_begun(console.clock().now())
    {
        m_subscriptions.push_back(m_queue.changed().add([this] { showProgress(); }));
        m_subscriptions.push_back(m_queue.unitEnded().add([this](const service::Visit &visit) { print(visit); }));
        m_subscriptions.push_back(m_queue.ended().add([this] { m_ended.set(); }));
        m_subscriptions.push_back(m_console.interrupted().add([this] { interrupt(); }));
    }
    [[nodiscard]] Task<int> run(std::vector<LinkAddress> links)
    {
        for (const LinkAddress &address : links) {
            Stage &stage = m_stages.emplace_back(m_console, address);
            Link *const link = co_await stage.session().openLinkSoon(address);
            link->settings().patience = m_console.options().patience;
            m_queue.addBus(stage.session(), *link);
        }
        m_console.begin();
        LeaseRenewal renewal(m_console.clock(), [this] { m_queue.renewLease(); });
        m_queue.start();
        co_await m_ended.wait();
        renewal.stop();
        m_console.stayAwake(false);
        summarize();
        co_return verdict();
    }

private:
    void interrupt()
    {
        m_console.note("motors stop; what must not be cut is brought to its end, and --resume goes on after that");
        m_queue.stop();
        m_isInterrupted = true;
    }
    void showProgress()
    {
        m_console.stayAwake(m_queue.mustStayAwake());
        for (const service::QueueRow &row : m_queue.rows()) {
            if (row.state == service::RowState::Running && !row.what.empty())
                m_progress.step(
                    say("%1 %2: %3", nameOf(row.visit), toString(row.visit.step), row.what), row.done, row.total);
        }
    }
    void print(const service::Visit &visit)
    {
        m_isUnconfirmed = m_isUnconfirmed || visit.ending == service::Ending::StopUnconfirmed;
        if (m_console.json())
            m_console.out().json(visitLine(visit));
        else
            m_console.out().line(textOf(visit));
    }
    void summarize()
    {
        const service::QueueCounts counts = m_queue.counts();
        const double seconds = std::round(secondsOf(m_console.clock().now() - m_begun) * 1e3) / 1e3;
        if (m_console.json())
            m_console.out().json({{QStringLiteral("summary"),
                QJsonObject{{QStringLiteral("passed"), counts.passed}, {QStringLiteral("failed"), counts.failed},
                    {QStringLiteral("refused"), counts.refused}, {QStringLiteral("seconds"), seconds}}}});
        else
            m_console.out().line(std::to_string(counts.passed) + " passed, " + std::to_string(counts.failed)
                + " failed, " + std::to_string(counts.refused) + " refused, " + numberText(seconds) + " s");
    }
    [[nodiscard]] Result<int> verdict() const
    {
        const service::QueueCounts counts = m_queue.counts();
        if (m_isUnconfirmed)
            return fail(Fault::Unsafe, say("the stop of a motor was not confirmed"), say("see that it stands"));
        if (m_queue.trouble())
            return fail(*m_queue.trouble());
        if (m_isInterrupted)
            return fail(
                Fault::Cancelled, say("cancelled before all units were done"), say("run it again with --resume"));
        if (counts.ended() == 0)
            return fail(Fault::Timeout, say("no %1 answers", m_queue.matter().recipe.family->key),
                say("check power and cable; 'motorbenchctl scan' lists what answers"));
        if (counts.failed + counts.refused > 0)
            return fail(Fault::Refused,
                say("of %1 units failed: %2, refused: %3", counts.ended(), counts.failed, counts.refused),
                say("their lines say why; 'motorbenchctl journal' has them, too"));
        return exitDone;
    }

    Console &m_console;
    SpokenPermit m_permit;
    std::list<Stage> m_stages;
    service::ServiceQueue m_queue;
    ProgressLine m_progress;
    const Instant m_begun;
    Event m_ended;
    bool m_isInterrupted = false;
    bool m_isUnconfirmed = false;
    std::vector<Subscription> m_subscriptions;
};

/// Empty: there is none. Usage where the recipe is not that of the last run any more: what has ended there ended under the other one.
Result<std::string> runToResume(ServiceBook &book, const ServicePlan &plan)
{
    const service::RecipeMatter &matter = plan.matter;
    const auto last = book.lastRun(matter.recipe.name, plan.links.front().isSimulated());
    if (!last || last->empty())
        return last;
    service::VisitFilter filter;
    filter.run = *last;
    MB_TRY(const auto visits, book.list(filter));
    const bool isOther = std::any_of(visits.begin(), visits.end(),
        [&matter](const service::Visit &visit) { return visit.recipeHash != matter.hash; });
    if (isOther)
        return fail(Fault::Usage, say("the recipe has changed since the run that would be resumed"),
            say("run it without --resume"));
    return last;
}

Task<int> serve(Console &console, ServiceArguments a)
{
    const auto plan = co_await check(console, a);
    co_await checkName("the name of a station", a.station);
    const std::string station = a.station.empty() ? hostName() : a.station;
    const auto desk = co_await ServiceDesk::open(console, station, a.journal);
    service::QueueOptions options;
    options.station = station;
    options.units = plan.units;
    if (a.resume) {
        options.run = co_await runToResume(desk->book(), plan);
        if (options.run.empty())
            console.note("there is nothing to resume: this station has not run this recipe yet");
    }
    Result<int> ran;
    {
        Service running(console, *desk, plan, std::move(options));
        ran = co_await running.run(plan.links).attempt();
        co_await Sleep(console.clock(), Duration::zero()); // a session is never ended from inside its own work
    }
    co_await desk->handOver();
    co_return ran;
}

} // namespace

Job declareService(CLI::App &arguments)
{
    const auto a = std::make_shared<ServiceArguments>();
    arguments.add_option("recipe", a->recipe, "What is done to every unit: a JSON file")->required();
    arguments.add_option("link", a->links, "Where the units are; every CAN interface that is up otherwise");
    arguments.add_option(
        "--units", a->units, "Wait for so many units, one after the other; what is there now otherwise");
    arguments.add_flag("--resume", a->resume, "Go on with the last run of this recipe, which was cut off");
    arguments.add_option(
        "--station", a->station, "The name of this place in the journal; that of the computer otherwise");
    arguments.add_option("--journal", a->journal, "Share the journal: postgresql://USER@HOST/DB");
    return [a](Console &console) { return serve(console, *a); };
}

} // namespace mb::console
