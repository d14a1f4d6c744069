// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/session.h"

#include <QObject>

#include <map>

namespace mb {

/// The one device that tree and pages agree on, and which of its axes.
class Selection : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    [[nodiscard]] DeviceId device() const { return m_device; }
    /// 1…, or 0: the device as a whole.
    [[nodiscard]] int axis() const { return m_axis; }
    /// Where one motor must be meant: that axis, or of the device as a whole the one that was selected last, or the first.
    [[nodiscard]] int motor() const
    {
        const auto last = m_lastAxis.find(m_device);
        return last == m_lastAxis.end() ? 1 : last->second;
    }
    /// Somebody chooses.
    void select(DeviceId device, int axis = 0)
    {
        change(device, axis);
        keep();
    }
    /// The program chooses, while nobody has.
    void offer(DeviceId device)
    {
        if (!m_kept)
            change(device, 0);
    }
    /// Somebody works with what is selected, whoever chose it: the program chooses no other from now on.
    void keep()
    {
        m_kept = m_device.value != 0;
        Q_EMIT kept();
    }

Q_SIGNALS:
    void changed();
    /// Somebody has chosen, or works.
    void kept();

private:
    void change(DeviceId device, int axis)
    {
        if (axis > 0)
            m_lastAxis[device] = axis;
        if (device == m_device && axis == m_axis)
            return;
        m_device = device;
        m_axis = axis;
        Q_EMIT changed();
    }

    DeviceId m_device;
    int m_axis = 0;
    bool m_kept = false;
    std::map<DeviceId, int> m_lastAxis;
};

} // namespace mb
