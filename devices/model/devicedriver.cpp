// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/devicedriver.h"

#include "model/family.h"

namespace mb {
namespace {

Result<void> checkOutput(const SetPoint &setPoint, const Family &family)
{
    const OutputOptions &can = family.capabilities.output;
    const auto refused = [](const Message &why) { return fail(Fault::Unsupported, why, say("leave it out")); };
    if (setPoint.ramp != 0.0 && !can.ramps(setPoint.mode))
        return refused(say("%1 has no ramp of the output in mode '%2'", family.title, toString(setPoint.mode)));
    if (setPoint.brake && !can.brake)
        return refused(say("%1 cannot be told to brake or to coast", family.title));
    if ((setPoint.reverseMotor || setPoint.reverseSensor) && !can.directions)
        return refused(say("%1 cannot exchange directions", family.title));
    if (setPoint.overrideLimits && !can.limits)
        return refused(say("%1 has no limit override", family.title));
    return {};
}

} // namespace

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

Result<void> DeviceDriver::check(const SetPoint &setPoint) const
{
    MB_TRY_VOID(checkOutput(setPoint, m_family));
    return doCheck(setPoint);
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
