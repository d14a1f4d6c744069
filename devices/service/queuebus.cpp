// SPDX-License-Identifier: GPL-3.0-or-later
#include "service/queuebus.h"

#include "async/scope.h"
#include "async/sleep.h"
#include "model/family.h"
#include "model/unit.h"
#include "service/unitrun.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace mb::service {
namespace {

using namespace std::chrono_literals;

constexpr Duration lookAgain = 300ms;
constexpr Duration whileLooking = 20ms; ///< is asked whether there is something better to do
constexpr Duration missedAfter = 10s;   ///< a unit that starts again, or a hand that puts it back

/// Whoever has the list keeps it as it was.
std::shared_ptr<const std::vector<LogLine>> extended(
    const std::shared_ptr<const std::vector<LogLine>> &log, const LogLine &line)
{
    auto longer = log ? std::make_shared<std::vector<LogLine>>(*log) : std::make_shared<std::vector<LogLine>>();
    longer->push_back(line);
    return longer;
}

bool isEnded(RowState state)
{
    return state == RowState::Passed || state == RowState::Failed || state == RowState::Refused;
}

} // namespace

/// Progress into a row, and into the operation that can be cancelled.
class QueueBus::Telling final : public Progress {
public:
    Telling(QueueBus &bus, Row &row)
        : m_bus(bus)
        , m_row(row.shown)
    {
    }
    void step(const Message &what, int done, int total) override
    {
        QueueRow &row = m_row.edit();
        row.what = what;
        row.done = done;
        row.total = total;
        m_bus.m_operation->step(what, done, total);
        m_bus.m_run.changed().notify();
    }
    void part(int number, PartState state) override
    {
        m_row.edit().parts[number] = state;
        m_bus.m_operation->part(number, state);
        m_bus.m_run.changed().notify();
    }
    void log(Severity severity, const Message &text) override
    {
        m_bus.m_operation->log(severity, text);
        m_row.edit().log = extended(m_row->log, {m_bus.m_run.clock().now(), severity, text});
        m_bus.m_run.changed().notify();
    }
    void mayInterrupt(bool may) override
    {
        m_row.edit().mayInterrupt = may;
        m_bus.m_operation->mayInterrupt(may);
        if (may && m_bus.m_wantsSkip)
            (void)m_bus.m_operation->cancel();
        m_bus.m_run.changed().notify();
    }
    void written(const Visit &visit)
    {
        QueueRow &row = m_row.edit();
        row.visit = visit;
        if (!visit.steps.empty() && !visit.steps.back().ended) { // what the step before was doing is done
            row.what = {};
            row.done = row.total = 0;
        }
        m_bus.m_run.changed().notify();
    }

private:
    QueueBus &m_bus;
    Published<QueueRow> &m_row;
};

QueueBus::QueueBus(QueueRun &run, Session &session, Link &link)
    : m_run(run)
    , m_session(session)
    , m_link(link)
    , m_rows(session, link, {run.matter().recipe.family, run.earlier(), run.isOnce(), run.options().onlyChosen},
          run.lastRow())
{
    m_run.addPlace(session, link);
}

QueueBus::~QueueBus() = default;

Task<void> QueueBus::run()
{
    co_await look();
    if (m_run.isOnce())
        co_await checkAll();
    while (!m_run.isFinishing() && !m_run.isComplete()) {
        if (m_link.state() != LinkState::Open)
            co_return fail(Fault::LinkLost, say("%1: %2", m_link.address().shortName(), m_link.loss().message()));
        Row *const row = m_run.mayBegin() ? m_rows.next() : nullptr;
        if (row) {
            co_await serve(*row);
            continue;
        }
        if (m_run.isOnce() && !m_rows.hasWaiting())
            break;
        co_await Sleep(m_session.clockOf(m_link), lookAgain);
        if (m_run.isOnce() && !m_rows.isAnyMissing())
            continue;
        co_await look();
        co_await giveUpMissing();
    }
    co_return {};
}

