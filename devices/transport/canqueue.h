// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "transport/canlink.h"
#include "wire/canframe.h"

#include <deque>
#include <string>
#include <vector>

namespace mb {

/// Frames that an interface does not take yet, in order, urgent ones first.
///
/// An order that nobody has taken for `mostPatience` is not sent any more: whoever gave it up must not see it carried out once the
/// cable is back. What was urgent once is a stop, and waits on. Thread of its link.
class CanQueue {
public:
    static constexpr std::size_t mostWaiting = 8192; ///< of each priority: seconds of a full bus
    static constexpr Duration mostPatience = std::chrono::milliseconds(500);

    explicit CanQueue(const Clock &clock)
        : m_clock(clock)
    {
    }
    [[nodiscard]] std::size_t size() const { return m_urgent.size() + m_normal.size(); }
    [[nodiscard]] bool isEmpty() const { return m_urgent.empty() && m_normal.empty(); }

    /// A frame is to be sent: an urgent one takes the place of what waits for the same identifier, and of itself. LinkLost when too many
    /// wait on the link of this name.
    [[nodiscard]] Result<void> admit(const CanFrame &frame, Priority priority, const std::string &link);
    /// Nothing goes before it.
    [[nodiscard]] bool isNext(Priority priority) const
    {
        return m_urgent.empty() && (priority == Priority::Urgent || m_normal.empty());
    }
    /// It waits, since CanFrame::time.
    void push(const CanFrame &frame, Priority priority);
    struct Next {
        CanFrame frame;
        Priority priority = Priority::Normal;
    };
    /// Takes the first out. Whoever offers it to the interface says what became of it.
    [[nodiscard]] Next take();
    void wentOut(const Next &next);
    /// It is the first again; false when a stop has taken its place meanwhile.
    bool putBack(const Next &next);
    /// Drops what nobody has taken for too long; how many those are.
    std::size_t dropStale();
    void clear();

private:
    [[nodiscard]] bool isStop(const CanFrame &frame) const;

    const Clock &m_clock;
    std::deque<CanFrame> m_urgent;
    std::deque<CanFrame> m_normal;
    Instant m_frontSince{};        ///< the first of m_normal is the first
    std::vector<CanFrame> m_stops; ///< what was urgent, each content once
};

} // namespace mb
