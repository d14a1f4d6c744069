// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/settingsdesk.h"

#include "async/sleep.h"
#include "families/abstractdc/answertime.h"
#include "families/abstractdc/parameters.h"
#include "families/abstractdc/setpoints.h"
#include "transport/exchange.h"

#include <QScopeGuard>

#include <algorithm>
#include <array>
#include <set>

namespace mb::abstractdc {
namespace {

constexpr int tries = 8; ///< of the question that proves an order: a bus may lose one frame in ten
constexpr std::array loops{Loop::Velocity, Loop::Current, Loop::Position};

std::string nameOf(Loop loop)
{
    return std::string(toString(modeOf(loop)));
}

std::string counterOf(Loop loop)
{
    return "saves." + nameOf(loop);
}

std::string unsavedOf(const Parameter &parameter)
{
    return std::string(counter::unsaved) + std::string(parameter.key);
}

bool isLegalAveraging(std::int64_t raw)
{
    return raw >= 1 && raw <= averagingMost;
}

} // namespace

SettingsDesk::SettingsDesk(Device &device, CanLink &link, const LogSense &logs, PowerCycleDebt &debt,
    std::function<void(const std::string &, std::int64_t)> count)
    : m_device(device)
    , m_can(link)
    , m_logs(logs)
    , m_debt(debt)
    , m_count(std::move(count))
    , m_exchanged(device.knowledge().exchanged().add([this] { replaced(true); }))
{
}

Task<void> SettingsDesk::expectAnswer()
{
    const Dialect &dialect = m_logs.dialect() ? *m_logs.dialect() : dialectF;
    const Log log = Log::Velocity; // the one code that is the same in F, L and D, should the dialect be mistaken
    const int offset = m_device.identity().address;
    const std::array answers{replyId(dialectF, offset, log), replyId(dialectL, offset, log)};
    const Question question{offset, dialect.request, static_cast<std::uint8_t>(dialect.codeOf(log))};
    // The answer to the same question that was asked before the order would not prove that it came. It comes by then, or never.
    const Instant latest = m_device.clock().now() + 2 * answerTime(m_can);
    while (m_logs.questions().isOpen(question) && m_device.clock().now() < latest)
        co_await Sleep(m_device.clock(), std::chrono::milliseconds(1));
    CanInbox::Match match = [this, answers, question](const CanFrame &frame) {
        return !frame.extended && frame.size == 4 && std::ranges::find(answers, frame.id) != answers.end()
            && m_logs.questions().isAnswerTo(question);
    };
    auto asking = exchange(
        m_can, m_device.clock(), encodeLogRequest(dialect, offset, log), std::move(match), {tries, answerTime(m_can)});
    const Result<CanFrame> answer = co_await std::move(asking).attempt();
    if (!answer && answer.error().fault == Fault::Timeout)
        co_return fail(Fault::Timeout, say("%1 does not answer", m_device.selector()));
    if (!answer)
        co_return fail(answer.error());
    co_return {};
}

Result<void> SettingsDesk::mayWrite(const Parameter &parameter, std::int64_t raw) const
{
    if (!m_logs.dialect())
        return fail(Fault::Unsafe, say("it is not proven which codes this drive speaks"), say("nothing was written"));
    MB_TRY_VOID(m_logs.isAddressedAlone());
    const Field field = fieldOf(parameter);
    if (field == Field::Divisor && raw == 0)
        return fail(Fault::OutOfRange, say("0 is no divisor"), say("the loop would be undefined"));
    const bool mayRun = m_logs.loop() ? m_logs.loop() == loopOf(parameter) : m_logs.isMoving();
    if (field == Field::Divisor && mayRun)
        return fail(Fault::Unsafe, say("a divisor changes all gains at once"), say("stop the motor first"));
    if (field != Field::Averaging)
        return {};
    if (!isLegalAveraging(raw))
        return fail(Fault::OutOfRange, say("legal is 1 … 500"),
            say("the drive does not check it and would overwrite its memory"));
    if (m_logs.isDriven() || m_logs.isMoving())
        return fail(
            Fault::Unsafe, say("until it has averaged once it reads a wrong current"), say("stop the motor first"));
    if (!mayOverrun(raw))
        return {};
    const auto saves = maySave(loopOf(parameter));
    return saves ? Result<void>() : fail(saves.error());
}

/// README.md#averaging: from now on its sample index may run out of the buffer. What is in force is known only where it was written
/// since this run of the program began, whatever a file says: otherwise any value but the greatest may be a lower one.
bool SettingsDesk::mayOverrun(std::int64_t averaging) const
{
    return !isLegalAveraging(averaging) || averaging < m_averaging.value_or(averagingMost);
}

bool SettingsDesk::overrunsEver() const
{
    const auto averaging = parameterOf(Loop::Current, Field::Averaging);
    const auto raw = averaging ? m_device.parameters().entry(*averaging).raw : std::nullopt;
    return raw && !isLegalAveraging(*raw);
}

/// On the disk before it can be in force: the next run of the program must know it.
Task<void> SettingsDesk::owe(const Parameter &parameter, std::int64_t raw)
{
    const bool wasOwed = m_debt.isOwed();
    const auto before = m_averaging;
    m_debt.incur();
    auto keeping = m_device.knowledge().kept();
    Result<void> may = co_await std::move(keeping).attempt();
    if (may)
        may = mayWrite(parameter, raw);            // that took its time
    if (!may && !wasOwed && m_averaging == before) // nobody else has lowered it meanwhile
        m_debt.pay();
    co_return may;
}

Task<std::int64_t> SettingsDesk::write(const Parameter &parameter, std::int64_t raw)
{
    const Loop loop = loopOf(parameter);
    const auto value = static_cast<std::int32_t>(raw);
    const bool lowered = fieldOf(parameter) == Field::Averaging && mayOverrun(raw);
    if (lowered) {
        auto owing = owe(parameter, raw);
        co_await std::move(owing);
    }
    const int offset = m_device.identity().address;
    co_await m_can.send(encodeSettings(*m_logs.dialect(), offset, loop, fieldOf(parameter), value));
    const auto proved = qScopeGuard([unproven = m_unproven] { unproven->reset(); });
    if (const auto index = parameterOf(loop, fieldOf(parameter))) {
        *m_unproven = {*index, raw};
        written(*index, raw);
    }
    co_await expectAnswer();
    if (lowered) {
        NoProgress unheard;
        co_await save(loop, unheard);
    }
    co_return raw;
}

std::int64_t SettingsDesk::savesOf(Loop loop) const
{
    const auto &counters = m_device.knowledge().profile().counters;
    const auto counted = counters.find(counterOf(loop));
    return counted == counters.end() ? 0 : counted->second;
}

Result<std::int64_t> SettingsDesk::maySave(Loop loop) const
{
    const std::int64_t saves = savesOf(loop);
    if (saves < savesPerPage)
        return saves;
    return fail(Fault::Unsafe, say("the settings of the %1 loop were saved %2 times", nameOf(loop), saves),
        say("one more would make the drive load something else. Erase its settings pages with a firmware update "
            "(erase settings), then save again"));
}

Task<void> SettingsDesk::save(Loop loop, Progress &progress)
{
    const auto before = co_await maySave(loop);
    const std::int64_t saves = before + 1;
    if (saves >= savesUntilWarning)
        progress.log(Severity::Caution,
            say("the %1 loop was saved %2 times; after %3 its settings pages must be erased", nameOf(loop), saves,
                savesPerPage));
    co_await m_can.send(encodeSave(*m_logs.dialect(), m_device.identity().address, loop));
    m_count(counterOf(loop), saves);
    co_await expectAnswer();
    settle(loop);
    co_return {};
}

void SettingsDesk::settle(Loop loop)
{
    for (const ParameterIndex index : unsaved()) {
        if (loopOf(parameterTable()[index.value]) == loop)
            setUnsaved(index, false);
    }
}

void SettingsDesk::saved(Loop loop)
{
    m_count(counterOf(loop), savesOf(loop) + 1);
    settle(loop);
}

Task<bool> SettingsDesk::store(Progress &progress)
{
    if (!m_logs.dialect())
        co_return fail(Fault::Unsafe, say("it is not proven which codes this drive speaks"), say("nothing was saved"));
    co_await m_logs.isAddressedAlone();
    if (m_logs.loop() ? m_logs.isDriven() : m_logs.isMoving())
        co_return fail(Fault::Unsafe, say("stop the motor first: the drive stands still while it writes its flash"));
    std::set<Loop> all;
    for (const ParameterIndex index : unsaved())
        all.insert(loopOf(parameterTable()[index.value]));
    int done = 0;
    for (const Loop loop : all) {
        progress.step(say("Saving the %1 loop", nameOf(loop)), done++, static_cast<int>(all.size()));
        co_await save(loop, progress);
    }
    progress.step(say("Saved"), static_cast<int>(all.size()), static_cast<int>(all.size()));
    co_return false;
}

void SettingsDesk::replaced(bool fresh)
{
    if (fresh) {
        for (const Loop loop : loops)
            m_count(counterOf(loop), 0);
    }
    for (const ParameterIndex index : unsaved())
        setUnsaved(index, false);
    m_averaging.reset();
}

void SettingsDesk::written(ParameterIndex index, std::int64_t raw)
{
    if (fieldOf(parameterTable()[index.value]) == Field::Averaging) {
        if (mayOverrun(raw))
            m_debt.incur();
        m_averaging = raw;
    }
    setUnsaved(index, true);
}

void SettingsDesk::restarted()
{
    for (const ParameterIndex index : unsaved()) {
        setUnsaved(index, false);
        m_device.knowledge().doubt(index);
        if (fieldOf(parameterTable()[index.value]) == Field::Averaging)
            m_averaging.reset();
    }
}

std::vector<ParameterIndex> SettingsDesk::unsaved() const
{
    std::vector<ParameterIndex> found;
    for (std::uint16_t i = 0; i < parameterTable().size(); ++i) {
        if (isUnsaved({i}))
            found.push_back({i});
    }
    return found;
}

bool SettingsDesk::isUnsaved(ParameterIndex index) const
{
    const auto &counters = m_device.knowledge().profile().counters;
    const auto counted = counters.find(unsavedOf(parameterTable()[index.value]));
    return counted != counters.end() && counted->second != 0;
}

void SettingsDesk::setUnsaved(ParameterIndex index, bool unsaved)
{
    if (unsaved != isUnsaved(index))
        m_count(unsavedOf(parameterTable()[index.value]), unsaved ? 1 : 0);
}

std::vector<std::pair<std::string, std::string>> SettingsDesk::saves() const
{
    std::vector<std::pair<std::string, std::string>> told;
    const auto &counters = m_device.knowledge().profile().counters;
    for (const Loop loop : loops) {
        const auto counted = counters.find(counterOf(loop));
        if (counted != counters.end())
            told.emplace_back(counterOf(loop), std::to_string(counted->second));
    }
    return told;
}

} // namespace mb::abstractdc