Task<void> QueueBus::look()
{
    Clock &clock = m_session.clockOf(m_link);
    std::optional<Result<std::vector<Device *>>> found;
    Scope scanning(clock);
    scanning.spawn<std::vector<Device *>>(
        m_session.scan(m_link), [&found](Result<std::vector<Device *>> result) { found = std::move(result); });
    while (!found) {
        if (m_run.isFinishing() || m_rows.isAnyBack() || (m_run.mayBegin() && m_rows.next()))
            co_return {};
        co_await Sleep(clock, whileLooking);
    }
    if (!*found)
        co_return fail(found->error());
    m_rows.take(**found, m_serving);
    m_run.changed().notify();
    co_return {};
}

/// One that holds half a program is mute on its bus: where firmware takes another way in it goes on all the same.
Task<void> QueueBus::reachSilent(Visit visit)
{
    const auto &firmware = m_run.matter().recipe.firmware;
    if (visit.step != Step::Firmware || !firmware || firmware->via.empty())
        co_return {};
    const DeviceSelector selector = co_await DeviceSelector::parse(visit.device);
    Device *const device = co_await m_session.connect(selector, true);
    m_rows.notice(*device);
    co_return {};
}

/// Nobody waits for ever for a unit that the cut has left dead: it has failed, and says where.
Task<void> QueueBus::giveUpMissing()
{
    const Instant now = m_session.clockOf(m_link).now();
    for (Row &row : m_rows.all()) {
        if (!row.isMissed() || row.seen || now - row.absentAt.value_or(now) < missedAfter)
            continue;
        Visit visit = row.shown->visit;
        const Result<void> reached = co_await reachSilent(visit).attempt();
        if (!reached && !reached.error().remedy.empty()) { // it is not lost: it waits for a hand
            leftOut(row, reached.error());
            if (m_run.isOnce())
                co_return fail(reached.error());
        }
        if (!row.isMissed())
            continue;
        visit.outcome = Outcome::Failed;
        visit.cause = say("it was cut off at '%1' and does not answer any more", Message::label(toString(visit.step)));
        visit.remedy = say("look at cable and supply; when it answers again it is served from the beginning");
        visit.evidence = visit.cause;
        visit.steps.push_back({visit.step, 0.0, true, visit.cause});
        const Visit written = co_await m_run.around().journal.write(std::move(visit));
        row.missing = false;
        row.gone = true;
        ended(row, written);
    }
    co_return {};
}

/// All of them are looked at before the first is touched.
Task<void> QueueBus::checkAll()
{
    for (Row &row : m_rows.all()) {
        if (row.shown->state != RowState::Waiting || !row.shown->visit.id.empty())
            continue;
        co_await check(row);
    }
    co_return {};
}

Task<void> QueueBus::check(Row &row)
{
    Device *const device = m_session.find(row.shown->device);
    if (!device)
        co_return {};
    NoProgress unseen;
    row.shown.edit().what = say("Preflight");
    m_run.changed().notify();
    Result<void> looked = co_await preflight(*device, m_run.matter(), m_run.around().trials, unseen).attempt();
    if (looked)
        looked = isAlone(row);
    if (looked || looked.error().fault == Fault::LinkLost || looked.error().fault == Fault::Timeout)
        co_return {}; // its turn will tell
    co_await refuse(row, *device, looked.error());
    co_return {};
}

/// What tells two units apart tells them nothing of each other: what one was given would be taken for the other's.
Result<void> QueueBus::isAlone(const Row &row) const
{
    if (!m_rows.hasTwin(row) && !m_run.isElsewhere(m_link, row.shown->visit.unit))
        return {};
    return fail(Fault::Refused, say("two units tell the serial number %1", row.shown->visit.serial),
        say("take one of them off, then test the other again"));
}

Task<void> QueueBus::refuse(Row &row, const Device &device, Error error)
{
    Visit visit = row.shown->visit;
    if (visit.id.empty()) {
        visit = co_await openVisit(row, device);
    }
    visit.outcome = outcomeOfRefusal(visit);
    visit.cause = error.detail;
    visit.remedy = error.help();
    visit.steps.push_back({Step::Preflight, 0.0, true, error.detail});
    const Visit written = co_await m_run.around().journal.write(visit);
    ended(row, written);
    co_return {};
}

