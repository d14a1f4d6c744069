// SPDX-License-Identifier: GPL-3.0-or-later
// The faults on demand of the simulated DMC60C.
#include "families/dmc60csimulatorbench.h"

namespace mb::test {
namespace {

using namespace std::chrono_literals;
using namespace dmc60c;
using namespace dmc60csim;

TEST(Dmc60cSimulatorFaults, StrikeTheFrameTheyName)
{
    const auto answers = [](const std::string &fault) {
        Dmc60cBench bench("dmc60c:5,session=0x1234,state=bootloader,fault=" + fault);
        bench.send("00000240#");
        bench.advance(100ms);
        return bench.answers();
    };
    const std::string first = "0206F005#341203012060";
    const std::string second = "0206F005#34120100FFFF0901";
    EXPECT_EQ(answers("drop@3"), (std::vector<std::string>{first, second}));
    EXPECT_EQ(answers("drop@1"), std::vector<std::string>{second});
    EXPECT_EQ(answers("silent@2"), std::vector<std::string>{first});
    EXPECT_EQ(answers("delay@1:50"), (std::vector<std::string>{second, first}));
    const auto damaged = answers("corrupt@1");
    ASSERT_EQ(damaged.size(), 2U);
    EXPECT_NE(damaged[0], first);
    EXPECT_EQ(damaged[0].size(), first.size());
}

TEST(Dmc60cSimulatorFaults, PowerGoesAtTheFrameAndComesBackByItself)
{
    Dmc60cBench bench("dmc60c:5,session=0x1234,fault=power@3");
    bench.wake();
    bench.send(vendorCommand(0x61));
    ASSERT_NE(bench.next(id::vendorDin), nullptr);
    bench.send(vendorCommand(0x61));
    EXPECT_EQ(bench.next(id::vendorDin, 100ms), nullptr);
    EXPECT_EQ(bench.eventNames(), "power-lost");
    bench.advance(300ms);
    EXPECT_EQ(bench.eventNames(), "power-lost power-on application");
    EXPECT_EQ(enumerate(bench).images, 0);
}

TEST(Dmc60cSimulatorFaults, ResetAndBusOffStopTheMotorAndGiveANewSession)
{
    for (const char *fault : {"reset@1", "busoff@1"}) {
        Dmc60cBench bench(std::string("dmc60c:5,session=0x1234,fault=") + fault);
        bench.wake();
        bench.drive("02060005#0000000000400000", 840ms);
        EXPECT_TRUE(bench.device().isOutputOn());
        bench.advance(11ms);
        EXPECT_FALSE(bench.device().isOutputOn()) << fault;
        ASSERT_NE(bench.event("output-off"), nullptr);
        EXPECT_EQ(bench.event("output-off")->time, Instant{} + 1s) << fault;
        const Enumerated found = enumerate(bench);
        EXPECT_EQ(found.images, 0);
        EXPECT_NE(found.session, 0x1234);
    }
}

TEST(Dmc60cSimulatorFaults, BusLossIsCountedSincePowerUp)
{
    Dmc60cBench bench("dmc60c:5,session=0x1234,fault=busoff@1");
    bench.wake();
    bench.advance(1s);
    const auto session = static_cast<std::uint16_t>(enumerate(bench).session);
    bench.send(parameterSet(57, 1, session));
    EXPECT_TRUE(bench.hears("02061845#390100000000"));
    bench.send(parameterSet(57, 1, session));
    EXPECT_TRUE(bench.hears("02061845#390000000000"));
}

TEST(Dmc60cSimulatorFaults, DuplicateIsASecondUnitOfTheSameNumber)
{
    Dmc60cBench bench("dmc60c:5,session=0x1234,fault=duplicate");
    bench.send("00000240#");
    bench.advance(100ms);
    const auto answers = bench.answers();
    EXPECT_EQ(answers.size(), 4U);
    EXPECT_EQ(std::count(answers.begin(), answers.end(), "0206F005#341203012060"), 1);
    EXPECT_EQ(std::count(answers.begin(), answers.end(), "0206F005#351203012060"), 1);
    bench.send(vendorCommand(0x01, 6, 0, 0x1235)); // the other one moves
    EXPECT_TRUE(bench.hears("0206FCC6#00000000"));
    bench.send(vendorCommand(0x61));
    EXPECT_TRUE(bench.hears("0206FCC5#00000600"));
}

} // namespace
} // namespace mb::test
