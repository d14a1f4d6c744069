// SPDX-License-Identifier: GPL-3.0-or-later
// What supply, reset line and jumper do to the simulated board, its bootloader and its motors.
#include "families/quadquad2drvbytes.h"
#include "families/quadquad2drvupdatebench.h"

namespace mb::quadquad2drv {
namespace {

using test::bytesOf;

struct PoweredBoard : QuadQuad2DrvUpdateBench {
    explicit PoweredBoard(const std::string &options = {})
        : QuadQuad2DrvUpdateBench(options)
    {
        device.reset(); // the test alone asks
        spi.close();
    }
    [[nodiscard]] bool answers()
    {
        request();
        clock.advance(1ms);
        const bool ready = board->isReady();
        std::vector<std::uint8_t> filler(8);
        std::vector<std::uint8_t> miso(8);
        if (ready)
            board->transfer(filler, miso);
        return ready;
    }
    void request()
    {
        const std::vector<std::uint8_t> version = bytesOf("02 04 01 F9");
        std::vector<std::uint8_t> miso(version.size());
        board->transfer(version, miso);
    }
    void powerCycle()
    {
        board->setPowered(false);
        clock.advance(200ms);
        board->setPowered(true);
        clock.advance(200ms);
    }
};

TEST(QuadQuad2DrvPower, AnUpdateOfABoardWhoseSupplyGoesIsNotConfirmed)
{
    QuadQuad2DrvUpdateBench bench;
    bench.boot->setJumper(true);
    bench.hand = [&bench] {
        if (bench.said("< ok"))
            bench.board->setPowered(false);
    };
    const UpdateReport report = bench.update();
    EXPECT_EQ(report.outcome, UpdateOutcome::Failed);
    EXPECT_TRUE(report.evidence.english().starts_with("line 2 was not confirmed")) << report.evidence;
    EXPECT_EQ(bench.board->version()[1], 3);
}

TEST(QuadQuad2DrvPower, ASupplyThatComesBackAsksForTheJumper)
{
    PoweredBoard bench;
    bench.boot->setJumper(true);
    EXPECT_TRUE(bench.answers()) << "closed while the application runs, it does nothing";
    bench.powerCycle();
    EXPECT_TRUE(bench.boot->isRunning());
    EXPECT_FALSE(bench.answers());
    bench.boot->setJumper(false);
    bench.powerCycle();
    EXPECT_FALSE(bench.boot->isRunning());
    EXPECT_TRUE(bench.answers());
}

TEST(QuadQuad2DrvPower, AResetByItselfAsksForTheJumper)
{
    PoweredBoard bench(",fault=reset@1");
    bench.boot->setJumper(true);
    bench.clock.advance(2s);
    EXPECT_TRUE(bench.boot->isRunning());
    EXPECT_FALSE(bench.answers());
}

TEST(QuadQuad2DrvPower, NoResetReachesABoardWithoutSupply)
{
    PoweredBoard bench(",fault=reset@1");
    bench.boot->setJumper(true);
    bench.board->setPowered(false);
    bench.board->reset();
    bench.clock.advance(2s);
    EXPECT_FALSE(bench.boot->isRunning());
    EXPECT_FALSE(bench.answers());
}

TEST(QuadQuad2DrvPower, ItGoesBeforeTheRequestOfTheFaultAndComesBackAfter200Milliseconds)
{
    PoweredBoard bench(",fault=power@50"); // some of them the bench has asked
    int answered = 0;
    while (answered < 50 && bench.answers())
        ++answered;
    EXPECT_GT(answered, 40);
    EXPECT_LT(answered, 50) << "it counts requests";
    bench.clock.advance(150ms);
    EXPECT_FALSE(bench.answers());
    bench.clock.advance(150ms);
    EXPECT_TRUE(bench.answers());
}

TEST(QuadQuad2DrvPower, TheBoardIsDeafForAWhileAfterAStart)
{
    PoweredBoard bench;
    bench.board->reset();
    EXPECT_FALSE(bench.answers());
    bench.clock.advance(8ms);
    EXPECT_FALSE(bench.answers()) << "the vendor's library waits 10 ms, its sister's up to 100";
    bench.clock.advance(resetTime - 9ms);
    EXPECT_TRUE(bench.answers());
}

TEST(QuadQuad2DrvPower, MotorsRunDownWithoutSupply)
{
    PoweredBoard bench;
    simulation::Axis &axis = bench.board->axis(0);
    axis.settings.power = fullPower;
    axis.setMode(ControlMode::Power);
    bench.clock.advance(1s);
    ASSERT_GT(axis.motor().countSpeed(), 5000.0);
    bench.board->setPowered(false);
    const std::int64_t before = axis.motor().counts();
    bench.clock.advance(3s);
    EXPECT_EQ(axis.motor().countSpeed(), 0.0);
    EXPECT_GT(axis.motor().counts(), before);
}

struct BootLine : PoweredBoard {
    explicit BootLine(const std::string &options = {})
        : PoweredBoard(options)
    {
        (void)hostEnd.open();
        enter();
    }
    void enter()
    {
        boot->setJumper(true);
        board->reset();
        clock.advance(50ms);
        heard.clear();
    }
    std::string type(const std::string &typed)
    {
        heard.clear();
        const std::string bytes = typed + '\r';
        (void)hostEnd.send(std::vector<std::uint8_t>(bytes.begin(), bytes.end()));
        clock.advance(50ms);
        return heard.substr(0, heard.find('\r'));
    }
    /// Out with the jumper, and a reset: does the application answer?
    bool runs()
    {
        boot->setJumper(false);
        board->reset();
        clock.advance(200ms);
        return answers();
    }
    std::string heard;
    Subscription listening = hostEnd.received().add(
        [this](std::span<const std::uint8_t> bytes) { heard.append(bytes.begin(), bytes.end()); });
};

TEST(QuadQuad2DrvBoot, AFileWithARefusedLineIsNotWhole)
{
    BootLine bench;
    EXPECT_EQ(bench.type(":0400000001020304F2"), "ok");
    EXPECT_EQ(bench.type(":0400040005060708DF"), "error: bad line");
    EXPECT_EQ(bench.type(":00000001FF"), "ok");
    EXPECT_FALSE(bench.runs());
    EXPECT_EQ(bench.board->version()[1], 3);
}

TEST(QuadQuad2DrvBoot, AnUploadThatWasCutLeavesNoApplicationButAnotherOneBringsIt)
{
    BootLine bench;
    EXPECT_EQ(bench.type(":0400000001020304F2"), "ok");
    EXPECT_FALSE(bench.runs());
    bench.powerCycle();
    EXPECT_FALSE(bench.answers());
    bench.enter();
    for (const char *line : {":0400000001020304F2", ":0400040005060708DE", ":00000001FF"})
        EXPECT_EQ(bench.type(line), "ok");
    EXPECT_TRUE(bench.runs());
    EXPECT_EQ(bench.board->version()[1], 4);
}

TEST(QuadQuad2DrvBoot, EnteringAndLeavingWithoutALineChangesNothing)
{
    BootLine bench;
    EXPECT_TRUE(bench.runs());
    EXPECT_EQ(bench.board->version()[1], 3);
    bench.enter();
    for (const char *line : {":0400000001020304F2", ":00000001FF"})
        EXPECT_EQ(bench.type(line), "ok");
    EXPECT_TRUE(bench.runs());
    bench.enter();
    EXPECT_TRUE(bench.runs());
    EXPECT_EQ(bench.board->version()[1], 4) << "one update, one version";
}

} // namespace
} // namespace mb::quadquad2drv
