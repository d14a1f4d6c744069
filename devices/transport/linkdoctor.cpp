// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/linkdoctor.h"

#include "transport/backends/caninterface.h"

namespace mb {
namespace {

using namespace std::chrono_literals;

constexpr Duration recent = 3s;
constexpr Duration stuckTooLong = 1s;
constexpr int smallBuffer = 2000; // frames; less than 250 ms of a saturated bus
constexpr int usualBitrate = 1'000'000;

bool isRecent(const std::optional<Instant> &time, Instant now)
{
    return time && now - *time < recent;
}

/// Whether a frame of somebody else came after this.
bool heardSince(const BusHealth &health, Instant time)
{
    return health.lastReceived && *health.lastReceived > time;
}

Diagnosis nobodyAcknowledges(const LinkSymptoms &link)
{
    Message remedy = link.bitrate > 0
        ? say("switch the devices on, check the cable and that two 120 Ω resistors end the "
              "bus, and that every device has the bit rate %1",
            bitrateText(link.bitrate))
        : say("switch the devices on, check the cable and that two 120 Ω resistors end the "
              "bus, and that every device has the bit rate of this interface");
    return {Ailment::NobodyAcknowledges, say("nobody acknowledges what %1 sends", link.name), std::move(remedy), {}};
}

Diagnosis wrongBitrate(const LinkSymptoms &link, bool listenable)
{
    const Message cause = link.bitrate > 0
        ? say("only disturbed frames arrive on %1, the bus has another bit rate than %2", link.name,
            bitrateText(link.bitrate))
        : say("only disturbed frames arrive on %1, the bus has another bit rate", link.name);
    if (listenable)
        return {Ailment::WrongBitrate, cause, say("find it by listening only"), findBitrateCommand(link.name)};
    return {Ailment::WrongBitrate, cause,
        say("this interface cannot listen without disturbing the bus, so ask who set it up; usual are 1 Mbit/s, 500, "
            "250 "
            "and 125 kbit/s"),
        "sudo ip link set " + link.name + " down; " + bringUpCommand(link.name, true, 500'000)};
}

Diagnosis listenOnly(const LinkSymptoms &link)
{
    return {Ailment::ListenOnly, say("%1 only listens, nothing can be sent", link.name),
        say("bring it up as a full member"),
        "sudo ip link set " + link.name + " down; sudo ip link set " + link.name + " up type can bitrate "
            + std::to_string(link.bitrate > 0 ? link.bitrate : usualBitrate) + " listen-only off"};
}

Diagnosis busOff(const std::string &name)
{
    return {Ailment::BusOff, say("%1 is bus-off", name), say("check wiring, termination and bit rate, then"),
        "sudo ip link set " + name + " type can restart"};
}

Diagnosis disturbed(const LinkSymptoms &link)
{
    const bool passive = link.health.state == BusState::Passive;
    Message cause = passive ? say("%1 is error-passive", link.name) : say("%1 is error-warning", link.name);
    if (link.health.transmitErrors && link.health.receiveErrors)
        cause = say("%1 with %2 transmit and %3 receive errors", cause, *link.health.transmitErrors,
            *link.health.receiveErrors);
    return {Ailment::Disturbed, std::move(cause),
        say("check the cable, both 120 Ω resistors, and that no number is taken twice"), {}};
}

Diagnosis losing(const LinkSymptoms &link)
{
    return {Ailment::Losing,
        say("%1 frames were lost, the kernel keeps only %2 for this program", link.counters.lost, link.receiveCapacity),
        say("allow more, then close and open the link"), "sudo sysctl -w net.core.rmem_max=16777216"};
}

/// Of a link that nobody can use at present.
Diagnosis lostLink(const LinkSymptoms &link, const std::optional<Diagnosis> &interface)
{
    if (interface && !interface->isHealthy())
        return *interface;
    if (link.kind == LinkKind::Can && link.health.state == BusState::BusOff) {
        if (link.scheme == "socketcan")
            return busOff(link.name);
        return {Ailment::BusOff, say("%1 is bus-off", link.name),
            say("check wiring, termination and bit rate, then reconnect"), {}};
    }
    if (link.scheme == "socketcan" && !interface)
        return {Ailment::Gone, say("%1 is gone", link.name),
            say("plug the adapter in again; the link is opened by itself as soon as it is up"), {}};
    if (link.loss.detail.empty())
        return {Ailment::Failed, say("%1 is not open", link.name), say("reconnect"), {}};
    Diagnosis lost = diagnose(link.loss);
    if (lost.ailment == Ailment::Down && lost.command.empty()) { // it was up, so it has its bit rate
        lost.remedy = say("bring it up");
        lost.command = bringUpCommand(link.name, false, usualBitrate);
    }
    if (lost.remedy.empty())
        lost.remedy = say("reconnect");
    return lost;
}

Diagnosis openCan(const LinkSymptoms &link, Instant now, bool listenable)
{
    const BusHealth &health = link.health;
    if (link.listenOnly)
        return listenOnly(link);
    if (isRecent(health.lastProtocolError, now) && !isRecent(health.lastReceived, now))
        return wrongBitrate(link, listenable);
    if (isRecent(health.lastAcknowledgeError, now) && !heardSince(health, *health.lastAcknowledgeError))
        return nobodyAcknowledges(link);
    if (link.backlog > 0 && health.stuckSince && now - *health.stuckSince >= stuckTooLong) {
        if (!heardSince(health, *health.stuckSince))
            return nobodyAcknowledges(link);
        return {Ailment::Busy, say("the bus leaves no room for what %1 sends", link.name),
            say("find the sender that fills it, on the Bus page or with 'motorbenchctl monitor'"), {}};
    }
    if (health.state == BusState::Passive || health.state == BusState::Warning)
        return disturbed(link);
    if (link.counters.lost > 0 && link.receiveCapacity > 0 && link.receiveCapacity < smallBuffer)
        return losing(link);
    return {};
}

} // namespace

Message Diagnosis::message() const
{
    return cause.empty() ? errorOf(*this).help() : errorOf(*this).message();
}

LinkSymptoms symptomsOf(const Link &link, Instant now)
{
    LinkSymptoms seen;
    seen.name = link.address().shortName();
    seen.scheme = link.address().scheme;
    seen.kind = link.kind();
    seen.state = link.state();
    seen.loss = link.loss();
    seen.counters = link.counters();
    if (link.kind() != LinkKind::Can)
        return seen;
    const auto &can = static_cast<const CanLink &>(link);
    seen.health = can.health();
    seen.bitrate = can.bitrate();
    seen.load = can.load(now).value_or(0.0);
    seen.listenOnly = can.isListenOnly();
    seen.receiveCapacity = can.receiveCapacity();
    seen.backlog = can.backlog();
    return seen;
}

Diagnosis diagnose(const CanInterface &interface)
{
    const std::string &name = interface.name;
    if (!interface.up) {
        const bool needsBitrate = interface.kind == CanInterface::Kind::Controller && interface.bitrate == 0;
        return {Ailment::Down, say("%1 is switched off", name), say("bring it up"),
            bringUpCommand(name, needsBitrate, usualBitrate)};
    }
    if (interface.state == BusState::BusOff && !interface.restarts)
        return busOff(name);
    if (interface.state == BusState::BusOff)
        return {Ailment::BusOff, say("%1 is bus-off", name),
            say("check wiring, termination and bit rate; it starts again by itself"), {}};
    return {};
}

Diagnosis diagnose(const LinkSymptoms &link, Instant now, const std::optional<Diagnosis> &interface, bool listenable)
{
    if (link.state == LinkState::Lost)
        return lostLink(link, interface);
    if (link.state == LinkState::Open && link.kind == LinkKind::Can)
        return openCan(link, now, listenable);
    return {};
}

Error errorOf(const Diagnosis &diagnosis)
{
    return {Fault::LinkLost, diagnosis.cause, diagnosis.remedy, diagnosis.command, diagnosis.ailment};
}

Diagnosis diagnose(const Error &opening)
{
    return {opening.ailment == Ailment::None ? Ailment::Failed : opening.ailment, opening.detail, opening.remedy,
        opening.command};
}

std::string bringUpCommand(const std::string &name, bool needsBitrate, int bitrate)
{
    return "sudo ip link set " + name + " up" + (needsBitrate ? " type can bitrate " + std::to_string(bitrate) : "");
}

std::string findBitrateCommand(const std::string &name)
{
    return "for r in 1000000 500000 250000 125000 800000 100000 50000 20000; do sudo ip link set " + name
        + " down; sudo ip link set " + name + " up type can bitrate $r listen-only on; timeout 2 candump -n 3 " + name
        + " >/dev/null && { echo \"the bit rate is $r\"; break; }; done; sudo ip link set " + name
        + " down; sudo ip link set " + name + " up type can bitrate $r listen-only off";
}

std::string bitrateText(int bitrate)
{
    if (bitrate % 1'000'000 == 0)
        return std::to_string(bitrate / 1'000'000) + " Mbit/s";
    std::string text = std::to_string(bitrate / 1000);
    if (const int rest = bitrate % 1000; rest != 0) {
        std::string digits = std::to_string(1000 + rest).substr(1);
        while (digits.back() == '0')
            digits.pop_back();
        text += '.' + digits;
    }
    return text + " kbit/s";
}

} // namespace mb
