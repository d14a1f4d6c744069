// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/scope.h"
#include "async/task.h"
#include "model/device.h"

#include <functional>

namespace mb {

/// Whether a device that restarts answers again: asked every 500 ms, ten times. One that did not answer before
/// (DeviceState::Bootloader) is looked for as a scan does, and identified by that. LinkLost. Engine thread.
[[nodiscard]] Task<bool> answersAgain(Device &device);

/// Asks a device while a programmer holds its processor, which answers nothing then: whoever does is another unit than the one that
/// is being written. Engine thread.
class HeldDevice {
public:
    explicit HeldDevice(Device &device)
        : m_device(device)
        , m_asking(device.clock())
    {
    }
    /// The programmer has halted it. `silent`, which outlives this: it did not answer.
    void hold(std::function<void()> silent);
    /// It may run again: what it says from now on proves nothing.
    void release() { m_asking.clear(); }
    [[nodiscard]] bool hasAnswered() const { return m_hasAnswered; }

private:
    Device &m_device;
    bool m_hasAnswered = false;
    Scope m_asking; ///< last: uses everything above
};

/// Of an update whose device has answered while it was held.
[[nodiscard]] Error anotherUnit(const Device &device);

} // namespace mb
