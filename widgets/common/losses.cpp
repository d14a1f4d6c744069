// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/losses.h"

namespace mb {

SampleCount samplesOf(const DeviceView &device)
{
    SampleCount count;
    for (std::uint16_t i = 0; device.telemetry && i < device.telemetry->channels().size(); ++i) {
        count.kept += device.telemetry->size({i});
        count.lost += device.telemetry->lost({i});
    }
    return count;
}

SampleCount samplesOn(const Snapshot &shot, std::string_view link)
{
    SampleCount count;
    for (const DeviceView &device : shot.devices) {
        if (!link.empty() && device.link != link)
            continue;
        const SampleCount of = samplesOf(device);
        count.kept += of.kept;
        count.lost += of.lost;
    }
    return count;
}

} // namespace mb
