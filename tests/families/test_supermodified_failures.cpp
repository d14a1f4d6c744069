// SPDX-License-Identifier: GPL-3.0-or-later
// Orders that have failed, or are under way, and what may still be told to the node meanwhile.
#include "families/supermodified/node.h"
#include "families/supermodifiedbench.h"
#include "wire/bytes.h"

#include <string>
#include <vector>

namespace mb::supermodified {
namespace {

using namespace std::chrono_literals;
using test::buffered;
using test::setPoint;

struct SupermodifiedFailures : test::OneNode {
    /// Where absolute moves that were sent lead to.
    [[nodiscard]] std::vector<int> targets() const
    {
        std::vector<int> all;
        for (const Frame &frame : bench.framesSent()) {
            if (frame.is(Command::MoveAbsolute))
                all.push_back(static_cast<int>(readU32le(frame.data, 0)));
        }
        return all;
    }
    [[nodiscard]] static std::string textOf(const Result<void> &result)
    {
        EXPECT_TRUE(result || result.error().fault == Fault::Unsafe);
        return result ? std::string() : result.error().text();
    }
};

TEST_F(SupermodifiedFailures, TheNewestTargetTakesThePlaceOfTheOneThatWaits)
{
    order(setPoint(Mode::Position, 0.0), 500ms);
    bench.sent.clear();
    for (const double target : {1000.0, 2000.0, 3000.0})
        ASSERT_TRUE(device->command(setPoint(Mode::Position, target)));
    bench.clock.advance(500ms);
    EXPECT_EQ(targets(), (std::vector<int>{1000, 3000})) << "the first was on the wire";
}

TEST_F(SupermodifiedFailures, WhileAMoveIsUnderWayNoneIsReleasedAndOnceItHasFailedNeither)
{
    order(setPoint(Mode::Position, 0.0), 500ms);
    EXPECT_FALSE(device->gate().keepsMove()) << "what is done at once is not kept";
    ASSERT_TRUE(device->command(buffered(setPoint(Mode::Position, 1000.0))));
    EXPECT_EQ(textOf(device->releaseMoves()), "a buffered move is not acknowledged yet; try again");
    bench.clock.advance(500ms);
    EXPECT_EQ(textOf(device->releaseMoves()), "");
    bench.clock.advance(3s);
    EXPECT_NEAR(position(), 1000.0, 30.0);
    node.setPowered(false);
    ASSERT_TRUE(device->command(setPoint(Mode::Position, 500.0)));
    bench.clock.advance(20s);
    const std::string failed = textOf(device->command(setPoint(Mode::Position, 700.0)));
    EXPECT_EQ(failed, "the device does not answer");
    EXPECT_EQ(textOf(device->releaseMoves()), failed);
}

TEST_F(SupermodifiedFailures, AnOrderThatALostLinkTookHasFailedWithIts)
{
    order(setPoint(Mode::Position, 0.0), 500ms);
    ASSERT_TRUE(device->command(setPoint(Mode::Position, 1000.0)));
    bench.host.close();
    bench.clock.advance(100ms);
    ASSERT_TRUE(bench.host.open());
    EXPECT_EQ(textOf(device->command(setPoint(Mode::Position, 500.0))), "sim:serial is not open");
}

TEST(SupermodifiedNodes, NothingIsSetBeforeTheirDialectIsKnown)
{
    Node node;
    node.id = 4;
    const auto early = setting(node, Command::P, 5);
    ASSERT_FALSE(early);
    EXPECT_EQ(early.error().fault, Fault::Unsupported);
    EXPECT_EQ(early.error().text(), "its dialect is not known yet; read it first");
    node.dialect = Dialect::D1;
    const auto known = setting(node, Command::P, 5);
    ASSERT_TRUE(known);
    EXPECT_EQ(known->frame.to, 4);
    EXPECT_EQ(known->baudrate, 57600);
}

} // namespace
} // namespace mb::supermodified
