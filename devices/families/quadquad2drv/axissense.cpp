// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/quadquad2drv/axissense.h"

#include "families/quadquad2drv/channels.h"
#include "families/quadquad2drv/states.h"

#include <cmath>
#include <string>

namespace mb::quadquad2drv {
namespace {

constexpr double standing = 8.0; ///< counts/s, twice the resolution (README.md#times-4096)
constexpr std::array<int, 4> positionBits{0, 8, 16, 32};

struct FaultBit {
    std::uint8_t bit;
    const char *key;
};
constexpr std::array faultBits{FaultBit{status::glitch, "glitch"}, FaultBit{status::overspeed, "overspeed"}};

std::string keyOf(std::size_t axis, const FaultBit &fault)
{
    return "ch" + std::to_string(axis + 1) + '.' + fault.key;
}

bool isWhole(std::uint8_t mask)
{
    return (mask & datamask::relative) == 0 && positionBits[mask & datamask::positionSize] == 32;
}

std::int64_t unwrapped(std::optional<std::int64_t> before, std::int32_t position, std::uint8_t mask)
{
    if ((mask & datamask::relative) != 0)
        return before.value_or(0) + position;
    const int bits = positionBits[mask & datamask::positionSize];
    if (!before || bits == 32)
        return position;
    const std::int64_t span = std::int64_t{1} << bits;
    std::int64_t moved = (position - *before) % span;
    if (moved >= span / 2)
        moved -= span;
    if (moved < -span / 2)
        moved += span;
    return *before + moved;
}

} // namespace

void AxisSense::take(const Motion &motion, const DataMasks &masks, Instant time, LiveStates &states)
{
    missed(masks, motion.elapsed.value_or(0));
    for (int axis = 0; axis < axes; ++axis) {
        const auto at = static_cast<std::size_t>(axis);
        takeAxis(axis, motion.channels[at], masks[at], time);
        if (const auto &status = motion.channels[at].status)
            takeStates(states, axis, *status);
    }
}

void AxisSense::missed(const DataMasks &masks, std::uint64_t count)
{
    constexpr std::array bits{std::pair{AxisChannel::Position, datamask::positionSize},
        std::pair{AxisChannel::Velocity, datamask::velocity}, std::pair{AxisChannel::Status, datamask::status}};
    for (int axis = 0; count > 0 && axis < axes; ++axis) {
        for (const auto &[channel, bit] : bits) {
            if ((masks[static_cast<std::size_t>(axis)] & bit) != 0)
                m_telemetry->lost(channelOf(axis, channel), count);
        }
    }
}

void AxisSense::takeAxis(int axis, const AxisMotion &motion, std::uint8_t mask, Instant time)
{
    Tracked &tracked = m_tracked[static_cast<std::size_t>(axis)];
    if (motion.position) {
        tracked.position = unwrapped(tracked.position, *motion.position, mask);
        tracked.place = isWhole(mask) ? motion.position : std::nullopt;
        m_telemetry->append({channelOf(axis, AxisChannel::Position), time, static_cast<double>(*tracked.position)});
    }
    if (motion.velocity)
        m_telemetry->append({channelOf(axis, AxisChannel::Velocity), time, static_cast<double>(*motion.velocity)});
    if (motion.status) {
        tracked.status = *motion.status;
        m_telemetry->append({channelOf(axis, AxisChannel::Status), time, static_cast<double>(*motion.status)});
    }
}

std::optional<std::int64_t> AxisSense::position(int axis) const
{
    return m_tracked[static_cast<std::size_t>(axis)].position;
}

std::optional<std::int32_t> AxisSense::place(int axis) const
{
    return m_tracked[static_cast<std::size_t>(axis)].place;
}

bool AxisSense::isTurning(int axis) const
{
    const auto velocity = m_telemetry->latest(channelOf(axis, AxisChannel::Velocity));
    return velocity && std::abs(velocity->value) > standing;
}

void AxisSense::forget()
{
    for (Tracked &tracked : m_tracked) {
        tracked.position.reset();
        tracked.place.reset();
    }
}

std::vector<std::string> AxisSense::faults() const
{
    std::vector<std::string> keys;
    for (std::size_t axis = 0; axis < axes; ++axis) {
        for (const FaultBit &fault : faultBits) {
            if ((m_tracked[axis].status & fault.bit) != 0)
                keys.push_back(keyOf(axis, fault));
        }
    }
    return keys;
}

std::vector<FaultRecord> AxisSense::records() const
{
    std::vector<FaultRecord> records;
    for (std::size_t axis = 0; axis < axes; ++axis) {
        for (const FaultBit &fault : faultBits)
            records.push_back({keyOf(axis, fault), (m_tracked[axis].status & fault.bit) != 0, false, std::nullopt});
    }
    return records;
}

} // namespace mb::quadquad2drv
