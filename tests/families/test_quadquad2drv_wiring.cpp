// SPDX-License-Identifier: GPL-3.0-or-later
// How a simulated board is wired up: its options, its bootloader's line, and an SPI link without a ready line.
#include "families/quadquad2drv/axisdrives.h"
#include "families/quadquad2drv/missedsamples.h"
#include "families/quadquad2drv/scan.h"
#include "families/quadquad2drv/simulator.h"
#include "families/quadquad2drvupdatebench.h"
#include "support/eventloop.h"
#include "support/pseudoterminal.h"
#include "support/temporaryfile.h"
#include "transport/backends/serialdriver.h"
#include "transport/backends/serialport.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace mb::quadquad2drv {
namespace {

using simulation::BoardOptions;

TEST(QuadQuad2DrvWiring, EveryOptionOfASimulatedBoardIsTakenOrRefusedWithItsName)
{
    const auto refusal = [](const std::string &unit) {
        const auto options = BoardOptions::parse(*SimulatedUnit::parse(unit));
        return options ? std::string() : options.error().text();
    };
    EXPECT_EQ(refusal("quadquad2drv:1"), "a QuadQuad2Drv has no address but 0");
    EXPECT_EQ(refusal("quadquad2drv:0,load=1,scale=0.001,firmware=2.7,serial=x,inputs=datasheet,target=shifted"), "");
    const std::string where = "; docs/bench.md has the options of each family, and what they take";
    EXPECT_EQ(refusal("quadquad2drv:0,load=0.5"),
        "'0.5' is no value for the option 'load' of a simulated QuadQuad2Drv" + where);
    EXPECT_EQ(refusal("quadquad2drv:0,boot=nowhere"),
        "'nowhere' is no value for the option 'boot' of a simulated QuadQuad2Drv" + where);
    EXPECT_EQ(
        refusal("quadquad2drv:0,fault=duplicate"), "a simulated QuadQuad2Drv has no option 'fault=duplicate'" + where);
    for (const char *without : {"jumper=closed", "jumper=open", "state=bootloader"})
        EXPECT_EQ(refusal(std::string("quadquad2drv:0,") + without),
            "a bootloader needs the board's serial line, such as boot=pty:./boot");
    EXPECT_EQ(refusal("quadquad2drv:0,boot=pty:./boot,jumper=open,state=application"), "");
    const auto made = BoardOptions::parse(*SimulatedUnit::parse(
        "quadquad2drv:0,motor=n20,load=7,firmware=2.7,boot=pty:./boot,jumper=closed,state=bootloader,scale=2.5,"
        "inputs=datasheet,target=shifted"));
    ASSERT_TRUE(made);
    EXPECT_EQ(made->motors, (std::array<std::string, axes>{"n20", "n20", "n20", "n20"}));
    EXPECT_EQ(made->loads, (std::array<double, axes>{7.0, 7.0, 7.0, 7.0}));
    EXPECT_EQ(made->version, (std::array<std::uint8_t, 3>{2, 7, 1}));
    EXPECT_EQ(made->boot, *LinkAddress::parse("pty:./boot"));
    EXPECT_TRUE(made->jumper && made->inBootloader && made->shiftedTarget);
    EXPECT_FALSE(made->libraryPolarity);
    EXPECT_EQ(made->gainScale, 2.5);
}

struct WiredBoard : testing::Test {
    Result<std::unique_ptr<Simulator>> made(const std::string &options)
    {
        return simulate(slave, loop.clock(), *SimulatedUnit::parse("quadquad2drv:0" + options));
    }
    /// What its bootloader says on the other end.
    std::unique_ptr<SerialLink> hearing(const std::string &path)
    {
        auto link = makeSerialPortLink(LinkAddress{"serial", path, {{"baud", "115200"}}}, loop.clock());
        EXPECT_TRUE((*link)->open());
        std::unique_ptr<SerialLink> host(static_cast<SerialLink *>(link->release()));
        received = host->received().add(
            [this](std::span<const std::uint8_t> bytes) { heard.insert(heard.end(), bytes.begin(), bytes.end()); });
        return host;
    }
    bool hears(std::string_view text)
    {
        return loop.runUntil([&] { return heard.find(text) != std::string::npos; }, 5s);
    }

