// SPDX-License-Identifier: GPL-3.0-or-later
// An update whose link goes and comes back (dmc60c/README.md#updates).
#include "support/hextext.h"
#include "support/simulatedsession.h"
#include "transport/backends/virtualcan.h"

#include <algorithm>
#include <map>

namespace mb {
namespace {

using namespace std::chrono_literals;
using test::run;

/// A link to a virtual bus whose adapter can be pulled out.
class Pluggable final : public CanLink {
public:
    Pluggable(VirtualCanBus &bus, Clock &clock)
        : CanLink(*LinkAddress::parse("sim:can"), clock)
        , m_port(*LinkAddress::parse("sim:can"), bus)
    {
        EXPECT_TRUE(m_port.open());
    }
    ~Pluggable() override { close(); }
    void pullOut()
    {
        m_isThere = false;
        m_received.reset();
        lose({Fault::LinkLost, say("the adapter is gone")});
    }
    void plugIn() { m_isThere = true; }

private:
    Result<void> doOpen() override
    {
        if (!m_isThere)
            return fail(Fault::LinkLost, say("there is no such adapter"));
        m_received = m_port.received().add([this](const CanFrame &frame) { deliver(frame); });
        return {};
    }
    void doClose() override { m_received.reset(); }
    Result<void> doSend(const CanFrame &frame, Priority priority) override { return m_port.send(frame, priority); }
    [[nodiscard]] std::size_t doBacklog() const override { return m_port.backlog(); }
    [[nodiscard]] int doBitrate() const override { return m_port.bitrate(); }

    VirtualCanLink m_port;
    bool m_isThere = true;
    Subscription m_received;
};

struct Watch final : Progress {
    void step(const Message &what, int, int) override { now = what.english(); }
    void part(int number, PartState state) override { parts[number] = state; }
    void replaces(const std::string &version) override { before = version; }
    void log(Severity, const Message &text) override { lines += text.english() + '\n'; }
    void mayInterrupt(bool may) override { interruptible = may; }
    [[nodiscard]] bool told(const std::string &text) const { return lines.find(text) != std::string::npos; }

    std::string now;
    std::string lines;
    std::string before;
    std::map<int, PartState> parts;
    bool interruptible = true;
};

struct LossBench {
    explicit LossBench(const std::string &unit = "dmc60c:5")
        : bus(clock, 1'000'000, 1)
        , host(bus, clock)
        , port(*LinkAddress::parse("sim:can"), bus)
    {
        EXPECT_TRUE(host.open());
        EXPECT_TRUE(port.open());
        simulator = std::move(*family.simulate(port, clock, *SimulatedUnit::parse(unit)));
        events = simulator->events().add([this](const SimulatorEvent &event) {
            if (event.what == "page-written")
                pages.push_back(static_cast<int>(event.value));
        });
        struct Sink final : ScanSink {
            void found(const Identity &identity) override { last = identity; }
            void progress(const Message &, int, int) override { }
            std::optional<Identity> last;
        } sink;
        EXPECT_TRUE(run(clock, family.scan(host, clock, sink)));
        device = family.open(host, clock, *sink.last);
    }
    /// Pages 0, 1 and 30.
    void begin(UpdateOptions options = {})
    {
        task = family.update(*device, image, std::move(options), watch);
        task->start();
    }
    [[nodiscard]] bool reaches(const std::string &step)
    {
        return clock.runUntil([&] { return watch.now == step || task->isFinished(); }, 1min) && !task->isFinished();
    }
    UpdateReport end()
    {
        EXPECT_TRUE(clock.runUntil([&] { return task->isFinished(); }, 10min));
        EXPECT_TRUE(task->result());
        return task->result().value_or(UpdateReport{});
    }

