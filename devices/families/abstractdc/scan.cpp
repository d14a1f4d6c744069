// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/scan.h"

#include "async/sleep.h"
#include "families/abstractdc/answertime.h"
#include "families/abstractdc/codec.h"
#include "families/abstractdc/scanprobe.h"

#include <QtGlobal>

#include <algorithm>
#include <set>

namespace mb::abstractdc {
namespace {

using namespace std::chrono_literals;

constexpr Duration broadcastSlack = 50ms;
constexpr int broadcasts = 2;

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
        if (auto sent = m_link.send(encodeLogRequest(dialectF, 0, Log::Velocity)); !sent)
            co_return fail(sent.error());
        while (m_clock.now() < end) {
            co_await Sleep(
                m_clock, std::min<Duration>(std::max<Duration>(roundTrip(m_link), 2ms), end - m_clock.now()));
            auto identifying = identifyNew();
            co_await std::move(identifying);
        }
        co_return {};
    }
    Task<void> askOldest()
    {
        std::set<int> expected;
        for (const Identity &identity : m_sink.remembered())
            expected.insert(identity.address);
        auto looking = findOldest(m_link, m_clock, std::move(expected));
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
    /// Two answers to one question: now that all questions of this scan are over.
    void tellTwins()
    {
        for (const auto &[answer, found] : m_found) {
            if (!m_census.isTwice(answer, found.offset))
                continue;
            Identity identity = identityOf(found.offset, found.dialect);
            identity.state = DeviceState::Duplicate;
            identity.detail = say("Several drives answer with offset %1; offsets are compiled into the firmware, so "
                                  "give one of them another and flash it.",
                found.offset);
            m_sink.found(identity);
        }
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
            const std::optional<Found> found = co_await std::move(identifying);
            if (!found || (!found->dialect && (m_offsets.count(found->offset) > 0 || isPositionOfLegacy(answer))))
                continue;
            m_offsets.insert(found->offset);
            if (!found->dialect) { // answers may have been lost: another round tries again
                m_sink.found(identityOf(found->offset, nullptr));
                continue;
            }
            m_identified.insert(answer);
            m_known.emplace_back(found->offset, found->dialect);
            m_found.emplace_back(answer, *found);
            m_sink.found(identityOf(found->offset, found->dialect));
        }
        co_return {};
    }

    /// Identifiers of velocity logs reach into those of legacy position logs, which somebody may be asking for meanwhile.
    [[nodiscard]] bool isPositionOfLegacy(std::uint32_t answer) const
    {
        const auto offset = static_cast<int>(answer) - static_cast<int>(id::positionLogLegacy);
        return std::find(m_known.begin(), m_known.end(), std::pair(offset, &dialectL)) != m_known.end();
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
    std::vector<std::pair<std::uint32_t, Found>> m_found;
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
        auto asking = round.askAll();
        co_await std::move(asking);
    }
    auto oldest = round.askOldest();
    co_await std::move(oldest);
    round.tellTwins();
    sink.progress(say("Abstract DC Drives found: %1", round.count()), broadcasts, broadcasts);
    if (can->state() != LinkState::Open)
        co_return fail(Fault::LinkLost, say("%1: %2", can->address().shortName(), can->loss().message()));
    co_return {};
}

} // namespace mb::abstractdc
