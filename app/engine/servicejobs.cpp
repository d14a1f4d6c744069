// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/engine/servicejobs.h"

#include <algorithm>
#include <utility>

namespace mb {
namespace {

Result<void> alreadyServing()
{
    return fail(Fault::Unsafe, say("units are served already"), say("end that first"));
}

} // namespace

ServiceJobs::ServiceJobs(const EngineContext &context, Scans &scans)
    : m_context(context)
    , m_links(context, scans)
    , m_permit(context.clock)
{
    m_sessionChanged = context.session.changed().add([this] { followLinks(); });
    m_permitChanged = m_permit.changed().add([this] { m_changed.notify(); });
}

ServiceJobs::~ServiceJobs()
{
    leave();
}

void ServiceJobs::setBooks(const Books &books, std::string station)
{
    leave();
    m_books = books;
    m_station = station;
    m_computer = std::move(station);
}

void ServiceJobs::carryOut(const orders::ServeUnits &order, const Finished &finished)
{
    finished(begin(order));
}

Result<void> ServiceJobs::begin(const orders::ServeUnits &order)
{
    if (isRunning())
        return alreadyServing();
    if (!m_books.visits || !order.matter)
        return fail(Fault::Unsupported);
    MB_TRY_VOID(m_links.take(order.links)); // and what was served before stays in sight
    m_permit.arm(false);
    m_queue.reset();
    m_last = {};
    m_trouble = {};
    m_permit.setLeaving(false);
    m_judged.clear();
    m_chosen.reset();
    if (order.chosen)
        m_chosen.emplace(order.chosen->begin(), order.chosen->end());
    service::QueueOptions options;
    options.station = m_station;
    options.units = order.units;
    options.run = order.run;
    options.onlyChosen = order.chosen.has_value();
    m_matter = order.matter;
    m_queue = std::make_unique<service::ServiceQueue>(m_context.clock, *m_matter,
        service::QueueSurroundings{*m_books.visits, m_books.settings, m_books.trials, &m_permit, {}}, options);
    for (Link *const link : m_links.links())
        m_queue->addBus(m_context.session, *link);
    m_queueChanged = m_queue->changed().add([this] { queueChanged(); });
    m_visitEnded = m_queue->unitEnded().add([this](const service::Visit &visit) { ended(visit); });
    m_queueEnded = m_queue->ended().add([this] {
        if (m_queue->trouble())
            m_trouble = m_queue->trouble()->message();
        arm(false);
        m_links.giveBack();
    });
    m_queue->start();
    m_changed.notify();
    return {};
}

void ServiceJobs::carryOut(const orders::KeepJournal &order, const Finished &finished)
{
    if (isRunning())
        return finished(alreadyServing());
    JournalPlace place{order.station.empty() ? m_computer : order.station, {}};
    if (!order.server.empty()) {
        auto server = JournalServer::parse(order.server);
        if (!server)
            return finished(fail(server.error()));
        place.server = std::move(*server);
    }
    m_station = place.station;
    m_journalChosen.notify(place, order);
    finished({});
}

/// A link that is lost ends the arming. One that was closed takes its queue along: nothing can be done again there, and what is known
/// stays in sight.
void ServiceJobs::followLinks()
{
    if (!m_queue)
        return;
    if (m_links.areThere()) {
        if (m_links.isOneMoreLost())
            arm(false);
        return;
    }
    ServiceView last = view();
    leave();
    last.running = false;
    last.finishing = true;
    last.mayTurn = MayTurn::Nothing;
    m_last = std::move(last);
    m_changed.notify();
}

void ServiceJobs::leave()
{
    m_permit.arm(false);
    m_queue.reset();
    m_links.forget();
}

void ServiceJobs::queueChanged()
{
    choose();
    m_permit.setServed(std::ranges::any_of(
        m_queue->rows(), [](const service::QueueRow &row) { return row.state == service::RowState::Running; }));
    m_changed.notify();
}

/// Of what is found the chosen are taken, the others stay left out.
void ServiceJobs::choose()
{
    if (!m_chosen)
        return;
    for (const service::QueueRow &row : m_queue->rows()) {
        if (m_judged.insert(row.id).second && row.state == service::RowState::Skipped
            && m_chosen->count(row.device) > 0)
            (void)m_queue->retry(row.id); // it was found just now
    }
}

void ServiceJobs::carryOut(const orders::PauseService &order, const Finished &finished)
{
    if (m_queue)
        order.on ? m_queue->pause() : m_queue->resume();
    finished({});
}

void ServiceJobs::carryOut(const orders::SkipUnit &order, const Finished &finished)
{
    if (m_queue)
        m_queue->skip(order.row);
    finished({});
}

/// A queue that has ended gets its links back for it, if anything comes of the order; only then somebody will arm again.
Result<void> ServiceJobs::again(const std::function<Result<void>()> &order)
{
    if (!m_queue)
        return fail(Fault::Refused, say("nothing is served here"), say("begin a queue first"));
    const bool idle = !isRunning();
    MB_TRY_VOID(idle ? m_links.takeAgain() : Result<void>());
    const Message before = std::exchange(m_trouble, {});
    const Result<void> done = order();
    if (done)
        m_permit.setLeaving(false);
    else
        m_trouble = before;
    if (idle && !isRunning())
        m_links.giveBack();
    m_changed.notify();
    return done;
}

void ServiceJobs::carryOut(const orders::RetryUnit &order, const Finished &finished)
{
    finished(again([&] { return m_queue->retry(order.row); }));
}

void ServiceJobs::carryOut(const orders::RetryFailedUnits &, const Finished &finished)
{
    finished(again([this] {
        return m_queue->retryFailed() ? Result<void>()
                                      : fail(Fault::Refused, say("no unit has failed that is still there"));
    }));
}

void ServiceJobs::carryOut(const orders::CancelService &, const Finished &finished)
{
    m_permit.disarmNext();
    if (isRunning()) {
        m_permit.setLeaving(true);
        m_queue->finish();
        for (const service::QueueRow &row : m_queue->rows()) {
            if (row.state == service::RowState::Running)
                m_queue->skip(row.id);
        }
    }
    finished({});
}

void ServiceJobs::carryOut(const orders::FinishService &, const Finished &finished)
{
    m_permit.disarmNext(); // a self-test that runs is brought to its end
    m_permit.setLeaving(true);
    if (m_queue)
        m_queue->finish();
    finished({});
}

void ServiceJobs::stop()
{
    arm(false);
    m_permit.setLeaving(true);
    if (isRunning())
        m_queue->stop();
}

void ServiceJobs::carryOut(const orders::ArmService &order, const Finished &finished)
{
    arm(order.on);
    finished({});
}

void ServiceJobs::carryOut(const orders::RenewService &, const Finished &finished)
{
    if (m_queue)
        m_queue->renewLease();
    finished({});
}

void ServiceJobs::ended(const service::Visit &visit)
{
    if (visit.outcome == service::Outcome::Failed)
        m_permit.disarmNext();
    m_unitEnded.notify(visit);
    m_changed.notify();
}

ServiceView ServiceJobs::view() const
{
    if (!m_queue)
        return m_last;
    ServiceView view;
    view.links = m_links.addresses();
    m_permit.describe(view);
    view.trouble = m_trouble;
    view.matter = m_matter;
    view.run = m_queue->run();
    view.running = m_queue->isRunning();
    view.pausing = m_queue->isPausing();
    view.finishing = m_queue->isFinishing();
    view.rows = m_queue->rows();
    view.counts = m_queue->counts();
    return view;
}

} // namespace mb
