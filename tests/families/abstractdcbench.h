// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/virtualclock.h"
#include "families/abstractdc/simulator.h"
#include "model/family.h"
#include "transport/backends/virtualcan.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

namespace mb::abstractdc {
extern const Family family;

using namespace std::chrono_literals;

/// Simulated drives on a bus in memory, spoken to with literal frames in the notation of candump.
class Drives : public testing::Test {
protected:
    explicit Drives(int bitrate = 1'000'000)
        : bus(clock, bitrate, 1)
        , host(*LinkAddress::parse("sim:can"), bus)
        , m_received(host.received().add([this](const CanFrame &frame) { heard.push_back(toText(frame)); }))
    {
        EXPECT_TRUE(host.open());
        clock.advance(1s);
    }
    Simulator &add(const std::string &text)
    {
        const auto parsed = SimulatedUnit::parse(text);
        EXPECT_TRUE(parsed) << text;
        m_links.push_back(std::make_unique<VirtualCanLink>(*LinkAddress::parse("sim:can"), bus));
        EXPECT_TRUE(m_links.back()->open());
        auto made = simulate(*m_links.back(), clock, *parsed);
        EXPECT_TRUE(made) << (made ? "" : made.error().text());
        m_drives.push_back(std::move(*made));
        m_events.push_back(
            m_drives.back()->events().add([this](const SimulatorEvent &event) { events.push_back(event.what); }));
        return *m_drives.back();
    }
    void send(const std::string &text)
    {
        const auto frame = canFrameFromText(text);
        ASSERT_TRUE(frame) << text;
        ASSERT_TRUE(host.send(*frame));
        clock.advance(answerWait);
    }
    /// The answers to one frame.
    std::vector<std::string> ask(const std::string &text)
    {
        heard.clear();
        send(text);
        return heard;
    }
    [[nodiscard]] bool happened(const std::string &what) const
    {
        return std::find(events.begin(), events.end(), what) != events.end();
    }

    Duration answerWait = 2ms;
    VirtualClock clock;
    VirtualCanBus bus;
    VirtualCanLink host;
    std::vector<std::string> heard;
    std::vector<std::string> events;

private:
    std::vector<std::unique_ptr<VirtualCanLink>> m_links;
    std::vector<std::unique_ptr<Simulator>> m_drives;
    std::vector<Subscription> m_events;
    Subscription m_received;
};

} // namespace mb::abstractdc
