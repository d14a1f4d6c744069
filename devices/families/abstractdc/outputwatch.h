// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/device.h"

#include <cstdint>
#include <string>
#include <vector>

namespace mb::abstractdc {

/// Whether the output of a loop is at its limit (saturated), or has passed 32767, where it turns to full reverse (wrapped:
/// README.md#wraps), and how often each was. Engine thread.
class OutputWatch {
public:
    /// A voltage log, PWM units. True when it is the first that tells of a wrap: the motor is to be stopped.
    [[nodiscard]] bool take(std::int32_t value);
    /// Another loop has the output now.
    void enterLoop() { m_saturated = false; }
    /// The motor was stopped: it may be driven again.
    void release() { m_wrapped = false; }
    /// Since the motor was stopped last.
    [[nodiscard]] bool hasWrapped() const { return m_wrapped; }
    /// Liveness::faults.
    [[nodiscard]] std::vector<std::string> faults() const;
    [[nodiscard]] std::vector<FaultRecord> records() const;
    void clearCounts();

private:
    bool m_saturated = false;
    bool m_wrapped = false;
    std::int64_t m_saturations = 0;
    std::int64_t m_wraps = 0;
};

} // namespace mb::abstractdc
