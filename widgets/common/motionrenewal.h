// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/workbench.h"

#include <QTimer>

namespace mb {

/// LeaseRenewal of the window, for as long as it is told to: by the window's own thread, so that a window
/// that hangs lets its motors stop. GUI thread.
class MotionRenewal : public QObject {
public:
    explicit MotionRenewal(Workbench &workbench);
    /// From now on these; none ends it.
    void keep(std::vector<DeviceId> devices);
    /// What is kept is renewed only while this says so.
    void setCondition(std::function<bool()> condition) { m_condition = std::move(condition); }
    /// The longest time between two renewals since keep(), until now.
    [[nodiscard]] Duration silence() const;

private:
    void renew();

    Workbench &m_workbench;
    std::vector<DeviceId> m_devices;
    std::function<bool()> m_condition;
    Instant m_renewedAt{};
    Duration m_silence{};
    QTimer m_timer;
};

} // namespace mb
