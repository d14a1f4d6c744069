// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/guardian/runner.h"

#include <algorithm>
#include <utility>

namespace mb::guardian {
namespace {

using namespace std::chrono_literals;

constexpr Time retryAfter = 1ms;
constexpr std::size_t keptBytes = 4096;

bool contains(const Bytes &heard, const Step &step, std::size_t messageSize)
{
    for (std::size_t start = 0; start + step.reply.size() <= heard.size(); start += messageSize) {
        bool fits = true;
        for (std::size_t i = 0; fits && i < step.reply.size(); ++i)
            fits = ((heard[start + i] ^ step.reply[i]) & step.mask[i]) == 0;
        if (fits)
            return true;
    }
    return false;
}

bool asksForAnswers(const Script &script)
{
    return std::ranges::any_of(script, [](const Step &step) { return !step.reply.empty(); });
}

} // namespace

void Runner::add(std::uint32_t id, const Script &script, Time now, Time patience)
{
    m_patientUntil = now + patience;
    Job job;
    job.id = id;
    job.script = script;
    job.notBefore = now;
    m_jobs.push_back(std::move(job));
}

std::vector<Runner::Outcome> Runner::proceed(Time now)
{
    if (m_answerUntil)
        listen(now);
    if (m_blockedUntil && *m_blockedUntil <= now)
        m_blockedUntil.reset();
    while (!m_answerUntil && !m_blockedUntil && attempt(now)) { }
    return std::exchange(m_ended, {});
}

std::optional<Time> Runner::due() const
{
    if (m_jobs.empty())
        return std::nullopt;
    if (m_answerUntil)
        return m_answerUntil;
    if (m_blockedUntil)
        return m_blockedUntil;
    return std::ranges::min_element(m_jobs, [](const Job &a, const Job &b) {
        return a.notBefore < b.notBefore;
    })->notBefore;
}

/// Ends the wait of the front job when its answer is there or its time is over.
void Runner::listen(Time now)
{
    Job &job = m_jobs.front();
    const Step &step = job.script[job.step];
    const Bytes more = m_port.read();
    m_heard.insert(m_heard.end(), more.begin(), more.end());
    if (m_heard.size() > keptBytes)
        m_heard.erase(m_heard.begin(), m_heard.end() - keptBytes);
    const bool answered = contains(m_heard, step, m_port.messageSize());
    if (!answered && now < *m_answerUntil)
        return;
    m_answerUntil.reset();
    if (answered)
        endStep(job, true);
    else if (job.attempts >= step.attempts)
        endStep(job, false);
    retire();
}

/// One message of the first job whose time has come. False when there is none, or it could not be sent.
bool Runner::attempt(Time now)
{
    const auto next = std::ranges::find_if(m_jobs, [now](const Job &candidate) { return candidate.notBefore <= now; });
    if (next == m_jobs.end())
        return false;
    std::rotate(m_jobs.begin(), next, next + 1);
    Job &job = m_jobs.front();
    const Step &step = job.script[job.step];
    if (job.step == 0 && job.attempts == 0)
        m_port.restoreSetup();
    if (!step.reply.empty()) {
        m_port.prepare();
        m_heard.clear();
    }
    const Port::Sent sent = m_port.send(step.bytes);
    if (sent != Port::Sent::All) {
        m_blockedUntil = now + retryAfter;
        if (sent == Port::Sent::Lost || now >= m_patientUntil)
            giveUp();
        return false;
    }
    if (!step.reply.empty()) {
        ++job.attempts;
        m_answerUntil = now + step.wait;
        return true;
    }
    wasSaid(Step(step), now);
    return true;
}

/// By the front job, and by all others that have the same to say now.
void Runner::wasSaid(const Step &step, Time now)
{
    auto next = m_jobs.begin();
    while (next != m_jobs.end()) {
        std::rotate(m_jobs.begin(), next, next + 1);
        Job &job = m_jobs.front();
        job.notBefore = now + step.wait;
        if (++job.attempts >= step.attempts)
            endStep(job, true);
        retire();
        next = std::ranges::find_if(
            m_jobs, [&](const Job &other) { return other.notBefore <= now && other.script[other.step] == step; });
    }
}

/// Nothing can be sent here any more.
void Runner::giveUp()
{
    for (const Job &job : m_jobs)
        m_ended.push_back({job.id, false, false, false});
    m_jobs.clear();
    m_port.forget();
    m_blockedUntil.reset();
}

void Runner::endStep(Job &job, bool good)
{
    job.confirmed = job.confirmed && good;
    job.attempts = 0;
    ++job.step;
}

/// The front job has had its turn.
void Runner::retire()
{
    Job job = std::move(m_jobs.front());
    m_jobs.pop_front();
    if (job.step < job.script.size())
        m_jobs.push_back(std::move(job));
    else
        m_ended.push_back({job.id, job.confirmed, true, job.confirmed && asksForAnswers(job.script)});
}

} // namespace mb::guardian
