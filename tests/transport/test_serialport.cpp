// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/descriptor.h"
#include "async/scope.h"
#include "async/virtualclock.h"
#include "support/eventloop.h"
#include "support/heldbackground.h"
#include "support/pseudoterminal.h"
#include "transport/backends/echofilter.h"
#include "transport/backends/ptyline.h"
#include "transport/backends/serialdriver.h"
#include "transport/backends/serialport.h"

#include <QSocketNotifier>

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <linux/serial.h>
#include <termios.h>

using namespace mb;
using namespace mb::test;
using namespace std::chrono_literals;

namespace {

using Bytes = std::vector<std::uint8_t>;

struct SerialPort : public ::testing::Test {
    std::unique_ptr<Link> make(const std::string &options = {})
    {
        auto link = makeSerialPortLink(LinkAddress::parse("serial:" + terminal.path() + options).value(), loop.clock());
        EXPECT_TRUE(link);
        return std::move(*link);
    }
    std::unique_ptr<SerialLink> open(const std::string &options = {})
    {
        auto link = make(options);
        const auto opened = link->open();
        EXPECT_TRUE(opened) << opened.error().text();
        std::unique_ptr<SerialLink> serial(static_cast<SerialLink *>(link.release()));
        received = serial->received().add(
            [this](std::span<const std::uint8_t> bytes) { heard.insert(heard.end(), bytes.begin(), bytes.end()); });
        return serial;
    }
    Bytes sent(std::size_t count)
    {
        Bytes all;
        loop.runUntil(
            [&] {
                const Bytes more = terminal.read();
                all.insert(all.end(), more.begin(), more.end());
                loop.clock().post([] {});
                return all.size() >= count;
            },
            5s);
        return all;
    }

    EventLoop loop;
    PseudoTerminal terminal;
    Bytes heard;
    Subscription received;
};

} // namespace

TEST_F(SerialPort, SendsBeforeSendReturnsAndReceivesWhatComes)
{
    const auto link = open();
    ASSERT_TRUE(link->send(Bytes{0x00, 0x11, 0x13, 0x0D, 0x0A, 0x03, 0xFF}));
    EXPECT_EQ(terminal.read(), (Bytes{0x00, 0x11, 0x13, 0x0D, 0x0A, 0x03, 0xFF})) << "changed, or not there yet";
    terminal.write({0x00, 0x11, 0x13, 0x0D, 0x0A, 0x03, 0x7F, 0xFF});
    ASSERT_TRUE(loop.runUntil([&] { return heard.size() >= 8; }));
    EXPECT_EQ(heard, (Bytes{0x00, 0x11, 0x13, 0x0D, 0x0A, 0x03, 0x7F, 0xFF}));
    EXPECT_EQ(link->counters().tx, 7U);
    EXPECT_EQ(link->counters().rx, 8U);
}

TEST_F(SerialPort, TakesAnyRateAndTellsTheOneThatTheAddressFixes)
{
    const auto link = open("?baud=59524");
    EXPECT_EQ(link->fixedBaudrate(), 59524);
    EXPECT_EQ(driverBaudrate(terminal.descriptor()), 59524);
    for (const int rate : {119048, 9600, 57600, 115200, 600, 1'000'000}) {
        ASSERT_TRUE(link->setBaudrate(rate)) << rate;
        EXPECT_EQ(driverBaudrate(terminal.descriptor()), rate);
        EXPECT_EQ(link->baudrate(), rate);
    }
}

TEST_F(SerialPort, HasTheFormatThatItsAddressNames)
{
    // A pseudo terminal keeps stop bits and the kind of parity, but not whether there is any.
    for (const auto &[format, kept] : std::initializer_list<std::pair<std::string, tcflag_t>>{
             {"8N2", CSTOPB}, {"8N1", 0}, {"8O1", PARODD}, {"8E1", 0}}) {
        const auto link = open("?format=" + format);
        termios settings{};
        ASSERT_EQ(::tcgetattr(terminal.descriptor(), &settings), 0);
        EXPECT_EQ(settings.c_cflag & (CSTOPB | PARODD), kept) << format;
    }
}

