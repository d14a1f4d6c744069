// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/supermodified/scan.h"

#include "families/supermodified/interview.h"

#include <algorithm>
#include <set>

namespace mb::supermodified {
namespace {

using namespace std::chrono_literals;

constexpr int firstUsual = 4; ///< where vendors leave their units
constexpr int lastUsual = 15;
constexpr Duration shortestSilence = 8ms;
constexpr int silenceRoundTrips = 4;
constexpr int attemptsForOne = 4;
constexpr int attemptsForOther = 3; ///< one lost answer would leave a follower unknown

/// One scan: what was asked and what answered.
class Search {
public:
    Search(std::shared_ptr<Line> line, ScanSink &sink)
        : m_line(std::move(line))
        , m_sink(sink)
        , m_unsolicited(m_line->unsolicited().add([this](const Frame &frame) { heardLate(frame); }))
    {
    }

    [[nodiscard]] Task<void> run();
    [[nodiscard]] Task<void> runFor(int address);

private:
    using Place = std::pair<int, int>; ///< rate and id

    [[nodiscard]] std::vector<int> rates() const;
    void recall();
    [[nodiscard]] std::vector<Place> knownAt(const std::vector<int> &rates) const;
    void plan(int rate, int first, int last, std::vector<Place> &out) const;
    [[nodiscard]] bool isDone(const Place &place) const;
    [[nodiscard]] Task<bool> look(Place place, Duration patience);
    [[nodiscard]] Task<void> learnOthers(int address);
    [[nodiscard]] Task<bool> learnMask(Node node);
    [[nodiscard]] Line::Request asking(const Node &node, Command command) const;
    [[nodiscard]] Task<void> lookAll(std::vector<Place> places, bool patiently = false);
    void heardLate(const Frame &frame);
    [[nodiscard]] Task<void> lookAtLate();
    [[nodiscard]] Task<void> lookAtRest(std::vector<int> rates);
    [[nodiscard]] Task<void> lookEverywhere();
    [[nodiscard]] Task<void> askSilent(std::vector<Place> known);
    void forgetSilent();
    void keepFoundRates(std::vector<int> &rates) const;
    [[nodiscard]] Duration silence() const;
    void report(const Message &what, int done, int total) const;

