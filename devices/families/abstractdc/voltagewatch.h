// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/abstractdc/protocol.h"
#include "transport/canlink.h"

#include <optional>
#include <vector>

namespace mb::abstractdc {

/// Whose voltage log it is: the answers of all drives have one identifier (1.2). Everybody on the link who asks is seen here, this
/// program's other drives and other hosts as well; an answer belongs to the only one that was asked, else to nobody.
class VoltageWatch {
public:
    VoltageWatch(CanLink &link, Clock &clock);

    /// Nobody's answer is awaited, so that one may be asked for.
    [[nodiscard]] bool isFree() const;
    /// Offset of the drive that sent the voltage log which is passing now; for listeners of `received`.
    [[nodiscard]] std::optional<int> owner() const { return m_owner; }

private:
    void pass(const CanFrame &frame);

    Clock &m_clock;
    CanLink &m_link;
    /// A drive whose answer may come until then.
    struct Asked {
        int offset = 0;
        Instant until{};
    };
    void positionOf(int offset);

    std::vector<Asked> m_open;
    std::vector<Asked> m_positions; ///< asked for their position with the firmware's code
    std::optional<int> m_owner;
    Subscription m_traffic;
};

/// How long an answer may take on this link (1.3): twice request and answer, and 20 ms. A link that does not know its bit rate
/// is taken for a slow one with other programs on it, which take their time.
[[nodiscard]] Duration answerTime(const CanLink &link);
/// Request and answer on the wire.
[[nodiscard]] Duration roundTrip(const CanLink &link);

} // namespace mb::abstractdc
