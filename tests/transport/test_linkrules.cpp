// SPDX-License-Identifier: GPL-3.0-or-later
// What every link does whatever is behind it: who may send, what is counted, how busy a line is, what is known of a bus.
#include "async/scope.h"
#include "async/virtualclock.h"
#include "support/heldbackground.h"
#include "transport/backends/socketcan.h"
#include "transport/canlink.h"
#include "transport/seriallink.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace mb {
namespace {

using namespace std::chrono_literals;
using Bytes = std::vector<std::uint8_t>;

/// A CAN link without a bus: takes all, and is told what it hears.
class BareCan final : public CanLink {
public:
    explicit BareCan(Clock &clock)
        : CanLink(LinkAddress{"socketcan", "can7", {}}, clock)
    {
    }
    using CanLink::deliver;
    using CanLink::startHealth;
    using CanLink::updateHealth;
    using Link::lose;

    int rate = 0;
    int closings = 0;
    std::vector<std::string> sent;
    Result<void> opening;
    std::function<void()> whileOpening;

private:
    Result<void> doOpen() override
    {
        if (whileOpening)
            whileOpening();
        return opening;
    }
    void doClose() override { ++closings; }
    [[nodiscard]] Outlet doOutlet() const override { return {Outlet::Form::CanSocket, 7}; }
    Result<void> doSend(const CanFrame &frame, Priority) override
    {
        sent.push_back(toText(frame));
        return {};
    }
    [[nodiscard]] std::size_t doBacklog() const override { return 0; }
    [[nodiscard]] int doBitrate() const override { return rate; }
};

class BareSerial final : public SerialLink {
public:
    BareSerial(const std::string &address, Clock &clock)
        : SerialLink(*LinkAddress::parse(address), clock)
    {
    }
    using SerialLink::deliver;
    using SerialLink::reportLineError;

    std::vector<int> rates;
    bool hangs = false; ///< its driver, when the rate is changed in the background

private:
    Result<void> doOpen() override { return {}; }
    void doClose() override { }
    [[nodiscard]] Outlet doOutlet() const override { return {}; }
    Result<void> doSend(std::span<const std::uint8_t>, Priority) override { return {}; }
    [[nodiscard]] std::size_t doBacklog() const override { return 0; }
    Result<void> doSetBaudrate(int baudrate) override
    {
        rates.push_back(baudrate);
        return {};
    }
    Task<void> doSetBaudrateSoon(Background &, int baudrate) override
    {
        if (hangs)
            co_await m_never.wait();
        co_return doSetBaudrate(baudrate);
    }

