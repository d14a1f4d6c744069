// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/device.h"

#include "model/family.h"

namespace mb {

Device::Device(const Family &family, Link &link, Clock &clock, Identity identity)
    : m_family(family)
    , m_link(link)
    , m_clock(clock)
    , m_identity(std::move(identity))
    , m_parameters(family.parameters)
    , m_telemetry(std::make_shared<Telemetry>(family.channels))
    , m_guard(*this)
{
}

Device::~Device() = default;

void Device::setIdentity(Identity identity)
{
    if (identity == m_identity)
        return;
    m_identity = std::move(identity);
    m_changed.notify();
}

void Device::setLiveness(const Liveness &liveness)
{
    if (liveness == m_liveness)
        return;
    m_liveness = liveness;
    m_changed.notify();
}

Task<std::int64_t> Device::read(ParameterIndex index)
{
    if (m_parameters.parameter(index).access == Access::WriteOnly)
        co_return fail(
            Fault::Unsupported, std::string(m_parameters.parameter(index).key) + " cannot be read from the device");
    auto task = doRead(index);
    const Result<std::int64_t> raw = co_await std::move(task).attempt();
    if (raw)
        m_parameters.setRead(index, *raw);
    else
        m_parameters.setFailed(index);
    co_return raw;
}

Task<std::int64_t> Device::write(ParameterIndex index, std::int64_t raw)
{
    const Parameter &parameter = m_parameters.parameter(index);
    if (parameter.access == Access::ReadOnly)
        co_return fail(Fault::OutOfRange, std::string(parameter.key) + " is read-only");
    auto task = doWrite(index, raw);
    const Result<std::int64_t> inForce = co_await std::move(task).attempt();
    if (inForce && parameter.nature != Nature::Counter)
        m_parameters.setWritten(index, *inForce);
    if (inForce && m_family.capabilities.storesAtOnce)
        m_parameters.setAllStored();
    co_return inForce;
}

Result<void> Device::mayMove() const
{
    if (!m_busy.empty())
        return fail(Fault::Unsafe, selector() + ": " + m_busy);
    if (m_link.state() != LinkState::Open)
        return fail(Fault::LinkLost, m_link.address().shortName() + ": " + m_link.reason());
    if (m_link.address().isRecording())
        return fail(Fault::Unsupported,
            m_link.address().shortName()
                + " is a recording: what is in it can be watched, not driven; open the link that it was made on");
    switch (m_identity.state) {
    case DeviceState::Duplicate:
        return fail(Fault::Unsafe,
            "several units answer as number " + std::to_string(m_identity.address)
                + "; control is locked until one has another number");
    case DeviceState::Unassigned:
        return fail(Fault::Unsafe, "this unit has no number yet; assign one before it is driven");
    case DeviceState::Bootloader:
        return fail(Fault::Unsafe, "no application runs in this unit; update its firmware first");
    case DeviceState::Online: break;
    }
    if (m_liveness.foreignMaster)
        return fail(Fault::Unsafe, "another master drives " + selector() + "; stop it there first");
    return m_guard.possible();
}

Result<void> Device::command(const SetPoint &setPoint)
{
    if (setPoint.mode == Mode::Off) {
        if (m_family.capabilities.axes > 1)
            return doCommand(setPoint); // the other axes go on
        stop();
        return {};
    }
    if (auto allowed = mayMove(); !allowed)
        return allowed;
    if (!m_guard.stands())
        return fail(Fault::Unsafe, m_guard.reason());
    if (auto checked = doCheck(setPoint); !checked)
        return checked;
    return doCommand(setPoint);
}

Result<void> Device::releaseMoves()
{
    if (auto allowed = mayMove(); !allowed)
        return allowed;
    return doReleaseMoves();
}

Result<void> Device::doReleaseMoves()
{
    return fail(Fault::Unsupported, std::string(m_family.title) + " has no buffered moves");
}

void Device::stop()
{
    m_stoppedAt = m_clock.now();
    doStop();
}

} // namespace mb
