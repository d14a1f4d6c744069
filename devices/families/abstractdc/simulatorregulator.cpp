// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/simulatorregulator.h"

#include "families/abstractdc/protocol.h"

#include <algorithm>

namespace mb::abstractdc::simulation {

void Pid::restart(const Record &gains, std::int64_t now)
{
    if (gains.divisor > 0)
        m_sum = 0;
    m_lastTime = now;
}

std::int64_t Pid::step(const Record &gains, std::int64_t error, std::int64_t now)
{
    if (gains.divisor == 0)
        return 0; // the firmware divides by it; what the library makes of that is not known
    const std::int64_t elapsed = std::max<std::int64_t>(now - m_lastTime, 1);
    const std::int64_t rate = gains.d * (m_last - error) / elapsed;
    m_sum += gains.i * error * elapsed / gains.divisor;
    m_last = error;
    m_lastTime = now;
    return (gains.p * error + rate) / gains.divisor + m_sum;
}

int pwmOf(std::int64_t output)
{
    const auto wrapped = static_cast<std::int16_t>(static_cast<std::uint16_t>(static_cast<std::uint64_t>(output)));
    return std::clamp<int>(wrapped, -fullPwm, fullPwm);
}

void Averager::add(int sample, int count)
{
    if (m_at >= size) {
        m_overrun = true;
        return;
    }
    m_samples[m_at++] = sample;
    if (static_cast<int>(m_at) == count)
        m_at = 0;
}

int Averager::mean(int count) const
{
    if (count < 1)
        return 0;
    const auto used = std::min<std::size_t>(static_cast<std::size_t>(count), size);
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < used; ++i)
        sum += m_samples.at(i);
    return static_cast<int>(sum / count);
}

} // namespace mb::abstractdc::simulation
