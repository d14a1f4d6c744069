// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/raisedrates.h"

#include "async/sleep.h"

namespace mb::tuning {
namespace {

constexpr Duration rateTime = std::chrono::milliseconds(200); ///< until samples come as often as was asked for

} // namespace

Task<void> RaisedRates::raise(
    int axis, double rate, const ExperimentSurroundings &around, std::span<const std::string_view> keys)
{
    for (const std::string_view key : keys) {
        const auto channel = axisChannel(m_device, key, axis);
        if (!channel)
            continue;
        const Result<void> set = co_await m_device.setRate(*channel, rate).attempt();
        if (set || set.error().fault == Fault::Timeout || set.error().fault == Fault::LinkLost) // or perhaps
            m_raised.push_back(*channel);
        if (!set && set.error().fault == Fault::LinkLost)
            co_return fail(set.error());
        if (!set && set.error().fault != Fault::Unsupported && set.error().fault != Fault::OutOfRange)
            around.caution(say("%1 is not told as often as was asked for: %2", key, set.error().detail));
    }
    co_await Sleep(m_device.clock(), rateTime);
    co_return {};
}

Task<void> RaisedRates::lower(const ExperimentSurroundings &around)
{
    for (const ChannelIndex channel : m_raised) {
        const Result<void> set = co_await m_device.setRate(channel, 0.0).attempt();
        if (!set && m_device.link().state() == LinkState::Open)
            around.caution(say("the device's rate was not put back: %1", set.error().detail));
    }
    m_raised.clear();
    co_return {};
}

} // namespace mb::tuning
