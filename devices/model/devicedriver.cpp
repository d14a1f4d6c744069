// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/devicedriver.h"

#include "model/family.h"

namespace mb {

DeviceDriver::DeviceDriver(const Family &family)
    : m_family(family)
{
}

Task<void> DeviceDriver::mayWrite(ParameterIndex index, std::int64_t raw, std::span<const ParameterChange> before)
{
    const Parameter &parameter = m_family.parameters[index.value];
    if (parameter.access == Access::ReadOnly)
        co_return fail(Fault::OutOfRange, say("%1 is read-only", parameter.key));
    if (!offers(index))
        co_return fail(Fault::Unsupported, say("%1 does not exist in this device's dialect", parameter.key));
    co_await doMayWrite(index, raw, before);
    co_return {};
}

Task<void> DeviceDriver::identify()
{
    co_return fail(Fault::Unsupported, say("%1 cannot blink", m_family.title));
}

Task<void> DeviceDriver::rename(std::string)
{
    co_return fail(Fault::Unsupported, say("%1 has no name", m_family.title));
}

Task<void> DeviceDriver::doMayWrite(ParameterIndex, std::int64_t, std::span<const ParameterChange>)
{
    co_return {};
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
