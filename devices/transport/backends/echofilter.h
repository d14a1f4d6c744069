// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

namespace mb {

/// Takes our own bytes out of what a half-duplex adapter reads while it sends. Compares them: an echo that differs is a
/// collision, and what follows is handed out as it came.
class EchoFilter {
public:
    /// Bytes are going out; their echo comes before `until` or not at all.
    void expect(std::span<const std::uint8_t> sent, Instant until)
    {
        m_expected.insert(m_expected.end(), sent.begin(), sent.end());
        m_until = until;
    }
    /// Appends to `others` what is no echo; false when an echo was not what we sent.
    bool take(Instant now, std::span<const std::uint8_t> bytes, std::vector<std::uint8_t> &others)
    {
        if (now > m_until)
            m_expected.clear();
        std::size_t same = 0;
        while (same < bytes.size() && !m_expected.empty() && bytes[same] == m_expected.front()) {
            m_expected.pop_front();
            ++same;
        }
        const bool good = same == bytes.size() || m_expected.empty();
        if (!good)
            m_expected.clear();
        others.insert(others.end(), bytes.begin() + static_cast<std::ptrdiff_t>(same), bytes.end());
        return good;
    }
    void clear() { m_expected.clear(); }

private:
    std::deque<std::uint8_t> m_expected;
    Instant m_until{};
};

} // namespace mb
