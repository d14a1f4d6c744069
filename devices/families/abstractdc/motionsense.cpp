// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/motionsense.h"

#include "families/abstractdc/whereabouts.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace mb::abstractdc {
namespace {

using namespace std::chrono_literals;

constexpr Duration kept = 250ms;
constexpr Duration velocityBase = 45ms;
constexpr Duration stale = 500ms;
constexpr double glitchTolerance = 4096.0;
constexpr double turnedAtOnce = 200.0; ///< counts between two readings, by a shaft whose speed nobody has seen yet

double seconds(Duration duration)
{
    return std::chrono::duration<double>(duration).count();
}

} // namespace

std::int64_t MotionSense::countedOn(std::int32_t position) const
{
    if (m_seen.empty())
        return position;
    const std::int64_t last = m_seen.back().position;
    return last + static_cast<std::int32_t>(static_cast<std::uint32_t>(position) - static_cast<std::uint32_t>(last));
}

MotionSense::Reading MotionSense::add(std::int32_t position, Instant time)
{
    const Seen seen{countedOn(position), time};
    const bool jumped = isJump(seen);
    if (jumped && !isWhereDoubted(seen)) {
        m_doubtful = seen;
        ++m_glitches;
        return Reading::Glitch;
    }
    const bool anew = isAnew(seen);
    if (jumped || anew)
        m_seen.clear();
    take(seen);
    return anew ? Reading::Anew : Reading::Taken;
}

bool MotionSense::isJump(const Seen &seen) const
{
    if (m_seen.empty())
        return false;
    const Seen &last = m_seen.back();
    const double way = velocity(last.time).value_or(0.0) * seconds(seen.time - last.time);
    const double off = std::abs(static_cast<double>(seen.position - last.position) - way);
    return std::abs(off - wrapLoss) < std::min(glitchTolerance + std::abs(way), 30000.0);
}

/// A jump to another place than the one before is one more glitch.
bool MotionSense::isWhereDoubted(const Seen &seen) const
{
    if (!m_doubtful)
        return false;
    const double speed = m_seen.empty() ? 0.0 : velocity(m_seen.back().time).value_or(0.0);
    const double way = speed * seconds(seen.time - m_doubtful->time);
    return std::abs(static_cast<double>(seen.position - m_doubtful->position) - way) < glitchTolerance + std::abs(way);
}

bool MotionSense::isAnew(const Seen &seen) const
{
    if (m_seen.empty())
        return false;
    const Seen &last = m_seen.back();
    const double reach = turnedAtOnce + 2.0 * m_fastest * seconds(seen.time - last.time);
    const double told = static_cast<std::int32_t>(seen.position);
    return Whereabouts::between(told - static_cast<double>(seen.position - last.position), told, reach)
        == Restart::Seen;
}

void MotionSense::take(const Seen &seen)
{
    m_doubtful.reset();
    m_seen.push_back(seen);
    while (m_seen.size() > 2 && seen.time - m_seen[1].time >= kept)
        m_seen.pop_front();
    m_fastest = std::max(m_fastest, std::abs(velocity(seen.time).value_or(0.0)));
}

void MotionSense::forget()
{
    m_seen.clear();
    m_doubtful.reset();
}

std::optional<double> MotionSense::velocity(Instant now) const
{
    if (m_seen.size() < 2 || now - m_seen.back().time > stale)
        return std::nullopt;
    const Seen &last = m_seen.back();
    auto first = std::prev(m_seen.end(), 2);
    while (first != m_seen.begin() && last.time - first->time < velocityBase)
        --first;
    const double elapsed = seconds(last.time - first->time);
    if (elapsed <= 0.0)
        return std::nullopt;
    return static_cast<double>(last.position - first->position) / elapsed;
}

std::optional<std::int32_t> MotionSense::position() const
{
    return m_seen.empty() ? std::nullopt : std::optional(static_cast<std::int32_t>(m_seen.back().position));
}

bool MotionSense::standsSince(Instant since) const
{
    if (m_seen.empty())
        return false;
    const Seen &last = m_seen.back();
    for (auto seen = m_seen.rbegin(); seen != m_seen.rend() && seen->time > since; ++seen) {
        if (std::abs(seen->position - last.position) > 1)
            return false;
        if (last.time - seen->time >= velocityBase)
            return true;
    }
    return false;
}

bool MotionSense::isMoving(Instant now) const
{
    if (m_seen.size() < 2 || now - m_seen.back().time > stale)
        return false;
    const auto [low, high] = std::minmax_element(
        m_seen.begin(), m_seen.end(), [](const Seen &a, const Seen &b) { return a.position < b.position; });
    return high->position - low->position > 2;
}

} // namespace mb::abstractdc
