// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/dmc60c/unitcontact.h"
#include "families/dmc60c/unitidentity.h"
#include "families/dmc60c/vendor.h"

namespace mb::dmc60c {

/// The vendor's commands to one unit: questions that are asked again until they are answered, and a new number. Engine thread;
/// outlives its tasks.
class VendorOrders {
public:
    explicit VendorOrders(const UnitContact &contact)
        : m_contact(contact)
    {
    }

    /// Fails with what the unit refused, or Timeout.
    [[nodiscard]] Task<VendorReply> ask(VendorCommand command, std::vector<std::uint8_t> data = {});
    [[nodiscard]] Task<FirmwareVersions> versions();
    [[nodiscard]] Task<DescriptorList> descriptors();
    /// Of its flash: it goes on with every write.
    [[nodiscard]] Task<std::uint32_t> flashSequence();
    /// Refused when another unit answers under this number.
    [[nodiscard]] Task<void> expectFree(int number);
    /// Gives the unit this number; the versions are its first words from there.
    [[nodiscard]] Task<FirmwareVersions> moveTo(int number);

private:
    const UnitContact &m_contact;
};

} // namespace mb::dmc60c
