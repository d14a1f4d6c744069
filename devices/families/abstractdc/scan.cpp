// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/scan.h"

#include "async/sleep.h"
#include "families/abstractdc/codec.h"
#include "families/abstractdc/voltagewatch.h"
#include "transport/caninbox.h"

#include <algorithm>
#include <set>

namespace mb::abstractdc {
namespace {

using namespace std::chrono_literals;

constexpr Duration broadcastSlack = 50ms;
constexpr int broadcasts = 2;
constexpr int tries = 3;
constexpr Duration sweepMost = 60ms; ///< what asking 99 old drives one by one may take

/// Identifiers of speed logs that came, and how often each was asked for and answered: two answers to one question are two
/// drives with one offset (trap 12).
class Census {
public:
    explicit Census(CanLink &link)
        : m_traffic(link.traffic().add([this](const Traffic &traffic) {
            if (traffic.can)
                pass(*traffic.can);
        }))
    {
    }
    [[nodiscard]] const std::set<std::uint32_t> &velocityIds() const { return m_velocity; }
    /// Answers to questions for the speed beyond one each.
    [[nodiscard]] bool isTwice(std::uint32_t answer, int offset) const
    {
        const int asked = m_broadcasts + m_asked.at(static_cast<std::size_t>(offset));
        return std::count(m_answers.begin(), m_answers.end(), answer)
            > asked + 1; // one question may be older than we are
    }

private:
    void pass(const CanFrame &frame)
    {
        if (frame.extended || frame.remote || frame.error)
            return;
        const bool request = frame.size == 1 && frame.data[0] == dialectF.codeOf(Log::Velocity);
        // Somebody asks a legacy drive for its position: that answer looks like the speed of another drive.
        if (frame.size == 1 && frame.id >= id::logRequest && frame.id <= id::logRequest + maxOffset
            && frame.data[0] == dialectL.codeOf(Log::Position))
            m_explained.insert(frame.id - id::logRequest + id::positionLogLegacy);
        if (request && frame.id == id::logRequest) {
            ++m_broadcasts;
        } else if (request && frame.id > id::logRequest && frame.id <= id::logRequest + maxOffset) {
            ++m_asked.at(frame.id - id::logRequest);
        } else if (frame.size == 4 && frame.id >= id::velocityLogLegacy && frame.id <= id::velocityLog + maxOffset
            && m_explained.count(frame.id) == 0) {
            m_velocity.insert(frame.id);
            m_answers.push_back(frame.id);
        }
    }

    std::set<std::uint32_t> m_velocity;
    std::set<std::uint32_t> m_explained;
    std::vector<std::uint32_t> m_answers;
    int m_broadcasts = 0;
    std::array<int, maxOffset + 1> m_asked{};
    Subscription m_traffic;
};

/// One drive asked for one log, as a code; yields the identifier that the answer came on, Timeout when none came.
struct Question {
    int offset = 0;
    std::uint32_t base = id::logRequest;
    std::uint8_t code = 0;
    std::vector<std::uint32_t> answers; ///< where one may come
};

class Prober {
public:
    Prober(CanLink &link, Clock &clock)
        : m_link(link)
        , m_clock(clock)
        , m_voltage(link, clock)
    {
    }

    /// Nothing when no answer came to any try. Of a voltage log without offset only an answer to this question counts.
    Task<std::optional<std::uint32_t>> ask(Question question, int most = tries)
    {
        const std::uint32_t shared = id::voltageLog;
        CanInbox::Match match = [this, question, shared](const CanFrame &frame) {
            const bool expected
                = std::find(question.answers.begin(), question.answers.end(), frame.id) != question.answers.end();
            return !frame.extended && frame.size == 4 && expected
                && (frame.id != shared || m_voltage.owner() == question.offset || question.code != codeOfVoltage());
        };
        CanInbox inbox(m_link, m_clock, std::move(match));
        const std::array data{question.code};
        const CanFrame request = standardFrame(question.base + static_cast<std::uint32_t>(question.offset), data);
        for (int attempt = 0; attempt < most; ++attempt) {
            while (question.code == codeOfVoltage() && !m_voltage.isFree())
                co_await Sleep(m_clock, roundTrip(m_link));
            if (auto sent = m_link.send(request); !sent)
                co_return fail(sent.error());
            const Result<CanFrame> answer = co_await inbox.next(answerTime(m_link));
            if (answer)
                co_return std::optional<std::uint32_t>(answer->id);
            if (answer.error().fault == Fault::LinkLost)
                co_return fail(answer.error());
        }
        co_return std::optional<std::uint32_t>();
    }

private:
    static constexpr std::uint8_t codeOfVoltage() { return 4; }

