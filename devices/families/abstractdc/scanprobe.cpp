// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/scanprobe.h"

#include "async/sleep.h"
#include "families/abstractdc/codec.h"

namespace mb::abstractdc {
namespace {

using namespace std::chrono_literals;

constexpr int probeTries = 3;
constexpr Duration patienceWithOthers = 500ms; ///< who ask for voltages all the time

} // namespace

Task<std::optional<std::uint32_t>> Prober::ask(Probe probe, int most)
{
    const Question question = probe.question;
    CanInbox::Match match = [this, probe = std::move(probe)](const CanFrame &frame) {
        return !frame.extended && frame.size == 4 && std::ranges::find(probe.answers, frame.id) != probe.answers.end()
            && m_questions.isAnswerTo(probe.question);
    };
    CanInbox inbox(m_link, m_clock, std::move(match));
    const std::array data{question.code};
    const CanFrame request = standardFrame(question.base + static_cast<std::uint32_t>(question.offset), data);
    for (int attempt = 0; attempt < most; ++attempt) {
        const Instant patience = m_clock.now() + patienceWithOthers;
        while (question.code == dialectF.codeOf(Log::Voltage) && !m_questions.isFree(question, id::voltageLog)) {
            if (m_clock.now() > patience)
                co_return std::optional<std::uint32_t>();
            co_await Sleep(m_clock, roundTrip(m_link));
        }
        co_await m_link.send(request);
        const Result<CanFrame> answer = co_await inbox.next(answerTime(m_link));
        if (answer)
            co_return std::optional<std::uint32_t>(answer->id);
        if (answer.error().fault == Fault::LinkLost)
            co_return fail(answer.error());
    }
    co_return std::optional<std::uint32_t>();
}

namespace {

/// README.md#dialects: decides on 03, confirms with 04; D and F answer both elsewhere. The answers of D to these are answers of F to other
/// questions, so D is proven by its voltage, too, on an identifier that no other dialect has.
Task<const Dialect *> tellNew(Prober &prober, int offset, int most)
{
    auto third
        = prober.ask({{offset, id::logRequest, 3}, {at(id::temperatureLog, offset), at(id::currentLog, offset)}}, most);
    const auto answer = co_await std::move(third);
    if (!answer)
        co_return nullptr;
    const bool today = *answer == at(id::temperatureLog, offset);
    const std::uint32_t proof = today ? id::voltageLog : at(id::positionLog, offset);
    const std::uint32_t doubt = today ? at(id::positionLog, offset) : id::voltageLog;
    auto fourth = prober.ask({{offset, id::logRequest, 4}, {proof, doubt}});
    const auto confirmed = co_await std::move(fourth);
    if (!confirmed || *confirmed != proof)
        co_return nullptr;
    if (today)
        co_return &dialectF;
    auto fifth = prober.ask({{offset, id::logRequest, 5}, {at(id::voltageLog, offset)}});
    const auto own = co_await std::move(fifth);
    co_return own ? &dialectD : nullptr;
}

/// The legacy logs come where no other dialect answers.
Task<const Dialect *> tellLegacy(Prober &prober, int offset)
{
    auto second = prober.ask({{offset, id::logRequest, 2}, {at(id::currentLogLegacy, offset)}});
    const auto current = co_await std::move(second);
    if (!current)
        co_return nullptr;
    auto zeroth = prober.ask({{offset, id::logRequest, 0}, {at(id::positionLogLegacy, offset)}});
    const auto position = co_await std::move(zeroth);
    co_return position ? &dialectL : nullptr;
}

/// A drive whose dialect is not proven is one all the same when it answers for itself, twice.
Task<std::optional<Found>> tellPresent(Prober &prober, int offset, std::uint32_t answer)
{
    const auto code = static_cast<std::uint8_t>(dialectF.codeOf(Log::Velocity));
    for (int i = 0; i < 2; ++i) {
        auto asking = prober.ask({{offset, id::logRequest, code}, {answer}});
        const auto speed = co_await std::move(asking);
        if (!speed)
            co_return std::optional<Found>();
    }
    co_return Found{offset, nullptr};
}

} // namespace

/// README.md#offsets: an identifier in 1024…1099 is today's with one offset or legacy with another.
Task<std::optional<Found>> identifyDrive(Prober &prober, std::uint32_t answer)
{
    const int today = static_cast<int>(answer) - static_cast<int>(id::velocityLog);
    const int legacy = static_cast<int>(answer) - static_cast<int>(id::velocityLogLegacy);
    const bool mayBeLegacy = legacy >= 0 && legacy <= maxOffset;
    if (today >= 0) {
        auto asking = tellNew(prober, today, mayBeLegacy ? 2 : probeTries);
        if (const Dialect *dialect = co_await std::move(asking))
            co_return Found{today, dialect};
    }
    if (mayBeLegacy) {
        if (const Dialect *dialect = co_await tellLegacy(prober, legacy); dialect)
            co_return Found{legacy, dialect};
    }
    if (today >= 0 && mayBeLegacy)
        co_return std::nullopt; // it cannot even be said which offset it has
    auto asking = tellPresent(prober, mayBeLegacy ? legacy : today, answer);
    co_return co_await std::move(asking);
}

/// Drives older than the broadcast are asked one by one.
Task<std::vector<int>> findOldest(CanLink &link, Clock &clock, std::optional<std::set<int>> expected)
{
    std::set<int> offsets;
    const Subscription received = link.received().add([&offsets](const CanFrame &frame) {
        const int offset = static_cast<int>(frame.id) - static_cast<int>(id::positionLogLegacy);
        if (!frame.extended && frame.size == 4 && offset >= 0 && offset <= maxOffset)
            offsets.insert(offset);
    });
    const Duration spacing = std::max<Duration>(1ms, 4 * roundTrip(link)); // others' frames do not wait behind a burst
    for (int offset = 0; offset <= maxOffset; ++offset) {
        if (expected && offset > 0 && !expected->contains(offset))
            continue;
        co_await link.send(encodeLogRequest(dialectLL, offset, Log::Position));
        co_await Sleep(clock, spacing);
    }
    co_await Sleep(clock, answerTime(link));
    co_return std::vector<int>(offsets.begin(), offsets.end());
}

} // namespace mb::abstractdc