TEST_F(SerialPort, OpensAndChangesItsRateInTheBackgroundAndIsLostWhenItsDriverTakesTooLong)
{
    VirtualClock clock;
    HeldBackground background;
    auto made = makeSerialPortLink(LinkAddress::parse("serial:" + terminal.path()).value(), clock);
    ASSERT_TRUE(made);
    auto &link = static_cast<SerialLink &>(**made);
    link.settings().background = &background;
    Scope scope(clock);
    std::optional<Result<void>> ended;
    const auto begin = [&](Task<void> task) {
        ended.reset();
        scope.spawn<void>(std::move(task), [&ended](const Result<void> &result) { ended = result; });
        clock.advance(Link::openLimit - 1ms);
        EXPECT_FALSE(ended);
    };
    const auto finish = [&] {
        background.release();
        clock.advance(1us);
        return ended && *ended;
    };
    begin(link.openSoon());
    ASSERT_TRUE(finish());
    ASSERT_TRUE(link.send(Bytes{1, 2}));
    EXPECT_EQ(terminal.read(), (Bytes{1, 2}));
    begin(link.setBaudrateSoon(9600));
    ASSERT_TRUE(finish());
    EXPECT_EQ(driverBaudrate(terminal.descriptor()), 9600);
    EXPECT_EQ(link.baudrate(), 9600);
    begin(link.setBaudrateSoon(57600));
    clock.advance(1ms);
    ASSERT_TRUE(ended && !*ended);
    EXPECT_EQ(link.state(), LinkState::Lost);
    EXPECT_NE(link.loss().text().find("its driver has not answered for 5 s"), std::string::npos) << link.loss().text();
    background.release();
    EXPECT_EQ(driverBaudrate(terminal.descriptor()), 9600) << "too late";
}

TEST_F(SerialPort, LeavesItsRateBehindSoThatWhatIsSentLastGoesOutAtIt)
{
    const Descriptor guardians(::open(terminal.path().c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC));
    ASSERT_TRUE(setDriverBaudrate(guardians.get(), 9600));
    const auto link = open("?baud=57600");
    link->close();
    EXPECT_EQ(driverBaudrate(terminal.descriptor()), 57600) << "a guardian's stop goes out at another rate";
}

TEST_F(SerialPort, SendsAStopThatStillWaitsWhenItIsClosed)
{
    const Descriptor guardians(::open(terminal.path().c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC));
    const auto link = open("?baud=9600");
    ASSERT_TRUE(link->send(Bytes(64, 0x55)));
    ASSERT_TRUE(link->send(Bytes{0x01}));
    ASSERT_TRUE(link->send(Bytes{0xAA}, Priority::Urgent));
    ASSERT_TRUE(link->send(Bytes{0x02}));
    ASSERT_EQ(terminal.read(), Bytes(64, 0x55));
    link->close();
    EXPECT_EQ(terminal.read(), Bytes{0xAA}) << "the stop, and nothing of what was not urgent";
}

/// A port on virtual time whose other end does not read, as an adapter that hangs.
struct HeldUpPort : public SerialPort {
    HeldUpPort()
    {
        auto made
            = makeSerialPortLink(LinkAddress::parse("serial:" + terminal.path() + "?baud=1000000").value(), clock);
        EXPECT_TRUE(made && (*made)->open());
        link.reset(static_cast<SerialLink *>(made->release()));
    }
    void fill()
    {
        while (link->backlog() < 4096 && clock.now() < Instant(10s))
            sendFor(10ms);
        ASSERT_GE(link->backlog(), 4096U);
    }
    /// Pieces that the terminal takes or not, for that long.
    void sendFor(Duration time)
    {
        for (const Instant end = clock.now() + time; clock.now() < end && link->state() == LinkState::Open;) {
            (void)link->send(Bytes(512, 0x55));
            clock.advance(10ms);
            loop.runReady();
        }
    }

    VirtualClock clock;
    std::unique_ptr<SerialLink> link;
};