    CanLink &m_link;
    Clock &m_clock;
    VoltageWatch m_voltage;
};

std::uint32_t at(std::uint32_t base, int offset)
{
    return base + static_cast<std::uint32_t>(offset);
}

/// 6.3: decides on 03, confirms with 04; D and F answer both elsewhere.
Task<const Dialect *> tellNew(Prober &prober, int offset, int most)
{
    auto third
        = prober.ask({offset, id::logRequest, 3, {at(id::temperatureLog, offset), at(id::currentLog, offset)}}, most);
    const auto answer = co_await std::move(third);
    if (!answer)
        co_return nullptr;
    const bool today = *answer == at(id::temperatureLog, offset);
    const std::uint32_t proof = today ? id::voltageLog : at(id::positionLog, offset);
    const std::uint32_t doubt = today ? at(id::positionLog, offset) : id::voltageLog;
    auto fourth = prober.ask({offset, id::logRequest, 4, {proof, doubt}});
    const auto confirmed = co_await std::move(fourth);
    if (!confirmed || *confirmed != proof)
        co_return nullptr;
    co_return today ? &dialectF : &dialectD;
}

/// The legacy logs come where no other dialect answers.
Task<const Dialect *> tellLegacy(Prober &prober, int offset)
{
    auto second = prober.ask({offset, id::logRequest, 2, {at(id::currentLogLegacy, offset)}});
    const auto current = co_await std::move(second);
    if (!current)
        co_return nullptr;
    auto zeroth = prober.ask({offset, id::logRequest, 0, {at(id::positionLogLegacy, offset)}});
    const auto position = co_await std::move(zeroth);
    co_return position ? &dialectL : nullptr;
}

struct Found {
    int offset = 0;
    const Dialect *dialect = nullptr;
};

/// 6.3: an identifier in 1024…1099 is today's with one offset or legacy with another.
Task<std::optional<Found>> judge(Prober &prober, std::uint32_t answer)
{
    const int today = static_cast<int>(answer) - static_cast<int>(id::velocityLog);
    const int legacy = static_cast<int>(answer) - static_cast<int>(id::velocityLogLegacy);
    const bool mayBeLegacy = legacy >= 0 && legacy <= maxOffset;
    if (today >= 0) {
        auto asking = tellNew(prober, today, mayBeLegacy ? 2 : tries);
        if (const Dialect *dialect = co_await std::move(asking))
            co_return Found{today, dialect};
    }
    if (mayBeLegacy) {
        auto asking = tellLegacy(prober, legacy);
        if (const Dialect *dialect = co_await std::move(asking))
            co_return Found{legacy, dialect};
    }
    if (today < 0 && mayBeLegacy)
        co_return Found{legacy, nullptr};
    if (today >= 0 && !mayBeLegacy)
        co_return Found{today, nullptr};
    co_return std::nullopt; // it cannot even be said which offset it has
}

/// Drives older than the broadcast are asked one by one, where the bit rate allows it.
Task<std::vector<int>> findOldest(CanLink &link, Clock &clock)
{
    std::set<int> offsets;
    const Subscription received = link.received().add([&offsets](const CanFrame &frame) {
        const int offset = static_cast<int>(frame.id) - static_cast<int>(id::positionLogLegacy);
        if (!frame.extended && frame.size == 4 && offset >= 0 && offset <= maxOffset)
            offsets.insert(offset);
    });
    const bool all = roundTrip(link) * maxOffset <= sweepMost;
    for (int offset = 0; offset <= (all ? maxOffset : 0); ++offset) {
        if (auto sent = link.send(encodeLogRequest(dialectLL, offset, Log::Position)); !sent)
            co_return fail(sent.error());
    }
    const Duration wait = answerTime(link) + (all ? roundTrip(link) * maxOffset : Duration::zero());
    co_await Sleep(clock, wait);
    co_return std::vector<int>(offsets.begin(), offsets.end());
}

} // namespace

Identity identityOf(int offset, const Dialect *dialect)
{
    Identity identity;
    identity.family = "abstractdc";
    identity.address = offset;
    if (!dialect) {
        identity.detail = "It answers, but not as any known dialect; it can be watched but not driven.";
        return identity;
    }
    identity.dialect = dialect->key;
    if (dialect == &dialectF)
        identity.detail = "Speaks the firmware's codes, not the document's.";
    else if (dialect == &dialectL)
        identity.detail = "Speaks the legacy frames of 8 bytes, as the published master does.";
    else if (dialect == &dialectLL)
        identity.detail = "So old that nothing but its power stops it; it can be watched but not driven.";
    else
        identity.detail = "Speaks the document's codes, which no published firmware does.";
    return identity;
}

namespace {

class Round {
public:
    Round(CanLink &link, Clock &clock, ScanSink &sink)
        : m_link(link)
        , m_clock(clock)
        , m_sink(sink)
        , m_census(link)
        , m_prober(link, clock)
    {
    }

