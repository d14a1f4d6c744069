// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/guardian/client/wirescript.h"

#include <algorithm>
#include <cstddef>
#include <cstring>

#include <linux/can.h>

namespace mb {
namespace {

guardian::Bytes rawFrame(const CanFrame &frame)
{
    can_frame raw{};
    raw.can_id = frame.id | (frame.extended ? CAN_EFF_FLAG : 0U) | (frame.remote ? CAN_RTR_FLAG : 0U);
    raw.can_dlc = frame.size;
    std::memcpy(raw.data, frame.data.data(), frame.size);
    guardian::Bytes bytes(sizeof raw);
    std::memcpy(bytes.data(), &raw, sizeof raw);
    return bytes;
}

std::optional<CanFrame> frameOf(const guardian::Bytes &bytes)
{
    can_frame raw{};
    if (bytes.size() != sizeof raw)
        return std::nullopt;
    std::memcpy(&raw, bytes.data(), sizeof raw);
    CanFrame frame;
    frame.extended = (raw.can_id & CAN_EFF_FLAG) != 0;
    frame.remote = (raw.can_id & CAN_RTR_FLAG) != 0;
    frame.id = raw.can_id & (frame.extended ? CAN_EFF_MASK : CAN_SFF_MASK);
    frame.size = raw.can_dlc <= CAN_MAX_DLEN ? raw.can_dlc : std::uint8_t{0};
    std::memcpy(frame.data.data(), raw.data, frame.size);
    return frame;
}

/// As it is written to the descriptor.
guardian::Step stepOf(const StopStep &step, Outlet::Form form)
{
    guardian::Step made{step.bytes, step.reply, step.replyMask, step.wait, step.attempts};
    if (made.mask.empty())
        made.mask.assign(made.reply.size(), 0xFF);
    if (form == Outlet::Form::CanSocket && step.frame)
        made.bytes = rawFrame(*step.frame);
    if (form == Outlet::Form::CanSocket && step.replyFrame) {
        made.reply = rawFrame(*step.replyFrame);
        made.mask.assign(made.reply.size(), 0);
        std::fill_n(made.mask.begin(), offsetof(can_frame, __pad), std::uint8_t{0xFF}); // identifier and length
    }
    if (form == Outlet::Form::SpiSocket) { // docs/names.md#links: as many bytes and the ready line come back
        const std::size_t size = step.bytes.size();
        made.bytes.insert(
            made.bytes.begin(), {static_cast<std::uint8_t>(size & 0xFFU), static_cast<std::uint8_t>(size >> 8U)});
        made.reply.assign(size + 1, 0);
        made.mask.assign(size + 1, 0);
    }
    return made;
}

} // namespace

guardian::Script wireScript(const StopScript &script, Outlet::Form form)
{
    guardian::Script made;
    for (const StopStep &step : script.steps)
        made.push_back(stepOf(step, form));
    return made;
}

StopScript scriptFromWire(const guardian::Script &script, Outlet::Form form)
{
    StopScript made;
    for (const guardian::Step &step : script) {
        StopStep one{std::nullopt, step.bytes, step.reply, step.mask, step.wait, step.attempts, std::nullopt};
        if (form == Outlet::Form::CanSocket) {
            one.frame = frameOf(step.bytes);
            one.replyFrame = frameOf(step.reply);
            one.bytes.clear();
            one.reply.clear();
            one.replyMask.clear();
        }
        if (form == Outlet::Form::SpiSocket && one.bytes.size() > 2) {
            one.bytes.erase(one.bytes.begin(), one.bytes.begin() + 2);
            one.reply.clear();
            one.replyMask.clear();
        }
        made.steps.push_back(std::move(one));
    }
    return made;
}

std::optional<guardian::PortForm> portFormOf(Outlet::Form form)
{
    switch (form) {
    case Outlet::Form::CanSocket: return guardian::PortForm::Packet;
    case Outlet::Form::Stream:
    case Outlet::Form::SpiSocket: return guardian::PortForm::Stream;
    case Outlet::Form::SpiDevice: return guardian::PortForm::Spi;
    case Outlet::Form::None:
    case Outlet::Form::InProcess: break;
    }
    return std::nullopt;
}

} // namespace mb
