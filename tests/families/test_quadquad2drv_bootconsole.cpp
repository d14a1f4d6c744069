// SPDX-License-Identifier: GPL-3.0-or-later
// What counts as a line of the bootloader: every one confirms a line of the firmware.
#include "families/quadquad2drv/bootconsole.h"
#include "support/simulatedsession.h"
#include "transport/backends/virtualserial.h"

namespace mb::quadquad2drv {
namespace {

using namespace std::chrono_literals;

class QuadQuad2DrvBootConsole : public testing::Test {
protected:
    QuadQuad2DrvBootConsole()
    {
        EXPECT_TRUE(host.open());
        EXPECT_TRUE(board.open());
    }
    void say(std::string_view text)
    {
        EXPECT_TRUE(board.send(std::vector<std::uint8_t>(text.begin(), text.end())));
        clock.advance(100ms);
    }
    VirtualClock clock;
    VirtualSerialLine line{clock, VirtualSerialLine::Wiring::FullDuplex, 1};
    VirtualSerialLink host{*LinkAddress::parse("sim:serial"), line};
    VirtualSerialLink board{*LinkAddress::parse("sim:serial"), line};
    BootConsole console{host, clock};
};

TEST_F(QuadQuad2DrvBootConsole, BlankLinesAndControlCharactersAreNone)
{
    using namespace std::string_view_literals;
    say("\0\x1B\x07\r\n\r\x1F\r"sv); // such as a board sends while it starts
    clock.advance(1s);
    EXPECT_EQ(console.take(), std::nullopt);
    say("\x02 o\0k\xE9\r\n"sv);
    EXPECT_EQ(console.take(), " ok\xE9");
    EXPECT_EQ(console.take(), std::nullopt);
}

TEST_F(QuadQuad2DrvBootConsole, ALineIsCutAt256Characters)
{
    say(std::string(300, 'x') + "\rok\r");
    EXPECT_EQ(console.take(), std::string(256, 'x'));
    EXPECT_EQ(console.take(), "ok");
}

TEST_F(QuadQuad2DrvBootConsole, WhatStandsWithoutAnEndFor200MillisecondsIsALine)
{
    say("> ");
    EXPECT_EQ(console.take(), std::nullopt);
    clock.advance(99ms);
    EXPECT_EQ(console.take(), std::nullopt);
    clock.advance(2ms); // they are on the line for a moment too
    EXPECT_EQ(console.take(), "> ");
}

TEST_F(QuadQuad2DrvBootConsole, ALineThatIsThereIsHandedOverAtOnce)
{
    say("ok\r");
    const Instant asked = clock.now();
    const auto text = test::run(clock, console.line(1s));
    ASSERT_TRUE(text);
    EXPECT_EQ(*text, "ok");
    EXPECT_EQ(clock.now(), asked);
}

TEST_F(QuadQuad2DrvBootConsole, ClearedItKeepsNeitherLinesNorTheBeginningOfOne)
{
    say("ok\rhalf");
    console.clear();
    say("\rnew\r");
    EXPECT_EQ(console.take(), "new");
    EXPECT_EQ(console.take(), std::nullopt);
}

} // namespace
} // namespace mb::quadquad2drv
