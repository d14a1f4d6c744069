// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/scan.h"

#include "async/sleep.h"
#include "families/abstractdc/answertime.h"
#include "families/abstractdc/codec.h"
#include "families/abstractdc/protocol.h"
#include "families/abstractdc/scanprobe.h"

#include <QtGlobal>

#include <algorithm>
#include <optional>
#include <set>

namespace mb::abstractdc {
namespace {

using namespace std::chrono_literals;

constexpr Duration broadcastSlack = 50ms;
constexpr int broadcasts = 2;
constexpr Duration sweepMost = 60ms; ///< what asking 99 old drives one by one may take
constexpr int closerLooks = 3;

} // namespace

Identity identityOf(int offset, const Dialect *dialect)
{
    Identity identity;
    identity.family = "abstractdc";
    identity.address = offset;
    if (!dialect) {
        identity.detail = say("It answers, but not as any known dialect; it can be watched but not driven.");
        return identity;
    }
    identity.dialect = dialect->key;
    if (dialect == &dialectF)
        identity.detail = say("Speaks the firmware's codes, not the document's.");
    else if (dialect == &dialectL)
        identity.detail = say("Speaks the legacy frames of 8 bytes, as the published master does.");
    else if (dialect == &dialectLL)
        identity.detail = say("So old that nothing but its power stops it; it can be watched but not driven.");
    else
        identity.detail = say("Speaks the document's codes, which no published firmware does.");
    return identity;
}

namespace {

/// How several drives with one offset show.
enum class Sharing { None, Answered, Destroyed };

Identity duplicateOf(const Found &found, Sharing sharing)
{
    Identity identity = identityOf(found.offset, found.dialect);
    identity.state = DeviceState::Duplicate;
    identity.detail = sharing == Sharing::Answered
        ? say("Several drives answer with offset %1; offsets are compiled into the firmware, so give one of them "
              "another and flash it.",
            found.offset)
        : say("Answers with offset %1 are destroyed on the bus, as where several drives have it and answer at once; "
              "offsets are compiled into the firmware, so give one of them another and flash it.",
            found.offset);
    return identity;
}

class Round {
public:
    Round(CanLink &link, Clock &clock, ScanSink &sink)
        : m_link(link)
        , m_clock(clock)
        , m_sink(sink)
        , m_questions(link, clock)
        , m_census(link, m_questions)
        , m_prober(link, clock, m_questions)
    {
        for (const Identity &identity : sink.known())
            m_known.emplace_back(identity.address, dialectByKey(identity.dialect));
    }

    /// Everybody who answers a broadcast, each judged once.
    Task<void> askAll()
    {
        m_tried.clear();
        const Duration answers = std::max(answerTime(m_link), 2 * roundTrip(m_link) + broadcastSlack);
        const Instant end = m_clock.now() + answers;
        co_await m_link.send(encodeLogRequest(dialectF, 0, Log::Velocity));
        while (m_clock.now() < end) {
            co_await Sleep(
                m_clock, std::min<Duration>(std::max<Duration>(roundTrip(m_link), 2ms), end - m_clock.now()));
            co_await identifyNew();
        }
        co_return {};
    }
    Task<void> askOldest()
    {
        std::set<int> expected;
        for (const Identity &identity : m_sink.remembered())
            expected.insert(identity.address);
        const bool all = m_sink.extent() == ScanExtent::Everything || roundTrip(m_link) * maxOffset <= sweepMost;
        if (!all)
            m_sink.leftOut(say("Abstract DC Drives so old that they answer no broadcast (dialect LL) are found at this "
                               "bit rate only by their number, or by %1",
                "motorbenchctl scan --everything"));
        auto looking = findOldest(m_link, m_clock, all ? std::nullopt : std::optional(std::move(expected)));
        const std::vector<int> offsets = co_await std::move(looking);
        for (const int offset : offsets) {
            // A legacy drive that somebody else asks at this moment answers there too: only this one answers 800.
            if (m_offsets.count(offset) > 0)
                continue;
            auto asking = m_prober.ask({{offset, id::logRequestOld, 1}, {at(id::velocityLogLegacy, offset)}});
            const auto answer = co_await std::move(asking);
            if (answer && m_offsets.insert(offset).second)
                m_sink.found(identityOf(offset, &dialectLL));
        }
        co_return {};
    }
    /// Two answers to one question, or none that stays whole: now that all questions of this scan are over.
    Task<void> tellTwins()
    {
        for (const Judged &one : m_judged) {
            Sharing sharing = m_census.isTwice(one.answer, one.found.offset) ? Sharing::Answered : Sharing::None;
            if (sharing == Sharing::None && isDoubtful(one)) {
                sharing = co_await lookCloser(one.found.offset);
            }
            if (sharing == Sharing::None)
                continue;
            m_offsets.insert(one.found.offset);
            m_sink.found(duplicateOf(one.found, sharing));
        }
        co_return {};
    }
    [[nodiscard]] std::size_t count() const { return m_offsets.size(); }

private:
    Task<void> identifyNew()
    {
        const std::set<std::uint32_t> seen = m_census.velocityIds();
        for (const std::uint32_t answer : seen) {
            if (m_identified.count(answer) > 0 || !m_tried.insert(answer).second)
                continue;
            auto identifying = identifyDrive(m_prober, answer);
            const std::uint64_t errors = m_link.health().protocolErrors;
            const std::optional<Found> found = co_await std::move(identifying);
            const bool hadErrors = m_link.health().protocolErrors > errors;
            const int today = static_cast<int>(answer) - static_cast<int>(id::velocityLog);
            if (!found && hadErrors && today >= 0)
                judged({answer, {today, nullptr}, true});
            if (!found || (!found->dialect && (m_offsets.count(found->offset) > 0 || isPositionOfLegacy(answer))))
                continue;
            m_offsets.insert(found->offset);
            judged({answer, *found, hadErrors});
            if (!found->dialect) { // answers may have been lost: another round tries again
                m_sink.found(identityOf(found->offset, nullptr));
                continue;
            }
            m_identified.insert(answer);
            m_known.emplace_back(found->offset, found->dialect);
            m_sink.found(identityOf(found->offset, found->dialect));
        }
        co_return {};
    }

