// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/noncopyable.h"
#include "model/device.h"

namespace mb {

/// That the unit in a place is still the one which stood there when this was made: as long as it is heard. Engine thread.
class HeardSince : NonCopyable {
public:
    explicit HeardSince(Device &device)
        : m_hearing(device.changed().add([this, &device] { m_holds = m_holds && device.liveness().heard; }))
    {
    }
    [[nodiscard]] bool holds() const { return m_holds; }

private:
    bool m_holds = true;
    Subscription m_hearing;
};

} // namespace mb
