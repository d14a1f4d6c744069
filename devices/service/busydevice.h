// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/noncopyable.h"
#include "model/device.h"

namespace mb::service {

/// Nothing else talks to a unit while its firmware is written.
class BusyDevice : NonCopyable {
public:
    BusyDevice(Device &device, const Message &why)
        : m_device(device)
    {
        device.gate().setBusy(why);
    }
    ~BusyDevice() { m_device.gate().setBusy({}); }

private:
    Device &m_device;
};

} // namespace mb::service