    /// Identifiers of velocity logs reach into those of legacy position logs, which somebody may be asking for meanwhile.
    [[nodiscard]] bool isPositionOfLegacy(std::uint32_t answer) const
    {
        const auto offset = static_cast<int>(answer) - static_cast<int>(id::positionLogLegacy);
        return std::ranges::find(m_known, std::pair(offset, &dialectL)) != m_known.end();
    }

    struct Judged {
        std::uint32_t answer = 0;
        Found found;
        bool hadErrors = false; ///< on the bus, while it was asked
    };
    /// The latest of each that answers.
    void judged(const Judged &one)
    {
        std::erase_if(m_judged, [&one](const Judged &before) { return before.answer == one.answer; });
        m_judged.push_back(one);
    }
    [[nodiscard]] bool isDoubtful(const Judged &one) const
    {
        const Census::Balance &told = m_census.temperatures(one.found.offset);
        return (one.found.dialect == &dialectF || !one.found.dialect) && (one.hadErrors || told.answered > told.asked);
    }
    /// Asked for its temperature again, and again: one time may be chance.
    Task<Sharing> lookCloser(int offset)
    {
        int doubled = 0;
        int destroyed = 0;
        for (int i = 0; i < closerLooks; ++i) {
            const Census::Balance before = m_census.temperatures(offset);
            const std::uint64_t errors = m_link.health().protocolErrors;
            const auto code = static_cast<std::uint8_t>(dialectF.codeOf(Log::Temperature));
            auto asking = m_prober.ask({{offset, id::logRequest, code}, {at(id::temperatureLog, offset)}}, 1);
            (void)co_await std::move(asking);
            co_await Sleep(m_clock, 2 * roundTrip(m_link)); // the second answer
            const Census::Balance &after = m_census.temperatures(offset);
            const int answered = after.answered - before.answered;
            doubled += answered > after.asked - before.asked ? 1 : 0;
            destroyed += answered == 0 && m_link.health().protocolErrors > errors ? 1 : 0;
        }
        if (doubled > 1)
            co_return Sharing::Answered;
        co_return destroyed == closerLooks ? Sharing::Destroyed : Sharing::None;
    }

    CanLink &m_link;
    Clock &m_clock;
    ScanSink &m_sink;
    QuestionWatch m_questions;
    Census m_census;
    Prober m_prober;
    std::vector<std::pair<int, const Dialect *>> m_known; ///< offsets in the list or found now
    std::set<std::uint32_t> m_identified;
    std::set<std::uint32_t> m_tried; ///< in this round
    std::set<int> m_offsets;
    std::vector<Judged> m_judged;
};

} // namespace

Task<void> scan(Link &link, Clock &clock, ScanSink &sink)
{
    auto *const can = dynamic_cast<CanLink *>(&link);
    if (!can)
        co_return fail(Fault::Unsupported, say("Abstract DC Drives are found on CAN links only"));
    Round round(*can, clock, sink);
    for (int i = 0; i < broadcasts; ++i) {
        sink.progress(say("Looking for Abstract DC Drives"), i, broadcasts);
        co_await round.askAll();
    }
    co_await round.askOldest();
    co_await round.tellTwins();
    sink.progress(say("Abstract DC Drives found: %1", round.count()), broadcasts, broadcasts);
    if (can->state() != LinkState::Open)
        co_return fail(Fault::LinkLost, say("%1: %2", can->address().shortName(), can->loss().message()));
    co_return {};
}

} // namespace mb::abstractdc
