// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"

#include <array>
#include <cstdint>
#include <span>

namespace mb {

/// Counts the frames of a bus that no family knows in any dialect: other people's traffic. What a frame is hangs on its identifier and
/// length, so each pair is decoded when it is seen first, and again when another has taken its place in the memory of
/// 1024 pairs. Nothing is allocated for a pair that is remembered.
class UnknownFrames {
public:
    explicit UnknownFrames(std::span<const Family *const> families);

    /// One received frame; error frames are nobody's and not counted.
    void take(const CanFrame &frame);
    [[nodiscard]] std::uint64_t count() const { return m_count; }

private:
    [[nodiscard]] bool isKnown(const CanFrame &frame) const;

    struct Seen {
        std::uint64_t key = 0; ///< 0: nothing
        bool known = false;
    };
    std::span<const Family *const> m_families;
    std::array<Seen, 1024> m_seen{};
    std::uint64_t m_count = 0;
};

} // namespace mb
