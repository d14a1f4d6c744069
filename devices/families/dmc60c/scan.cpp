// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/scan.h"

#include "async/sleep.h"
#include "families/dmc60c/unitidentity.h"
#include "families/dmc60c/vendor.h"

#include <algorithm>
#include <map>

namespace mb::dmc60c {
namespace {

using namespace std::chrono_literals;

constexpr int extraRounds = 3;
constexpr Duration answersDue = 70ms;           ///< the latest answer starts 63.5 ms after the request
constexpr Attempts descriptorAttempts{1, 40ms}; ///< the windows are short, and there is a next one
constexpr int descriptorTries = 4;

/// Who answered so far, by number and session.
class Census {
public:
    Census(CanLink &link, ScanSink &sink)
        : m_sink(sink)
        , m_received(link.received().add([this](const CanFrame &frame) { take(frame); }))
    {
    }

    struct Unit {
        std::optional<EnumResponse0> first;
        std::optional<EnumResponse1> second;
        Identity identity; ///< valid when both halves are here
        int descriptorTries = 0;
        bool described = false;

        [[nodiscard]] bool isComplete() const { return first && second; }
    };
    [[nodiscard]] bool hasHalves() const
    {
        return std::ranges::any_of(m_units, [](const auto &entry) { return !entry.second.isComplete(); });
    }
    [[nodiscard]] int complete() const
    {
        return static_cast<int>(
            std::ranges::count_if(m_units, [](const auto &entry) { return entry.second.isComplete(); }));
    }
    /// The next unit whose descriptors are worth a try; nodes are stable.
    [[nodiscard]] Unit *nextUndescribed()
    {
        const auto fewer = [](const auto &a, const auto &b) { return rank(a.second) < rank(b.second); };
        const auto found = std::ranges::min_element(m_units, fewer);
        return found == m_units.end() || rank(found->second) >= descriptorTries ? nullptr : &found->second;
    }
    void describe(Unit &unit, const DescriptorList &list)
    {
        unit.described = true;
        setDescriptors(unit.identity, list);
        m_sink.found(unit.identity);
    }

private:
    using Key = std::pair<int, std::uint16_t>;

    static int rank(const Unit &unit)
    {
        return unit.isComplete() && !unit.described ? unit.descriptorTries : descriptorTries;
    }

    void take(const CanFrame &frame)
    {
        if (const auto first = decodeEnumResponse0(frame))
            unitFor({first->device, first->session}).first = first;
        else if (const auto second = decodeEnumResponse1(frame))
            unitFor({second->device, second->session}).second = second;
        else
            return;
        for (auto &[key, unit] : m_units) {
            if (key.first == deviceOf(frame) && unit.isComplete())
                report(key, unit);
        }
    }
    Unit &unitFor(const Key &key) { return m_units[key]; }

    void report(const Key &key, Unit &unit)
    {
        Identity identity = identityOf(*unit.first, *unit.second);
        const auto sharing
            = std::ranges::count_if(m_units, [&](const auto &entry) { return entry.first.first == key.first; });
        if (sharing > 1)
            markDuplicate(identity, static_cast<int>(sharing));
        carryDescriptors(identity, unit.identity);
        if (identity == unit.identity)
            return;
        unit.identity = std::move(identity);
        m_sink.found(unit.identity);
    }

    ScanSink &m_sink;
    std::map<Key, Unit> m_units;
    Subscription m_received;
};

/// Reads descriptors until `until`, one unit after the other.
Task<void> describeUnits(CanLink &link, Clock &clock, Census &census, Instant until)
{
    while (clock.now() < until) {
        Census::Unit *const unit = census.nextUndescribed();
        if (!unit)
            co_return {};
        ++unit->descriptorTries;
        VendorRequest request{unit->first->device, unit->first->session, {Command::GetDescriptors}};
        auto task = vendorExchange(link, clock, std::move(request), descriptorAttempts);
        const Result<VendorReply> reply = co_await std::move(task).attempt();
        if (!reply && reply.error().fault == Fault::LinkLost)
            co_return fail(reply.error());
        if (!reply)
            continue;
        if (const auto list = descriptorsIn(*reply))
            census.describe(*unit, *list);
    }
    co_return {};
}

} // namespace

Task<void> scan(Link &link, Clock &clock, ScanSink &sink)
{
    auto *const can = dynamic_cast<CanLink *>(&link);
    if (!can)
        co_return fail(Fault::Unsupported, say("DMC60C controllers are found on CAN links only"));
    Census census(*can, sink);
    for (int round = 0; round < enumRounds + (census.hasHalves() ? extraRounds : 0); ++round) {
        sink.progress(say("Looking for DMC60C"), round, enumRounds);
        const Instant end = clock.now() + enumWindow;
        co_await can->send(encodeEnumerate());
        co_await Sleep(clock, answersDue);
        co_await describeUnits(*can, clock, census, end);
        if (clock.now() < end)
            co_await Sleep(clock, end - clock.now());
    }
    // A unit that only the last round found, or whose bytes were lost, gets what tries it has left.
    co_await describeUnits(*can, clock, census, Instant::max());
    sink.progress(say("DMC60C found: %1", census.complete()), enumRounds, enumRounds);
    if (can->state() != LinkState::Open)
        co_return fail(Fault::LinkLost, say("%1: %2", can->address().shortName(), can->loss().message()));
    co_return {};
}

} // namespace mb::dmc60c
