// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/notebook.h"
#include "app/console/optionwords.h"
#include "app/console/progressline.h"
#include "app/console/target.h"
#include "app/console/verb.h"
#include "app/folders/userfolders.h"
#include "async/event.h"
#include "async/noncopyable.h"
#include "files/filebytes.h"
#include "model/operation.h"
#include "model/registry.h"
#include "model/standstill.h"
#include "model/transcript.h"
#include "service/preflight.h"

#include <algorithm>
#include <memory>

namespace mb::console {
namespace {

constexpr Duration drawEvery = std::chrono::milliseconds(50);

struct FlashArguments {
    std::string device;
    std::string file;
    UpdateOptions options;
};

struct FlashPlan {
    Target target;
    FirmwareImage image;
};

/// `--via` as a recipe has it, with the target behind it, is understood too.
Result<void> readWay(UpdateOptions &options)
{
    const UpdateOptions way = service::updateOptionsOf({{}, options.via});
    if (way.target.empty())
        return {};
    if (!options.target.empty() && options.target != way.target)
        return fail(Fault::Usage, say("--via %1 and --target %2 contradict each other", options.via, options.target),
            say("leave one of the two out"));
    options.via = way.via;
    options.target = way.target;
    return {};
}

/// `--via`, `--target` and `--erase-settings` against what the family has; its update() looks at them in detail.
Result<void> checkRoute(std::span<const Family *const> families, const Family &family, const UpdateOptions &options)
{
    const std::string &target = options.target;
    const std::vector<std::string_view> known = targetWords(families);
    if (!target.empty() && std::ranges::find(known, target) == known.end())
        return fail(Fault::Usage, say("--target: '%1' is unknown", target), say("%1 are known", joined(known)));
    const auto hasOne = [](const UpdateRoute &route) { return route.targets.empty(); };
    if (!target.empty() && std::ranges::all_of(family.routes, hasOne))
        return fail(Fault::Usage, say("%1 has one kind of chip", family.title), say("leave out --target"));
    const auto erases = [](const UpdateRoute &route) { return route.erasesSettings; };
    if (options.eraseSettings && std::ranges::none_of(family.routes, erases))
        return fail(Fault::Unsupported, say("%1 has no settings that an update could erase", family.key));
    if (family.routes.empty() && !options.via.empty())
        return fail(Fault::Unsupported, say("%1 is updated over its own link", family.title),
            say("leave the other way in out"));
    if (family.routes.empty())
        return {};
    for (const UpdateRoute &route : family.routes) {
        if (options.via.starts_with(std::string(route.scheme) + ':')) {
            if (route.targets.empty() || std::ranges::find(route.targets, target) != route.targets.end())
                return {};
            return fail(Fault::Usage, say("--target is missing"),
                say("%1 needs one of: %2", family.key, joined({route.targets.begin(), route.targets.end()})));
        }
    }
    return fail(Fault::Usage, say("%1 is not updated over its own link", family.key),
        say("add --via %1", waysOf(family.routes, " or ")));
}

Result<FlashPlan> check(const Console &console, FlashArguments &arguments)
{
    MB_TRY_VOID(readWay(arguments.options));
    MB_TRY(auto target, parseTarget(console, arguments.device));
    const Family &family = *target.family;
    const std::string name(family.key);
    if (!family.update)
        return fail(Fault::Unsupported, say("%1 has no firmware update here", name), say("use the maker's tool"));
    MB_TRY_VOID(checkRoute(console.families(), family, arguments.options));
    MB_TRY(const auto bytes, loadFile(arguments.file, static_cast<std::int64_t>(FirmwareImage::maxTextSize)));
    auto parsed
        = FirmwareImage::fromIntelHex(std::string_view(bytes.constData(), static_cast<std::size_t>(bytes.size())));
    if (!parsed)
        return fail(Fault::OutOfRange, say("%1: %2", arguments.file, parsed.error().detail),
            say("an undamaged Intel HEX file is needed"));
    if (family.inspect) {
        if (auto summary = family.inspect(*parsed); !summary)
            return fail(summary.error().about(arguments.file));
    }
    target.mayBeSilent = true; // it may hold half a program
    return FlashPlan{std::move(target), std::move(*parsed)};
}

std::string viaHelp()
{
    std::string ways;
    for (const Family *family : families()) {
        if (!family->routes.empty())
            ways += (ways.empty() ? "" : ", ") + waysOf(family->routes, ", ");
    }
    return "The other way in, such as " + ways;
}

/// Runs the update as an operation: shows its progress, and cancels it on a signal as soon as that does no harm.
class Update : NonCopyable {
public:
    explicit Update(Console &console)
        : m_console(console)
        , m_operation(console.clock(), say("firmware update"))
        , m_progress(console)
        , m_tick(console.clock())
        , m_interrupted(console.interrupted().add([this] { cancel(); }))
    {
    }
    ~Update() { free(); }
    void start(const Family &family, Device &device, const FirmwareImage &image, const UpdateOptions &options)
    {
        m_device = &device;
        device.gate().setBusy(say("firmware update")); // nothing else may talk to it meanwhile
        m_operation.run<UpdateReport>(
            family.update(device, image, options, m_operation), [this](Result<UpdateReport> result) {
                report = std::move(result);
                free();
                done.set();
            });
        tick();
    }

    /// Kept for whoever has to find out why it failed.
    void keep(const Device &device, const UpdateReport &how) const
    {
        if (m_operation.status().log.empty())
            return;
        const auto path = save(transcriptOf(transcriptFolder(), device, m_operation.status(), how));
        m_console.note(path ? "the transcript of the update is in " + *path : path.error().text());
    }