TEST_F(HeldUpPort, IsLostWhenItTakesNothingForASecondAndGoesOnWhenItDoes)
{
    fill();
    sendFor(700ms);
    while (!terminal.read().empty())
        loop.runReady();
    sendFor(700ms);
    EXPECT_EQ(link->state(), LinkState::Open) << "it was slow";
    sendFor(10s);
    ASSERT_EQ(link->state(), LinkState::Lost);
    EXPECT_EQ(
        link->loss().text(), link->address().shortName() + " takes no bytes any more; unplug it and plug it in again");
}

TEST_F(HeldUpPort, TakesAStopBeforeWhatItHasNotTaken)
{
    fill();
    ASSERT_TRUE(link->send(Bytes{0xAA}, Priority::Urgent));
    EXPECT_EQ(link->backlog(), 1U) << "on the wire, and nothing behind it";
    Bytes all;
    for (Bytes more = terminal.read(); !more.empty(); more = terminal.read()) {
        all.insert(all.end(), more.begin(), more.end());
        loop.runReady();
    }
    ASSERT_FALSE(all.empty());
    EXPECT_EQ(all.back(), 0xAA);
}

TEST_F(SerialPort, APieceWaitsUntilTheOneBeforeHasLeftAndAStopGoesFirst)
{
    const auto link = open("?baud=9600");
    const Instant start = loop.clock().now();
    ASSERT_TRUE(link->send(Bytes(20, 1)));
    ASSERT_TRUE(link->send(Bytes(20, 2)));
    ASSERT_TRUE(link->send(Bytes{9}, Priority::Urgent));
    EXPECT_GT(link->backlog(), 1U);
    EXPECT_EQ(terminal.read(), Bytes(20, 1));
    EXPECT_EQ(sent(1), Bytes{9});
    EXPECT_GE(loop.clock().now() - start, 20 * link->byteTime());
    EXPECT_EQ(link->counters().lost, 20U) << "an older order followed the stop";
}

TEST_F(SerialPort, AHalfDuplexLineRestsForOneByteBeforeItTurnsRound)
{
    const auto link = open("?baud=600&echo=1");
    Instant heardAt{};
    const auto answer = link->received().add([&](std::span<const std::uint8_t>) {
        heardAt = loop.clock().now();
        EXPECT_TRUE(link->send(Bytes{2}));
        EXPECT_EQ(terminal.read(), Bytes{});
    });
    terminal.write({1});
    EXPECT_EQ(sent(1), Bytes{2});
    EXPECT_GE(loop.clock().now() - heardAt, link->byteTime());
}

TEST_F(SerialPort, TakesItsOwnEchoOutAndCountsOneThatWasChanged)
{
    const auto link = open("?echo=1");
    ASSERT_TRUE(link->send(Bytes{1, 2, 3}));
    EXPECT_EQ(sent(3), (Bytes{1, 2, 3}));
    terminal.write({1, 2});
    terminal.write({3, 7, 8});
    ASSERT_TRUE(loop.runUntil([&] { return heard.size() >= 2; }));
    EXPECT_EQ(heard, (Bytes{7, 8}));
    EXPECT_EQ(link->counters().errors, 0U);
    ASSERT_TRUE(link->send(Bytes{1, 2, 3}));
    EXPECT_EQ(sent(3), (Bytes{1, 2, 3}));
    heard.clear();
    terminal.write({1, 9, 3});
    ASSERT_TRUE(loop.runUntil([&] { return heard.size() >= 2; }));
    EXPECT_EQ(heard, (Bytes{9, 3}));
    EXPECT_EQ(link->counters().errors, 1U);
}

TEST_F(SerialPort, AnEchoThatIsStillExpectedIsForgottenWithTheClosedPort)
{
    const auto link = open("?echo=1");
    ASSERT_TRUE(link->send(Bytes{1, 2, 3}));
    EXPECT_EQ(sent(3), (Bytes{1, 2, 3}));
    link->close();
    ASSERT_TRUE(link->open());
    terminal.write({1, 2, 3});
    ASSERT_TRUE(loop.runUntil([&] { return heard.size() >= 3; })) << "that is somebody else";
    EXPECT_EQ(heard, (Bytes{1, 2, 3}));
}