    Event m_never;
};

class CanRules : public testing::Test {
protected:
    CanRules()
    {
        clock.advance(10s);
        EXPECT_TRUE(link.open());
    }
    void error(const std::string &frame, Duration at)
    {
        CanFrame seen = *canFrameFromText(frame);
        seen.time = Instant{at};
        link.deliver(seen);
    }
    VirtualClock clock;
    BareCan link{clock};
};

TEST(SocketCanRules, IsOpenedInTheBackgroundBecauseADriverMayHoldUpWhatTheKernelSays)
{
    VirtualClock clock;
    test::HeldBackground background;
    SocketCanLink link({"socketcan", "mbnone0", {}}, clock);
    link.settings().background = &background;
    Scope scope(clock);
    std::optional<Result<void>> opened;
    scope.spawn<void>(link.openSoon(), [&opened](const Result<void> &result) { opened = result; });
    clock.advance(Link::openLimit - 1ms);
    EXPECT_FALSE(opened);
    ASSERT_EQ(background.waiting(), 1U);
    EXPECT_EQ(background.lane(), "can:mbnone0");
    clock.advance(2ms);
    ASSERT_TRUE(opened && !*opened);
    EXPECT_NE(opened->error().text().find("a driver holds it up"), std::string::npos) << opened->error().text();
    background.release();
}

TEST_F(CanRules, OnlyFramesAreSent)
{
    const auto frame = [](std::uint32_t id, bool extended, std::size_t size) {
        CanFrame made;
        made.id = id;
        made.extended = extended;
        made.size = static_cast<std::uint8_t>(size);
        return made;
    };
    EXPECT_TRUE(link.send(frame(0x7FF, false, 8)));
    EXPECT_TRUE(link.send(frame(0x1FFFFFFF, true, 0)));
    EXPECT_EQ(link.send(frame(0x800, false, 0)).error().fault, Fault::OutOfRange);
    EXPECT_EQ(link.send(frame(0x20000000, true, 0)).error().fault, Fault::OutOfRange);
    EXPECT_EQ(link.send(frame(1, false, 9)).error().fault, Fault::OutOfRange);
    CanFrame error = frame(1, false, 8);
    error.error = true;
    EXPECT_EQ(link.send(error).error().fault, Fault::OutOfRange);
    link.close();
    EXPECT_EQ(link.send(frame(1, false, 0)).error().fault, Fault::LinkLost);
    EXPECT_EQ(link.sent.size(), 2U);
    EXPECT_EQ(link.counters().tx, 2U);
}

TEST_F(CanRules, TheLoadIsTheBitsOfTheLastSecondAtTheKnownRateOrAtOneMegabit)
{
    clock.advance(1s); // its second begins
    CanFrame extended = extendedFrame(0x100, {1, 2, 3, 4, 5, 6, 7, 8});
    for (int i = 0; i < 10; ++i)
        ASSERT_TRUE(link.send(extended)); // 67 + 64, and 10 stuff bits
    CanFrame heard = *canFrameFromText("123#01");
    heard.time = clock.now();
    link.deliver(heard); // 47 + 8, and 4
    clock.advance(1s);
    constexpr double bits = 10 * 141 + 59;
    EXPECT_NEAR(link.load(clock.now()).value_or(0.0), bits / 1e6, 1e-12);
    link.rate = 125'000;
    EXPECT_NEAR(link.load(clock.now()).value_or(0.0), bits / 125e3, 1e-12);
    link.rate = 1000;
    EXPECT_EQ(link.load(clock.now()), 1.0) << "no more than all of it";
    clock.advance(1s);
    EXPECT_EQ(link.load(clock.now()), 0.0);
}

TEST_F(CanRules, AFrameTakesItsTimeOnAWireWhoseRateIsKnown)
{
    const CanFrame frame = *canFrameFromText("123#01");
    EXPECT_EQ(link.wireTime(frame), 0ns);
    link.rate = 1;
    EXPECT_EQ(link.wireTime(frame), std::chrono::seconds(bitsOnWire(frame)));
    link.rate = 1'000'000;
    EXPECT_EQ(link.wireTime(frame), std::chrono::microseconds(bitsOnWire(frame)));
}

TEST_F(CanRules, EachErrorFrameIsCountedAsWhatItTells)
{
    int frames = 0;
    int errors = 0;
    const auto heard = link.received().add([&frames](const CanFrame &) { ++frames; });
    const auto told = link.errorFrames().add([&errors](const CanFrame &) { ++errors; });
    error("20000020#0000000000000000", 1s); // nobody acknowledged
    error("20000002#0500000000000000", 2s); // arbitration lost
    error("20000008#0000040000000000", 3s); // a violation
    error("20000004#0001000000000000", 4s); // an overrun of the receiver
    error("20000100#0000000000000000", 5s); // started again
    const BusHealth &health = link.health();
    EXPECT_EQ(health.acknowledgeErrors, 1U);
    EXPECT_EQ(health.arbitrationLosses, 1U);
    EXPECT_EQ(health.protocolErrors, 1U);
    EXPECT_EQ(health.overruns, 1U);
    EXPECT_EQ(health.restarts, 1U);
    EXPECT_EQ(health.lastAcknowledgeError, Instant{1s});
    EXPECT_EQ(health.lastProtocolError, Instant{3s});
    EXPECT_EQ(health.lastError, Instant{5s});
    EXPECT_FALSE(health.lastReceived);
    EXPECT_EQ(link.counters().errors, 5U);
    EXPECT_EQ(link.counters().rx, 5U);
    EXPECT_EQ(errors, 5);
    EXPECT_EQ(frames, 0) << "an error is no message";
    error("20000200#0000000000000703", 6s); // counters
    EXPECT_EQ(health.transmitErrors, 7);
    EXPECT_EQ(health.receiveErrors, 3);
    error("20000020#0000000000000000", 7s);
    EXPECT_EQ(health.transmitErrors, 7) << "as last told";
    link.startHealth(BusState::Active, std::nullopt, 1);
    EXPECT_FALSE(health.transmitErrors);
    EXPECT_EQ(health.receiveErrors, 1);
    EXPECT_FALSE(health.lastAcknowledgeError);
    EXPECT_FALSE(health.lastProtocolError);
    EXPECT_EQ(health.acknowledgeErrors, 2U) << "a count stays";
    link.updateHealth(BusState::Passive, 200, 4);
    EXPECT_EQ(health.state, BusState::Passive);
    EXPECT_EQ(health.transmitErrors, 200);
}

// Any link

TEST_F(CanRules, OpeningAndClosingAreToldOnceAndTheCountersBeginWithAnOpening)
{
    std::vector<LinkState> states;
    const auto told = link.stateChanged().add([&states](LinkState state) { states.push_back(state); });
    ASSERT_TRUE(link.open());
    ASSERT_TRUE(link.send(*canFrameFromText("123#01")));
    EXPECT_TRUE(states.empty());
    link.lose({Fault::LinkLost, say("cut")});
    link.lose({Fault::LinkLost, say("cut again")});
    EXPECT_EQ(link.loss().message(), "cut");
    EXPECT_EQ(link.send(*canFrameFromText("123#01")).error().message(), "cut");
    ASSERT_TRUE(link.open());
    EXPECT_EQ(link.closings, 1) << "what was lost is closed before it is opened again";
    EXPECT_EQ(link.counters().tx, 1U) << "it counts on after a loss";
    EXPECT_TRUE(link.loss().detail.empty());
    link.close();
    link.close();
    EXPECT_EQ(link.closings, 2);
    EXPECT_EQ(link.send(*canFrameFromText("123#01")).error().message(), "can7 is not open");
    ASSERT_TRUE(link.open());
    EXPECT_EQ(link.counters().tx, 0U);
    EXPECT_EQ(states, (std::vector<LinkState>{LinkState::Lost, LinkState::Open, LinkState::Closed, LinkState::Open}));
}

TEST_F(CanRules, ALinkThatIsClosedForAReasonIsALostOne)
{
    link.closedFor(say("avrdude had the port"));
    EXPECT_EQ(link.state(), LinkState::Open) << "it is in use";
    link.close();
    link.closedFor(say("avrdude had the port"));
    EXPECT_EQ(link.state(), LinkState::Lost);
    EXPECT_EQ(link.loss().message(), "avrdude had the port");
    link.close();
    link.opening = fail(Fault::LinkLost, say("there is none"));
    EXPECT_FALSE(link.open());
    EXPECT_EQ(link.state(), LinkState::Closed);
}

TEST_F(CanRules, AnotherAdapterThatTakesItsNameWhileItIsOpenedIsNotOpened)
{
    std::string place = "usb:1/can";
    link.close();
    link.settings().identify = [&place](const LinkAddress &) { return place; };
    BareCan other(clock);
    other.settings().identify = link.settings().identify;
    ASSERT_TRUE(other.open());
    EXPECT_EQ(other.line(), "usb:1/can");
    other.close();
    const int before = other.closings;
    other.whileOpening = [&place] { place = "usb:2/can"; };
    const auto opened = other.open();
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().fault, Fault::LinkLost);
    EXPECT_EQ(opened.error().text(),
        "another adapter is called can7 now; close the link, and open it again to see who is there");
    EXPECT_EQ(other.closings, before + 1);
    EXPECT_EQ(other.state(), LinkState::Closed);
    EXPECT_EQ(other.line(), "usb:1/can");
}

