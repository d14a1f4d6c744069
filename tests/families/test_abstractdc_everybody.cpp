// SPDX-License-Identifier: GPL-3.0-or-later
// What is sent to the drive with offset 0 is done by all drives of the bus (abstractdc/README.md#offsets).
#include "abstractdccontrollerbench.h"

#include <algorithm>

namespace mb::abstractdc {
namespace {

TEST_F(AbstractDcController, OffsetZeroIsNeitherMovedNorWrittenWhileAnotherDriveAnswers)
{
    add("abstractdc:0");
    for (const char *other : {"abstractdc:3", "abstractdc:24,dialect=L", "abstractdc:52,dialect=L"}) {
        Simulator &beside = add(other);
        open(0, &dialectF);
        clock.advance(1s);
        ASSERT_TRUE(device->liveness().heard);
        const auto refused = device->command(setPoint(Mode::Duty, 0.2));
        ASSERT_FALSE(refused) << other;
        EXPECT_EQ(refused.error().fault, Fault::Unsafe);
        EXPECT_NE(refused.error().text().find("an offset of its own"), std::string::npos) << refused.error().text();
        EXPECT_EQ(write("velocity.p", 5).error().fault, Fault::Unsafe) << other;
        NoProgress progress;
        EXPECT_EQ(test::run(clock, device->store(progress)).error().fault, Fault::Unsafe) << other;
        EXPECT_TRUE(sentOf("064").empty());
        EXPECT_TRUE(sentOf("0C8").empty());
        device->stop();
        EXPECT_EQ(sentOf("064#00").size(), 3U) << "it may always be stopped";
        beside.setPowered(false);
        clock.advance(6s);
        EXPECT_TRUE(device->mayMove()) << "it is alone again";
        device.reset();
    }
}

TEST_F(AbstractDcController, OffsetZeroIsNotAskedForItsOutputWhileAnotherDriveAnswers)
{
    add("abstractdc:0");
    add("abstractdc:3");
    open(0, &dialectF);
    VirtualCanLink master(*LinkAddress::parse("sim:can"), bus);
    ASSERT_TRUE(master.open());
    ASSERT_TRUE(master.send(*canFrameFromText("064#0420000000")));
    clock.advance(1s);
    ASSERT_TRUE(device->liveness().moving);
    EXPECT_TRUE(sentOf("384#04").empty()) << "all would answer on one identifier";
    EXPECT_FALSE(sentOf("384#00").empty());
}

TEST_F(AbstractDcController, OffsetZeroAloneOnItsBusIsADriveLikeOthers)
{
    Simulator &drive = add("abstractdc:0");
    open(0, &dialectF);
    ASSERT_TRUE(write("velocity.p", 5));
    NoProgress progress;
    EXPECT_TRUE(test::run(clock, device->store(progress)));
    SetPointStream stream(*device, clock);
    ASSERT_TRUE(stream.start(setPoint(Mode::Duty, 0.3), 60s));
    clock.advance(10s);
    EXPECT_TRUE(stream.isRunning()) << stream.reason().english();
    EXPECT_TRUE(drive.isOutputOn());
    EXPECT_FALSE(sentOf("384#04").empty());
    stream.stop();
    clock.advance(5ms);
    EXPECT_FALSE(drive.isOutputOn());
}

/// To a drive of dialect LL eight bytes of nothing are the speed 0.
TEST_F(AbstractDcController, TheStopOfOffsetZeroStartsNoDriveOfTheOldestDialect)
{
    struct Row {
        const Dialect *dialect;
        const char *own;
        const char *other;
    };
    add("abstractdc:7,dialect=LL");
    for (const Row &row : {Row{&dialectF, "064#0000000000", "064#0000000000000000"},
             Row{&dialectL, "064#0000000000000000", "064#0000000000"}}) {
        const auto watched = family.open(host, clock, identityOf(7, &dialectLL));
        open(0, row.dialect);
        clock.advance(500ms);
        ASSERT_TRUE(watched->liveness().heard);
        device->stop();
        EXPECT_EQ(std::ranges::count(sent, row.own), 2);
        EXPECT_EQ(std::ranges::count(sent, row.other), 0);
        const bool isWide = row.dialect->wide;
        EXPECT_EQ(device->mayStop().has_value(), !isWide) << "STOP leaves out what would start the other";
        EXPECT_EQ(toText(*device->stopScript().steps.front().frame), row.own);
        EXPECT_EQ(device->stopScript().steps.size(), isWide ? 1U : 2U) << "with what proves it";
        EXPECT_EQ(watched->liveness().foreignMaster, isWide) << "nothing else drives it";
    }
}

TEST_F(AbstractDcController, TheStopOfOffsetZeroIsNotWithheldOnceTheOldestDialectIsSilent)
{
    Simulator &oldest = add("abstractdc:7,dialect=LL");
    const auto watched = family.open(host, clock, identityOf(7, &dialectLL));
    open(0, &dialectL);
    clock.advance(500ms);
    ASSERT_TRUE(watched->liveness().heard);
    EXPECT_FALSE(device->mayStop());
    oldest.setPowered(false);
    clock.advance(6s);
    EXPECT_TRUE(device->mayStop());
}

TEST_F(AbstractDcController, AnotherDriveThatComesEndsTheMotionOfOffsetZero)
{
    Simulator &drive = add("abstractdc:0");
    Simulator &other = add("abstractdc:3");
    other.setPowered(false);
    open(0, &dialectF);
    SetPointStream stream(*device, clock);
    ASSERT_TRUE(stream.start(setPoint(Mode::Duty, 0.3), 60s));
    clock.advance(1s);
    ASSERT_TRUE(stream.isRunning());
    other.setPowered(true);
    clock.advance(200ms);
    EXPECT_EQ(stream.end(), SetPointStream::End::Refused);
    EXPECT_FALSE(drive.isOutputOn());
    EXPECT_FALSE(other.isOutputOn());
    EXPECT_FALSE(clock.runUntil([&] { return drive.isOutputOn() || other.isOutputOn(); }, 2s));
}

TEST_F(AbstractDcController, ADriveThatThisProgramMovesThroughOffsetZeroIsNotDrivenToo)
{
    Simulator &drive = add("abstractdc:3");
    open(3, &dialectF);
    SetPointStream stream(*device, clock);
    ASSERT_TRUE(stream.start(setPoint(Mode::Duty, 0.3), 60s));
    clock.advance(500ms);
    ASSERT_TRUE(host.send(*canFrameFromText("064#0420000000")));
    clock.advance(5ms);
    EXPECT_EQ(stream.end(), SetPointStream::End::ForeignMaster);
    ASSERT_TRUE(host.send(*canFrameFromText("064#0420000000")));
    clock.advance(5ms);
    EXPECT_TRUE(device->liveness().foreignMaster);
    EXPECT_FALSE(device->mayMove());
    ASSERT_TRUE(host.send(*canFrameFromText("064#0000000000")));
    clock.advance(5ms);
    EXPECT_FALSE(drive.isOutputOn());
    EXPECT_TRUE(device->mayMove());
}

} // namespace
} // namespace mb::abstractdc
