// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/outputwatch.h"

#include "families/abstractdc/protocol.h"

#include <cstdlib>

namespace mb::abstractdc {
namespace {

constexpr const char *saturatedKey = "output_saturated";
constexpr const char *wrappedKey = "output_wrapped";

} // namespace

bool OutputWatch::take(std::int32_t value)
{
    const bool saturated = std::abs(std::int64_t{value}) > fullPwm;
    m_saturations += saturated && !m_saturated ? 1 : 0;
    m_saturated = saturated;
    if (std::abs(std::int64_t{value}) < outputWraps || m_wrapped)
        return false;
    m_wrapped = true; // the next command is refused, which ends the stream
    ++m_wraps;
    return true;
}

std::vector<std::string> OutputWatch::faults() const
{
    std::vector<std::string> keys;
    if (m_saturated)
        keys.emplace_back(saturatedKey);
    if (m_wrapped)
        keys.emplace_back(wrappedKey);
    return keys;
}

std::vector<FaultRecord> OutputWatch::records() const
{
    std::vector<FaultRecord> records;
    records.push_back({saturatedKey, m_saturated, m_saturations > 0, m_saturations});
    records.push_back({wrappedKey, m_wrapped, m_wraps > 0, m_wraps});
    return records;
}

void OutputWatch::clearCounts()
{
    m_saturations = 0;
    m_wraps = 0;
}

} // namespace mb::abstractdc