TEST_F(CanRules, WhoWritesToItsDescriptorIsToldOfOneThatIs)
{
    EXPECT_EQ(link.outlet().form, Outlet::Form::CanSocket);
    EXPECT_EQ(link.outlet().descriptor, 7);
    EXPECT_TRUE(link.outlet().isInheritable());
    const BareSerial simulated("sim:serial", clock);
    EXPECT_EQ(simulated.outlet().form, Outlet::Form::InProcess);
    EXPECT_EQ(simulated.outlet().descriptor, -1);
    EXPECT_FALSE(simulated.outlet().isInheritable());
}

// Serial lines

class SerialRules : public testing::Test {
protected:
    VirtualClock clock;
    BareSerial link{"serial:/dev/ttyUSB7", clock};
};

TEST_F(SerialRules, ARateIsFrom50To4000000AndIsSetOnceItIsAnother)
{
    EXPECT_EQ(link.baudrate(), 115200);
    EXPECT_TRUE(link.setBaudrate(9600));
    EXPECT_TRUE(link.rates.empty()) << "it opens with it";
    ASSERT_TRUE(link.open());
    for (const int good : {50, 4'000'000, 4'000'000}) {
        EXPECT_TRUE(link.setBaudrate(good)) << good;
        EXPECT_EQ(link.baudrate(), good);
    }
    EXPECT_EQ(link.rates, (std::vector<int>{50, 4'000'000}));
    for (const int bad : {49, 0, -1, 4'000'001}) {
        EXPECT_EQ(link.setBaudrate(bad).error().fault, Fault::OutOfRange) << bad;
        auto soon = link.setBaudrateSoon(bad);
        soon.start();
        EXPECT_FALSE(soon.result());
        EXPECT_EQ(link.baudrate(), 4'000'000);
    }
    auto soon = link.setBaudrateSoon(57600);
    soon.start();
    EXPECT_TRUE(soon.result()) << "without a background it is done at once";
    EXPECT_EQ(link.rates.back(), 57600);
    EXPECT_EQ(link.baudrate(), 57600);
}

