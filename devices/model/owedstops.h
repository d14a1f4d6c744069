// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/devicebook.h"
#include "model/motionguard.h"

#include <string>
#include <string_view>
#include <vector>

namespace mb {

/// Stops that are owed to motors which nobody has seen stand: their link was closed before, or another run of the program left them.
/// They are in the guardians' book of their line, which every program sees; what no book takes is kept here. Sent when their line is
/// open again, or within a second where it is open already, for DeviceStop::debtLimit; each ends when its device was seen to stand,
/// when a guardian has stopped it, or when its user has looked. Thread of the session.
class OwedStops {
public:
    /// All of them outlive it. Without a guard nothing is known of other runs.
    OwedStops(Clock &clock, DeviceBook &devices, MotionGuard *guard);

    /// Those whose device does not show its own stop or motion. As of the last change of ours, or of the last second.
    [[nodiscard]] std::vector<OwedStop> unseen() const;
    /// As of the same moment; whether or not its device follows it. An older one than DeviceStop::debtLimit is only shown.
    [[nodiscard]] bool isOwed(std::string_view line, std::string_view selector) const;
    /// A link was opened: what is owed on its line, now or later, is this program's business, and is sent before anything else.
    void pay(Link &link);
    /// The link of a device is closed while nobody has seen its motor stand: the stop stays.
    void add(Device &device);
    /// To a device that was found, or whose link is back: from now on its own stop follows it up; where it may not be told now, as soon
    /// as it may. One that this program has driven since is not told: the newer order counts, and its own stop settles the debt.
    void passTo(Device &device);
    /// The device was seen to stand.
    void settle(const Device &device) { settle(device.link().line(), device.selector()); }
    /// It was closed or lost: what is owed on its line is the guardians' again, unless that is open here under another name, too.
    void leave(const Link &link);
    /// The user has looked at the motors: nothing is owed any more.
    void dismiss();

private:
    /// From its opening until it is left.
    struct Line {
        Link *link;
        bool isOurs = false; ///< nobody else's business
        std::vector<OwedStop> sent{};
    };

    void look();
    void read();
    void sendDue();
    void settle(const std::string &line, const std::string &device);
    [[nodiscard]] bool isFollowed(const OwedStop &owed, const Link *on = nullptr) const; ///< by a device on any link

    Clock &m_clock;
    DeviceBook &m_devices;
    MotionGuard *m_guard;
    std::vector<OwedStop> m_unbooked;
    std::vector<OwedStop> m_owed; ///< those and what is in the books
    std::vector<Line> m_lines;
    Timer m_look;
};

} // namespace mb