    std::shared_ptr<Line> m_line;
    ScanSink &m_sink;
    std::vector<Place> m_asked;
    std::vector<int> m_found;    ///< ids
    std::vector<int> m_recalled; ///< ids that only the memory of an earlier run knew
    std::vector<Place> m_late;   ///< somebody there answered when its question had been given up
    Subscription m_unsolicited;
};

std::vector<int> Search::rates() const
{
    const SerialLink &link = m_line->link();
    if (const auto fixed = link.fixedBaudrate())
        return {*fixed};
    if (m_line->driven().any())
        return {link.baudrate()};
    return {searchRates.begin(), searchRates.end()};
}

bool Search::isDone(const Place &place) const
{
    return std::ranges::find(m_asked, place) != m_asked.end()
        || std::ranges::find(m_found, place.second) != m_found.end();
}

/// Nodes of an earlier run: where to ask first, and which ids the host must not have (README.md#masks).
void Search::recall()
{
    for (const Identity &identity : m_sink.remembered()) {
        const Node node = nodeOf(identity, m_line->link());
        const bool legal = node.id >= lowestNode && node.id <= highestNode && node.baudrate >= slowestRate
            && node.baudrate <= realRate(fastestRate);
        if (!legal || m_line->roster().nodes().contains(node.id))
            continue;
        m_line->roster().note(node.id, node.baudrate);
        if (const auto mask = maskOf(identity))
            m_line->roster().noteMask(node.id, *mask);
        m_recalled.push_back(node.id);
    }
}

void Search::forgetSilent()
{
    for (const int id : m_recalled) {
        if (std::ranges::find(m_found, id) == m_found.end())
            m_line->roster().forget(id);
    }
    m_recalled.clear();
}

/// A node that is gone leaves neither its id nor its mask to others; one that missed a question is not taken for gone.
Task<void> Search::askSilent(std::vector<Place> known)
{
    for (const Place &place : known) {
        const bool recalled = std::ranges::find(m_recalled, place.second) != m_recalled.end();
        const auto isThere = [&] { return std::ranges::find(m_found, place.second) != m_found.end(); };
        for (int attempt = 1; attempt < attemptsForOne && !recalled && !isThere(); ++attempt)
            co_await look(place, std::min<Duration>(answerTime * (1 << attempt), AnswerTime::ceiling));
        if (!isThere() && !m_line->driven().any())
            m_line->roster().forget(place.second);
    }
    co_return {};
}

std::vector<Search::Place> Search::knownAt(const std::vector<int> &rates) const
{
    std::vector<Place> known;
    const bool anyRate = !m_line->link().fixedBaudrate() && !m_line->driven().any();
    for (const auto &[id, node] : m_line->roster().nodes()) {
        if (anyRate || std::ranges::find(rates, node.baudrate) != rates.end())
            known.emplace_back(node.baudrate, id);
    }
    return known;
}

void Search::plan(int rate, int first, int last, std::vector<Place> &out) const
{
    for (int id = first; id <= last; ++id) {
        const Place place{rate, id};
        if (!isDone(place) && std::ranges::find(out, place) == out.end())
            out.push_back(place);
    }
}

Duration Search::silence() const
{
    const auto roundTrip = m_line->link().roundTrip();
    if (m_found.empty() || !roundTrip)
        return answerTime;
    return std::clamp<Duration>(*roundTrip * silenceRoundTrips, shortestSilence, answerTime);
}

/// A node with the host's own id can be asked under another one only.
Line::Request Search::asking(const Node &node, Command command) const
{
    Line::Request request = supermodified::asking(node, command);
    if (node.id == m_line->roster().hostId())
        request.frame.from = static_cast<std::uint8_t>(node.id == highestNode ? lowestNode : node.id + 1);
    return request;
}

/// Any frame from the node counts, an error frame too: it is there and has something to tell.
Task<bool> Search::look(Place place, Duration patience)
{
    m_asked.push_back(place);
    const Node node{place.second, place.first, std::nullopt};
    Line::Request request = asking(node, Command::GetPosition);
    request.patience = patience;
    const Result<Frame> reply = co_await ask(*m_line, request).attempt();
    if (!reply && reply.error().fault != Fault::Timeout)
        co_return fail(reply.error());
    if (!reply)
        co_return false;
    m_line->roster().note(node.id, node.baudrate);
    const Result<Interview> said = co_await interview(*m_line, node).attempt();
    if (!said && said.error().fault == Fault::LinkLost)
        co_return fail(said.error());
    if (!said)
        m_line->roster().noteUnreadMask(node.id);
    m_found.push_back(node.id);
    m_sink.found(identityOf(m_line->roster(), node, said.value_or(Interview{})));
    co_return true;
}

void Search::report(const Message &what, int done, int total) const
{
    m_sink.progress(what, done, total);
}

Task<void> Search::lookAll(std::vector<Place> places, bool patiently)
{
    const int total = static_cast<int>(places.size());
    int done = 0;
    for (const Place &place : places) {
        report(say("Looking for Supermodified nodes at %1 bit/s", place.first), done++, total);
        if (isDone(place))
            continue;
        auto looking = look(place, patiently ? answerTime : silence());
        co_await std::move(looking);
    }
    co_await lookAtLate();
    co_return {};
}

/// A busy computer answers late, and is late itself: who was asked in vain and is heard now may be there after all.
void Search::heardLate(const Frame &frame)
{
    const Place place{m_line->link().baudrate(), frame.from};
    const bool asked = std::ranges::find(m_asked, place) != m_asked.end();
    const bool found = std::ranges::find(m_found, place.second) != m_found.end();
    if (asked && !found && std::ranges::find(m_late, place) == m_late.end())
        m_late.push_back(place);
}

/// It counts as found by the answer to a question of its own only.
Task<void> Search::lookAtLate()
{
    for (int attempt = 0; attempt < attemptsForOne; ++attempt) {
        for (const Place &place : std::exchange(m_late, {})) {
            if (std::ranges::find(m_found, place.second) != m_found.end())
                continue;
            co_await look(place, AnswerTime::ceiling);
        }
    }
    co_return {};
}

Task<void> Search::run()
{
    recall();
    std::vector<int> searched = rates();
    const std::vector<Place> known = knownAt(searched);
    co_await lookAll(known, true);
    co_await askSilent(known);
    forgetSilent();
    const bool allThere = !known.empty() && m_found.size() == known.size();
    if (allThere)
        keepFoundRates(searched);
    std::vector<Place> usual;
    for (const int rate : searched) {
        // a node with the host's id would take the answers of others for questions, so it is looked for first
        plan(rate, usualHostId, usualHostId, usual);
        plan(rate, firstUsual, lastUsual, usual);
    }
    co_await lookAll(std::move(usual));
    if (!m_found.empty())
        keepFoundRates(searched);
    if (!allThere || m_sink.extent() != ScanExtent::Quick)
        co_await lookAtRest(searched);
    if (m_sink.extent() == ScanExtent::Everything)
        co_await lookEverywhere();
    report(say("Supermodified found: %1", m_found.size()), 1, 1);
    co_return {};
}

/// All ids at these rates.
Task<void> Search::lookAtRest(std::vector<int> rates)
{
    std::vector<Place> rest;
    for (const int rate : rates)
        plan(rate, lowestNode, highestNode, rest);
    co_await lookAll(std::move(rest));
    co_return {};
}

/// What was left out: other rates than those where somebody answered, and those that are never usual.
Task<void> Search::lookEverywhere()
{
    std::vector<int> all = rates();
    if (!m_line->link().fixedBaudrate() && !m_line->driven().any())
        all.insert(all.end(), rareRates.begin(), rareRates.end());
    for (const int rate : all) {
        auto looking = lookAtRest({rate});
        const Result<void> looked = co_await std::move(looking).attempt();
        const Fault fault = looked ? Fault::Timeout : looked.error().fault;
        if (fault == Fault::LinkLost || fault == Fault::Unsafe)
            co_return fail(looked.error());
        if (!looked) // an adapter need not have every rate
            report(say("The adapter has no %1 bit/s", rate), 1, 1);
    }
    co_return {};
}

/// Nodes of one line have one rate as a rule: two would take each other's bytes for errors.
void Search::keepFoundRates(std::vector<int> &rates) const
{
    std::vector<int> found;
    for (const int id : m_found) {
        const int rate = m_line->roster().entry(id).baudrate;
        if (std::ranges::find(found, rate) == found.end())
            found.push_back(rate);
    }
    rates = found;
}

Task<void> Search::runFor(int address)
{
    recall();
    std::vector<Place> places;
    if (m_line->roster().nodes().contains(address))
        places.emplace_back(m_line->roster().entry(address).baudrate, address);
    for (const int rate : rates())
        plan(rate, address, address, places);
    for (int attempt = 0; attempt < attemptsForOne && m_found.empty(); ++attempt) { // silence is asked again
        for (const Place &place : places) {
            if (attempt == 0 && address != usualHostId) { // as in run()
                auto learning = learnMask({usualHostId, place.first, std::nullopt});
                co_await std::move(learning);
            }
            const bool found
                = co_await look(place, std::min<Duration>(answerTime * (1 << attempt), AnswerTime::ceiling));
            if (found)
                break;
        }
    }
    if (!m_found.empty())
        co_await learnOthers(address);
    std::erase_if(m_recalled, [address](int id) { return id != address; }); // of the others nothing is known
    forgetSilent();
    co_return {};
}

/// Others may act on what is sent to this node (README.md#masks), so their masks are known before it is driven: those of the nodes that
/// are known, and of whoever may be where vendors leave theirs.
Task<void> Search::learnOthers(int address)
{
    const int rate = m_line->roster().entry(address).baudrate;
    std::set<int> others;
    for (const auto &[id, node] : m_line->roster().nodes()) {
        if (node.baudrate == rate)
            others.insert(id);
    }
    for (int id = firstUsual; id <= lastUsual; ++id)
        others.insert(id);
    others.erase(address);
    for (const int id : others) {
        auto learning = learnMask({id, rate, std::nullopt});
        const bool answered = co_await std::move(learning);
        if (!answered && m_line->roster().entry(id).nextId == address)
            m_line->roster().forget(id); // it was restarted, and is the one that was found
    }
    co_return {};
}

/// True where it answered. Silence is asked again, and longer where somebody is known to be.
Task<bool> Search::learnMask(Node node)
{
    Line::Request request = asking(node, Command::GetNodeMask);
    const bool isKnown = m_line->roster().nodes().contains(node.id)
        && std::ranges::find(m_recalled, node.id) == m_recalled.end(); // an earlier run's may be gone
    for (int attempt = 0; attempt < attemptsForOther; ++attempt) {
        request.patience = isKnown ? std::min<Duration>(answerTime * (1 << attempt), AnswerTime::ceiling) : silence();
        Result<Frame> reply = co_await ask(*m_line, request).attempt();
        if (reply && codesOf(*reply)) { // it is there, and had something to tell first
            reply = co_await ask(*m_line, request).attempt();
        }
        if (!reply && reply.error().fault == Fault::LinkLost)
            co_return fail(reply.error());
        if (!reply)
            continue;
        const auto mask = codesOf(*reply) ? std::nullopt : valueOf(reply->payload(), Format::U8);
        m_line->roster().note(node.id, node.baudrate);
        if (mask)
            m_line->roster().noteMask(node.id, static_cast<std::uint8_t>(*mask));
        else
            m_line->roster().noteUnreadMask(node.id);
        co_return true;
    }
    co_return false;
}

} // namespace

Task<void> scan(Link &link, Clock &clock, ScanSink &sink)
{
    auto *const serial = dynamic_cast<SerialLink *>(&link);
    if (!serial)
        co_return fail(Fault::Unsupported, say("Supermodified controllers are found on serial links only"));
    Search search(Line::of(*serial, clock), sink);
    co_await search.run();
    co_return {};
}

Task<void> probe(Link &link, Clock &clock, int address, ScanSink &sink)
{
    auto *const serial = dynamic_cast<SerialLink *>(&link);
    if (!serial)
        co_return fail(Fault::Unsupported, say("Supermodified controllers are found on serial links only"));
    if (address < lowestNode || address > highestNode)
        co_return {};
    Search search(Line::of(*serial, clock), sink);
    co_await search.runFor(address);
    co_return {};
}

} // namespace mb::supermodified
