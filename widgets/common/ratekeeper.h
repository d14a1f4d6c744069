// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/workbench.h"

#include <QTimer>

#include <map>
#include <set>
#include <vector>

namespace mb {

/// Asks devices for faster telemetry of what pages show, and puts their own rates back once nobody shows it. One per
/// workbench, shared by the pages: of several wishes for one channel the highest counts. A rate is an operation of the
/// device, so requests go one by one, each when the device is free.
class RateKeeper : public QObject {
    Q_OBJECT
public:
    struct Wish {
        DeviceId device;
        ChannelIndex channel;
        double hertz = 0.0;
    };

    /// The one of this workbench, made when first needed.
    [[nodiscard]] static RateKeeper &of(Workbench &workbench);
    /// What a page wishes from now on instead of what it wished before; nothing when it is hidden. Page: who, no more.
    void wish(const QObject *page, const std::vector<Wish> &wishes);
    /// A page that only shows a device may do this; to others its telemetry is a setting, and only who drives it changes it.
    [[nodiscard]] static bool isFree(const DeviceView &device)
    {
        const bool recorded = device.link.rfind("replay:", 0) == 0; // nothing is asked there
        return !recorded && (device.family->capabilities.freeRates || device.motion.running);
    }

private:
    using Place = std::pair<DeviceId, ChannelIndex>;

    explicit RateKeeper(Workbench &workbench);
    [[nodiscard]] double wished(const Place &place) const;
    [[nodiscard]] bool isFreeNow(DeviceId device) const;
    void sendNext();

    Workbench &m_workbench;
    std::map<const QObject *, std::map<Place, double>> m_wishes;
    std::map<Place, double> m_sent; ///< what the devices were asked for
    QTimer m_timer;
};

} // namespace mb
