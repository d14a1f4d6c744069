// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/framedecoder.h"
#include "model/registry.h"

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace mb {

/// One row of the chronological view.
struct FrameRow {
    TrafficRecord record;
    double sinceSame = 0.0;   ///< seconds since the last frame of this identifier and direction; 0 for the first
    std::optional<int> asked; ///< whom it is from, where the frame does not tell
    std::shared_ptr<const std::vector<FrameMeaning>> said{}; ///< packets that bytes complete; never empty

    [[nodiscard]] const FrameMeaning *packet() const { return said ? &said->front() : nullptr; }
};

/// Makes rows of all records of one link, given in their order: what a row says because of those before it.
class FrameSuccession {
public:
    explicit FrameSuccession(LinkKind kind)
        : m_follower(families())
        , m_packets(families(), kind)
    {
    }
    [[nodiscard]] FrameRow next(TrafficRecord record);
    /// The next of each identifier is the first.
    void forgetTimes();

private:
    FrameFollower m_follower;
    ByteFollower m_packets;
    std::map<TrafficKey, Instant> m_last;
    std::map<std::pair<Direction, std::string_view>, Instant> m_lastPacket; ///< by its name
};

} // namespace mb