    /// How far it is, or was when it ended.
    [[nodiscard]] const UpdateStanding &standing() const { return m_operation.status().update; }

    Event done;
    Result<UpdateReport> report{UpdateReport{}};

private:
    void free()
    {
        if (Device *const device = std::exchange(m_device, nullptr))
            device->gate().setBusy({});
    }
    void tick()
    {
        if (!m_operation.isRunning())
            return;
        const OperationStatus &status = m_operation.status();
        for (; m_shown < status.log.size(); ++m_shown)
            m_progress.log(status.log[m_shown].severity, status.log[m_shown].text);
        m_progress.step(status.step, status.done, status.total);
        if (m_cancelling)
            (void)m_operation.cancel();
        m_tick.startIn(drawEvery, [this] { tick(); });
    }
    void cancel()
    {
        m_cancelling = true;
        if (!m_operation.cancel())
            m_console.note("the part that is being written now must not be cut; the update ends after it");
    }

    Console &m_console;
    Device *m_device = nullptr; ///< while it is updated
    Operation m_operation;
    ProgressLine m_progress;
    Timer m_tick;
    std::size_t m_shown = 0;
    bool m_cancelling = false;
    Subscription m_interrupted;
};

/// A fault that ended the update is a report too: the caller always learns what became of the device.
UpdateReport reportOf(Result<UpdateReport> result, const UpdateStanding &standing)
{
    if (result)
        return std::move(*result);
    UpdateReport report = unfinished(standing, result.error());
    if (report.outcome == UpdateOutcome::Cancelled) {
        report.evidence = say("cancelled before it was complete");
        report.remedy = say("run it again to finish");
    }
    return report;
}

void show(Console &console, const UpdateReport &report, double seconds)
{
    if (console.json()) {
        console.out().json({
            {QStringLiteral("result"), qt(toString(report.outcome))},
            {QStringLiteral("from"), textOrNull(report.from)},
            {QStringLiteral("to"), textOrNull(report.to)},
            {QStringLiteral("pages"), report.pages},
            {QStringLiteral("retries"), report.retries},
            {QStringLiteral("seconds"), seconds},
            {QStringLiteral("verified"), report.verified},
            {QStringLiteral("evidence"), textOrNull(report.summary().english())},
        });
    } else if (report.outcome == UpdateOutcome::Done || report.outcome == UpdateOutcome::UpToDate) {
        std::string line(toString(report.outcome));
        if (report.pages > 0)
            line += ": " + (report.from.empty() ? std::string("no application") : report.from) + " → "
                + (report.to.empty() ? std::string("unknown") : report.to) + ", " + std::to_string(report.pages)
                + " pages, " + std::to_string(report.retries) + " retries, " + numberText(seconds) + " s";
        if (report.verified)
            line += ", verified";
        console.out().line(report.evidence.empty() ? line : line + ": " + report.summary().english());
    }
}

Result<int> verdictOf(const Console &console, const UpdateReport &report)
{
    if (report.outcome == UpdateOutcome::Done || report.outcome == UpdateOutcome::UpToDate)
        return exitDone;
    if (report.outcome == UpdateOutcome::Refused && report.fault && exitStatusOf(*report.fault, false) == exitUsage) {
        tell(Error{*report.fault, report.evidence, report.remedy}, exitUsage,
            console.options()); // nothing of it was sent
        return exitUsage;
    }
    if (report.outcome == UpdateOutcome::Cancelled)
        return fail(Fault::Cancelled, report.evidence, report.remedy);
    return fail(
        report.fault.value_or(Fault::Refused), say("%1: %2", toString(report.outcome), report.evidence), report.remedy);
}

Task<int> flash(Console &console, FlashArguments arguments)
{
    const auto plan = co_await check(console, arguments);
    Device *const device = co_await connect(console, plan.target);
    const Identity &identity = device->identity();
    if (identity.state == DeviceState::Bootloader && !plan.target.family->routes.empty())
        console.note(device->selector() + ": " + identity.detail.english());
    co_await standsStill(*device);
    if (!arguments.options.dryRun) {
        Notebook notebook(console);
        co_await notebook.keepOrRefuse(*device, settings::Occasion::Update);
    }
    const Instant start = console.clock().now();
    UpdateReport report;
    {
        Update update(console);
        update.start(*plan.target.family, *device, plan.image, arguments.options);
        co_await update.done.wait();
        if (!update.report && exitStatusOf(update.report.error().fault, false) == exitUsage)
            co_return fail(update.report.error());
        report = reportOf(std::move(update.report), update.standing());
        update.keep(*device, report);
    }
    const auto took = std::chrono::duration_cast<std::chrono::milliseconds>(console.clock().now() - start);
    show(console, report, static_cast<double>(took.count()) / 1000.0);
    co_return verdictOf(console, report);
}

} // namespace

Job declareFlash(CLI::App &arguments)
{
    const auto a = std::make_shared<FlashArguments>();
    arguments.add_option("device", a->device, "LINK/FAMILY:ADDRESS")->required();
    arguments.add_option("file", a->file, "Intel HEX")->required();
    arguments.add_flag("--dry-run", a->options.dryRun, "Preflight only, nothing is written");
    arguments.add_flag("--force", a->options.force, "Write even if the device has this version");
    arguments.add_option("--via", a->options.via, viaHelp());
    arguments.add_option(
        "--target", a->options.target, "The chip, where there are several: " + joined(targetWords(families())));
    arguments.add_flag("--erase-settings", a->options.eraseSettings,
        "Erase what the unit has stored as well, where the way in can; its gains are lost");
    return [a](Console &console) { return flash(console, *a); };
}

} // namespace mb::console
