// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/stopscript.h"

#include "transport/canlink.h"
#include "transport/seriallink.h"
#include "transport/spilink.h"

namespace mb {

void sendScript(Link &link, const StopScript &script)
{
    for (const StopStep &step : script.steps) {
        if (link.kind() == LinkKind::Can && step.frame)
            (void)static_cast<CanLink &>(link).send(*step.frame, Priority::Urgent);
        else if (link.kind() == LinkKind::Serial)
            (void)static_cast<SerialLink &>(link).send(step.bytes, Priority::Urgent);
        else if (link.kind() == LinkKind::Spi)
            (void)static_cast<SpiLink &>(link).sendUrgent(step.bytes);
    }
}

} // namespace mb
