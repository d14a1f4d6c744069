// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/firmwareimage.h"

#include <algorithm>

namespace mb {

std::vector<FirmwareImage::Segment>::const_iterator FirmwareImage::firstReaching(std::uint32_t address) const
{
    return std::lower_bound(m_segments.begin(), m_segments.end(), address,
        [](const Segment &segment, std::uint32_t wanted) { return segment.last < wanted; });
}

std::optional<std::uint8_t> FirmwareImage::at(std::uint32_t address) const
{
    const auto segment = firstReaching(address);
    if (segment == m_segments.end() || segment->first > address)
        return std::nullopt;
    return m_bytes[segment->offset + (address - segment->first)];
}

bool FirmwareImage::hasAny(std::uint32_t first, std::uint32_t last) const
{
    const auto segment = firstReaching(first);
    return segment != m_segments.end() && segment->first <= last && first <= last;
}

void FirmwareImage::overlay(std::uint32_t from, std::span<std::uint8_t> out) const
{
    const std::uint64_t end = std::uint64_t{from} + out.size();
    for (auto segment = firstReaching(from); segment != m_segments.end() && segment->first < end; ++segment) {
        const std::uint64_t first = std::max(segment->first, from);
        const std::uint64_t stop = std::min(end, std::uint64_t{segment->last} + 1);
        const auto source = bytes(*segment).subspan(first - segment->first, stop - first);
        std::copy(source.begin(), source.end(), out.subspan(first - from).begin());
    }
}

std::size_t FirmwareImage::byteCount(std::uint32_t first, std::uint32_t last) const
{
    std::size_t count = 0;
    for (auto segment = firstReaching(first); segment != m_segments.end() && segment->first <= last; ++segment) {
        const std::uint64_t from = std::max(segment->first, first);
        const std::uint64_t to = std::min(segment->last, last);
        count += to >= from ? to - from + 1 : 0;
    }
    return count;
}

} // namespace mb
