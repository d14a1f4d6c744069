// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/quadquad2drv/packetport.h"

#include "async/sleep.h"

#include <algorithm>

namespace mb::quadquad2drv {
namespace {

using namespace std::chrono_literals;

/// Without a ready line: how long the board gets before it is asked, and how far its answer is looked for (README.md#ready-line).
constexpr Duration blindPause = 1ms;
constexpr std::size_t blindBytes = 64;
constexpr int mostWaiting = 16; ///< packets read in a row

} // namespace

PacketPort::PacketPort(SpiLink &link, Clock &clock)
    : m_link(link)
    , m_clock(clock)
    , m_traffic(link.traffic().add([this](const Traffic &traffic) { hear(traffic); }))
{
}

void PacketPort::setLayout(const DataMasks &masks, std::uint8_t streamConfig)
{
    m_masks = masks;
    m_streamConfig = streamConfig;
}

void PacketPort::hear(const Traffic &traffic)
{
    if (traffic.direction != Direction::Received)
        return;
    m_reader.feed(traffic.bytes);
    while (const auto packet = m_reader.next()) {
        noteDamage(); // which was before it
        const std::uint64_t begin = m_reader.taken() - packet->payload.size() - overhead;
        if (m_round && !m_round->reply && packet->id == m_round->id && begin >= m_round->from)
            m_round->reply = *packet;
        m_received.notify(*packet, traffic.time);
    }
    noteDamage();
}

void PacketPort::noteDamage()
{
    const bool isOwed = m_round && !m_round->reply;
    if (std::exchange(m_bad, m_reader.bad()) != m_reader.bad())
        m_damage = std::max(m_damage, isOwed ? Damage::Unclear : Damage::OfStream);
    if (std::exchange(m_strays, m_reader.strays()) != m_reader.strays())
        m_damage = std::max(m_damage, Damage::Unclear);
}

Task<void> PacketPort::clockOut(std::size_t bytes)
{
    Bytes filler(bytes);
    const Result<Bytes> got = co_await m_link.transfer(std::move(filler));
    if (!got)
        co_return fail(got.error());
    co_return {};
}

Task<void> PacketPort::searchStart()
{
    co_await Sleep(m_clock, blindPause);
    for (std::size_t i = 0; i < blindBytes && m_reader.missing() == 0; ++i)
        co_await clockOut(1);
    co_return {};
}

/// Reads until the reply of the round is there or its time is over (README.md#waiting-packets).
Task<void> PacketPort::listenFor(Round &round, std::size_t expected)
{
    const bool blind = !m_link.ready().has_value();
    while (!round.reply) {
        if (m_clock.now() >= round.deadline)
            co_return fail(Fault::Timeout, say("the board did not answer"));
        if (const std::size_t missing = m_reader.missing(); missing > 0) {
            co_await clockOut(missing);
            continue;
        }
        if (blind) {
            co_await searchStart();
            continue;
        }
        co_await m_link.waitReady(round.deadline - m_clock.now());
        co_await clockOut(expected);
    }
    co_return {};
}

Task<Packet> PacketPort::ask(const Bytes &request, const Gate &gate, Duration patience)
{
    const Turns::Turn turn = co_await m_link.turns().take();
    auto pending = takeWaiting(); // the request would clock it out, and what is late is no reply to it
    co_await std::move(pending);
    Round round{request[2], {}, m_clock.now() + patience};
    struct Hearing {
        Hearing(Round *&slot, Round &round)
            : m_slot(slot)
        {
            m_slot = &round;
        }
        ~Hearing() { m_slot = nullptr; }
        Round *&m_slot;
    };
    const Hearing hearing(m_round, round);
    if (gate && !gate())
        co_return fail(Fault::Cancelled, say("a stop went first"));
    const Result<Bytes> sent = co_await m_link.transfer(request);
    if (!sent)
        co_return fail(sent.error());
    round.from = m_reader.fed();
    const Result<void> heard = co_await listenFor(round, replySize(request, m_masks)).attempt();
    if (!heard) {
        m_reader.clear(); // half a packet must not eat the next one
        co_return fail(heard.error());
    }
    auto emptying = takeWaiting(); // the line will not rise again while a packet waits
    (void)co_await std::move(emptying).attempt();
    co_return std::move(*round.reply);
}

Task<Packet> PacketPort::request(Bytes request, int tries, Gate gate)
{
    Error last{Fault::Timeout, say("the board did not answer")};
    const Patience wanted
        = gate || tries == 1 ? Patience() : m_link.settings().patience; // an order to a motor, a poll: as they are
    for (int i = 0; i < wanted.tries(tries); ++i) {
        Result<Packet> reply = co_await ask(request, gate, wanted.answer(answerTime)).attempt();
        if (reply) {
            const auto code = returnCode(*reply);
            if (code == std::int8_t{0})
                co_return std::move(*reply);
            if (code)
                co_return fail(Fault::Refused, say("%1 (code %2)", explain(*code), *code));
            last = {Fault::BadReply, say("the board sent a reply without a return code")};
            continue;
        }
        if (reply.error().fault != Fault::Timeout)
            co_return fail(reply.error());
        last = reply.error();
    }
    co_return fail(last);
}

Task<void> PacketPort::takeWaiting()
{
    for (int i = 0; i < mostWaiting && m_link.ready().value_or(false); ++i) {
        const std::size_t missing = m_reader.missing();
        auto reading = clockOut(missing > 0 ? missing : streamPacketSize(m_masks, m_streamConfig));
        co_await std::move(reading);
    }
    co_return {};
}

Task<void> PacketPort::fetch()
{
    const Turns::Turn turn = co_await m_link.turns().take();
    co_await takeWaiting();
    co_return {};
}

} // namespace mb::quadquad2drv
