// SPDX-License-Identifier: GPL-3.0-or-later
// Flash, resets and loss of supply of the simulated DMC60C.
#include "families/dmc60c/simulatorflash.h"
#include "families/dmc60csimulatorbench.h"
#include "wire/checksum.h"

namespace mb::test {
namespace {

using namespace std::chrono_literals;
using namespace dmc60c;
using namespace dmc60csim;
using simulation::CrcVariant;
using simulation::pageCrc;

constexpr auto status = [](int code) { return "0206FCC5#0" + std::to_string(code) + "000000"; };

std::vector<std::uint8_t> blankPage()
{
    return std::vector<std::uint8_t>(pageSize, 0xFF);
}

/// The last page with a version in its last instruction.
std::vector<std::uint8_t> versionPage(std::uint16_t version)
{
    auto page = blankPage();
    writeU16le(page, pageSize - 4, version);
    page[pageSize - 2] = 0;
    return page;
}

void sendPage(Dmc60cBench &bench, int page, const std::vector<std::uint8_t> &bytes, CrcVariant variant = CrcVariant::A,
    int damage = 0)
{
    bench.send(vendorCommand(0xF2, 0, static_cast<std::uint16_t>(page)));
    std::vector<std::uint8_t> all = bytes;
    all.resize(pageTransferSize);
    writeU32le(all, pageSize, pageCrc(variant, bytes) ^ static_cast<std::uint32_t>(damage));
    const std::span<const std::uint8_t> view = all;
    for (std::size_t at = 0; at < all.size(); at += 8)
        bench.send(extendedFrame(id::vendorDout | 5U, view.subspan(at, std::min<std::size_t>(8, all.size() - at))));
}

bool writePage(Dmc60cBench &bench, int page, const std::vector<std::uint8_t> &bytes)
{
    sendPage(bench, page, bytes);
    return bench.hears(status(0), 2s);
}

bool writeImage(Dmc60cBench &bench, std::uint16_t version)
{
    bool good = writePage(bench, lastPage, versionPage(version));
    for (int page = lastPage - 1; page >= firstPage; --page)
        good = good && writePage(bench, page, blankPage());
    return good;
}

std::uint32_t sequenceNumber(Dmc60cBench &bench)
{
    bench.send(vendorCommand(0x62));
    const CanFrame *data = bench.next(id::vendorDin);
    return data == nullptr ? 0 : readU32le(data->bytes(), 0);
}

TEST(Dmc60cSimulatorFlash, ChecksPagesByTheThreeVariantsOfTheReference)
{
    const std::string text = "123456789";
    const std::vector<std::uint8_t> digits(text.begin(), text.end());
    EXPECT_EQ(pageCrc(CrcVariant::A, digits), 0x2DFD2D88U);
    EXPECT_EQ(pageCrc(CrcVariant::B, digits), 0xCBF43926U);
    EXPECT_EQ(pageCrc(CrcVariant::C, digits), 0xCD6F8FD9U);
    EXPECT_EQ(pageCrc(CrcVariant::A, blankPage()), 0x3648671BU);
    EXPECT_EQ(pageCrc(CrcVariant::B, blankPage()), 0xF154670AU);
    EXPECT_EQ(pageCrc(CrcVariant::C, blankPage()), 0x2939ED25U);
    EXPECT_EQ(pageCrc(CrcVariant::A, versionPage(0x0117)), 0x09FDAD64U);
    EXPECT_EQ(pageCrc(CrcVariant::B, versionPage(0x0117)), 0xCEE1AD75U);
}

TEST(Dmc60cSimulatorFlash, UpdatesPageByPageAndStartsTheNewApplication)
{
    Dmc60cBench bench;
    bench.wake();
    bench.send("0206FC05#3412F00000000000"); // V16
    ASSERT_TRUE(bench.hears(status(4)));
    EXPECT_EQ(bench.eventNames(), "reset bootloader");
    ASSERT_TRUE(writeImage(bench, 0x0119));
    bench.send("0206FC05#3412F10000000000"); // V18
    ASSERT_TRUE(bench.hears(status(7)));     // V19
    bench.send(vendorCommand(0x61));
    EXPECT_TRUE(bench.hears("0206FC85#000019010901"));
    EXPECT_EQ(bench.event("page-written")->value, 30.0);
    EXPECT_EQ(enumerate(bench).session, 0x1234);
}

TEST(Dmc60cSimulatorFlash, APageTakesTheTimeOfItsFlash)
{
    Dmc60cBench bench("dmc60c:5,session=0x1234,state=bootloader");
    bench.wake();
    sendPage(bench, 12, blankPage());
    bench.clock().runUntil([&] { return bench.host().backlog() == 0; });
    const Instant sent = bench.clock().now();
    ASSERT_TRUE(bench.hears(status(0), 2s));
    EXPECT_GE(bench.clock().now() - sent, 77ms);
    EXPECT_LE(bench.clock().now() - sent, 79ms);
}

TEST(Dmc60cSimulatorFlash, RefusesPagesItCannotWrite)
{
    Dmc60cBench bench;
    bench.wake();
    bench.send("0206FC05#3412F20000000000"); // V21
    EXPECT_TRUE(bench.hears(status(1)));
    bench.send(vendorCommand(0xF0));
    ASSERT_TRUE(bench.hears(status(4)));
    bench.send(vendorCommand(0xF2, 0, 31));
    EXPECT_TRUE(bench.hears(status(2)));
    bench.send(vendorCommand(0xF2, 1, 30));
    EXPECT_TRUE(bench.hears(status(2)));
    sendPage(bench, 30, versionPage(0x0119), CrcVariant::A, 1);
    EXPECT_TRUE(bench.hears(status(5))); // V22
    bench.send(vendorCommand(0x61));
    EXPECT_TRUE(bench.hears("0206FC85#010017010901")); // nothing was erased
    bench.device().disturb("flash-fail", 30);
    sendPage(bench, 30, versionPage(0x0119));
    EXPECT_TRUE(bench.hears(status(6), 1s));
    sendPage(bench, 30, versionPage(0x0119));
    bench.send("0206FC45#00"); // one byte more than a page: it comes while the processor is busy, after the transfer
    EXPECT_TRUE(bench.hears(status(0), 1s));
    bench.send(vendorCommand(0xF2, 2, 7)); // auxiliary image: as any other
    for (int i = 0; i < 513; ++i)
        bench.send("0206FC45#0102030405060708");
    EXPECT_TRUE(bench.hears(status(3), 1s));
}

TEST(Dmc60cSimulatorFlash, AcceptsOnlyItsOwnCrc)
{
    for (const auto &[name, variant] : {std::pair{"B", CrcVariant::B}, std::pair{"C", CrcVariant::C}}) {
        Dmc60cBench bench(std::string("dmc60c:5,session=0x1234,state=bootloader,crc=") + name);
        bench.wake();
        sendPage(bench, 30, versionPage(0x0119), CrcVariant::A);
        EXPECT_TRUE(bench.hears(status(5)));
        sendPage(bench, 30, versionPage(0x0119), variant);
        EXPECT_TRUE(bench.hears(status(0), 1s));
    }
}

TEST(Dmc60cSimulatorFlash, TheReceiveFifoHolds24FramesWhileThePageIsWritten)
{
    Dmc60cBench bench("dmc60c:5,session=0x1234,state=bootloader");
    bench.wake();
    sendPage(bench, 30, versionPage(0x0119));
    bench.clock().runUntil([&] { return bench.host().backlog() == 0; });
    for (int i = 0; i < 40; ++i)
        bench.send(vendorCommand(0x50));
    bench.advance(500ms);
    EXPECT_EQ(bench.answers().size(), 1U + 24U);
}

TEST(Dmc60cSimulatorFlash, SoftResetWithoutAnApplicationIsSilentAndTheSessionSurvives)
{
    Dmc60cBench bench("dmc60c:5,session=0x1234,state=bootloader");
    bench.wake();
    bench.send(vendorCommand(0xF1));
    bench.advance(3s);
    EXPECT_TRUE(bench.answers().empty());
    const Enumerated found = enumerate(bench);
    EXPECT_EQ(found.images, 1);
    EXPECT_EQ(found.session, 0x1234);
}

TEST(Dmc60cSimulatorFlash, StayingInTheBootloaderEndsWithTheNextReset)
{
    Dmc60cBench bench;
    bench.wake();
    bench.send(vendorCommand(0xF0));
    ASSERT_TRUE(bench.hears(status(4)));
    bench.send(vendorCommand(0xF1));
    EXPECT_TRUE(bench.hears(status(7)));
    EXPECT_EQ(enumerate(bench).images, 0);
}

TEST(Dmc60cSimulatorFlash, PowerCutLeavesWhatTheReferenceSays)
{
    const auto after = [](int page) {
        Dmc60cBench bench("dmc60c:5,session=0x1234,fault=power-page@" + std::to_string(page));
        bench.wake();
        bench.send(vendorCommand(0xF0));
        EXPECT_TRUE(bench.hears(status(4)));
        EXPECT_FALSE(writeImage(bench, 0x0119));
        EXPECT_NE(bench.event("power-lost"), nullptr);
        return enumerate(bench);
    };
    for (const int page : {30, 29, 15, 1}) {
        EXPECT_EQ(after(page).images, 1) << page;
        EXPECT_EQ(after(page).version, 0xFFFF) << page;
        EXPECT_NE(after(page).session, 0x1234) << page;
    }
    EXPECT_EQ(after(0).images, -1); // nothing left that could start
}

TEST(Dmc60cSimulatorFlash, PowerCutBeforeTheFirstEraseKeepsTheOldApplication)
{
    Dmc60cBench bench;
    bench.wake();
    bench.send(vendorCommand(0xF0));
    ASSERT_TRUE(bench.hears(status(4)));
    sendPage(bench, 30, versionPage(0x0119));
    bench.advance(20ms);
    bench.device().setPowered(false);
    bench.advance(1s);
    EXPECT_EQ(enumerate(bench).images, -1);
    bench.device().setPowered(true);
    const Enumerated found = enumerate(bench);
    EXPECT_EQ(found.images, 0);
    EXPECT_EQ(found.version, 0x0117);
    EXPECT_NE(found.session, 0x1234);
}

TEST(Dmc60cSimulatorFlash, PageZeroWithoutPage30StartsABrokenApplication)
{
    Dmc60cBench bench("dmc60c:5,session=0x1234,state=bootloader");
    bench.wake();
    ASSERT_TRUE(writePage(bench, 30, versionPage(0x0119)));
    bench.send(vendorCommand(0xF0)); // already there, no restart
    ASSERT_TRUE(bench.hears(status(4)));
    bench.send(vendorCommand(0xF1)); // but this one forgets the version
    bench.advance(100ms);
    ASSERT_TRUE(writePage(bench, 0, blankPage()));
    bench.send(vendorCommand(0x61));
    EXPECT_TRUE(bench.hears("0206FC85#010000000901"));
    bench.send(vendorCommand(0xF1));
    bench.advance(100ms);
    EXPECT_NE(bench.event("bricked"), nullptr);
    EXPECT_EQ(enumerate(bench).images, -1);
}

TEST(Dmc60cSimulatorFlash, ParametersReachFlashAtOnceAfterQuietElse15SecondsAfterTheLastChange)
{
    Dmc60cBench bench;
    bench.wake();
    EXPECT_EQ(sequenceNumber(bench), 1U);
    bench.send(parameterSet(61, 30 << 16));
    ASSERT_NE(bench.next(id::paramResponse), nullptr);
    EXPECT_EQ(sequenceNumber(bench), 2U);
    bench.send(parameterSet(61, 31 << 16));
    ASSERT_NE(bench.next(id::paramResponse), nullptr);
    bench.advance(10s);
    EXPECT_EQ(sequenceNumber(bench), 2U);
    bench.send(parameterSet(61, 32 << 16));
    ASSERT_NE(bench.next(id::paramResponse), nullptr);
    bench.advance(14900ms);
    EXPECT_EQ(sequenceNumber(bench), 2U);
    bench.advance(200ms);
    EXPECT_EQ(sequenceNumber(bench), 3U);
    bench.send(parameterSet(93, 20)); // not kept, so not written
    bench.send(parameterSet(41, 20));
    bench.advance(30s);
    EXPECT_EQ(sequenceNumber(bench), 3U);
}

TEST(Dmc60cSimulatorFlash, AWriteToFlashKeepsTheFirstAnswerWaiting)
{
    Dmc60cBench bench;
    bench.wake();
    const Instant before = bench.clock().now();
    bench.send(parameterSet(61, 30 << 16));
    ASSERT_NE(bench.next(id::paramResponse), nullptr);
    EXPECT_GE(bench.clock().now() - before, 54ms);
    EXPECT_LE(bench.clock().now() - before, 56ms);
    const Instant second = bench.clock().now();
    bench.send(parameterSet(62, 30 << 16));
    ASSERT_NE(bench.next(id::paramResponse), nullptr);
    EXPECT_LE(bench.clock().now() - second, 1ms);
}

TEST(Dmc60cSimulatorFlash, LossOfSupplyForgetsWhatFlashDoesNotHave)
{
    Dmc60cBench bench;
    bench.wake();
    bench.send(parameterSet(61, 30 << 16));
    ASSERT_NE(bench.next(id::paramResponse), nullptr);
    bench.send(parameterSet(62, 50 << 16));
    bench.send(parameterSet(93, 20));
    bench.advance(1s);
    bench.device().setPowered(false);
    EXPECT_EQ(bench.clock().armed(), 0U);
    bench.device().setPowered(true);
    const auto session = static_cast<std::uint16_t>(enumerate(bench).session);
    const auto value = [&](std::uint8_t id) {
        std::array<std::uint8_t, 3> bytes{0, 0, id};
        writeU16le(bytes, 0, session);
        bench.send(extendedFrame(id::paramRequest | 5U, bytes));
        return readU32le(bench.next(id::paramResponse)->bytes(), 1);
    };
    EXPECT_EQ(value(61), 30U << 16U);
    EXPECT_EQ(value(62), 60U << 16U);
    EXPECT_EQ(value(93), 10U);
}

} // namespace
} // namespace mb::test
