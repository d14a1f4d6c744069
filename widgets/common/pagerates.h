// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/noncopyable.h"
#include "widgets/common/workbench.h"

namespace mb {

/// How often one page wishes to see what it shows, told to the engine when that changes; ends with the page, which the workbench
/// outlives. What a device then sends decides app/engine/rates.h. GUI thread.
class PageRates : NonCopyable {
public:
    explicit PageRates(Workbench &workbench)
        : m_workbench(workbench)
    {
    }
    ~PageRates() { wish({}); }

    /// From now on instead of what was wished before; nothing where nobody sees the page.
    void wish(std::vector<RateWish> wishes)
    {
        if (wishes == m_wishes)
            return;
        m_wishes = std::move(wishes);
        m_workbench.send(orders::WishRates{reinterpret_cast<std::uintptr_t>(this), m_wishes});
    }
    /// A page that only shows a device may wish; to others its telemetry is a setting, and only who drives it changes it.
    [[nodiscard]] static bool isFree(const DeviceView &device)
    {
        const bool recorded = device.link.rfind("replay:", 0) == 0; // nothing is asked there
        return !recorded && (device.family->capabilities.freeRates || device.motion.running);
    }

private:
    Workbench &m_workbench;
    std::vector<RateWish> m_wishes;
};

} // namespace mb