TEST(EchoFilter, LetsAnAnswerThroughWhenTheEchoNeverCame)
{
    EchoFilter filter;
    filter.expect(Bytes{1, 2}, Instant{} + 10ms);
    Bytes others;
    EXPECT_TRUE(filter.take(Instant{} + 11ms, Bytes{1, 2, 5}, others));
    EXPECT_EQ(others, (Bytes{1, 2, 5}));
}

TEST_F(SerialPort, AnEchoIsAwaitedForATenthOfASecondAfterItsLastByte)
{
    VirtualClock clock;
    auto made
        = makeSerialPortLink(LinkAddress::parse("serial:" + terminal.path() + "?echo=1&baud=1000").value(), clock);
    ASSERT_TRUE(made && (*made)->open());
    auto &link = static_cast<SerialLink &>(**made);
    received = link.received().add(
        [this](std::span<const std::uint8_t> bytes) { heard.insert(heard.end(), bytes.begin(), bytes.end()); });
    clock.advance(1s);
    for (const Duration late : {0ns, 1ns}) {
        ASSERT_TRUE(link.send(Bytes{1, 2, 3}));
        clock.advance(30ms + 100ms + late);
        terminal.write({1, 2, 3, 9});
        ASSERT_TRUE(loop.runUntil([this] { return !heard.empty(); }));
        EXPECT_EQ(heard, late == 0ns ? Bytes{9} : (Bytes{1, 2, 3, 9}));
        heard.clear();
        clock.advance(1s);
    }
}

TEST_F(SerialPort, APortThatGoesAwayInMidFrameIsLostWithItsRemedyAndWhatCameBeforeIsThere)
{
    const auto link = open();
    terminal.write({0x55, 0xAA, 0x01});
    ASSERT_TRUE(loop.runUntil([&] { return heard.size() >= 3; }));
    terminal.write({0x04});
    terminal.pull();
    ASSERT_TRUE(loop.runUntil([&] { return link->state() == LinkState::Lost; }));
    EXPECT_EQ(link->loss().message(), "the other end of " + link->address().shortName() + " hung up; start it again");
    const auto refused = link->send(Bytes{1});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().fault, Fault::LinkLost);
    EXPECT_EQ(refused.error().text(), link->loss().message());
    const auto again = link->open();
    ASSERT_FALSE(again);
    EXPECT_NE(again.error().text().find("there is no"), std::string::npos) << again.error().text();
}

TEST_F(SerialPort, APortWhoseLossIsNoticedByAWriteTellsItFromTheClock)
{
    const auto link = open();
    bool isSending = false;
    bool wasToldWithin = false;
    const auto telling = link->stateChanged().add([&](LinkState) { wasToldWithin = isSending; });
    terminal.pull();
    isSending = true;
    (void)link->send(Bytes{1});
    isSending = false;
    ASSERT_TRUE(loop.runUntil([&] { return link->state() == LinkState::Lost; }));
    EXPECT_FALSE(wasToldWithin) << "whoever sends does not expect to be called back";
}

TEST_F(SerialPort, MayBeClosedAndOpenedAgainWhileItReceives)
{
    const auto link = open();
    int chunks = 0;
    const auto closing = link->received().add([&](std::span<const std::uint8_t>) {
        ++chunks;
        link->close();
        EXPECT_TRUE(link->open());
    });
    terminal.write({1});
    ASSERT_TRUE(loop.runUntil([&] { return chunks == 1; }));
    terminal.write({2});
    ASSERT_TRUE(loop.runUntil([&] { return chunks == 2; }));
    EXPECT_EQ(heard, (Bytes{1, 2}));
}

TEST_F(SerialPort, ASecondProgramIsToldThatItIsInUse)
{
    const auto link = open();
    const auto second = make();
    const auto opened = second->open();
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().fault, Fault::LinkLost);
    EXPECT_NE(opened.error().text().find("in use by another program; close that one first"), std::string::npos)
        << opened.error().text();
    link->close();
    EXPECT_TRUE(second->open());
}

TEST_F(SerialPort, AnRs485LineWhoseDriverCannotSwitchOpensWithARemark)
{
    const auto link = open("?rs485=1");
    EXPECT_NE(link->remark().english().find("cannot switch the direction"), std::string::npos) << link->remark();
    EXPECT_TRUE(link->send(Bytes{1}));
}

