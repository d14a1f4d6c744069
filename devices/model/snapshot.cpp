// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/snapshot.h"

#include "model/unit.h"
#include "transport/seriallink.h"
#include "transport/spilink.h"

#include <algorithm>

namespace mb {

const DeviceView *Snapshot::device(DeviceId id) const
{
    const auto found = std::ranges::find(devices, id, &DeviceView::id);
    return found == devices.end() ? nullptr : &*found;
}

const LinkView *Snapshot::link(std::string_view address) const
{
    const auto found = std::ranges::find(links, address, &LinkView::address);
    return found == links.end() ? nullptr : &*found;
}

const OperationView *Snapshot::operation(DeviceId device) const
{
    const auto found = std::find_if(
        operations.rbegin(), operations.rend(), [device](const OperationView &o) { return o.device == device; });
    return found == operations.rend() ? nullptr : &*found;
}

const SetPoint *MotionView::on(int axis) const
{
    const auto found = std::ranges::find(setPoints, axis, &SetPoint::axis);
    return !running || found == setPoints.end() ? nullptr : &*found;
}

std::span<const Channel> DeviceView::channels() const
{
    return telemetry ? telemetry->channels() : family->channels;
}

DeviceView viewOf(Session &session, Device &device)
{
    DeviceView view;
    view.id = session.idOf(device);
    view.family = &device.family();
    view.identity = device.sharedIdentity();
    view.selector = device.selector();
    view.link = device.link().address().text();
    view.unit = unitKeyOf(device.identity(), device.link().line(), device.link().address().isSimulated());
    view.liveness = device.liveness();
    view.origin = device.gate().origin();
    view.states = device.states();
    view.busy = device.gate().busy();
    const SetPointStream &stream = session.stream(device);
    view.motion = {stream.isRunning(), stream.setPoint(), stream.setPoints(), stream.end(), stream.reason()};
    view.telemetry = device.telemetry();
    for (std::size_t i = 0; i < view.family->channels.size(); ++i)
        view.rates.push_back(device.telemetry()->rate({static_cast<std::uint16_t>(i)}, device.clock().now()));
    view.parameters = device.parameters().sharedEntries();
    view.parameterRevision = device.parameters().revision();
    view.lastWrite = device.parameters().lastWrite();
    view.profile = device.knowledge().sharedProfile();
    if (auto allowed = device.mayMove(); !allowed)
        view.mayNotMove = allowed.error().message();
    view.stop = device.stopping().state();
    view.stopsMotion = device.stopping().isForMotion();
    view.mayTurn = device.stopping().mayTurn();
    if (auto allowed = device.mayStop(); !allowed)
        view.mayNotBeStopped = allowed.error().message();
    view.kept = device.gate().kept();
    return view;
}

LinkView viewOf(const Link &link, const Clock &clock)
{
    const Instant now = clock.now();
    LinkView view;
    view.time = now;
    view.address = link.address().text();
    view.name = link.address().shortName();
    view.kind = link.kind();
    view.state = link.state();
    view.reason = link.loss().message();
    view.simulated = link.address().isSimulated();
    view.counters = link.counters();
    if (link.kind() == LinkKind::Can) {
        const auto &can = static_cast<const CanLink &>(link);
        view.bitrate = can.bitrate();
        view.load = can.load(now);
        view.health = can.health();
    } else if (link.kind() == LinkKind::Serial) {
        const auto &serial = static_cast<const SerialLink &>(link);
        view.bitrate = serial.baudrate();
        view.load = serial.load(now);
        view.roundTrip = serial.roundTrip();
    } else {
        const auto &spi = static_cast<const SpiLink &>(link);
        view.bitrate = spi.clockRate();
        view.load = spi.load(now);
    }
    if (const auto *replay = dynamic_cast<const ReplayLink *>(&link))
        view.replay = replay->replay();
    if (view.replay && view.replay->length > Duration::zero()) // of the same instant
        view.time = Instant(view.replay->start + view.replay->position - clock.unixOffset());
    return view;
}

} // namespace mb
