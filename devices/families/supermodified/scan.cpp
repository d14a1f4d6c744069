// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/supermodified/scan.h"

#include "families/supermodified/interview.h"

#include <algorithm>

namespace mb::supermodified {
namespace {

using namespace std::chrono_literals;

constexpr int firstUsual = 4; ///< where vendors leave their units
constexpr int lastUsual = 15;
constexpr Duration shortestSilence = 8ms;
constexpr int silenceRoundTrips = 4;

/// One scan: what was asked and what answered.
class Search {
public:
    Search(std::shared_ptr<Line> line, ScanSink &sink)
        : m_line(std::move(line))
        , m_sink(sink)
    {
    }

    [[nodiscard]] Task<void> run();
    [[nodiscard]] Task<void> runFor(int address);

private:
    using Place = std::pair<int, int>; ///< rate and id

    [[nodiscard]] std::vector<int> rates() const;
    void plan(int rate, int first, int last, std::vector<Place> &out) const;
    [[nodiscard]] bool isDone(const Place &place) const;
    [[nodiscard]] Task<bool> look(Place place);
    [[nodiscard]] Task<void> lookAll(std::vector<Place> places);
    void keepFoundRates(std::vector<int> &rates) const;
    [[nodiscard]] Duration silence() const;
    void report(const std::string &what, int done, int total) const;

    std::shared_ptr<Line> m_line;
    ScanSink &m_sink;
    std::vector<Place> m_asked;
    std::vector<int> m_found; ///< ids
    bool m_quick = false;     ///< the nodes of an earlier scan answered, so the answer time of the line is known
};

std::vector<int> Search::rates() const
{
    const SerialLink &link = m_line->link();
    if (const auto fixed = link.fixedBaudrate())
        return {*fixed};
    if (m_line->isDriving())
        return {link.baudrate()};
    return {searchRates.begin(), searchRates.end()};
}

bool Search::isDone(const Place &place) const
{
    return std::find(m_asked.begin(), m_asked.end(), place) != m_asked.end()
        || std::find(m_found.begin(), m_found.end(), place.second) != m_found.end();
}

void Search::plan(int rate, int first, int last, std::vector<Place> &out) const
{
    for (int id = first; id <= last; ++id) {
        const Place place{rate, id};
        if (!isDone(place) && std::find(out.begin(), out.end(), place) == out.end())
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

/// Any frame from the node counts, an error frame too: it is there and has something to tell.
Task<bool> Search::look(Place place)
{
    m_asked.push_back(place);
    const Node node{place.second, place.first, std::nullopt};
    Line::Request request = asking(node, Command::GetPosition);
    request.patience = silence();
    if (node.id == m_line->hostId()) // a node with the host's own id can be asked under another one only
        request.frame.from = static_cast<std::uint8_t>(node.id == highestNode ? lowestNode : node.id + 1);
    auto question = ask(*m_line, std::move(request));
    const Result<Frame> reply = co_await std::move(question).attempt();
    if (!reply && reply.error().fault != Fault::Timeout)
        co_return fail(reply.error());
    if (!reply)
        co_return false;
    m_line->note(node.id, {node.baudrate, exactMask});
    auto talk = interview(*m_line, node);
    const Result<Interview> said = co_await std::move(talk).attempt();
    if (!said && said.error().fault == Fault::LinkLost)
        co_return fail(said.error());
    m_found.push_back(node.id);
    m_sink.found(identityOf(*m_line, node, said.value_or(Interview{})));
    co_return true;
}

void Search::report(const std::string &what, int done, int total) const
{
    m_sink.progress(what, done, total);
}

Task<void> Search::lookAll(std::vector<Place> places)
{
    const int total = static_cast<int>(places.size());
    int done = 0;
    for (const Place &place : places) {
        report("Looking for Supermodified nodes at " + std::to_string(place.first) + " bit/s", done++, total);
        if (isDone(place))
            continue;
        auto looking = look(place);
        co_await std::move(looking);
    }
    co_return {};
}

Task<void> Search::run()
{
    std::vector<Place> known;
    std::vector<int> searched = rates();
    for (const auto &[id, node] : m_line->nodes()) {
        if (std::find(searched.begin(), searched.end(), node.baudrate) != searched.end())
            known.emplace_back(node.baudrate, id);
    }
    auto again = lookAll(known);
    co_await std::move(again);
    if (!known.empty() && m_found.size() == known.size())
        keepFoundRates(searched);
    std::vector<Place> usual;
    for (const int rate : searched) {
        // a node with the host's id would take the answers of others for questions, so it is looked for first
        plan(rate, usualHostId, usualHostId, usual);
        plan(rate, firstUsual, lastUsual, usual);
    }
    auto looking = lookAll(std::move(usual));
    co_await std::move(looking);
    if (!m_found.empty())
        keepFoundRates(searched);
    std::vector<Place> rest;
    for (const int rate : searched)
        plan(rate, lowestNode, highestNode, rest);
    auto lookingOn = lookAll(std::move(rest));
    co_await std::move(lookingOn);
    report("Supermodified found: " + std::to_string(m_found.size()), 1, 1);
    co_return {};
}

/// Nodes of one line have one rate as a rule: two would take each other's bytes for errors.
void Search::keepFoundRates(std::vector<int> &rates) const
{
    std::erase_if(rates, [this](int rate) {
        return std::none_of(m_found.begin(), m_found.end(),
            [&](int id) { return m_line->nodes().contains(id) && m_line->nodes().at(id).baudrate == rate; });
    });
}

Task<void> Search::runFor(int address)
{
    std::vector<Place> places;
    if (const auto known = m_line->nodes().find(address); known != m_line->nodes().end())
        places.emplace_back(known->second.baudrate, address);
    for (const int rate : rates()) {
        if (m_line->nodes().empty())
            plan(rate, usualHostId, usualHostId, places);
        plan(rate, address, address, places);
    }
    for (const Place &place : places) {
        auto looking = look(place);
        if (co_await std::move(looking) && place.second == address)
            break;
    }
    co_return {};
}

} // namespace

Task<void> scan(Link &link, Clock &clock, ScanSink &sink)
{
    auto *const serial = dynamic_cast<SerialLink *>(&link);
    if (!serial)
        co_return fail(Fault::Unsupported, "Supermodified controllers are found on serial links only");
    Search search(Line::of(*serial, clock), sink);
    auto searching = search.run();
    co_await std::move(searching);
    co_return {};
}

Task<void> probe(Link &link, Clock &clock, int address, ScanSink &sink)
{
    auto *const serial = dynamic_cast<SerialLink *>(&link);
    if (!serial)
        co_return fail(Fault::Unsupported, "Supermodified controllers are found on serial links only");
    if (address < lowestNode || address > highestNode)
        co_return {};
    Search search(Line::of(*serial, clock), sink);
    auto searching = search.runFor(address);
    co_await std::move(searching);
    co_return {};
}

} // namespace mb::supermodified
