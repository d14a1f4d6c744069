// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/virtualclock.h"
#include "playedkernel.h"
#include "support/datedclock.h"
#include "support/eventloop.h"
#include "transport/backends/cansocket.h"
#include "transport/backends/socketcan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <string>
#include <vector>

#include <linux/can.h>
#include <sys/socket.h>

namespace mb::test {

/// A SocketCanLink on a played kernel, in virtual time.
struct CanSocket : testing::Test {
    CanSocket()
    {
        kernel.networks = {PlayedKernel::controller(7, "can0")};
        clock.advance(10s);
        subscriptions.push_back(link->received().add([this](const CanFrame &frame) { frames.push_back(frame); }));
        subscriptions.push_back(link->batchEnded().add([this] { ++batches; }));
    }
    void open() { ASSERT_TRUE(link->open()); }
    void put(std::uint32_t id, std::initializer_list<std::uint8_t> bytes = {}) const
    {
        can_frame raw{};
        raw.can_id = id;
        raw.can_dlc = static_cast<std::uint8_t>(bytes.size());
        std::copy(bytes.begin(), bytes.end(), raw.data);
        ASSERT_EQ(::send(kernel.cable, &raw, sizeof raw, MSG_DONTWAIT), ssize_t(sizeof raw));
    }
    /// What went out since, as "ID#DATA", with the flags that the kernel sees.
    [[nodiscard]] std::vector<std::string> taken() const
    {
        std::vector<std::string> all;
        can_frame raw{};
        while (::recv(kernel.cable, &raw, sizeof raw, MSG_DONTWAIT) == ssize_t(sizeof raw))
            all.push_back(toText(frameOf(raw, {})));
        return all;
    }
    [[nodiscard]] bool isSocketClosed() const
    {
        can_frame raw{};
        return ::recv(kernel.cable, &raw, sizeof raw, MSG_DONTWAIT) == 0;
    }

    PlayedKernel kernel;
    EventLoop loop;
    VirtualClock clock;
    DatedClock dated{clock};
    std::unique_ptr<SocketCanLink> link = std::make_unique<SocketCanLink>(LinkAddress{"socketcan", "can0", {}}, dated);
    std::vector<CanFrame> frames;
    int batches = 0;
    std::vector<Subscription> subscriptions;
};

} // namespace mb::test
