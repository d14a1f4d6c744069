// SPDX-License-Identifier: GPL-3.0-or-later
// What an update leaves to avrdude meanwhile, the port and the node, and what it tells of how far it is.
#include "supermodifiedupdatebench.h"

#include "async/background.h"
#include "async/virtualclock.h"
#include "families/supermodified/line.h"

#include <utility>

namespace mb::supermodified {
namespace {

/// A serial port of this computer, as far as its name goes.
struct PortFile {
    PortFile()
    {
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.close();
    }
    [[nodiscard]] std::string name() const { return file.fileName().toStdString(); }
    [[nodiscard]] LinkAddress address() const { return *LinkAddress::parse("serial:" + name() + "?baud=115200"); }

    QTemporaryDir folder;
    QFile file{folder.filePath(QStringLiteral("port"))};
};

/// Says when it works and when it is over, in files beside it.
QByteArray slowly(const SupermodifiedUpdateBench &bench, const QByteArray &script)
{
    const QByteArray folder = bench.folder.path().toUtf8();
    return "touch '" + folder + "/working'; sleep 0.4; touch '" + folder + "/over'\n" + script;
}

TEST(SupermodifiedUpdate, AvrdudeHasThePortOfTheLinkAloneAndTheLinkIsOpenAgainAfterIt)
{
    const PortFile port;
    SupermodifiedUpdateBench bench(port.address());
    bench.standIn(slowly(bench, supermodifiedSuccess));
    int looked = 0;
    const auto report = bench.update("avrdude:arduino:" + port.name(), [&](Operation &) {
        if (!bench.has("working") || bench.has("over"))
            return;
        ++looked;
        EXPECT_EQ(bench.host.state(), LinkState::Closed);
    });
    ASSERT_TRUE(report) << report.error().text();
    EXPECT_EQ(report->outcome, UpdateOutcome::Done);
    EXPECT_GT(looked, 0);
    EXPECT_EQ(bench.host.state(), LinkState::Open);
}

TEST(SupermodifiedUpdate, ALinkOnAnotherPortThanAvrdudesStaysOpen)
{
    const PortFile port;
    const PortFile other;
    for (const std::string &programmer : {std::string("usbasp:usb"), "stk500v1:" + other.name()}) {
        SupermodifiedUpdateBench bench(port.address());
        bench.standIn(slowly(bench, supermodifiedSuccess));
        int closed = 0;
        const Subscription watch = bench.host.stateChanged().add([&closed](LinkState) { ++closed; });
        EXPECT_TRUE(bench.update("avrdude:" + programmer)) << programmer;
        EXPECT_EQ(closed, 0) << programmer;
    }
}

TEST(SupermodifiedUpdate, TheBootloaderOnItsOwnLineIsNotUsedWhileAnotherNodeHearsIt)
{
    const PortFile port;
    SupermodifiedUpdateBench bench(port.address());
    bench.standIn(supermodifiedSuccess);
    Roster &roster = Line::of(bench.host, bench.loop.clock())->roster();
    roster.note(5, 57600);
    const auto refused = bench.update("avrdude:arduino:" + port.name());
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().fault, Fault::Unsafe);
    EXPECT_NE(refused.error().text().find("node 5 is on this line"), std::string::npos) << refused.error().text();
    EXPECT_TRUE(bench.calls().isEmpty());
    EXPECT_TRUE(bench.update("avrdude:usbasp:usb")) << "whose pins are those of one unit";
    roster.forget(5);
    EXPECT_TRUE(bench.update("avrdude:arduino:" + port.name()));
}

TEST(SupermodifiedUpdate, TheNodeIsAskedNothingWhileItIsWrittenAndPolledAgainAfterIt)
{
    SupermodifiedUpdateBench bench;
    bench.standIn(slowly(bench, supermodifiedSuccess));
    int before = 0;
    int meanwhile = 0;
    const Subscription tap = bench.host.traffic().add([&](const Traffic &traffic) {
        if (traffic.direction != Direction::Sent)
            return;
        ++before;
        meanwhile += bench.has("working") && !bench.has("over") ? 1 : 0;
    });
    ASSERT_TRUE(bench.loop.runUntil([&] { return bench.positions() > 2; }));
    EXPECT_GT(before, 0);
    const auto report = bench.update("avrdude:usbasp:usb");
    ASSERT_TRUE(report) << report.error().text();
    EXPECT_TRUE(bench.has("over"));
    EXPECT_EQ(meanwhile, 0);
    const std::size_t known = bench.positions();
    EXPECT_TRUE(bench.loop.runUntil([&] { return bench.positions() > known + 2; }));
}

TEST(SupermodifiedUpdate, GivenUpItLeavesALostLinkThatIsOpenedAgainAndANodeThatIsPolled)
{
    const PortFile port;
    SupermodifiedUpdateBench bench(port.address());
    bench.standIn("echo 'avrdude: waiting' >&2; exec sleep 20\n");
    bool asked = false;
    const auto cancelled = bench.update("avrdude:usbasp:" + port.name(), [&](Operation &operation) {
        if (!operation.status().log.empty() && !std::exchange(asked, true)) {
            EXPECT_TRUE(operation.cancel());
        }
    });
    ASSERT_FALSE(cancelled);
    EXPECT_EQ(bench.host.state(), LinkState::Lost) << "what opens lost links opens no closed ones";
    EXPECT_EQ(bench.host.loss().detail.english(), "avrdude had the port");
    ASSERT_TRUE(bench.host.open());
    const std::size_t known = bench.positions();
    EXPECT_TRUE(bench.loop.runUntil([&] { return bench.positions() > known + 2; }));
}

/// A port whose adapter can go away.
struct LeavingPort final : SerialLink {
    LeavingPort(LinkAddress address, Clock &clock)
        : SerialLink(std::move(address), clock)
    {
    }
    Result<void> doOpen() override
    {
        return isGone ? Result<void>(fail(Fault::LinkLost, say("the adapter was unplugged"))) : Result<void>();
    }
    Task<void> doOpenSoon(Background &) override
    {
        if (isClosedMeanwhile)
            close();
        co_return doOpen();
    }
    void doClose() override { }
    Result<void> doSend(std::span<const std::uint8_t>, Priority) override { return {}; }
    [[nodiscard]] std::size_t doBacklog() const override { return 0; }
    Result<void> doSetBaudrate(int) override { return {}; }
    bool isGone = false;
    bool isClosedMeanwhile = false;
};

struct IdleBackground final : Background {
    void run(const std::string &, std::function<void()>, std::function<void()>) override { }
};

TEST(SupermodifiedUpdate, APortThatIsAwayWhenAvrdudeEndsIsALostLinkWithTheCause)
{
    const PortFile port;
    SupermodifiedUpdateBench bench;
    LeavingPort leaving(port.address(), bench.loop.clock());
    ASSERT_TRUE(leaving.open());
    bench.device = bench.device->family().open(leaving, bench.loop.clock(), bench.device->identity());
    bench.standIn(slowly(bench, supermodifiedSuccess));
    leaving.isGone = true;
    const auto report = bench.update("avrdude:arduino:" + port.name());
    ASSERT_FALSE(report);
    EXPECT_EQ(report.error().fault, Fault::LinkLost);
    EXPECT_EQ(leaving.state(), LinkState::Lost) << "what opens lost links opens no closed ones";
    EXPECT_EQ(leaving.loss().detail.english(), "the adapter was unplugged");
    bench.device.reset();
}

TEST(SupermodifiedUpdate, ALinkThatIsClosedByHandWhileItIsOpenedAgainStaysClosed)
{
    const PortFile port;
    SupermodifiedUpdateBench bench;
    LeavingPort closed(port.address(), bench.loop.clock());
    ASSERT_TRUE(closed.open());
    IdleBackground background;
    closed.settings().background = &background;
    closed.isClosedMeanwhile = true;
    bench.device = bench.device->family().open(closed, bench.loop.clock(), bench.device->identity());
    bench.standIn(supermodifiedSuccess);
    EXPECT_FALSE(bench.update("avrdude:arduino:" + port.name()));
    EXPECT_EQ(closed.state(), LinkState::Closed);
    bench.device.reset();
}

TEST(SupermodifiedUpdate, ALinkThatIsClosedByHandWhileItLooksForTheNodeStaysClosed)
{
    const PortFile port;
    SupermodifiedUpdateBench bench(port.address());
    bench.standIn(supermodifiedSuccess);
    bench.cut();
    EXPECT_FALSE(bench.update("avrdude:arduino:" + port.name(), [&bench](Operation &operation) {
        if (operation.status().step.english() == "Looking for the controller")
            bench.host.close();
    }));
    EXPECT_EQ(bench.host.state(), LinkState::Closed);
}

/// Each step once, with the fraction that is told to be done.
struct TitledSteps final : Progress {
    void step(const Message &what, int done, int total) override
    {
        const std::pair<std::string, double> told{what.english(), static_cast<double>(done) / total};
        if (steps.empty() || steps.back() != told)
            steps.push_back(told);
        if (bench)
            bench->power(!SupermodifiedUpdateBench::isHeld(what.english()));
    }
    void part(int, PartState) override { }
    void log(Severity, const Message &) override { }
    std::vector<std::pair<std::string, double>> steps;
    SupermodifiedUpdateBench *bench = nullptr; ///< whose node the programmer sits on
};

TEST(SupermodifiedUpdate, TellsEachOfFourQuartersAndHowFarItIs)
{
    SupermodifiedUpdateBench bench;
    bench.standIn("echo 'avrdude: erasing chip' >&2\n"
                  "echo 'Writing | #########################' >&2\n"
                  "echo 'Writing | ##################################################' >&2\n"
                  "echo 'avrdude: 6 bytes of flash written' >&2\n"
                  "echo 'Reading | #########################' >&2\n"
                  "echo 'Reading | ##################################################' >&2\n"
                  "echo 'avrdude: 6 bytes of flash verified' >&2\n");
    TitledSteps told;
    told.bench = &bench;
    auto options = bench.options;
    options.via = "avrdude:usbasp:usb";
    auto task = supermodified::update(*bench.device, bench.written, options, told);
    task.start();
    ASSERT_TRUE(bench.loop.runUntil([&] { return task.isFinished(); }));
    ASSERT_TRUE(task.result()) << task.result().error().text();
    const std::vector<std::pair<std::string, double>> expected{{"Connecting through avrdude", 0.0},
        {"Erasing flash", 0.25}, {"Writing flash", 0.625}, {"Writing flash", 0.75}, {"Verifying flash", 0.75},
        {"Verifying flash", 0.875}, {"Verifying flash", 1.0}, {"Looking for the controller", 1.0}};
    EXPECT_EQ(told.steps, expected);
}

TEST(SupermodifiedUpdate, AnAvrdudeThatSaysNothingIsToldAsConnecting)
{
    SupermodifiedUpdateBench bench;
    bench.standIn("exec sleep 20\n");
    TitledSteps told;
    auto options = bench.options;
    options.via = "avrdude:usbasp:usb";
    auto task = supermodified::update(*bench.device, bench.written, options, told);
    task.start();
    ASSERT_TRUE(bench.loop.runUntil([&] { return !told.steps.empty(); }, 5s));
    EXPECT_EQ(told.steps.front().first, "Connecting through avrdude");
    task.cancel();
}

TEST(SupermodifiedUpdate, MayBeCancelledAgainWhileItLooksForTheNode)
{
    SupermodifiedUpdateBench bench;
    bench.standIn(supermodifiedSuccess);
    bench.cut();
    bool looked = false;
    const auto cancelled = bench.update("avrdude:usbasp:usb", [&](Operation &operation) {
        if (operation.status().step.english() == "Looking for the controller" && !std::exchange(looked, true)) {
            EXPECT_EQ(operation.status().update.pages, 1) << "they are written";
            EXPECT_TRUE(operation.cancel());
        }
    });
    EXPECT_TRUE(looked);
    ASSERT_FALSE(cancelled);
    EXPECT_EQ(cancelled.error().fault, Fault::Cancelled);
}

TEST(SupermodifiedUpdate, AnAvrdudeThatFallsSilentWhileItWritesIsNotRunAgain)
{
    for (const std::string via : {"avrdude:arduino:/dev/nowhere", "avrdude:usbasp:usb"}) {
        SupermodifiedUpdateBench bench;
        bench.standIn("printf 'Writing | ####' >&2; exec sleep 300\n");
        VirtualClock clock; // a minute of silence
        VirtualSerialLine line(clock, VirtualSerialLine::Wiring::HalfDuplex, 1);
        VirtualSerialLink host(*LinkAddress::parse("sim:serial?bitrate=115200"), line);
        ASSERT_TRUE(host.open());
        const auto device = bench.device->family().open(host, clock, bench.device->identity());
        Operation operation(clock, say("firmware update"));
        std::optional<Result<UpdateReport>> report;
        UpdateOptions options;
        options.via = via;
        operation.run<UpdateReport>(supermodified::update(*device, bench.written, options, operation),
            [&report](Result<UpdateReport> result) { report = std::move(result); });
        ASSERT_TRUE(bench.loop.runUntil([&] {
            clock.advance(1ms);
            return operation.status().step.english() == "Writing flash";
        }));
        clock.advance(61s);
        ASSERT_TRUE(bench.loop.runUntil([&] {
            clock.advance(10ms);
            return report.has_value() || bench.calls().count('\n') > 1;
        }));
        EXPECT_EQ(bench.calls().count('\n'), 1) << via;
        ASSERT_TRUE(report && !*report) << via;
        EXPECT_NE(report->error().text().find("half a program"), std::string::npos) << report->error().text();
    }
}

} // namespace
} // namespace mb::supermodified
