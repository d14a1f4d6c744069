// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/snapshot.h"

namespace mb {

/// How many frames a second pass on the link that is shown, counted anew twice a second.
class LinkFrameRate {
public:
    /// 0 until a link was looked at for long enough.
    [[nodiscard]] double of(const LinkView &link, Instant now);

private:
    std::string m_link;
    Instant m_since{};
    std::uint64_t m_frames = 0;
    double m_rate = 0.0;
};

} // namespace mb
