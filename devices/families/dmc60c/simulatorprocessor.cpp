// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/simulatorprocessor.h"

#include <utility>

namespace mb::dmc60c::simulation {
namespace {

constexpr std::size_t fifoFrames = 24;

} // namespace

Processor::Processor(Clock &clock, Owner owner)
    : m_owner(std::move(owner))
    , m_timer(clock)
{
}

void Processor::take(const CanFrame &frame)
{
    if (!isBusy())
        m_owner.handle(frame);
    else if (m_fifo.size() < fifoFrames)
        m_fifo.push_back(frame);
}

void Processor::stall(Duration time, std::function<void()> then)
{
    m_stalls.push_back({time, std::move(then)});
    if (m_stalls.size() == 1)
        begin();
}

void Processor::begin()
{
    m_timer.startIn(m_stalls.front().time, [this] { end(); });
}

void Processor::end()
{
    const auto then = std::move(m_stalls.front().then);
    const std::size_t waiting = m_stalls.size();
    then(); // may add a stall, or lose the supply
    if (m_stalls.size() < waiting)
        return;
    m_stalls.pop_front();
    if (isBusy())
        return begin();
    m_owner.freed();
    while (!isBusy() && !m_fifo.empty()) {
        const CanFrame frame = m_fifo.front();
        m_fifo.pop_front();
        m_owner.handle(frame);
    }
}

void Processor::clear()
{
    m_timer.stop();
    m_stalls.clear();
    m_fifo.clear();
}

} // namespace mb::dmc60c::simulation
