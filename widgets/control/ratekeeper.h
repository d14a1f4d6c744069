// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/workbench.h"

#include <QTimer>

#include <deque>

namespace mb {

/// Asks a device for faster telemetry while a page needs it, and puts its own rates back afterwards. A rate is an
/// operation of the device, so requests go one by one, each when the device is free.
class RateKeeper : public QObject {
    Q_OBJECT
public:
    struct Wish {
        std::string_view channel;
        double hertz = 0.0;
    };

    RateKeeper(Workbench &workbench, std::vector<Wish> wishes, QObject *parent);
    /// Whose telemetry is to be fast; nobody's for an empty id.
    void follow(DeviceId device);

private:
    struct Request {
        DeviceId device;
        ChannelIndex channel;
        double hertz = 0.0;
    };
    void queue(DeviceId device, bool fast);
    void sendNext();

    Workbench &m_workbench;
    std::vector<Wish> m_wishes;
    DeviceId m_device;
    std::deque<Request> m_requests;
    QTimer m_timer;
};

} // namespace mb