Task<Visit> QueueBus::openVisit(Row &row, const Device &device)
{
    Visit visit;
    visit.run = m_run.options().run;
    visit.recipe = m_run.matter().recipe.name;
    visit.recipeHash = m_run.matter().hash;
    visit.imageHash = m_run.matter().imageHash;
    visit.unit = row.shown->visit.unit;
    visit.serial = device.identity().serial;
    visit.device = device.selector();
    visit.family = device.identity().family;
    visit.from = device.identity().firmware;
    visit.simulated = m_link.address().isSimulated();
    visit.station = m_run.options().station;
    Visit opened = co_await m_run.around().journal.open(visit);
    row.shown.edit().visit = opened;
    co_return opened;
}

/// The row that is served, for as long as it is.
class QueueBus::Serving {
public:
    Serving(QueueBus &bus, Row &row)
        : m_bus(bus)
        , m_row(row)
    {
        m_bus.m_serving = &row;
        m_bus.m_wantsSkip = false;
        m_bus.m_interruption = std::make_unique<tuning::Interruption>();
        m_bus.m_run.begin(m_bus.m_link, row.shown->visit.unit);
    }
    Serving(const Serving &) = delete;
    Serving &operator=(const Serving &) = delete;
    ~Serving()
    {
        m_bus.m_rows.served(m_row);
        m_bus.m_run.end(m_bus.m_link);
        m_bus.m_serving = nullptr;
        m_bus.m_stream = nullptr;
    }

private:
    QueueBus &m_bus;
    Row &m_row;
};

Task<void> QueueBus::serve(Row &row)
{
    Device *const device = m_session.find(row.shown->device);
    if (!device) {
        row.shown.edit().state = RowState::Skipped;
        row.shown.edit().visit.cause = say("another unit stands in its place by now");
        m_run.changed().notify();
        co_return {};
    }
    const Serving serving(*this, row);
    QueueRow &shown = row.shown.edit();
    shown.state = RowState::Running;
    shown.startedAt = m_run.clock().now();
    shown.parts.clear();
    ++shown.tries;
    m_run.changed().notify();
    const Result<void> served = co_await serveHere(row, *device).attempt();
    if (served)
        co_return {};
    const bool isSkipped = served.error().fault == Fault::Cancelled;
    leftOut(row, isSkipped ? Error{Fault::Cancelled, say("left out before it was done"), {}} : served.error());
    if (!isSkipped) // the journal
        co_return fail(served.error());
    co_return {};
}

Task<void> QueueBus::serveHere(Row &row, Device &device)
{
    if (auto alone = isAlone(row); !alone) {
        co_await refuse(row, device, alone.error());
        co_return {};
    }
    Visit visit = row.shown->visit;
    if (visit.id.empty()) {
        // What is known may be of another that stood there, in whatever queue.
        if (unitByOf(visit.unit) == UnitBy::Place)
            device.knowledge().unitExchanged();
        visit = co_await openVisit(row, device);
    }
    if (m_wantsSkip) // while the journal took its time
        co_return fail(Fault::Cancelled);
    const Visit result = co_await perform(row, device, std::move(visit));
    ended(row, result);
    co_return {};
}

/// Its visit is open still.
void QueueBus::leftOut(Row &row, const Error &why)
{
    QueueRow &shown = row.shown.edit();
    shown.state = RowState::Skipped;
    shown.what = {};
    shown.mayInterrupt = true;
    shown.visit.cause = why.detail;
    shown.visit.remedy = why.help();
    m_run.changed().notify();
}

