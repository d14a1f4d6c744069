// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/abstractdc/simulatorflash.h"

#include <array>
#include <cstdint>

/// The integer arithmetic of the drive (README.md#control-law), with everything that is wrong with it.
namespace mb::abstractdc::simulation {

class Pid {
public:
    /// A change of mode. With a divisor of 0 or less the integral stays (README.md#divisor).
    void restart(const Record &gains, std::int64_t now);
    /// `now` in whole milliseconds. PWM units, neither limited nor wrapped.
    [[nodiscard]] std::int64_t step(const Record &gains, std::int64_t error, std::int64_t now);

private:
    std::int64_t m_sum = 0;
    std::int64_t m_last = 0;
    std::int64_t m_lastTime = 0;
};

/// What the timer gets for a controller output: cast to 16 bits first, then clamped (README.md#wraps).
[[nodiscard]] int pwmOf(std::int64_t output);

/// The mean of N samples of a converter, in a buffer of 500 whose index is compared with N for equality only (README.md#averaging).
class Averager {
public:
    void add(int sample, int count);
    [[nodiscard]] int mean(int count) const;
    /// The index has left the buffer: whatever lies behind it is overwritten.
    [[nodiscard]] bool hasOverrun() const { return m_overrun; }

private:
    static constexpr std::size_t size = 500;
    std::array<int, size> m_samples{};
    std::size_t m_at = 0;
    bool m_overrun = false;
};

} // namespace mb::abstractdc::simulation
