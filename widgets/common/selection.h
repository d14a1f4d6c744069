// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/session.h"

#include <QObject>

namespace mb {

/// The one device that tree and pages agree on.
class Selection : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    [[nodiscard]] DeviceId device() const { return m_device; }
    void select(DeviceId device)
    {
        if (device == m_device)
            return;
        m_device = device;
        Q_EMIT changed();
    }

Q_SIGNALS:
    void changed();

private:
    DeviceId m_device;
};

} // namespace mb
