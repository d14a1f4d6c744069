// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/simulatorenumeration.h"

#include <algorithm>
#include <utility>

namespace mb::dmc60c::simulation {
namespace {

constexpr auto halfMillisecond = std::chrono::microseconds(500);

} // namespace

Enumeration::Enumeration(
    Clock &clock, std::mt19937_64 &random, std::optional<std::uint16_t> first, std::function<bool()> answer)
    : m_random(random)
    , m_next(first)
    , m_answer(std::move(answer))
    , m_timer(clock)
{
}

void Enumeration::begin()
{
    m_session = std::exchange(m_next, std::nullopt).value_or(static_cast<std::uint16_t>(m_random() % 0xFFFFU + 1U));
}

void Enumeration::ask(int number, bool inBootloader)
{
    if (m_timer.isActive())
        return;
    Duration delay = std::chrono::milliseconds(number);
    if (number == 0) {
        const auto ticks = inBootloader ? m_random() : m_session;
        delay = std::max<Duration>(halfMillisecond, halfMillisecond * static_cast<int>(ticks & 0x7FU));
    }
    m_timer.startIn(delay, [this] { tell(); });
}

void Enumeration::tell()
{
    if (!m_answer())
        m_timer.startIn(halfMillisecond, [this] { tell(); });
}

} // namespace mb::dmc60c::simulation
