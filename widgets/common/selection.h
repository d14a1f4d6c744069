// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/session.h"

#include <QObject>

namespace mb {

/// The one device that tree and pages agree on, and which of its axes.
class Selection : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    [[nodiscard]] DeviceId device() const { return m_device; }
    /// 1…, or 0: the device as a whole.
    [[nodiscard]] int axis() const { return m_axis; }
    void select(DeviceId device, int axis = 0)
    {
        if (device == m_device && axis == m_axis)
            return;
        m_device = device;
        m_axis = axis;
        Q_EMIT changed();
    }

Q_SIGNALS:
    void changed();

private:
    DeviceId m_device;
    int m_axis = 0;
};

} // namespace mb
