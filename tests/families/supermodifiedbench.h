// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/virtualclock.h"
#include "families/supermodified/controller.h"
#include "families/supermodified/scan.h"
#include "families/supermodified/simulator.h"
#include "families/supermodifiedvectors.h"
#include "model/family.h"
#include "model/registry.h"
#include "model/setpointstream.h"
#include "support/simulatedsession.h"
#include "transport/backends/virtualserial.h"

#include <gtest/gtest.h>

#include <cmath>
#include <list>
#include <memory>

namespace mb::supermodified::test {

using namespace std::chrono_literals;

/// A line in memory with simulated nodes and a host, in virtual time.
class Bench {
public:
    explicit Bench(std::string_view address = "sim:serial", std::uint64_t seed = 1)
        : line(clock, VirtualSerialLine::Wiring::HalfDuplex, seed)
        , m_address(*LinkAddress::parse(address))
        , host(m_address, line)
    {
        EXPECT_TRUE(host.open());
        m_tap = host.traffic().add([this](const Traffic &traffic) {
            auto &log = traffic.direction == Direction::Sent ? sent : heard;
            log.insert(log.end(), traffic.bytes.begin(), traffic.bytes.end());
        });
    }
    Simulator &add(std::string_view unit)
    {
        m_links.emplace_back(m_address, line);
        EXPECT_TRUE(m_links.back().open());
        const auto parsed = SimulatedUnit::parse(unit);
        EXPECT_TRUE(parsed);
        auto made = simulate(m_links.back(), clock, *parsed);
        EXPECT_TRUE(made) << (made ? "" : made.error().text());
        m_simulators.push_back(std::move(*made));
        return *m_simulators.back();
    }
    struct Found final : ScanSink {
        void found(const Identity &identity) override { rows.push_back(identity); }
        void progress(const Message &, int, int) override { ++steps; }
        std::vector<Identity> remembered() const override { return known; }
        ScanExtent extent() const override { return wanted; }
        std::vector<Identity> rows;
        std::vector<Identity> known; ///< from an earlier run
        ScanExtent wanted = ScanExtent::Quick;
        int steps = 0;
    };
    std::vector<Identity> scanAll(std::vector<Identity> known = {}, ScanExtent extent = ScanExtent::Quick)
    {
        Found sink;
        sink.known = std::move(known);
        sink.wanted = extent;
        const auto scanned = mb::test::run(clock, scan(host, clock, sink));
        EXPECT_TRUE(scanned) << (scanned ? "" : scanned.error().text());
        return sink.rows;
    }
    std::unique_ptr<Device> connect(int node, std::vector<Identity> known = {})
    {
        Found sink;
        sink.known = std::move(known);
        EXPECT_TRUE(mb::test::run(clock, probe(host, clock, node, sink)));
        EXPECT_FALSE(sink.rows.empty()) << "node " << node;
        Identity identity = sink.rows.empty() ? Identity{} : sink.rows.back();
        return open(host, clock, identity);
    }
    /// Frames that the host sent since the log was cleared.
    [[nodiscard]] std::vector<Frame> framesSent() const { return framesIn(sent); }
    [[nodiscard]] int count(Command command) const
    {
        int n = 0;
        for (const Frame &frame : framesSent())
            n += frame.is(command) ? 1 : 0;
        return n;
    }
    void say(std::string_view hex)
    {
        heard.clear();
        EXPECT_TRUE(host.send(bytesOf(hex)));
        clock.advance(80ms);
    }
    [[nodiscard]] static ParameterIndex index(std::string_view key) { return *findParameter(family().parameters, key); }
    [[nodiscard]] static const Family &family()
    {
        for (const Family *candidate : families()) {
            if (candidate->key == "supermodified")
                return *candidate;
        }
        std::abort();
    }

    VirtualClock clock;
    VirtualSerialLine line;

private:
    LinkAddress m_address;

public:
    VirtualSerialLink host;
    std::vector<std::uint8_t> sent;
    std::vector<std::uint8_t> heard;

private:
    std::list<VirtualSerialLink> m_links;
    std::vector<std::unique_ptr<Simulator>> m_simulators;
    Subscription m_tap;
};

inline SetPoint setPoint(Mode mode, double target)
{
    SetPoint made;
    made.mode = mode;
    made.target = target;
    return made;
}

inline SetPoint ramp(double target, double velocity, double acceleration)
{
    SetPoint made = setPoint(Mode::RampPosition, target);
    made.velocity = velocity;
    made.acceleration = acceleration;
    return made;
}

inline SetPoint buffered(SetPoint move)
{
    move.buffered = true;
    return move;
}

/// One simulated node of dialect D1, found and open.
class OneNode : public testing::Test {
protected:
    /// Commands a set-point and lets time pass.
    void order(const SetPoint &wanted, Duration time)
    {
        ASSERT_TRUE(device->command(wanted));
        bench.clock.advance(time);
    }
    [[nodiscard]] double position() const { return latest("position"); }
    [[nodiscard]] double latest(std::string_view channel) const
    {
        const auto sample = device->telemetry()->latest(*device->telemetry()->find(channel));
        return sample ? sample->value : NAN;
    }

    Bench bench;
    Simulator &node = bench.add("supermodified:4");
    std::unique_ptr<Device> device = bench.connect(4);
};

} // namespace mb::supermodified::test
