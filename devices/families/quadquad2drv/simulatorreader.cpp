// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/quadquad2drv/simulatorreader.h"

#include "families/quadquad2drv/protocol.h"

#include <numeric>
#include <utility>

namespace mb::quadquad2drv::simulation {
namespace {

constexpr Duration thinking
    = std::chrono::microseconds(20); ///< from a request to its answer; the real time is not known

} // namespace

std::uint8_t sumOf(const std::vector<std::uint8_t> &bytes)
{
    return static_cast<std::uint8_t>(std::accumulate(bytes.begin(), bytes.end(), 0U));
}

RequestReader::RequestReader(Clock &clock, std::function<void(const Packet &)> execute)
    : m_execute(std::move(execute))
    , m_answer(clock)
{
}

void RequestReader::clear()
{
    m_in.clear();
    m_pending.clear();
    m_answer.stop();
}

void RequestReader::take(std::uint8_t byte)
{
    if (m_in.empty() && byte != stx)
        return;
    m_in.push_back(byte);
    understand();
}

void RequestReader::understand()
{
    if (m_in.size() < 2 || (m_in[1] >= overhead && m_in.size() < m_in[1]))
        return;
    if (m_in[1] >= overhead && sumOf(m_in) == 0) {
        m_pending.push_back(std::exchange(m_in, {}));
        if (!m_answer.isActive())
            m_answer.startIn(thinking, [this] { answer(); });
        return;
    }
    // No packet: drop this start and look for one in what followed.
    const Packet rest(m_in.begin() + 1, m_in.end());
    m_in.clear();
    for (const std::uint8_t byte : rest)
        take(byte);
}

void RequestReader::answer()
{
    while (!m_pending.empty()) {
        const Packet packet = std::move(m_pending.front());
        m_pending.pop_front();
        m_execute(packet);
    }
}

} // namespace mb::quadquad2drv::simulation
