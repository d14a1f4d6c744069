// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/backends/virtualcan.h"

#include <algorithm>

namespace mb {
namespace {

constexpr int collisionsUntilBusOff = 32;
constexpr int errorFrameBits = 6 + 8 + 3; // error flag, delimiter, intermission

/// Lower is sent first: the bits of the arbitration field in the order of the wire, with RTR or SRR and IDE after the
/// base identifier, so that of one base identifier the 11-bit frame wins.
std::uint64_t arbitrationKey(const CanFrame &frame)
{
    const std::uint64_t remote = frame.remote ? 1U : 0U;
    if (!frame.extended)
        return (static_cast<std::uint64_t>(frame.id) << 21U) | (remote << 20U);
    const std::uint64_t base = frame.id >> 18U;
    return (base << 21U) | (3ULL << 19U) | ((frame.id & 0x3FFFFULL) << 1U) | remote;
}

/// Each sender reads another bit than it sends, somewhere in the data.
CanErrorReport collisionReport()
{
    CanErrorReport report;
    report.protocol = true;
    report.busError = true;
    report.violation = 0x01;
    report.place = 0x0A;
    return report;
}

} // namespace

VirtualCanBus::VirtualCanBus(Clock &clock, int bitrate, std::uint64_t seed)
    : m_clock(clock)
    , m_bitrate(bitrate)
    , m_random(seed)
    , m_timer(clock)
{
}

void VirtualCanBus::attach(VirtualCanLink &link)
{
    m_links.push_back(&link);
}

void VirtualCanBus::detach(VirtualCanLink &link)
{
    m_links.erase(std::remove(m_links.begin(), m_links.end(), &link), m_links.end());
    m_sending.erase(std::remove(m_sending.begin(), m_sending.end(), &link), m_sending.end());
}

void VirtualCanBus::forceBusOff(VirtualCanLink &link)
{
    detach(link);
    link.m_queue.clear();
    CanErrorReport report;
    report.state = BusState::BusOff;
    link.noteError(report, m_clock.now());
    link.lose({Fault::LinkLost, say("bus-off: the controller left the bus after too many errors"),
        say("check wiring, termination and bit rate"), {}, Ailment::BusOff});
}

void VirtualCanBus::arm(Instant deadline)
{
    if (m_timer.isActive() && m_armedFor <= deadline)
        return;
    m_armedFor = deadline;
    m_timer.start(deadline, [this] {
        if (m_sending.empty())
            contend();
        else
            finishFrame();
    });
}

void VirtualCanBus::contend()
{
    const Instant now = std::max(m_armedFor, m_idleAt);
    std::uint64_t best = ~0ULL;
    Instant soonest = Instant::max();
    std::vector<VirtualCanLink *> winners;
    for (VirtualCanLink *link : m_links) {
        if (link->m_queue.empty())
            continue;
        const auto &head = link->m_queue.front();
        soonest = std::min(soonest, head.readyAt);
        if (head.readyAt > now)
            continue;
        const std::uint64_t key = arbitrationKey(head.frame);
        if (key < best)
            winners.clear();
        if (key <= best)
            winners.push_back(link);
        best = std::min(best, key);
    }
    if (!winners.empty())
        startFrame(winners);
    else if (soonest != Instant::max())
        arm(soonest);
}

void VirtualCanBus::startFrame(const std::vector<VirtualCanLink *> &winners)
{
    const Instant start = std::max(m_armedFor, m_idleAt);
    m_sending = winners;
    m_onWire = winners.front()->m_queue.front().frame;
    m_collision = std::ranges::any_of(
        winners, [this](const VirtualCanLink *link) { return !sameContent(link->m_queue.front().frame, m_onWire); });
    for (VirtualCanLink *link : winners)
        link->m_onWire = true;
    m_idleAt = start + bits(bitsOnWire(m_onWire) + (m_collision ? errorFrameBits : 0));
    m_timer.stop();
    arm(m_idleAt);
}

void VirtualCanBus::finishFrame()
{
    const auto senders = std::exchange(m_sending, {});
    const auto links = m_links; // receivers may come and go while they are called
    m_onWire.time = m_idleAt;
    for (VirtualCanLink *link : senders) {
        link->m_onWire = false;
        auto &head = link->m_queue.front();
        const bool isGivenUp = m_stubborn && ++head.collisions >= collisionsUntilBusOff;
        if (!m_collision || isGivenUp)
            link->m_queue.pop_front();
        else
            head.readyAt = m_idleAt + bits(m_stubborn ? 0 : static_cast<int>(m_random() % 64U));
    }
    const CanFrame frame = m_onWire;
    const bool collision = m_collision;
    const bool lost = m_loss > 0.0 && std::uniform_real_distribution<double>(0.0, 1.0)(m_random) < m_loss;
    arm(m_idleAt);
    for (VirtualCanLink *link : links) {
        const bool sender = std::ranges::find(senders, link) != senders.end();
        if (std::ranges::find(m_links, link) == m_links.end() || link->state() != LinkState::Open)
            continue;
        if (collision) {
            link->noteError(collisionReport(), m_idleAt);
        } else if (!sender && !lost) {
            link->deliver(frame);
            link->endBatch();
        }
    }
}

VirtualCanLink::VirtualCanLink(LinkAddress address, VirtualCanBus &bus)
    : CanLink(std::move(address), bus.clock())
    , m_bus(bus)
{
}

VirtualCanLink::~VirtualCanLink()
{
    m_bus.detach(*this);
}

Result<void> VirtualCanLink::doOpen()
{
    m_bus.attach(*this);
    startHealth(BusState::Active, {}, {});
    return {};
}

void VirtualCanLink::doClose()
{
    m_bus.detach(*this);
    m_queue.clear();
    m_onWire = false;
}

Result<void> VirtualCanLink::doSend(const CanFrame &frame, Priority priority)
{
    const bool urgent = priority == Priority::Urgent;
    const auto waiting = [this] { return m_queue.begin() + (m_onWire ? 1 : 0); };
    auto place = m_queue.end();
    if (urgent) {
        const auto replaced = [&frame](const Waiting &w) { return !w.urgent && sameIdentifier(w.frame, frame); };
        m_queue.erase(std::remove_if(waiting(), m_queue.end(), replaced), m_queue.end());
        place = std::find_if(waiting(), m_queue.end(), [](const Waiting &w) { return !w.urgent; });
    }
    m_queue.insert(place, Waiting{frame, frame.time, urgent});
    if (m_bus.m_sending.empty())
        m_bus.arm(std::max(frame.time, m_bus.m_idleAt));
    return {};
}

} // namespace mb