TEST_F(SerialPort, GivesTheGuardianItsDescriptorWhileItIsOpen)
{
    const auto link = open();
    const Outlet outlet = link->outlet();
    EXPECT_EQ(outlet.form, Outlet::Form::Stream);
    const Bytes stop{7};
    EXPECT_EQ(::write(outlet.descriptor, stop.data(), 1), 1);
    EXPECT_EQ(terminal.read(), stop);
    link->close();
    EXPECT_FALSE(link->outlet().isInheritable());
}

TEST_F(SerialPort, AnAnswerThatItsGuardianReadsFirstIsNoLostLink)
{
    // Another descriptor that is ready in the same turn of the loop plays the guardian: it reads what we were told of.
    const PseudoTerminal trigger;
    const int other = ::open(trigger.path().c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK);
    ASSERT_GE(other, 0);
    for (const bool first : {true, false}) {
        std::unique_ptr<SerialLink> link;
        std::unique_ptr<QSocketNotifier> thief;
        const auto hire = [&] { thief = std::make_unique<QSocketNotifier>(other, QSocketNotifier::Read); };
        if (first)
            hire();
        link = open();
        if (!first)
            hire();
        bool stole = false;
        QObject::connect(thief.get(), &QSocketNotifier::activated, thief.get(), [&] {
            std::array<char, 64> taken{};
            stole = ::read(link->outlet().descriptor, taken.data(), taken.size()) > 0 || stole;
            (void)::read(other, taken.data(), taken.size());
        });
        terminal.write({1, 2, 3});
        trigger.write({1});
        loop.runReady();
        EXPECT_EQ(link->state(), LinkState::Open) << first << stole;
        heard.clear();
        terminal.write({4, 5});
        EXPECT_TRUE(loop.runUntil([&] { return heard.size() >= 2; }, 5s)) << "it still listens";
        link->close();
        loop.runReady();
    }
    ::close(other);
}

TEST(SerialPortErrors, BytesThatWereLostInTheDriverOrBehindItCountAndSoDoBadOnes)
{
    serial_icounter_struct counted{};
    counted.frame = 1;
    counted.parity = 20;
    counted.brk = 300;
    counted.overrun = 4000;
    counted.buf_overrun = 50000;
    counted.rx = counted.tx = counted.cts = 7; // none of them is an error
    EXPECT_EQ(errorsOf(counted).framing, 321U);
    EXPECT_EQ(errorsOf(counted).overrun, 54000U);
}

TEST(SerialPortCauses, NameWhatIsMissingAndWhatHelps)
{
    EventLoop loop;
    const auto causeOf = [&loop](const std::string &path) {
        auto link = makeSerialPortLink(LinkAddress::parse("serial:" + path).value(), loop.clock());
        const auto opened = (*link)->open();
        EXPECT_FALSE(opened) << path;
        EXPECT_EQ((*link)->state(), LinkState::Closed);
        return opened ? std::string() : opened.error().text();
    };
    EXPECT_EQ(causeOf("ttyNOSUCH7"), "there is no ttyNOSUCH7; plug in the adapter, or name another port");
    EXPECT_EQ(causeOf("/etc/passwd"), "/etc/passwd is no serial port; name one such as /dev/ttyUSB0");
    EXPECT_NE(causeOf("/dev/null").find("cannot be opened"), std::string::npos);
    for (const char *options : {"?baud=0", "?baud=fast", "?baud=5000000", "?rs485=yes", "?rs485=2", "?rs485=-1",
             "?echo=2", "?parity=even", "?format=7N1", "?format=8N3", "?format=1"}) {
        const auto link
            = makeSerialPortLink(LinkAddress::parse(std::string("serial:x") + options).value(), loop.clock());
        ASSERT_FALSE(link) << options;
        EXPECT_EQ(link.error().fault, Fault::OutOfRange);
    }
    for (const char *options : {"?baud=600", "?format=8N1", "?format=8E1", "?format=8O1", "?format=8N2", "?rs485=0",
             "?rs485=1", "?echo=0", "?echo=1"})
        EXPECT_TRUE(makeSerialPortLink(LinkAddress::parse(std::string("serial:x") + options).value(), loop.clock()))
            << options;
}
