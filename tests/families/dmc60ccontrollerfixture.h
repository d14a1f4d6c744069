// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/virtualclock.h"
#include "families/dmc60c/controller.h"
#include "model/family.h"
#include "support/fakeunit.h"

#include <gtest/gtest.h>

#include <limits>

/// A controller on number 5, session 0x1234, and a unit that answers with literal frames, mostly those of dmc60c/README.md#vectors.
namespace mb::dmc60c {
extern const Family family;

using namespace std::chrono_literals;
using test::FakeUnit;

inline const std::string enumeration = "00000240#";
inline const std::string idle = "02061405#000011007A000000"; // S6 has a fault; this is duty 0, NoDrive, under-voltage
inline const std::string resting = "02061405#0000110078000000";                            // duty 0, NoDrive, no fault
inline const std::string drivingHalf = "02061405#0040110000000000";                        // S1
inline const FakeUnit::Frames versionsReply{"0206FCC5#00000600", "0206FC85#000017010901"}; // V12
inline const std::string getVersions = "0206FC05#3412610000000000";                        // V10
inline const std::string getDescriptors = "0206FC05#3412600000000000";                     // V5
inline const std::string getSequence = "0206FC05#3412620000000000";
inline const std::string softReset = "0206FC05#3412F10000000000"; // V18
inline const FakeUnit::Frames descriptors{"0206FCC5#00002700", "0206FC85#0106444D43363043", "0206FC85#030F446967696C65",
    "0206FC85#6E7420444D433630", "0206FC85#43060C3231303333", "0206FC85#34334137394632"};

inline FakeUnit::Frames sequence(int low)
{
    return {"0206FCC5#00000400", std::string("0206FC85#0") + static_cast<char>('0' + low) + "000000"};
}

inline Identity identityOf5()
{
    Identity identity;
    identity.family = "dmc60c";
    identity.address = 5;
    identity.session = 0x1234;
    identity.firmware = "1.23";
    return identity;
}

class Dmc60cController : public testing::Test {
protected:
    Dmc60cController()
        : bus(clock, 1'000'000, 1)
        , host(*LinkAddress::parse("sim:can"), bus)
        , unit(bus, clock)
    {
        EXPECT_TRUE(host.open());
        clock.advance(1s);
        device = family.open(host, clock, identityOf5());
    }
    template <class T> Result<T> run(Task<T> task, Duration limit = 2min)
    {
        task.start();
        EXPECT_TRUE(clock.runUntil([&] { return task.isFinished(); }, limit));
        if (!task.isFinished())
            return fail(Fault::Cancelled, say("the task hangs"));
        return std::move(task.result());
    }
    static ParameterIndex index(std::string_view key) { return *findParameter(family.parameters, key); }
    static ChannelIndex channel(std::string_view key) { return *findChannel(family.channels, key); }
    double latest(std::string_view key)
    {
        const auto point = device->telemetry()->latest(channel(key));
        return point ? point->value : std::numeric_limits<double>::quiet_NaN();
    }
    std::uint64_t lost(std::string_view key)
    {
        device->telemetry()->commit();
        return device->telemetry()->lost(channel(key));
    }
    Result<void> command(Mode mode, double target) { return device->command(setPoint(mode, target)); }
    static SetPoint setPoint(Mode mode, double target)
    {
        SetPoint s;
        s.mode = mode;
        s.target = target;
        return s;
    }

    VirtualClock clock;
    VirtualCanBus bus;
    VirtualCanLink host;
    FakeUnit unit;
    std::unique_ptr<Device> device;
};

} // namespace mb::dmc60c
