// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/control/arming.h"

#include <QTimer>

#include <vector>

namespace mb {

/// Several devices of one link under one arming: each gets a move that it keeps, then one command starts them all. The Arm
/// button is the lead's; the others live as long as it moves, renewed from the GUI thread as it is. Whoever stops takes the others
/// with it.
class GroupMotion : public QObject {
    Q_OBJECT
public:
    struct Member {
        DeviceId device;
        SetPoint setPoint;
    };

    GroupMotion(Workbench &workbench, Arming &arming, QObject *parent = nullptr);

    /// Hands out the moves; false, with a notice, when the lead is not armed or not among them.
    bool prepare(DeviceId lead, std::vector<Member> members);
    /// Starts what is prepared; false when not every device has acknowledged its move.
    bool start();
    /// All of them stay where they are.
    void hold();

    [[nodiscard]] bool isActive() const { return !m_members.empty(); }
    /// Every member has acknowledged its move, and none has begun.
    [[nodiscard]] bool isPrepared() const;
    [[nodiscard]] bool hasAcknowledged(DeviceId device) const;
    [[nodiscard]] bool isStarted() const { return m_started; }

Q_SIGNALS:
    void changed();

private:
    void follow();
    void end();
    void command(const Member &member);
    void letGo(const std::vector<Member> &staying);
    void released(bool begun);
    [[nodiscard]] const DeviceView *viewOf(DeviceId device) const { return m_workbench.snapshot().device(device); }

    Workbench &m_workbench;
    Arming &m_arming;
    DeviceId m_lead;
    std::vector<Member> m_members;
    std::vector<DeviceId> m_seen; ///< a snapshot has shown them running
    bool m_started = false;
    bool m_starting = false; ///< ordered, and not answered yet
    std::uint32_t m_order = 0;
    MotionRenewal m_renewal;
};

} // namespace mb
