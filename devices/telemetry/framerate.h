// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "telemetry/channel.h"

#include <algorithm>
#include <map>

namespace mb {

/// How often one frame is to come that has several channels in it (Device::setRate sets one by one): as often as the fastest of them.
class FrameRate {
public:
    /// 0: this channel needs no rate any more.
    void set(ChannelIndex channel, double hertz)
    {
        if (hertz > 0.0)
            m_channels[channel.value] = hertz;
        else
            m_channels.erase(channel.value);
    }
    /// Samples per second; 0: no channel needs one.
    [[nodiscard]] double highest() const
    {
        double most = 0.0;
        for (const auto &[channel, hertz] : m_channels)
            most = std::max(most, hertz);
        return most;
    }

private:
    std::map<std::uint16_t, double> m_channels;
};

} // namespace mb
