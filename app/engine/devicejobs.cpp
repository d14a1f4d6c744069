// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/engine/devicejobs.h"

namespace mb {

void DeviceJobs::carryOut(const orders::Identify &order, const Finished &finished)
{
    m_context.operations.begin(
        order.device, {say("Identify"), OperationKind::Look},
        [](Device &device, Progress &) { return device.identify(); }, finished);
}

void DeviceJobs::carryOut(const orders::Rename &order, const Finished &finished)
{
    m_context.operations.begin(
        order.device, say("Rename"), [name = order.name](Device &device, Progress &) { return device.rename(name); },
        finished);
}

void DeviceJobs::carryOut(const orders::Renumber &order, const Finished &finished)
{
    m_context.operations.begin(
        order.device, say("Assign number"),
        [log = m_parameters.log(), address = order.address](Device &device, Progress &progress) {
            return settings::renumberKept(device, address, settings::Origin::Window, log, progress);
        },
        finished);
}

void DeviceJobs::carryOut(const orders::ClearFaults &order, const Finished &finished)
{
    m_context.operations.begin<std::vector<FaultRecord>>(
        order.device, say("Read and clear faults"), [](Device &device, Progress &) { return device.clearFaults(); },
        [finished](Operations::Job &, const Result<std::vector<FaultRecord>> &faults) {
            finished(faults ? Result<void>() : fail(faults.error()));
        },
        finished);
}

void DeviceJobs::carryOut(const orders::Calibrate &order, const Finished &finished)
{
    Device *device = m_context.session.find(order.device);
    if (device && m_context.session.stream(*device).isRunning()) // its set-points are computed from it
        finished(fail(Fault::Unsafe, say("stop the motor before its calibration is changed")));
    else
        finished(device ? device->knowledge().calibrate(order.key, order.value)
                        : fail(Fault::Timeout, say("the device is gone")));
}

void DeviceJobs::carryOut(const orders::SetDialect &order, const Finished &finished)
{
    Device *device = m_context.session.find(order.device);
    if (device && m_context.session.stream(*device).isRunning())
        finished(fail(Fault::Unsafe, say("stop the motor before its dialect is changed")));
    else
        finished(device ? device->knowledge().setDialect(order.key) : fail(Fault::Timeout, say("the device is gone")));
}

} // namespace mb