TEST_F(SerialRules, ARateWhoseChangeWasGivenUpIsSetAgainWhicheverIsWanted)
{
    class Later final : public Background {
    public:
        void run(const std::string &, std::function<void()>, std::function<void()>) override { }
    } never;
    ASSERT_TRUE(link.open());
    link.hangs = true;
    link.settings().background = &never;
    {
        Scope scope(clock);
        scope.spawn<void>(link.setBaudrateSoon(19200));
        clock.advance(1ms);
    }
    EXPECT_TRUE(link.setBaudrate(115200));
    EXPECT_EQ(link.rates.back(), 115200) << "the port may have the other one by now";
}

TEST_F(SerialRules, AnAddressFixesARateThatIsOne)
{
    EXPECT_EQ(BareSerial("serial:/dev/ttyUSB7?baud=1", clock).fixedBaudrate(), 1);
    EXPECT_EQ(BareSerial("serial:/dev/ttyUSB7?baud=9600", clock).baudrate(), 9600);
    for (const char *none : {"serial:/dev/ttyUSB7?baud=0", "serial:/dev/ttyUSB7?baud=-5", "serial:/dev/ttyUSB7?baud=x",
             "serial:/dev/ttyUSB7?bitrate=9600"}) {
        const BareSerial usual(none, clock);
        EXPECT_FALSE(usual.fixedBaudrate()) << none;
        EXPECT_EQ(usual.baudrate(), 115200);
    }
    EXPECT_EQ(BareSerial("sim:serial?bitrate=9600", clock).fixedBaudrate(), 9600);
}

TEST_F(SerialRules, BytesOfBothDirectionsAreCountedAndAreTheLoadWithTenBitsEach)
{
    clock.advance(10s);
    EXPECT_EQ(link.send(Bytes{1}).error().fault, Fault::LinkLost);
    ASSERT_TRUE(link.open());
    EXPECT_EQ(link.send({}).error().fault, Fault::OutOfRange);
    ASSERT_TRUE(link.send(Bytes(100, 1)));
    link.deliver(clock.now(), Bytes(52, 2));
    clock.advance(1s);
    EXPECT_NEAR(link.load(clock.now()).value_or(0.0), 1520.0 / 115200.0, 1e-12);
    EXPECT_EQ(link.counters().tx, 100U);
    EXPECT_EQ(link.counters().rx, 52U);
    int errors = 0;
    const auto told = link.lineErrors().add([&errors] { ++errors; });
    link.reportLineError();
    EXPECT_EQ(errors, 1);
    EXPECT_EQ(link.counters().errors, 1U);
    ASSERT_TRUE(link.setBaudrate(1000));
    EXPECT_EQ(link.byteTime(), 10ms);
}

TEST_F(SerialRules, ARoundTripIsSmoothedOverSixteen)
{
    EXPECT_FALSE(link.roundTrip());
    link.noteRoundTrip(16ms);
    EXPECT_EQ(link.roundTrip(), 16ms);
    link.noteRoundTrip(32ms);
    EXPECT_EQ(link.roundTrip(), 17ms);
    link.noteRoundTrip(1ms);
    EXPECT_EQ(link.roundTrip(), 16ms);
}

} // namespace
} // namespace mb
