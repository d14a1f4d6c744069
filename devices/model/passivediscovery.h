// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"

#include <functional>
#include <map>
#include <set>
#include <vector>

namespace mb {

/// Finds devices by what they send, without asking: for recordings. Tells of each as soon as one frame of it has been
/// seen, and again when more is known.
class PassiveDiscovery {
public:
    using Found = std::function<void(const Family &, const Identity &)>;

    PassiveDiscovery(std::span<const Family *const> families, Found found);
    /// The next frame. Those that the recorder had sent itself, `bySelf`, are nobody's, but tell what an answer means.
    void take(const CanFrame &frame, bool bySelf);

private:
    struct Sighting {
        Identity identity;
        std::set<int> sessions; ///< all that were seen before the present one
    };
    [[nodiscard]] static Identity merged(Sighting &sighting, Identity seen);

    std::vector<std::pair<const Family *, Recogniser>> m_recognisers;
    Found m_found;
    std::map<std::pair<const Family *, int>, Sighting> m_sightings;
};

} // namespace mb
