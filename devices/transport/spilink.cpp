// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/spilink.h"

#include "async/event.h"

#include <algorithm>

namespace mb {
namespace {

constexpr Duration pollWhileWaiting = std::chrono::microseconds(200);

} // namespace

SpiLink::Transfer::Transfer(SpiLink &link, Bytes mosi)
    : m_link(link)
    , m_job(std::make_shared<Job>())
{
    m_job->mosi = std::move(mosi);
}

SpiLink::Transfer::~Transfer()
{
    m_job->waiting = {};
    m_link.forget(m_job);
}

bool SpiLink::Transfer::await_suspend(std::coroutine_handle<> handle)
{
    if (m_link.state() != LinkState::Open || m_link.m_dropping) {
        m_job->result = fail(m_link.notOpen());
        return false;
    }
    m_job->waiting = handle;
    m_link.m_jobs.push_back(m_job);
    m_link.begin();
    return true;
}

Result<SpiLink::Bytes> SpiLink::Transfer::await_resume()
{
    return std::move(*m_job->result);
}

Result<void> SpiLink::sendUrgent(Bytes mosi)
{
    if (state() != LinkState::Open)
        return fail(notOpen());
    std::deque<std::shared_ptr<Job>> dropped;
    dropped.swap(m_jobs);
    auto job = std::make_shared<Job>();
    job->mosi = std::move(mosi);
    m_jobs.push_back(std::move(job));
    begin();
    for (const auto &waiting : dropped) // told from the clock: who stops may be in the middle of anything
        m_clock.post([waiting] { conclude(waiting, fail(Fault::Cancelled, say("a stop went first"))); });
    return {};
}

void SpiLink::begin()
{
    if (m_current || m_jobs.empty() || state() != LinkState::Open)
        return;
    m_current = std::move(m_jobs.front());
    m_jobs.pop_front();
    passed(Traffic{m_clock.now(), Direction::Sent, nullptr, m_current->mosi});
    doTransfer(m_current->mosi);
}

void SpiLink::forget(const std::shared_ptr<Job> &job)
{
    std::erase(m_jobs, job);
}

void SpiLink::conclude(const std::shared_ptr<Job> &job, Result<Bytes> result)
{
    job->result = std::move(result);
    if (const auto waiting = std::exchange(job->waiting, {}))
        waiting.resume();
}

void SpiLink::finishTransfer(Bytes miso)
{
    const auto job = std::exchange(m_current, nullptr);
    if (!job)
        return;
    m_load.count(m_clock.now(), job->mosi.size() * 8); // both ways at once
    passed(Traffic{m_clock.now(), Direction::Received, nullptr, miso});
    conclude(job, std::move(miso)); // what it wakes may close this link, or ask for more
    begin();
}

void SpiLink::dropTransfers()
{
    std::deque<std::shared_ptr<Job>> dropped;
    dropped.swap(m_jobs);
    if (auto job = std::exchange(m_current, nullptr))
        dropped.push_front(std::move(job));
    m_dropping = true; // those who are told so may ask again at once
    for (const auto &job : dropped)
        conclude(job, fail(notOpen()));
    m_dropping = false;
}

void SpiLink::setReady(std::optional<bool> level)
{
    const bool rose = level == true && m_ready != true;
    m_ready = level;
    if (rose)
        m_readyRaised.notify();
}

Task<void> SpiLink::waitReady(Duration timeout)
{
    if (!m_ready)
        co_return fail(Fault::Unsupported, say("no ready line is wired"), say("add ready=CHIP:LINE to the address"));
    struct Waiter {
        explicit Waiter(SpiLink &link)
            : owner(link)
        {
            ++owner.m_waiters;
        }
        ~Waiter() { --owner.m_waiters; }
        SpiLink &owner;
    };
    Event risen;
    Timer limit(m_clock);
    const Waiter waiter(*this);
    const Subscription raised = m_readyRaised.add([&risen] { risen.set(); });
    const Subscription changed = stateChanged().add([&risen](LinkState) { risen.set(); });
    limit.startIn(timeout, [&risen] { risen.set(); });
    poll(pollWhileWaiting);
    if (!*m_ready && state() == LinkState::Open)
        co_await risen.wait();
    if (state() != LinkState::Open)
        co_return fail(notOpen());
    if (!m_ready.value_or(false))
        co_return fail(Fault::Timeout, say("the ready line stayed low"));
    co_return {};
}

void SpiLink::watchReady(Duration period)
{
    m_watchPeriod = period;
    poll(period);
}

void SpiLink::poll(Duration period)
{
    if (doSignalsReady() || period <= Duration::zero())
        return;
    m_poll.startIn(period, [this] {
        if (state() != LinkState::Open)
            return;
        doSampleReady();
        poll(m_waiters > 0 ? pollWhileWaiting : m_watchPeriod);
    });
}

Result<void> SpiLink::pulseReset()
{
    if (state() != LinkState::Open)
        return fail(notOpen());
    return doPulseReset();
}

} // namespace mb
