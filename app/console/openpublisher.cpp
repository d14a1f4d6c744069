// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/openpublisher.h"

#include "app/console/mqttpublisher.h"
#include "app/console/udppublisher.h"

namespace mb::console {

Result<std::unique_ptr<Publisher>> openPublisher(const PublishAddress &address)
{
    if (address.scheme == "udp")
        return UdpPublisher::open(address);
    return MqttPublisher::open(address);
}

} // namespace mb::console
