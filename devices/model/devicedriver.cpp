// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/devicedriver.h"

#include "model/family.h"

namespace mb {

DeviceDriver::DeviceDriver(const Family &family)
    : m_family(family)
{
}

Result<void> DeviceDriver::doReleaseMoves()
{
    return fail(Fault::Unsupported, say("%1 has no buffered moves", m_family.title));
}

Task<void> DeviceDriver::doRestart()
{
    co_return fail(
        Fault::Unsupported, say("%1 cannot be restarted from here", m_family.title), say("switch it off and on"));
}

Task<void> DeviceDriver::zeroPosition()
{
    co_return fail(Fault::Unsupported, say("%1 has no command that zeroes its position", m_family.title));
}

} // namespace mb
