// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/unknownframes.h"

#include <algorithm>

namespace mb {

UnknownFrames::UnknownFrames(std::span<const Family *const> families)
    : m_families(families)
{
}

void UnknownFrames::take(const CanFrame &frame)
{
    if (frame.error)
        return;
    const std::uint64_t key = (std::uint64_t{frame.id} << 8U) | (std::uint64_t{frame.size} << 3U)
        | (frame.extended ? 4U : 0U) | (frame.remote ? 2U : 0U) | 1U;
    Seen &seen = m_seen[(key * 0x9E3779B97F4A7C15ULL) >> 54U];
    if (seen.key != key)
        seen = {key, isKnown(frame)};
    m_count += seen.known ? 0 : 1;
}

bool UnknownFrames::isKnown(const CanFrame &frame) const
{
    return std::ranges::any_of(m_families, [&frame](const Family *family) {
        const auto reads = [&](std::string_view dialect) { return family->decodeCan(frame, dialect).has_value(); };
        return family->decodeCan && (reads({}) || std::ranges::any_of(family->dialects, [&reads](const auto &row) {
            return reads(row.key);
        }));
    });
}

} // namespace mb
