// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"
#include "support/mutedevice.h"
#include "transport/canlink.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace mb::test {

/// A CAN link that only logs what is sent, with whatever outlet a test wants.
class LoggedLink final : public CanLink {
public:
    LoggedLink(Clock &clock, Outlet outlet)
        : CanLink(LinkAddress{"socketcan", "can7", {}}, clock)
        , m_outlet(outlet)
    {
    }
    using Link::lose;

    std::vector<std::string> sent;

private:
    Result<void> doOpen() override { return {}; }
    void doClose() override { }
    [[nodiscard]] Outlet doOutlet() const override { return m_outlet; }
    Result<void> doSend(const CanFrame &frame, Priority) override
    {
        sent.push_back(toText(frame));
        return {};
    }
    [[nodiscard]] std::size_t doBacklog() const override { return 0; }
    [[nodiscard]] int doBitrate() const override { return 0; }

    Outlet m_outlet;
};

inline constexpr Mode looseModes[] = {Mode::Duty};

/// A family whose drive has no watchdog: 00000100#01 drives it, 00000100#00 stops it, and it says nothing.
inline constexpr Family looseFamily = [] {
    Family family;
    family.key = "loose";
    family.title = "Loose motor";
    family.modes = looseModes;
    family.capabilities.watchdog = false;
    return family;
}();

class LooseMotor final : public MuteDevice {
public:
    LooseMotor(CanLink &link, Clock &clock, const Family &family = looseFamily)
        : MuteDevice(family, link, clock, {})
        , m_link(link)
    {
    }

    bool seenStopped = false;
    bool refuses = false; ///< to be driven
    StopScript script{{{extendedFrame(0x100, {0}), {}, {}, {}, std::chrono::milliseconds(5), 2}}};

private:
    /// It counts as moving at once, which its listeners hear from inside the command.
    Result<void> doCommand(const SetPoint &) override
    {
        if (refuses)
            return fail(Fault::Refused, say("not now"));
        tellMoving(true);
        return m_link.send(extendedFrame(0x100, {1}));
    }
    void doStop() override
    {
        (void)m_link.send(extendedFrame(0x100, {0}), Priority::Urgent);
        tellMoving(false);
    }
    void tellMoving(bool moving)
    {
        Liveness now = liveness();
        now.moving = moving;
        setLiveness(now);
    }
    [[nodiscard]] StopScript stopScript() const override { return script; }
    [[nodiscard]] bool isSeenStopped() const override { return seenStopped; }

    CanLink &m_link;
};

} // namespace mb::test