    const FirmwareImage image
        = *FirmwareImage::fromIntelHex(test::smallApplication(0x0119).add(0x1000, {0x12, 0x34, 0x56, 0x00}).text());
    const Family &family = *findFamily(families(), "dmc60c");
    VirtualClock clock;
    VirtualCanBus bus;
    Pluggable host;
    VirtualCanLink port;
    std::unique_ptr<Simulator> simulator;
    std::vector<int> pages;
    Subscription events;
    Watch watch;
    std::unique_ptr<Device> device;
    std::optional<Task<UpdateReport>> task;
};

void expectDoneAgain(const UpdateReport &report, const std::string &what)
{
    EXPECT_EQ(report.outcome, UpdateOutcome::Done) << what << ": " << report.evidence;
    EXPECT_TRUE(report.verified) << what;
    EXPECT_EQ(report.to, "1.25") << what;
}

TEST(Dmc60cLinkLoss, AnUpdateWaitsForItsLinkAndBeginsAgainAtPage30)
{
    for (const char *const step : {"Enter bootloader", "Page 30", "Page 1", "Page 0"}) {
        for (const Duration into : {Duration(1ms), Duration(30ms), Duration(75ms)}) {
            LossBench bench;
            bench.begin();
            ASSERT_TRUE(bench.reaches(step));
            bench.clock.advance(into);
            bench.host.pullOut();
            ASSERT_TRUE(bench.reaches("Wait for sim:can")) << step;
            EXPECT_TRUE(bench.watch.told("waiting up to 30 s for it to come back")) << bench.watch.lines;
            EXPECT_TRUE(bench.watch.interruptible) << step;
            bench.clock.advance(10s);
            bench.host.plugIn();
            const std::size_t before = bench.pages.size();
            expectDoneAgain(bench.end(), step);
            EXPECT_TRUE(bench.watch.told("sim:can is back")) << bench.watch.lines;
            const std::vector<int> since(bench.pages.begin() + static_cast<std::ptrdiff_t>(before), bench.pages.end());
            if (!bench.watch.told("all pages are in the unit")) {
                EXPECT_EQ(since, (std::vector<int>{30, 1, 0})) << step << ": never on in the middle";
            } else {
                EXPECT_EQ(std::string(step), "Page 0");
            }
        }
    }
}

TEST(Dmc60cLinkLoss, AUnitThatLostItsPowerMeanwhileIsUpdatedAllTheSame)
{
    LossBench bench;
    bench.begin();
    ASSERT_TRUE(bench.reaches("Page 1"));
    bench.host.pullOut();
    bench.clock.advance(1s);
    bench.simulator->setPowered(false);
    bench.simulator->setPowered(true);
    bench.clock.advance(1s);
    bench.host.plugIn();
    expectDoneAgain(bench.end(), "another session");
}

TEST(Dmc60cLinkLoss, PagesThatAreSentAgainAreShownAsWaitingAgain)
{
    LossBench bench;
    bench.begin();
    ASSERT_TRUE(bench.reaches("Page 1"));
    EXPECT_EQ(bench.watch.before, "1.23");
    EXPECT_EQ(bench.watch.parts[30], PartState::Done);
    bench.host.pullOut();
    bench.clock.advance(1s);
    bench.simulator->setPowered(false);
    bench.simulator->setPowered(true);
    bench.host.plugIn();
    ASSERT_TRUE(bench.reaches("Enter bootloader"));
    EXPECT_EQ(bench.watch.parts[30], PartState::Waiting);
    EXPECT_EQ(bench.watch.parts[1], PartState::Waiting);
    expectDoneAgain(bench.end(), "again");
}

TEST(Dmc60cLinkLoss, AUnitThatRestartsInEveryRoundIsGivenUpAfterTheFourth)
{
    LossBench bench;
    bench.begin();
    int rounds = 0;
    while (bench.reaches("Enter bootloader") && bench.reaches("Page 1")) {
        ++rounds;
        bench.simulator->setPowered(false);
        bench.simulator->setPowered(true);
    }
    EXPECT_EQ(rounds, 4);
    const UpdateReport report = bench.end();
    EXPECT_EQ(report.fault, Fault::Refused);
    EXPECT_TRUE(report.evidence.english().starts_with("the device restarted 4 times")) << report.evidence;
}

TEST(Dmc60cLinkLoss, AUnitWithoutANumberHasNoneAfterItsUpdateEither)
{
    LossBench bench("dmc60c:0");
    bench.begin();
    expectDoneAgain(bench.end(), "number 0");
    EXPECT_EQ(bench.device->identity().state, DeviceState::Unassigned);
}

TEST(Dmc60cLinkLoss, WhatIsWrittenIsNotWrittenAgain)
{
    LossBench bench;
    bench.begin();
    ASSERT_TRUE(bench.reaches("Restart"));
    bench.host.pullOut();
    bench.clock.advance(5s);
    bench.host.plugIn();
    expectDoneAgain(bench.end(), "while it restarted");
    EXPECT_EQ(bench.pages, (std::vector<int>{30, 1, 0}));
    EXPECT_TRUE(bench.watch.told("all pages are in the unit")) << bench.watch.lines;
}

TEST(Dmc60cLinkLoss, AForcedUpdateToTheSameVersionIsNotTakenForDoneBeforeItsPagesWereSent)
{
    LossBench bench("dmc60c:5,firmware=1.25");
    UpdateOptions force;
    force.force = true;
    bench.begin(force);
    ASSERT_TRUE(bench.reaches("Page 30"));
    bench.clock.advance(1ms);
    bench.host.pullOut();
    bench.clock.advance(3s);
    bench.host.plugIn();
    expectDoneAgain(bench.end(), "forced");
    EXPECT_EQ(bench.pages, (std::vector<int>{30, 30, 1, 0})) << "page 30 had been sent whole";
}

/// Its version stays while no page has come, so that only page 0, sent last, tells that all are there.
TEST(Dmc60cLinkLoss, AForcedUpdateToTheSameVersionIsNotTakenForDoneBecausePagesWereSentThatNeverCame)
{
    LossBench bench("dmc60c:5,firmware=1.25");
    UpdateOptions force;
    force.force = true;
    bench.begin(force);
    ASSERT_TRUE(bench.reaches("Page 30"));
    bench.bus.setLoss(1.0);
    bench.clock.advance(100ms);
    bench.host.pullOut();
    bench.bus.setLoss(0.0);
    bench.clock.advance(3s);
    bench.host.plugIn();
    expectDoneAgain(bench.end(), "forced");
    EXPECT_EQ(bench.pages, (std::vector<int>{30, 1, 0}));
}

TEST(Dmc60cLinkLoss, ALinkThatStaysAwayEndsTheUpdateWithTheCauseAndTheRemedy)
{
    LossBench bench;
    bench.begin();
    ASSERT_TRUE(bench.reaches("Page 1"));
    bench.host.pullOut();
    const Instant from = bench.clock.now();
    const UpdateReport report = bench.end();
    EXPECT_GE(bench.clock.now() - from, 30s);
    EXPECT_LT(bench.clock.now() - from, 31s);
    EXPECT_EQ(report.outcome, UpdateOutcome::Failed);
    EXPECT_EQ(report.fault, Fault::LinkLost);
    EXPECT_EQ(report.summary(),
        "sim:can did not come back within 30 s: there is no such adapter; the unit waits in its bootloader, run the "
        "update again");
    bench.host.plugIn();
    ASSERT_TRUE(bench.host.open());
    bench.begin();
    expectDoneAgain(bench.end(), "run again");
}

TEST(Dmc60cLinkLoss, AUnitThatRestartedBeforeTheLinkWentIsNotSaidToWaitInItsBootloader)
{
    LossBench bench;
    bench.begin();
    ASSERT_TRUE(bench.clock.runUntil([&] { return bench.watch.told("restarted, the application answers"); }, 1min));
    bench.host.pullOut();
    const UpdateReport report = bench.end();
    EXPECT_EQ(report.fault, Fault::LinkLost);
    EXPECT_EQ(report.summary().english().find("bootloader"), std::string::npos) << report.summary();
}

TEST(Dmc60cLinkLoss, ALinkThatIsLostBehindTheBytesOfPage30LeavesAUnitThatWaitsInItsBootloader)
{
    LossBench bench;
    bench.begin();
    ASSERT_TRUE(bench.reaches("Page 30"));
    bench.clock.advance(30ms); // before its status
    ASSERT_TRUE(bench.pages.empty());
    bench.host.pullOut();
    const UpdateReport report = bench.end();
    EXPECT_NE(report.summary().english().find("waits in its bootloader"), std::string::npos) << report.summary();
}

TEST(Dmc60cLinkLoss, AUnitThatRefusesPage30RunsItsOldApplicationAgain)
{
    for (const bool resets : {true, false}) {
        LossBench bench;
        VirtualCanLink other(*LinkAddress::parse("sim:can"), bench.bus);
        ASSERT_TRUE(other.open());
        Timer refusal(bench.clock);
        const Subscription page = bench.host.traffic().add([&](const Traffic &traffic) {
            const std::string text = toText(*traffic.can);
            if (traffic.direction != Direction::Sent || !text.starts_with("0206FC05#"))
                return;
            if (text.substr(13, 4) == "F100" && !resets)
                bench.bus.setLoss(1.0);
            if (text.substr(13, 4) != "F200")
                return;
            bench.bus.setLoss(1.0); // nothing of it arrives
            refusal.startIn(100ms, [&] {
                bench.bus.setLoss(0.0);
                EXPECT_TRUE(other.send(*canFrameFromText("0206FCC5#02000000")));
            });
        });
        bench.begin();
        const UpdateReport report = bench.end();
        EXPECT_EQ(report.outcome, UpdateOutcome::Failed);
        EXPECT_NE(report.evidence.english().find("refuses page 30"), std::string::npos) << report.evidence;
        EXPECT_EQ(report.summary().english().find("waits in its bootloader"), std::string::npos);
        EXPECT_EQ(bench.watch.told("restarted, the application answers"), resets);
        EXPECT_EQ(report.summary().english().find("its old firmware is still there") == std::string::npos, resets)
            << report.summary();
    }
}

TEST(Dmc60cLinkLoss, ALinkThatIsClosedOrLostAgainAndAgainIsNotWaitedForForEver)
{
    LossBench closed;
    closed.begin();
    ASSERT_TRUE(closed.reaches("Page 1"));
    closed.host.close();
    EXPECT_EQ(closed.end().fault, Fault::LinkLost);
    LossBench flapping;
    flapping.begin();
    int losses = 0;
    while (flapping.reaches("Page 1")) {
        flapping.host.pullOut();
        flapping.clock.advance(1s);
        flapping.host.plugIn();
        ++losses;
    }
    EXPECT_EQ(losses, 4);
    EXPECT_EQ(flapping.end().fault, Fault::LinkLost);
}

TEST(Dmc60cLinkLoss, WaitingCanBeCancelled)
{
    LossBench bench;
    bench.begin();
    ASSERT_TRUE(bench.reaches("Page 1"));
    const std::size_t timers = bench.clock.armed();
    bench.host.pullOut();
    bench.clock.advance(2s);
    bench.task->cancel();
    EXPECT_LT(bench.clock.armed(), timers);
}

} // namespace
} // namespace mb
