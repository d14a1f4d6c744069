// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/dmc60c/flashproof.h"
#include "families/dmc60c/vendororders.h"
#include "model/device.h"

namespace mb::dmc60c {

/// Reads and writes the parameters of one unit by their number on the wire, and proves that they are in its flash. Engine
/// thread; outlives its tasks.
class ParameterDesk {
public:
    ParameterDesk(const UnitContact &contact, VendorOrders &orders, ParameterStore &known);

    [[nodiscard]] Task<std::int64_t> read(std::uint8_t number);
    /// Yields what is in force.
    [[nodiscard]] Task<std::int64_t> write(const Parameter &parameter, std::int64_t raw);
    /// Yields the count before it was cleared.
    [[nodiscard]] Task<std::int64_t> clearCounter(const Parameter &parameter, std::int64_t raw);
    /// Device::store().
    [[nodiscard]] Task<bool> store(Progress &progress);
    /// The same for what a restart would take. What was lost before is for store() to tell.
    [[nodiscard]] Task<void> storeWhatWaits();
    /// Sticky bits and counts, and whether each fault is present; clears them if asked to.
    [[nodiscard]] Task<std::vector<FaultRecord>> faults(bool clear);
    /// The unit was reset: what it has not written is lost.
    void restarted();

private:
    const UnitContact &m_contact;
    VendorOrders &m_orders;
    ParameterStore &m_known;
    ParameterExchange m_exchange;
    FlashProof m_flash;
    bool m_flashLost = false; ///< the device restarted before its flash was proved
};

} // namespace mb::dmc60c