    /// Everybody who answers a broadcast, each judged once.
    Task<void> askAll()
    {
        m_tried.clear();
        const Instant end = m_clock.now() + answerTime(m_link) - answerSlack + broadcastSlack;
        if (auto sent = m_link.send(encodeLogRequest(dialectF, 0, Log::Velocity)); !sent)
            co_return fail(sent.error());
        while (m_clock.now() < end) {
            co_await Sleep(
                m_clock, std::min<Duration>(std::max<Duration>(roundTrip(m_link), 2ms), end - m_clock.now()));
            auto judging = judgeNew();
            co_await std::move(judging);
        }
        co_return {};
    }
    Task<void> askOldest()
    {
        auto looking = findOldest(m_link, m_clock);
        const std::vector<int> offsets = co_await std::move(looking);
        for (const int offset : offsets) {
            // A legacy drive that somebody else asks at this moment answers there too: only this one answers 800.
            auto asking = m_prober.ask({offset, id::logRequestOld, 1, {at(id::velocityLogLegacy, offset)}});
            const auto answer = co_await std::move(asking);
            if (answer && m_offsets.insert(offset).second)
                m_sink.found(identityOf(offset, &dialectLL));
        }
        co_return {};
    }
    /// Two answers to one question: now that all questions of this scan are over.
    void tellTwins()
    {
        for (const auto &[answer, found] : m_found) {
            if (!m_census.isTwice(answer, found.offset))
                continue;
            Identity identity = identityOf(found.offset, found.dialect);
            identity.state = DeviceState::Duplicate;
            identity.detail = "Several drives answer with offset " + std::to_string(found.offset)
                + "; offsets are compiled into the firmware, so give one of them another and flash it.";
            m_sink.found(identity);
        }
    }
    [[nodiscard]] std::size_t count() const { return m_offsets.size(); }

private:
    Task<void> judgeNew()
    {
        const std::set<std::uint32_t> seen = m_census.velocityIds();
        for (const std::uint32_t answer : seen) {
            if (m_judged.count(answer) > 0 || !m_tried.insert(answer).second)
                continue;
            auto judging = judge(m_prober, answer);
            const std::optional<Found> found = co_await std::move(judging);
            if (!found || (!found->dialect && m_offsets.count(found->offset) > 0))
                continue;
            m_offsets.insert(found->offset);
            if (!found->dialect) { // answers may have been lost: another round tries again
                m_sink.found(identityOf(found->offset, nullptr));
                continue;
            }
            m_judged.insert(answer);
            m_found.emplace_back(answer, *found);
            m_sink.found(identityOf(found->offset, found->dialect));
        }
        co_return {};
    }

    CanLink &m_link;
    Clock &m_clock;
    ScanSink &m_sink;
    Census m_census;
    Prober m_prober;
    std::set<std::uint32_t> m_judged;
    std::set<std::uint32_t> m_tried; ///< in this round
    std::set<int> m_offsets;
    std::vector<std::pair<std::uint32_t, Found>> m_found;
};

} // namespace

Task<void> scan(Link &link, Clock &clock, ScanSink &sink)
{
    auto *const can = dynamic_cast<CanLink *>(&link);
    if (!can)
        co_return fail(Fault::Unsupported, "Abstract DC Drives are found on CAN links only");
    Round round(*can, clock, sink);
    for (int i = 0; i < broadcasts; ++i) {
        sink.progress("Looking for Abstract DC Drives", i, broadcasts);
        auto asking = round.askAll();
        co_await std::move(asking);
    }
    auto oldest = round.askOldest();
    co_await std::move(oldest);
    round.tellTwins();
    sink.progress("Abstract DC Drives found: " + std::to_string(round.count()), broadcasts, broadcasts);
    if (can->state() != LinkState::Open)
        co_return fail(Fault::LinkLost, can->address().shortName() + ": " + can->reason());
    co_return {};
}

} // namespace mb::abstractdc
