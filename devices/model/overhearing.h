// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"

#include <functional>
#include <map>
#include <set>

namespace mb {

/// Finds devices by what they send, without asking: for recordings. Tells of each as soon as one frame of it has been
/// seen, and again when more is known.
class Overhearing {
public:
    using Found = std::function<void(const Family &, const Identity &)>;

    Overhearing(std::span<const Family *const> families, Found found);
    /// A frame that a device, or another host, may have sent.
    void take(const CanFrame &frame);

private:
    struct Sighting {
        Identity identity;
        std::set<int> sessions; ///< all that were seen before the present one
    };
    [[nodiscard]] static Identity merged(Sighting &sighting, Identity seen);

    std::span<const Family *const> m_families;
    Found m_found;
    std::map<std::pair<const Family *, int>, Sighting> m_sightings;
};

} // namespace mb