    test::EventLoop loop;
    test::TemporaryFolder folder;
    VirtualSpiSlaveLink slave{*LinkAddress::parse("sim:spi")};
    std::string heard;
    Subscription received;
};

constexpr std::string_view banner = "QuadQuad2Drv bootloader 1.0\r\n";

TEST_F(WiredBoard, ItsBootloaderSpeaksOnATerminalOfItsOwnOnceItsJumperIsClosedAndItIsReset)
{
    const std::string path = folder.path("boot");
    const auto board = made(",boot=pty:" + path);
    ASSERT_TRUE(board);
    EXPECT_EQ((*board)->name(), "quadquad2drv:0");
    EXPECT_FALSE((*board)->isOutputOn());
    EXPECT_EQ((*board)->speed(), 0.0);
    EXPECT_EQ((*board)->position(), 0.0);
    const auto host = hearing(path);
    EXPECT_TRUE((*board)->disturb("reset", 1.0));
    loop.runReady();
    EXPECT_EQ(heard, "") << "its jumper is open";
    EXPECT_TRUE((*board)->disturb("jumper", 1.0));
    EXPECT_TRUE((*board)->disturb("reset", 1.0));
    EXPECT_TRUE(hears(banner));
    heard.clear();
    const std::string end = ":00000001FF\r";
    ASSERT_TRUE(host->send({reinterpret_cast<const std::uint8_t *>(end.data()), end.size()}));
    EXPECT_TRUE(hears("ok\r\n"));
    EXPECT_FALSE((*board)->disturb("melt", 1.0));
    const auto second = made(",boot=pty:" + path);
    ASSERT_FALSE(second);
    EXPECT_EQ(
        second.error().text(), path + " is served by another simulator; end that one first, or choose another path");
}

TEST_F(WiredBoard, OrOnALinkThatIsThereAt115200UnlessItsAddressFixesAnother)
{
    for (const auto &[options, rate] : {std::pair{"", 115200}, {"?baud=9600", 9600}}) {
        const test::PseudoTerminal terminal;
        const auto board = made(",boot=serial:" + terminal.path() + options + ",state=bootloader");
        ASSERT_TRUE(board);
        EXPECT_EQ(driverBaudrate(terminal.descriptor()), rate);
        std::vector<std::uint8_t> all;
        EXPECT_TRUE(loop.runUntil([&] {
            const auto more = terminal.read();
            all.insert(all.end(), more.begin(), more.end());
            return all.size() >= banner.size();
        }));
        EXPECT_EQ(std::string(all.begin(), all.end()), banner);
    }
}

TEST_F(WiredBoard, WhatCannotBeItsBootloadersLineIsRefused)
{
    const auto refusal = [this](const std::string &options) {
        const auto board = made(options);
        return board ? std::pair(Fault::Timeout, std::string()) : std::pair(board.error().fault, board.error().text());
    };
    EXPECT_EQ(refusal(",boot=socketcan:can0"),
        std::pair(Fault::OutOfRange, std::string("boot= names a serial link, such as pty:./boot")));
    EXPECT_EQ(refusal(",boot=serial:/etc/passwd"),
        std::pair(Fault::LinkLost, std::string("/etc/passwd is no serial port; name one such as /dev/ttyUSB0")));
    EXPECT_EQ(refusal(",fault=power-page@3"),
        std::pair(
            Fault::Unsupported, std::string("a bootloader needs the board's serial line, such as boot=pty:./boot")));
    EXPECT_EQ(refusal("").second, "");
    VirtualSerialLine line(loop.clock(), VirtualSerialLine::Wiring::FullDuplex, 1);
    VirtualSerialLink other(*LinkAddress::parse("sim:serial"), line);
    EXPECT_EQ(simulate(other, loop.clock(), *SimulatedUnit::parse("quadquad2drv:0")).error().text(),
        "a QuadQuad2Drv is simulated on the board's end of an SPI link");
}

TEST(QuadQuad2DrvFirmware, AFileIsSummedUpByItsLinesAndBytes)
{
    const auto summary = inspect(*FirmwareImage::fromIntelHex(hex));
    ASSERT_TRUE(summary);
    ASSERT_EQ(summary->notes.size(), 1U);
    EXPECT_EQ(summary->notes[0], "3 lines, 8 bytes; the file does not name its version");
    EXPECT_EQ(summary->version, "");
    EXPECT_EQ(inspect(FirmwareImage()).error().text(), "the file has no lines to send");
}

TEST(QuadQuad2DrvVersion, OfAnotherProtocolItIsWarnedOf)
{
    Identity identity;
    identity.state = DeviceState::Bootloader;
    setVersion(identity, 1, 3, 1);
    EXPECT_EQ(identity.state, DeviceState::Online);
    EXPECT_EQ(identity.firmware, "1.3");
    EXPECT_EQ(identity.dialect, "protocol 1");
    EXPECT_TRUE(identity.detail.empty());
    setVersion(identity, 2, 10, 2);
    EXPECT_EQ(identity.firmware, "2.10");
    EXPECT_EQ(identity.dialect, "protocol 2");
    EXPECT_EQ(identity.detail,
        "the board speaks protocol 2, this program was written for protocol 1; watch it before it is driven");
}

TEST(QuadQuad2DrvSetPoints, WhatTheBoardCannotDoIsSaidInOneClause)
{
    const auto refusal = [](Mode mode, double target, const auto &change) {
        SetPoint order;
        order.mode = mode;
        order.target = target;
        change(order);
        const auto checked = checkSetPoint(order);
        return checked ? std::string() : checked.error().text();
    };
    const auto nothing = [](SetPoint &) {};
    EXPECT_EQ(refusal(Mode::Duty, 1.0, nothing), "");
    EXPECT_EQ(refusal(Mode::Off, 0.0, nothing), "");
    for (const int axis : {0, 5})
        EXPECT_EQ(
            refusal(Mode::Duty, 0.0, [axis](SetPoint &order) { order.axis = axis; }), "the board has axes 1 to 4");
    EXPECT_EQ(
        refusal(Mode::Duty, 0.0, [](SetPoint &order) { order.slot = 1; }), "the board has one set of gains per axis");
    EXPECT_EQ(refusal(Mode::Duty, 1.01, nothing), "duty is a fraction from −1 to 1");
    EXPECT_EQ(refusal(Mode::Velocity, -100'000.0, nothing), "");
    EXPECT_EQ(refusal(Mode::Velocity, -100'000.1, nothing), "velocity is −100000 to 100000 counts/s");
    EXPECT_EQ(refusal(Mode::Position, -2147483648.0, nothing), "");
    EXPECT_EQ(refusal(Mode::Position, 2147483648.0, nothing), "position has 32 bits");
    EXPECT_EQ(refusal(Mode::Current, 1.0, nothing), "the board has no such mode");
    EXPECT_EQ(refusal(Mode::RampVelocity, 1.0, [](SetPoint &order) { order.acceleration = 1'000'000.5; }),
        "a profile has up to 100000 counts/s and 1000000 counts/s²");
}

TEST(QuadQuad2DrvSimulator, ABrokenStartHidesNoRequestBehindIt)
{
    VirtualClock clock;
    VirtualSpiSlaveLink slave(*LinkAddress::parse("sim:spi"));
    simulation::Board board(
        slave, clock, *BoardOptions::parse(*SimulatedUnit::parse("quadquad2drv:0")), [](std::string_view, double) {});
    for (const Bytes &request : {Bytes{0x02, 0x04, 0x02, 0x04, 0x01, 0xF9}, Bytes{0x02, 0x02, 0x04, 0x01, 0xF9},
             Bytes{0x77, 0x02, 0x03, 0x02, 0x04, 0x01, 0xF9}}) {
        Bytes answer(request.size());
        board.transfer(request, answer);
        clock.advance(1ms);
        Bytes reply;
        while (board.isReady()) {
            std::uint8_t byte = 0;
            board.transfer(std::array<std::uint8_t, 1>{}, {&byte, 1});
            reply.push_back(byte);
        }
        EXPECT_EQ(reply, (Bytes{0x02, 0x08, 0x01, 0x00, 0x01, 0x03, 0x01, 0xF0})) << request.size();
    }
}

// A link without a ready line

/// Clocks a simulated board, and does not see its ready line.
class BlindLink final : public SpiLink {
public:
    BlindLink(Clock &clock, SpiSlave &board)
        : SpiLink(*LinkAddress::parse("spidev:/dev/spidev0.0"), clock)
        , m_board(board)
        , m_done(clock)
    {
    }
    ~BlindLink() override { BlindLink::doClose(); }
    std::vector<std::size_t> sizes; ///< of transfers

private:
    Result<void> doOpen() override { return {}; }
    void doClose() override
    {
        m_done.stop();
        dropTransfers();
    }
    void doTransfer(const Bytes &mosi) override
    {
        sizes.push_back(mosi.size());
        m_done.startIn(16us * static_cast<std::int64_t>(mosi.size()), [this, mosi] {
            Bytes miso(mosi.size());
            m_board.transfer(mosi, miso);
            finishTransfer(std::move(miso));
        });
    }
    Result<void> doPulseReset() override { return fail(Fault::Unsupported); }

    SpiSlave &m_board;
    Timer m_done;
};

/// Answers nothing but zeros.
struct DeafBoard final : SpiSlave {
    void transfer(std::span<const std::uint8_t>, std::span<std::uint8_t>) override { }
    [[nodiscard]] bool isReady() const override { return false; }
    void reset() override { }
};

TEST(QuadQuad2DrvBlind, AReplyIsLookedForByteByByteUntilItBeginsAndThenReadWhole)
{
    VirtualClock clock;
    VirtualSpiSlaveLink slave(*LinkAddress::parse("sim:spi"));
    simulation::Board board(
        slave, clock, *BoardOptions::parse(*SimulatedUnit::parse("quadquad2drv:0")), [](std::string_view, double) {});
    BlindLink link(clock, board);
    ASSERT_TRUE(link.open());
    PacketPort port(link, clock);
    const auto version = test::run(clock, port.request({0x02, 0x04, 0x01, 0xF9}));
    ASSERT_TRUE(version);
    EXPECT_EQ(version->id, 0x01);
    EXPECT_EQ(version->payload, (Bytes{0x00, 0x01, 0x03, 0x01}));
    const auto request = std::ranges::find(link.sizes, std::size_t{4});
    ASSERT_NE(request, link.sizes.end());
    const std::vector<std::size_t> after(request + 1, link.sizes.end());
    ASSERT_GE(after.size(), 2U);
    EXPECT_EQ(after[0], 1U) << "its start";
    EXPECT_LE(std::ranges::count(after, std::size_t{1}), 64);
}

TEST(QuadQuad2DrvBlind, ABoardThatSaysNothingIsLookedForWith64BytesAMillisecond)
{
    VirtualClock clock;
    DeafBoard board;
    BlindLink link(clock, board);
    ASSERT_TRUE(link.open());
    PacketPort port(link, clock);
    Task<Packet> asked = port.request({0x02, 0x04, 0x01, 0xF9}, 1);
    asked.start();
    ASSERT_TRUE(clock.runUntil([&] { return std::ranges::count(link.sizes, std::size_t{4}) == 1; }));
    link.sizes.clear();
    clock.advance(64us + 1ms);
    EXPECT_EQ(link.sizes, std::vector<std::size_t>{1});
    clock.advance(64 * 16us + 1ms - 1ns);
    EXPECT_EQ(link.sizes, std::vector<std::size_t>(64, 1));
    clock.advance(1ns);
    EXPECT_EQ(link.sizes, std::vector<std::size_t>(65, 1));
    clock.advance(1s);
    ASSERT_TRUE(asked.isFinished());
    EXPECT_EQ(asked.result().error().fault, Fault::Timeout);
    EXPECT_EQ(asked.result().error().text(), "the board did not answer");
}

TEST(QuadQuad2DrvMissed, OfAStreamThatDoesNotTellHowManyItSkippedTheTimeTells)
{
    using Damage = PacketPort::Damage;
    const auto after = [](std::optional<std::uint8_t> elapsed, Duration gap, Damage damage) {
        MissedSamples missed;
        EXPECT_EQ(missed.before(elapsed, Instant(1s), 10ms, Damage::None), 0U) << "the first";
        return missed.before(elapsed, Instant(1s) + gap, 10ms, damage);
    };
    EXPECT_EQ(after(std::nullopt, 10ms, Damage::None), 0U);
    EXPECT_EQ(after(std::nullopt, 30ms, Damage::None), 2U);
    EXPECT_EQ(after(std::nullopt, 34ms, Damage::None), 2U);
    EXPECT_EQ(after(std::nullopt, 36ms, Damage::None), 3U);
    EXPECT_EQ(after(std::nullopt, 10ms, Damage::OfStream), 1U) << "one came garbled";
    EXPECT_EQ(after(std::nullopt, 10ms, Damage::Unclear), 0U);
    EXPECT_EQ(after(2, 30ms, Damage::None), 0U) << "the board told of both";
    EXPECT_EQ(after(2, 50ms, Damage::OfStream), 2U);
    EXPECT_EQ(after(2, 30ms, Damage::OfStream), 1U);
    EXPECT_EQ(after(254, 10s, Damage::None), 0U);
    EXPECT_EQ(after(255, 3s, Damage::None), 299U - 255U) << "its count stays there";
}

} // namespace
} // namespace mb::quadquad2drv
