// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/standstill.h"

#include "async/sleep.h"

namespace mb {
namespace {
constexpr Duration masterListen = std::chrono::milliseconds(150); // another master sends at least this often
} // namespace

Task<void> hasNoOtherMaster(Device &device)
{
    if (device.identity().state == DeviceState::Bootloader)
        co_return {};
    co_await Sleep(device.clock(), masterListen);
    if (device.liveness().foreignMaster)
        co_return fail(
            Fault::Unsafe, say("another program or controller drives this unit"), say("stop it there first"));
    co_return {};
}

Task<void> standsStill(Device &device)
{
    co_await device.link().address().takesOrders(); // time may stand there: it would be waited for without end
    if (device.identity().state == DeviceState::Duplicate)
        co_return fail(Fault::Unsafe, say("several units answer as number %1", device.identity().address),
            say("take the other one off, or give one of them another number"));
    co_await hasNoOtherMaster(device);
    if (device.identity().state != DeviceState::Bootloader && device.liveness().moving)
        co_return fail(Fault::Unsafe, say("its motor is turning or driven already"), say("bring it to rest first"));
    co_return {};
}

} // namespace mb
