// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "telemetry/channel.h"

#include <algorithm>
#include <map>

namespace mb {

/// How often the channels that a device sends together are wished for (Device::setRate): whoever wants most of them decides.
class RateWishes {
public:
    /// 0 takes the wish for this channel back.
    void set(ChannelIndex channel, double hertz)
    {
        if (hertz > 0.0)
            m_wishes[channel.value] = hertz;
        else
            m_wishes.erase(channel.value);
    }
    /// Samples per second; 0 when nobody wishes for anything.
    [[nodiscard]] double highest() const
    {
        double most = 0.0;
        for (const auto &[channel, hertz] : m_wishes)
            most = std::max(most, hertz);
        return most;
    }

private:
    std::map<std::uint16_t, double> m_wishes;
};

} // namespace mb
