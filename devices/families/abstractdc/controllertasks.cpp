// SPDX-License-Identifier: GPL-3.0-or-later
// Controller: what asks and waits.
#include "families/abstractdc/answertime.h"
#include "families/abstractdc/channels.h"
#include "families/abstractdc/codec.h"
#include "families/abstractdc/controller.h"
#include "families/abstractdc/parameters.h"
#include "transport/exchange.h"

#include <QtGlobal>

#include <algorithm>
#include <array>
#include <cmath>

namespace mb::abstractdc {
namespace {

constexpr int tries = 3;
constexpr std::array loops{Loop::Velocity, Loop::Current, Loop::Position};

std::string nameOf(Loop loop)
{
    return std::string(toString(modeOf(loop)));
}

std::string counterOf(Loop loop)
{
    return "saves." + nameOf(loop);
}

std::optional<Log> logOf(ChannelIndex channel)
{
    if (channel == channel::position)
        return Log::Position;
    if (channel == channel::velocity)
        return Log::Velocity;
    if (channel == channel::current)
        return Log::Current;
    if (channel == channel::duty)
        return Log::Voltage;
    if (channel == channel::temperature)
        return Log::Temperature;
    return std::nullopt;
}

} // namespace

/// The drive acknowledges nothing; that it answers a question which was sent behind the order is all that can be known.
Task<void> Controller::expectAnswer()
{
    const Dialect &dialect = m_dialect ? *m_dialect : dialectF;
    const Log log = Log::Velocity; // the one code that is the same in F, L and D, should the dialect be mistaken
    const int offset = identity().address;
    const std::array answers{replyId(dialectF, offset, log), replyId(dialectL, offset, log)};
    const Question question{offset, dialect.request, static_cast<std::uint8_t>(dialect.codeOf(log))};
    CanInbox::Match match = [this, answers, question](const CanFrame &frame) {
        return !frame.extended && frame.size == 4
            && std::find(answers.begin(), answers.end(), frame.id) != answers.end()
            && m_poller.questions().isAnswerTo(question);
    };
    auto asking = exchange(
        m_can, clock(), encodeLogRequest(dialect, offset, log), std::move(match), {tries, answerTime(m_can)});
    const Result<CanFrame> answer = co_await std::move(asking).attempt();
    if (!answer && answer.error().fault == Fault::Timeout)
        co_return fail(Fault::Timeout, selector() + " does not answer");
    if (!answer)
        co_return fail(answer.error());
    co_return {};
}

Task<void> Controller::doRefresh()
{
    auto asking = expectAnswer();
    co_await std::move(asking);
    Identity known = identity();
    known.descriptors = {{"position_glitches", std::to_string(m_sense.glitches())}};
    for (const Loop loop : loops) {
        const auto counted = profile().counters.find(counterOf(loop));
        if (counted != profile().counters.end())
            known.descriptors.emplace_back(counterOf(loop), std::to_string(counted->second));
    }
    setIdentity(std::move(known));
    co_return {};
}

Task<std::int64_t> Controller::doRead(ParameterIndex)
{
    co_return fail(
        Fault::Unsupported, QT_TRANSLATE_NOOP("table", "an Abstract DC Drive cannot be asked for its settings"));
}

Result<void> Controller::mayWrite(const Parameter &parameter, std::int64_t raw) const
{
    if (!m_dialect)
        return fail(Error::fromPhrase(Fault::Unsafe,
            QT_TRANSLATE_NOOP("table", "it is not proven which codes this drive speaks; nothing was written")));
    const Field field = fieldOf(parameter);
    if (field == Field::Divisor && raw == 0)
        return fail(Error::fromPhrase(
            Fault::OutOfRange, QT_TRANSLATE_NOOP("table", "0 is no divisor; the loop would be undefined")));
    if (field == Field::Divisor && m_loop == loopOf(parameter))
        return fail(Error::fromPhrase(
            Fault::Unsafe, QT_TRANSLATE_NOOP("table", "a divisor changes all gains at once; stop the motor first")));
    if (field != Field::Averaging)
        return {};
    if (raw < 1 || raw > averagingMost)
        return fail(Error::fromPhrase(Fault::OutOfRange,
            QT_TRANSLATE_NOOP(
                "table", "legal is 1 … 500; the drive does not check it and would overwrite its memory")));
    if (mayLowerAveraging(raw) && (isDriven() || m_sense.isMoving(clock().now())))
        return fail(Fault::Unsafe, QT_TRANSLATE_NOOP("table", "lowering it needs a stopped motor"));
    return {};
}

/// What is in force is known only where this program wrote it: otherwise any value but the greatest may be a lower one.
bool Controller::mayLowerAveraging(std::int64_t raw) const
{
    const auto before = parameters().entry(*parameterOf(Loop::Current, Field::Averaging)).raw;
    return raw < before.value_or(averagingMost);
}

Task<std::int64_t> Controller::doWrite(ParameterIndex index, std::int64_t raw)
{
    const Parameter &parameter = parameters().parameter(index);
    if (auto allowed = mayWrite(parameter, raw); !allowed)
        co_return fail(allowed.error());
    const Loop loop = loopOf(parameter);
    const auto value = static_cast<std::int32_t>(raw);
    const bool lowered = fieldOf(parameter) == Field::Averaging && mayLowerAveraging(raw);
    if (lowered)
        setCounter(std::string(counter::powerCycle),
            1); // README.md#averaging: from now on its sample index may run out of the buffer
    if (auto sent = m_can.send(encodeSettings(*m_dialect, identity().address, loop, fieldOf(parameter), value)); !sent)
        co_return fail(sent.error());
    auto asking = expectAnswer();
    co_await std::move(asking);
    m_unsaved.insert(loop);
    if (lowered) {
        NoProgress unheard;
        auto saving = save(loop, unheard);
        co_await std::move(saving);
        Identity known = identity();
        known.detail = QT_TRANSLATE_NOOP("table",
            "Its averaging was lowered, as far as can be known, and saved. Switch it off and on now: until then it may "
            "overwrite its memory.");
        setIdentity(std::move(known));
    }
    co_return raw;
}

Task<void> Controller::save(Loop loop, Progress &progress)
{
    const auto counted = profile().counters.find(counterOf(loop));
    const std::int64_t saves = counted == profile().counters.end() ? 0 : counted->second;
    if (saves >= savesPerPage)
        co_return fail(Fault::Unsafe,
            "the settings of the " + nameOf(loop) + " loop were saved " + std::to_string(saves) + " times",
            "one more would make the drive load something else. Erase its settings pages with a firmware "
            "update (erase settings), then save again");
    if (saves + 1 >= savesUntilWarning)
        progress.log(Severity::Caution,
            "the " + nameOf(loop) + " loop was saved " + std::to_string(saves + 1) + " times; after "
                + std::to_string(savesPerPage) + " its settings pages must be erased");
    if (auto sent = m_can.send(encodeSave(*m_dialect, identity().address, loop)); !sent)
        co_return fail(sent.error());
    setCounter(counterOf(loop), saves + 1);
    m_unsaved.erase(loop);
    auto asking = expectAnswer();
    co_await std::move(asking);
    co_return {};
}

Task<bool> Controller::doStore(Progress &progress)
{
    if (!m_dialect)
        co_return fail(Error::fromPhrase(Fault::Unsafe,
            QT_TRANSLATE_NOOP("table", "it is not proven which codes this drive speaks; nothing was saved")));
    if (isDriven())
        co_return fail(Fault::Unsafe,
            QT_TRANSLATE_NOOP("table", "stop the motor first: the drive stands still while it writes its flash"));
    const std::set<Loop> all = m_unsaved;
    int done = 0;
    for (const Loop loop : all) {
        progress.step("Saving the " + nameOf(loop) + " loop", done++, static_cast<int>(all.size()));
        auto saving = save(loop, progress);
        co_await std::move(saving);
    }
    progress.step("Saved", static_cast<int>(all.size()), static_cast<int>(all.size()));
    co_return false;
}

void Controller::settingsErased()
{
    for (const Loop loop : loops)
        setCounter(counterOf(loop), 0);
    for (std::uint16_t i = 0; i < parameterTable().size(); ++i)
        assume({i}, fieldOf(parameterTable()[i]) == Field::Averaging ? 1 : 0);
    m_unsaved.clear();
}

Task<std::vector<FaultRecord>> Controller::doReadFaults()
{
    std::vector<FaultRecord> records;
    records.push_back({"output_saturated", m_saturated, m_saturations > 0, m_saturations});
    records.push_back({"output_wrapped", m_wrapped, m_wraps > 0, m_wraps});
    co_return records;
}

Task<std::vector<FaultRecord>> Controller::doClearFaults()
{
    auto reading = doReadFaults();
    auto records = co_await std::move(reading);
    m_saturations = 0;
    m_wraps = 0;
    co_return records;
}

Task<void> Controller::doIdentify()
{
    co_return fail(Fault::Unsupported, QT_TRANSLATE_NOOP("table", "an Abstract DC Drive has no lamp to blink"));
}

Task<void> Controller::doRename(std::string)
{
    co_return fail(Fault::Unsupported, QT_TRANSLATE_NOOP("table", "an Abstract DC Drive has no name"));
}

Task<void> Controller::doRenumber(int)
{
    co_return fail(Fault::Unsupported,
        QT_TRANSLATE_NOOP("table", "the offset of an Abstract DC Drive is compiled into its firmware"));
}

Task<void> Controller::doSetRate(ChannelIndex channel, double hertz)
{
    const auto log = logOf(channel);
    if (!log)
        co_return fail(
            Fault::Unsupported, QT_TRANSLATE_NOOP("table", "the set-point comes from here, not from the device"));
    if (!std::isfinite(hertz) || hertz < 0.0)
        co_return fail(
            Fault::OutOfRange, QT_TRANSLATE_NOOP("table", "a rate is a positive number, or 0 for the usual one"));
    if (hertz > 0.0)
        m_wishes[*log] = hertz;
    else
        m_wishes.erase(*log);
    if (*log == Log::Velocity && hertz > 0.0) // outside its mode velocity is computed from positions
        m_wishes[Log::Position] = std::max(m_wishes[Log::Position], hertz);
    planPolling();
    co_return {};
}

} // namespace mb::abstractdc
