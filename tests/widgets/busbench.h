// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "parameterbench.h"
#include "widgets/control/arming.h"
#include "widgets/monitor/framemodel.h"

#include <memory>

namespace mb::test {

using namespace std::chrono_literals;

/// Frames of candump text, stamped and put into a log as a link would.
class FakeTraffic {
public:
    explicit FakeTraffic(Instant start = Instant{std::chrono::seconds(1000)})
        : now(start)
    {
    }
    void add(const char *text, Direction direction = Direction::Received, Duration after = 10ms)
    {
        CanFrame frame = canFrameFromText(text).value();
        now += after;
        frame.time = now;
        log->append(direction, frame);
    }
    void addError(std::uint32_t classes)
    {
        CanFrame frame;
        frame.id = classes;
        frame.size = 8;
        frame.error = true;
        frame.time = now;
        log->append(Direction::Received, frame);
    }

    Instant now;
    std::shared_ptr<TrafficLog> log = std::make_shared<TrafficLog>();
};

inline LinkView canLink(const std::shared_ptr<TrafficLog> &log)
{
    LinkView link;
    link.address = "sim:can";
    link.name = "sim:can";
    link.state = LinkState::Open;
    link.simulated = true;
    link.bitrate = 1000000;
    link.load = 0.06;
    link.traffic = log;
    return link;
}

inline constexpr const char *generalOf5 = "02061405#A125110008070000"; // velocity, duty 9633/32767, error +7
inline constexpr const char *generalOf7 = "02061407#FE04110010020000"; // position, duty 1278/32767
inline constexpr const char *encoderOf5 = "02061485#126B27FC00000004";
inline constexpr const char *controlOf5 = "02060005#7100000000280000"; // velocity 10 240, slot 1
inline constexpr const char *unknown = "0206144A#00003E1102";

} // namespace mb::test
