// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/engine/owedbook.h"

#include "model/family.h"
#include "model/unit.h"

#include <algorithm>

namespace mb {
namespace {

using Owed = std::vector<tuning::OwedGains>;

constexpr Duration askNotebookAgain = std::chrono::seconds(5);

Task<void> settle(tuning::ExperimentJournal &journal, std::int64_t trial)
{
    co_await journal.settle(trial);
    co_return {};
}

} // namespace

void OwedBook::lookAgain(DeviceId id)
{
    if (const Device *device = m_context.session.find(id); device && tuning::storesLater(*device))
        m_lookAgain[id] = m_context.clock.now() + tuning::storingTime(*device);
}

void OwedBook::ended(DeviceId id)
{
    m_lookedFor.erase(id);
    lookAgain(id);
}

void OwedBook::look()
{
    const Instant now = m_context.clock.now();
    for (const auto &[id, at] : m_lookAgain) {
        if (now > at)
            m_lookedFor.erase(id);
    }
    std::erase_if(m_lookAgain, [now](const auto &entry) { return now > entry.second; });
    for (const Device *device : m_context.session.devices())
        lookUp(*device);
    std::erase_if(m_owed, [this](const auto &entry) { return !m_context.session.find(entry.first); });
    std::erase_if(m_lookedFor, [this](const auto &entry) { return !m_context.session.find(entry.first); });
}

/// Without a word to those who are owed nothing.
void OwedBook::lookUp(const Device &device)
{
    const DeviceId id = m_context.session.idOf(device);
    const bool ready = m_journal && device.family().trials && device.liveness().heard
        && device.identity().state == DeviceState::Online && !device.link().address().isRecording()
        && !m_context.operations.has(id);
    const std::string unit = unitKeyOf(device);
    if (!ready || m_lookedFor[id] == unit)
        return;
    m_lookedFor[id] = unit;
    m_asking.spawn<Owed>(m_journal->owedTo(unit), [this, id, unit](const Result<Owed> &owed) {
        if (!owed)
            return notAnswered(id, owed.error());
        m_told.erase(id);
        const auto isUnderWay = [](const tuning::OwedGains &debt) { return debt.isUnderWay; };
        if (std::any_of(owed->begin(), owed->end(), isUnderWay))
            m_lookAgain[id] = m_context.clock.now(); // that program may end in the middle of it
        if (!std::all_of(owed->begin(), owed->end(), isUnderWay))
            compare(id, unit);
        else
            m_owed.erase(id);
    });
}

/// Told once, asked again: gains that an experiment tried may be in force.
void OwedBook::notAnswered(DeviceId id, const Error &error)
{
    m_lookAgain[id] = m_context.clock.now() + askNotebookAgain;
    if (m_told.insert(id).second)
        m_context.log.tell(Severity::Caution, id,
            say("whether gains of an experiment are still to be put back is not known yet: %1", error.message()));
}

/// With what the unit has; later, when it is busy now.
void OwedBook::compare(DeviceId id, const std::string &unit)
{
    m_context.operations.begin<Owed>(
        id, {say("Look for gains that are owed"), OperationKind::Look},
        [this](Device &device, Progress &) { return tuning::lookForOwed(device, *m_journal); },
        [this, id](Operations::Job &, const Result<Owed> &owed) {
            if (owed && !owed->empty())
                m_owed[id] = *owed;
            else if (owed)
                m_owed.erase(id);
            else
                m_lookedFor.erase(id);
            lookAgain(id); // until nothing is owed
        },
        [this, id, unit](const Result<void> &) {
            if (m_lookedFor[id] == unit)
                m_lookedFor.erase(id);
        });
}

void OwedBook::end(DeviceId id, std::int64_t trial)
{
    std::erase_if(m_owed[id], [trial](const tuning::OwedGains &owed) { return owed.trial == trial; });
    if (m_owed[id].empty())
        m_owed.erase(id);
}

void OwedBook::carryOut(const orders::PayGains &order, const Finished &finished)
{
    const auto known = m_owed.find(order.device);
    const Owed all = known == m_owed.end() ? Owed() : known->second;
    const auto found = std::ranges::find(all, order.trial, &tuning::OwedGains::trial);
    if (found == all.end())
        return finished(fail(Fault::OutOfRange, say("this trial owes nothing to the unit")));
    if (auto same = m_context.operations.checkRecognised(order.device); !same)
        return finished(same);
    if (Device *unit = m_context.session.find(order.device); unit && m_context.session.stream(*unit).isRunning())
        return finished(
            fail(Fault::Unsafe, say("its motor is turning or driven already"), say("bring it to rest first")));
    m_context.operations.begin(
        order.device, say("Put gains back"),
        [this, owed = *found](Device &device, Progress &) { return tuning::payOwed(device, *m_journal, owed); },
        [this, order, finished](const Result<void> &result) {
            if (result) {
                end(order.device, order.trial);
                lookAgain(order.device);
                m_context.log.tell(Severity::Good, order.device,
                    say("the gains that trial #%1 had changed are put back", order.trial));
            }
            finished(result);
        });
}

void OwedBook::carryOut(const orders::DismissGains &order, const Finished &finished)
{
    if (!m_journal)
        return finished({});
    m_context.operations.begin(
        order.device, say("Keep the gains of a trial"),
        [this, trial = order.trial](Device &, Progress &) { return settle(*m_journal, trial); },
        [this, order, finished](const Result<void> &result) {
            if (result)
                end(order.device, order.trial);
            finished(result);
        });
}

} // namespace mb
