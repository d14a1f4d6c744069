// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/supermodified/frame.h"
#include "model/device.h"
#include "support/simulatedsession.h"
#include "transport/canlink.h"
#include "transport/seriallink.h"
#include "wire/canframe.h"

#include <chrono>

namespace mb::test {

/// Another program orders something of this unit, over its own end of the same wire, until the device tells of it: of a DMC60C 5, an
/// Abstract DC Drive 3 and any Supermodified.
inline void commandElsewhere(Link &other, VirtualClock &clock, Device &device)
{
    ASSERT_TRUE(other.open());
    if (auto *const can = dynamic_cast<CanLink *>(&other)) {
        const bool isDigilent = device.family().key == "dmc60c";
        ASSERT_TRUE(can->send(*canFrameFromText(isDigilent ? "02060005#0000000010270000" : "067#0410000000")));
        for (int i = 0; i < 5 && !device.liveness().foreignMaster; ++i) // other frames may stand before it
            clock.advance(std::chrono::milliseconds(1));
    } else {
        auto &serial = dynamic_cast<SerialLink &>(other);
        ASSERT_TRUE(serial.setBaudrate(dynamic_cast<SerialLink &>(device.link()).baudrate()));
        const supermodified::Frame halt{static_cast<std::uint8_t>(device.identity().address), 2,
            static_cast<std::uint8_t>(supermodified::Command::Halt), 0, {}};
        for (int i = 0; i < 40 && !device.liveness().foreignMaster; ++i) { // some of them meet a question on the wire
            ASSERT_TRUE(serial.send(supermodified::uartBytes(halt)));
            clock.advance(std::chrono::microseconds(7300));
        }
    }
    EXPECT_TRUE(device.liveness().foreignMaster);
}

} // namespace mb::test
