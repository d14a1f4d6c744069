// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/operation.h"

namespace mb {

Operation::Operation(Clock &clock, Message title, OperationKind kind)
    : m_clock(clock)
    , m_timer(clock)
{
    m_status.title = std::move(title);
    m_status.kind = kind;
    m_status.startedAt = clock.now();
}

Operation::~Operation()
{
    if (m_job)
        m_job->abandon();
}

bool Operation::cancel()
{
    if (!isRunning() || !m_status.mayInterrupt)
        return false;
    m_timer.startIn(Duration::zero(), [this] {
        const auto keep = m_job; // the callback may destroy this operation
        if (m_status.mayInterrupt)
            keep->cut(*this, {Fault::Cancelled, say("cancelled")});
    });
    return true;
}

void Operation::dismiss(const Error &error)
{
    if (!isRunning() || !m_job)
        return;
    m_timer.stop();
    const auto keep = m_job; // the callback may destroy this operation
    keep->cut(*this, error);
}

void Operation::step(const Message &what, int done, int total)
{
    m_status.step = what;
    m_status.done = done;
    m_status.total = total;
    ++m_revision;
}

void Operation::part(int number, PartState state)
{
    m_status.parts[number] = state;
    ++m_revision;
}

void Operation::log(Severity severity, const Message &text)
{
    m_status.log.push_back({m_clock.now(), severity, text});
    ++m_revision;
}

void Operation::mayInterrupt(bool may)
{
    m_status.mayInterrupt = may;
    ++m_revision;
}

void Operation::replaces(const std::string &version)
{
    m_status.update.from = version;
    ++m_revision;
}

void Operation::accepted(int parts, int retries)
{
    m_status.update.pages = parts;
    m_status.update.retries = retries;
    ++m_revision;
}

void Operation::ended(const Error *error)
{
    m_status.endedAt = m_clock.now();
    m_status.mayInterrupt = true;
    m_status.state = OperationStatus::State::Done;
    if (error) {
        m_status.error = *error;
        m_status.state
            = error->fault == Fault::Cancelled ? OperationStatus::State::Cancelled : OperationStatus::State::Failed;
    }
    ++m_revision;
}

} // namespace mb
