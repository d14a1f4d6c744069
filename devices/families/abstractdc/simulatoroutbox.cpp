// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/simulatoroutbox.h"

#include "wire/bytes.h"

namespace mb::abstractdc::simulation {
namespace {

using namespace std::chrono_literals;

constexpr Duration answerTime = 15us; ///< replies are sent from the receive interrupt
constexpr std::size_t mailboxes = 3;  ///< further replies are dropped

} // namespace

Outbox::Outbox(CanLink &link, Clock &clock, const UnitOptions &options, FaultPlan &faults)
    : m_link(link)
    , m_clock(clock)
    , m_options(options)
    , m_faults(faults)
{
}

void Outbox::clear()
{
    m_replies.clear();
    m_pending = 0;
}

void Outbox::reply(Log log, std::int32_t value)
{
    if (m_pending + m_link.backlog() >= mailboxes)
        return;
    std::array<std::uint8_t, 4> data{};
    writeU32le(data, 0, static_cast<std::uint32_t>(value));
    const Dialect &dialect = *m_options.dialect;
    const int base = dialect.reply.at(static_cast<std::size_t>(log));
    const bool shifted = log != Log::Voltage || dialect.voltageOffset;
    const CanFrame frame = standardFrame(static_cast<std::uint32_t>(base + (shifted ? m_options.offset : 0)), data);
    ++m_pending;
    m_replies.emplace_back(m_clock);
    m_replies.back().startIn(answerTime, [this, frame, self = &m_replies.back()] {
        --m_pending;
        transmit(frame);
        m_replies.remove_if([self](const Timer &timer) { return &timer == self; });
    });
}

void Outbox::transmit(CanFrame frame)
{
    const FrameFate fate = m_faults.sent();
    if (fate.lost)
        return;
    if (fate.corrupt)
        frame.data[fate.number % frame.size] ^= 0x55U;
    if (fate.delay) {
        m_late.emplace_back(m_clock).startIn(*fate.delay, [this, frame] { (void)m_link.send(frame); });
        return;
    }
    (void)m_link.send(frame); // a lost link is noticed by its state
}

} // namespace mb::abstractdc::simulation
