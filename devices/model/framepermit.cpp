// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/framepermit.h"

namespace mb {
namespace {

std::vector<const DeviceView *> addressed(const FrameMeaning &meaning, const std::string &link, const Snapshot &shot)
{
    std::vector<const DeviceView *> found;
    for (const DeviceView &device : shot.devices) {
        if (device.link == link && device.family && device.family->key == meaning.family->key
            && device.identity->address == meaning.frame.address)
            found.push_back(&device);
    }
    return found;
}

Result<void> mayDrive(const std::vector<const DeviceView *> &devices, const FrameMeaning &meaning,
    const std::function<bool(DeviceId)> &isArmed)
{
    const std::string name = std::string(meaning.family->title) + " #" + std::to_string(meaning.frame.address);
    if (devices.empty())
        return fail(
            Fault::Unsafe, say("no %1 is known on this link, so STOP could not reach it", name), say("scan first"));
    if (devices.size() > 1)
        return fail(Fault::Unsafe, say("two units answer as %1", name), say("assign one a new number first"));
    const DeviceView &device = *devices.front();
    if (!device.family->capabilities.watchdog)
        return fail(Fault::Unsafe, say("%1 keeps its last set-point for ever: it has no watchdog", name),
            say("drive it from the Tune page"));
    if (!device.busy.empty())
        return fail(Fault::Unsafe, say("%1 is busy: %2", name, device.busy));
    if (device.motion.running)
        return fail(Fault::Unsafe, say("%1 is driven already", name), say("halt it first"));
    if (!device.mayNotMove.empty())
        return fail(Fault::Unsafe, device.mayNotMove);
    if (!isArmed(device.id))
        return fail(Fault::Unsafe, say("%1 is not armed", name), say("select it, then hold Arm in the header"));
    return {};
}

Result<void> takesFrames(const LinkView *link)
{
    if (link && link->state == LinkState::Open && link->kind == LinkKind::Can)
        return {};
    if (link && link->kind == LinkKind::Can && !link->reason.empty())
        return fail(Fault::LinkLost, link->reason);
    return fail(Fault::Unsafe, say("no open CAN link is shown"), say("open one first"));
}

} // namespace

FramePermit permitFor(const CanFrame &frame, const std::string &link, const Snapshot &shot,
    std::span<const Family *const> families, const std::function<bool(DeviceId)> &isArmed)
{
    const FrameDecoder decoder = decoderFor(families, shot, link);
    FramePermit permit;
    permit.meaning = decoder.control(frame);
    permit.control = permit.meaning.has_value();
    if (!permit.control)
        permit.meaning = decoder.decode(frame);
    Result<void> allowed = takesFrames(shot.link(link));
    if (allowed && permit.control) {
        const auto devices = addressed(*permit.meaning, link, shot);
        allowed = mayDrive(devices, *permit.meaning, isArmed);
        if (allowed)
            permit.device = devices.front()->id;
    }
    if (!allowed)
        permit.refusal = allowed.error();
    return permit;
}

} // namespace mb