ServiceSurroundings QueueBus::surroundings(Row &row, Telling &telling)
{
    QueueSurroundings &around = m_run.around();
    ServiceSurroundings out{m_run.matter(), around.journal, around.settings, {}, around.permit, {}, {}};
    out.experiments.journal = around.trials;
    out.experiments.directions = &m_run.directions();
    out.experiments.interruption = m_interruption.get();
    out.experiments.note = [&telling](const Message &text) { telling.log(Severity::Info, text); };
    out.written = [&telling](const Visit &visit) { telling.written(visit); };
    out.taken = m_rows.numbersBeside(row);
    out.leftOut = &m_wantsSkip;
    return out;
}

Task<Visit> QueueBus::perform(Row &row, Device &device, Visit visit)
{
    m_operation = std::make_unique<Operation>(m_session.clockOf(m_link), say("service"));
    m_run.directions().forget(device.selector()); // another motor may hang on it
    m_stream = &m_session.stream(device);
    Telling telling(*this, row);
    Event done;
    Result<Visit> result;
    m_operation->run<Visit>(serveUnit(device, *m_stream, std::move(visit), surroundings(row, telling), telling),
        [&result, &done](Result<Visit> ended) {
            result = std::move(ended);
            done.set();
        });
    struct Cut { // the job is never left running without what it works with
        std::unique_ptr<Operation> &operation;
        explicit Cut(std::unique_ptr<Operation> &which)
            : operation(which)
        {
        }
        Cut(const Cut &) = delete;
        Cut &operator=(const Cut &) = delete;
        ~Cut() { operation.reset(); }
    };
    const Cut cut(m_operation);
    co_await done.wait();
    co_return result;
}

void QueueBus::ended(Row &row, const Visit &visit)
{
    QueueRow &shown = row.shown.edit();
    shown.visit = visit;
    shown.state = stateOf(visit.outcome);
    shown.what = {};
    shown.mayInterrupt = true;
    m_run.count(visit);
}

void QueueBus::addRows(std::vector<Shared<QueueRow>> &rows) const
{
    for (const Row &row : m_rows.all())
        rows.push_back(row.shown.shared());
}

bool QueueBus::skip(std::uint32_t id)
{
    Row *const row = m_rows.find(id);
    if (!row)
        return false;
    if (row == m_serving) {
        m_wantsSkip = true;
        if (m_interruption->hasStory()) // which brings motor and rates to rest; what it was of ends by itself then
            m_interruption->interrupt();
        else if (m_operation)
            (void)m_operation->cancel();
    } else if (row->shown->state == RowState::Waiting) {
        row->shown.edit().state = RowState::Skipped;
    }
    return true;
}

Result<void> QueueBus::retry(std::uint32_t id)
{
    Row *const row = m_rows.find(id);
    if (!row)
        return fail(Fault::Refused, say("it is not in the queue"));
    if (m_run.isFinishing())
        return fail(Fault::Refused, say("the queue was ended"), say("begin it once more to serve this unit again"));
    if (row == m_serving || row->shown->state == RowState::Waiting)
        return fail(Fault::Refused, say("it is being served, or waits for its turn"));
    if (row->shown->state == RowState::Passed)
        return fail(Fault::Refused, say("it has passed"), say("take it off and put it on again to serve it once more"));
    if (row->gone)
        return fail(Fault::Refused, say("it was taken off"), say("put it on again; it gets a row of its own"));
    if (isEnded(row->shown->state)) {
        m_run.uncount(row->shown->visit);
        Visit again;
        again.unit = row->shown->visit.unit;
        again.serial = row->shown->visit.serial;
        again.device = row->shown->visit.device;
        again.family = row->shown->visit.family;
        row->shown.edit().visit = std::move(again);
    }
    row->shown.edit().state = RowState::Waiting;
    row->shown.edit().what = {};
    return {};
}

bool QueueBus::retryFailed()
{
    bool any = false;
    for (const Row &row : m_rows.all()) {
        if (row.shown->state == RowState::Failed)
            any = retry(row.shown->id).has_value() || any;
    }
    return any;
}

void QueueBus::stop()
{
    if (m_interruption)
        m_interruption->interrupt();
}

void QueueBus::renewLease()
{
    if (m_stream)
        m_stream->renew();
}

} // namespace mb::service
