// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/stallingclock.h"

#include "model/registry.h"
#include "model/session.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace mb {
namespace {

using namespace std::chrono_literals;

/// A session on a simulated bench, on a computer that calls it up to 300 ms late.
class BusyComputer : public testing::TestWithParam<const char *> {
protected:
    BusyComputer()
        : session(clock, families())
        , link(**session.openLink(*LinkAddress::parse(GetParam())))
    {
    }
    [[nodiscard]] std::set<std::string> scanned()
    {
        auto scan = session.scan(link);
        scan.start();
        EXPECT_TRUE(clock.runUntil([&scan] { return scan.isFinished(); }, 1min));
        EXPECT_TRUE(scan.result());
        std::set<std::string> rows;
        for (const Device *device : session.devices())
            rows.insert(device->selector() + ' ' + device->identity().dialect);
        return rows;
    }
    /// As many of its devices as take it turn for `time`; their leases are renewed whenever the computer gets to it.
    void drive(Duration time)
    {
        std::vector<SetPointStream *> streams;
        for (Device *device : session.devices()) {
            if (device->identity().state != DeviceState::Online)
                continue;
            SetPoint setPoint;
            setPoint.mode = device->family().modes.front();
            setPoint.target = setPoint.mode == Mode::Duty ? 0.1 : 300.0;
            setPoint.axis = device->family().capabilities.axes > 1 ? 1 : setPoint.axis;
            streams.push_back(&session.stream(*device));
            EXPECT_TRUE(streams.back()->start(setPoint, 10s)) << device->selector();
        }
        EXPECT_FALSE(streams.empty());
        for (Duration passed{}; passed < time; passed += 1s) {
            clock.advance(1s);
            for (SetPointStream *stream : streams) {
                EXPECT_TRUE(stream->isRunning());
                stream->renew();
            }
        }
        for (SetPointStream *stream : streams)
            stream->stop();
    }

    test::StallingClock clock{300ms};
    Session session;
    Link &link;
};

TEST_P(BusyComputer, LosesNoSampleOfASimulatedBench)
{
    ASSERT_FALSE(scanned().empty());
    drive(20s);
    clock.advance(5s);
    std::size_t samples = 0;
    for (const Device *device : session.devices()) {
        const auto channels = static_cast<std::uint16_t>(device->telemetry()->channels().size());
        for (std::uint16_t i = 0; i < channels; ++i) {
            EXPECT_EQ(device->telemetry()->lost({i}), 0U)
                << device->selector() << ' ' << device->telemetry()->channels()[i].key;
            samples += device->telemetry()->size({i});
        }
    }
    EXPECT_GT(samples, 1000U);
    EXPECT_EQ(link.counters().lost, 0U);
    EXPECT_EQ(link.counters().errors, 0U);
}

TEST_P(BusyComputer, FindsTheSameDevicesInEveryScan)
{
    const auto first = scanned();
    for (int i = 0; i < 20; ++i) {
        clock.advance(3s);
        ASSERT_EQ(scanned(), first) << "scan " << i;
    }
}

INSTANTIATE_TEST_SUITE_P(Links, BusyComputer, testing::Values("sim:can", "sim:serial", "sim:spi"),
    [](const auto &row) { return std::string(row.param).substr(4); });

} // namespace
} // namespace mb
