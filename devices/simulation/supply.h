// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"

#include <functional>

namespace mb {

/// The supply of a simulated unit, on at first: taken away and given back by hand, or lost and back by itself.
class Supply {
public:
    /// `switched` hears each change.
    Supply(Clock &clock, std::function<void(bool on)> switched)
        : m_switched(std::move(switched))
        , m_back(clock)
    {
    }
    [[nodiscard]] bool isOn() const { return m_on; }
    /// By hand: what is taken away stays away.
    void set(bool on)
    {
        m_back.stop();
        if (on == m_on)
            return;
        m_on = on;
        m_switched(on);
    }
    void lose(Duration gap = std::chrono::milliseconds(200))
    {
        if (!m_on)
            return;
        set(false);
        m_back.startIn(gap, [this] { set(true); });
    }

private:
    std::function<void(bool)> m_switched;
    bool m_on = true;
    Timer m_back;
};

} // namespace mb
