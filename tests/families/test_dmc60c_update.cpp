// SPDX-License-Identifier: GPL-3.0-or-later
// dmc60c/README.md#updates, from the file to the version that the device answers with.
#include "files/filebytes.h"
#include "support/hextext.h"
#include "support/simulatedsession.h"
#include "support/sourcetree.h"
#include "transport/backends/virtualcan.h"

#include <cstdlib>

namespace mb {
namespace {

using namespace std::chrono_literals;
using test::run;

/// A session with one unit of our own on a bus, so that its options and faults can be chosen.
struct Dmc60cUpdateBench {
    explicit Dmc60cUpdateBench(const std::string &unit, double loss = 0.0, std::uint64_t seed = 1)
        : bus(clock, 1'000'000, seed)
        , host(*LinkAddress::parse("sim:can"), bus)
        , port(*LinkAddress::parse("sim:can"), bus)
    {
        bus.setLoss(loss);
        EXPECT_TRUE(host.open());
        EXPECT_TRUE(port.open());
        auto parsed = SimulatedUnit::parse(unit);
        EXPECT_TRUE(parsed) << unit;
        parsed->seed = seed;
        auto made = family.simulate(port, clock, *parsed);
        EXPECT_TRUE(made) << unit;
        simulator = std::move(*made);
        events = simulator->events().add([this](const SimulatorEvent &event) { log.push_back(event); });
    }
    /// Scans until the unit answers, then updates it.
    Result<UpdateReport> update(const FirmwareImage &image, UpdateOptions options = {})
    {
        device.reset();
        struct Sink final : ScanSink {
            void found(const Identity &identity) override { last = identity; }
            void progress(const Message &, int, int) override { }
            std::optional<Identity> last;
        } sink;
        for (int i = 0; i < 20 && !sink.last; ++i) {
            (void)run(clock, family.scan(host, clock, sink));
        }
        if (!sink.last)
            return fail(Fault::Timeout, say("the unit was not found"));
        state = sink.last->state;
        device = family.open(host, clock, *sink.last);
        return updateOpened(image, std::move(options));
    }
    /// The same for the device that is open.
    Result<UpdateReport> updateOpened(const FirmwareImage &image, UpdateOptions options = {})
    {
        const bool dry = options.dryRun;
        auto report = run(clock, family.update(*device, image, std::move(options), progress), 30min);
        if (report && report->outcome == UpdateOutcome::Done && !dry) {
            EXPECT_EQ(wrongBytes(image), 0) << "success was told";
        }
        return report;
    }
    /// Bytes of the image that the flash of the unit does not hold; where the bootloader puts its own, none are compared.
    [[nodiscard]] int wrongBytes(const FirmwareImage &image) const
    {
        constexpr std::uint32_t ownReset = 8;
        const std::vector<std::uint8_t> flash = simulator->flash();
        int wrong = 0;
        for (std::uint32_t address = ownReset; address < flash.size(); ++address) {
            const auto wanted = address % 4 == 3 ? std::nullopt : image.at(address);
            wrong += wanted && *wanted != flash[address] ? 1 : 0;
        }
        return wrong;
    }
    std::vector<int> pagesWritten() const
    {
        std::vector<int> pages;
        for (const SimulatorEvent &event : log) {
            if (event.what == "page-written")
                pages.push_back(static_cast<int>(event.value));
        }
        return pages;
    }

    const Family &family = *findFamily(families(), "dmc60c");
    VirtualClock clock;
    VirtualCanBus bus;
    VirtualCanLink host;
    VirtualCanLink port;
    std::unique_ptr<Simulator> simulator;
    std::vector<SimulatorEvent> log;
    Subscription events;
    NoProgress progress;
    std::unique_ptr<Device> device;
    DeviceState state = DeviceState::Online;
};

const FirmwareImage &demoImage()
{
    static const FirmwareImage image = [] {
        const auto bytes = loadFile(inSourceTree("resources/firmware/dmc60c-demo.hex"), 1 << 24);
        EXPECT_TRUE(bytes);
        auto parsed = FirmwareImage::fromIntelHex(
            std::string_view(bytes->constData(), static_cast<std::size_t>(bytes->size())));
        EXPECT_TRUE(parsed);
        return *parsed;
    }();
    return image;
}

/// Pages 0, 1 and 30 only: quick, and every rule of the order applies.
const FirmwareImage &smallImage()
{
    static const FirmwareImage image
        = *FirmwareImage::fromIntelHex(test::smallApplication(0x0119).add(0x1000, {0x12, 0x34, 0x56, 0x00}).text());
    return image;
}

void expectDone(const Result<UpdateReport> &report, const std::string &what = {})
{
    ASSERT_TRUE(report) << what << ": " << report.error().text();
    EXPECT_EQ(report->outcome, UpdateOutcome::Done) << what << ": " << report->evidence;
    EXPECT_TRUE(report->verified) << what;
    EXPECT_EQ(report->to, "1.25") << what;
}

TEST(Dmc60cUpdate, WritesPage30FirstPage0LastAndProvesTheVersion)
{
    Dmc60cUpdateBench bench("dmc60c:5");
    const auto report = bench.update(demoImage());
    expectDone(report);
    EXPECT_EQ(report->from, "1.23");
    EXPECT_EQ(report->pages, 31);
    EXPECT_EQ(report->retries, 0);
    std::vector<int> expected;
    for (int page = 30; page >= 0; --page)
        expected.push_back(page);
    EXPECT_EQ(bench.pagesWritten(), expected);
    EXPECT_EQ(bench.device->identity().firmware, "1.25");
}

/// Which page is written while nobody may interrupt.
struct Critical final : Progress {
    void step(const Message &, int, int) override { }
    void part(int number, PartState state) override { page = state == PartState::Active ? number : page; }
    void log(Severity, const Message &) override { }
    void mayInterrupt(bool may) override
    {
        interruptible = may;
        if (!may)
            pages.push_back(page);
    }
    int page = -1;
    bool interruptible = true;
    std::vector<int> pages;
};

TEST(Dmc60cUpdate, MustNotBeInterruptedWhilePage0IsWrittenAndAtNoOtherTime)
{
    Dmc60cUpdateBench bench("dmc60c:5");
    expectDone(bench.update(smallImage()));
    Critical critical;
    UpdateOptions again;
    again.force = true;
    const auto report = run(bench.clock, bench.family.update(*bench.device, smallImage(), again, critical), 30min);
    ASSERT_TRUE(report);
    EXPECT_EQ(report->outcome, UpdateOutcome::Done) << report->evidence;
    EXPECT_EQ(critical.pages, std::vector<int>{0});
    EXPECT_TRUE(critical.interruptible) << "at the end";
}

TEST(Dmc60cUpdate, TakesAtMostATenthLongerThanBusAndFlashNeed)
{
    Dmc60cUpdateBench bench("dmc60c:9,state=bootloader");
    const Instant begin = bench.clock.now();
    expectDone(bench.update(demoImage()));
    // Per page: 513 frames of at least 131 bits back to back, 23.1 ms of erasing and 54 ms of writing; the resets apart.
    const double frames = 513 * 131e-6 * 1.05; // stuff bits of ordinary data
    const double needed = 31 * (frames + 0.0231 + 0.054);
    const double taken = std::chrono::duration<double>(bench.clock.now() - begin).count() - 0.45; // the scan
    std::printf("[ measured ] update of 31 pages: %.3f s, bus and flash need %.3f s\n", taken, needed);
    EXPECT_LE(taken, 1.1 * needed);
}

TEST(Dmc60cUpdate, FindsTheCrcVariantOnTheFirstPage)
{
    for (const char *variant : {"A", "B", "C"}) {
        Dmc60cUpdateBench bench(std::string("dmc60c:5,crc=") + variant);
        const auto report = bench.update(smallImage());
        expectDone(report, variant);
        EXPECT_EQ(report->retries, variant[0] - 'A') << variant;
    }
}

TEST(Dmc60cUpdate, DoesNothingWhenTheVersionIsThereAlreadyUnlessForced)
{
    Dmc60cUpdateBench bench("dmc60c:5,firmware=1.25");
    const auto same = bench.update(smallImage());
    ASSERT_TRUE(same);
    EXPECT_EQ(same->outcome, UpdateOutcome::UpToDate);
    EXPECT_TRUE(bench.pagesWritten().empty());
    UpdateOptions force;
    force.force = true;
    expectDone(bench.update(smallImage(), force));
}

TEST(Dmc60cUpdate, ADryRunWritesNothingAndStopsNoMotor)
{
    Dmc60cUpdateBench bench("dmc60c:5");
    VirtualCanLink ear(*LinkAddress::parse("sim:can"), bench.bus);
    ASSERT_TRUE(ear.open());
    int orders = 0;
    const auto heard = ear.received().add([&orders](const CanFrame &frame) { orders += frame.id == 0x02060005U; });
    UpdateOptions dry;
    dry.dryRun = true;
    const auto report = bench.update(smallImage(), dry);
    ASSERT_TRUE(report);
    EXPECT_FALSE(report->verified);
    EXPECT_TRUE(bench.pagesWritten().empty());
    EXPECT_EQ(orders, 0);
    expectDone(bench.update(smallImage()));
    EXPECT_GT(orders, 0);
}

TEST(Dmc60cUpdate, RefusesAnImageWithoutEntryPointBeforeAnythingIsSent)
{
    Dmc60cUpdateBench bench("dmc60c:5");
    const auto image = FirmwareImage::fromIntelHex(
        ":020000040000FA\n:080000000002040000000000F2\n:020000040001F9\n:04EFFC0017010000F9\n:00000001FF\n");
    ASSERT_TRUE(image);
    const auto report = bench.update(*image);
    ASSERT_TRUE(report);
    EXPECT_EQ(report->outcome, UpdateOutcome::Refused);
    EXPECT_TRUE(bench.pagesWritten().empty());
}

TEST(Dmc60cUpdate, AUnitThatLosesItsSupplyInAnyPageRunsAgainToSuccess)
{
    for (int page = 30; page >= 1; --page) {
        Dmc60cUpdateBench bench("dmc60c:5,fault=power-page@" + std::to_string(page));
        const auto first = bench.update(demoImage());
        // The unit is back after 200 ms: the same run may already carry on from page 30.
        if (first && first->outcome == UpdateOutcome::Done)
            continue;
        bench.clock.advance(1s);
        expectDone(bench.update(demoImage()), "page " + std::to_string(page));
    }
}

TEST(Dmc60cUpdate, AProgramThatDiesInAnyPageLeavesAUnitThatIsFoundInItsBootloaderAndRunsAgain)
{
    for (int page = 30; page >= 0; --page) {
        Dmc60cUpdateBench bench("dmc60c:5");
        bench.update(demoImage(), {.dryRun = true, .force = false, .via = {}, .target = {}});
        struct LastStep final : Progress {
            void step(const Message &what, int, int) override { now = what.english(); }
            void part(int, PartState) override { }
            void log(Severity, const Message &) override { }
            std::string now;
        } watch;
        Task<UpdateReport> task = bench.family.update(*bench.device, demoImage(), {}, watch);
        task.start();
        const std::string wanted = "Page " + std::to_string(page);
        ASSERT_TRUE(bench.clock.runUntil([&] { return watch.now == wanted; }));
        bench.clock.advance(30ms); // in the middle of its frames
        task.cancel();
        bench.clock.advance(3s);
        bench.simulator->setPowered(false);
        bench.simulator->setPowered(true);
        bench.clock.advance(1s);
        const auto again = bench.update(demoImage());
        if (page == 0 && again && again->outcome == UpdateOutcome::UpToDate)
            continue; // its frames were with the bus already: the unit finished by itself
        expectDone(again, wanted);
        if (page < 30 && page > 0) {
            EXPECT_EQ(bench.state, DeviceState::Bootloader) << wanted;
        }
    }
}

TEST(Dmc60cUpdate, RunsAgainToSuccessAfterThePowerWasCutAtSeededFrames)
{
    // Every frame of a soak, forty seeded ones otherwise. Frames are those addressed to the unit, from the scan on.
    constexpr int most = 3 * 514 + 40;
    const bool all = std::getenv("MOTORBENCH_SOAK") != nullptr;
    std::mt19937 random(7);
    const int cuts = all ? most : 40;
    for (int i = 0; i < cuts; ++i) {
        const int frame = all ? i + 1 : static_cast<int>(random() % most) + 1;
        Dmc60cUpdateBench bench("dmc60c:5,fault=power@" + std::to_string(frame));
        const auto first = bench.update(smallImage());
        if (first && first->outcome == UpdateOutcome::Done)
            continue;
        bool bricked = false; // a cut while page 0 is erased cannot be repaired over the bus
        for (const SimulatorEvent &event : bench.log)
            bricked = bricked || event.what == "bricked";
        bench.clock.advance(1s);
        if (bricked)
            continue;
        const auto again = bench.update(smallImage());
        if (again && again->outcome == UpdateOutcome::UpToDate)
            continue; // the cut came after page 0: the new version was there, only its proof was missing
        expectDone(again, "frame " + std::to_string(frame));
    }
}

TEST(Dmc60cUpdate, SurvivesSingleDropsAndCorruptionsOfAnyReply)
{
    for (const char *fault : {"drop", "corrupt", "delay"}) {
        for (int frame = 8; frame < 40; frame += 3) {
            const std::string argument = std::string(fault) == "delay" ? ":400" : "";
            Dmc60cUpdateBench bench(
                "dmc60c:9,state=bootloader,fault=" + std::string(fault) + "@" + std::to_string(frame) + argument);
            const auto first = bench.update(smallImage());
            if (first && first->outcome == UpdateOutcome::Done)
                continue;
            expectDone(bench.update(smallImage()), std::string(fault) + "@" + std::to_string(frame));
        }
    }
}

TEST(Dmc60cUpdate, AnAnswerThatComesLateIsNotTakenForTheOneToAnotherQuestion)
{
    for (const char *late : {"300", "400", "700", "2200", "3000"}) {
        for (int frame = 4; frame < 34; ++frame) {
            const std::string first = std::to_string(frame);
            const std::string second = std::to_string(frame + 1);
            Dmc60cUpdateBench bench(
                "dmc60c:9,state=bootloader,fault=delay@" + first + ':' + late + ",fault=delay@" + second + ':' + late);
            expectDone(bench.update(smallImage()), first + " and " + second + " by " + late + " ms");
        }
    }
}

TEST(Dmc60cUpdate, WaitsUntilParametersThatWereJustChangedAreInFlash)
{
    Dmc60cUpdateBench bench("dmc60c:5");
    (void)bench.update(smallImage(), {.dryRun = true, .force = false, .via = {}, .target = {}});
    const auto key = [&](const char *name) { return *findParameter(bench.device->parameters().table(), name); };
    for (const char *name : {"limit.forward.soft.threshold", "limit.reverse.soft.threshold"})
        ASSERT_TRUE(run(bench.clock, bench.device->write(key(name), 4711))) << name;
    expectDone(bench.updateOpened(smallImage()));
    for (const char *name : {"limit.forward.soft.threshold", "limit.reverse.soft.threshold"})
        EXPECT_EQ(run(bench.clock, bench.device->read(key(name))), 4711) << name;
}

TEST(Dmc60cUpdate, SaysThatWhatAnotherProgramJustChangedIsLost)
{
    struct Log final : Progress {
        void step(const Message &, int, int) override { }
        void part(int, PartState) override { }
        void log(Severity, const Message &text) override { all += text.english() + '\n'; }
        std::string all;
    };
    for (const char *unit : {"dmc60c:5", "dmc60c:5,state=bootloader"}) {
        Dmc60cUpdateBench bench(unit);
        (void)bench.update(smallImage(), {.dryRun = true, .force = false, .via = {}, .target = {}});
        Log log;
        ASSERT_TRUE(run(bench.clock, bench.family.update(*bench.device, smallImage(), {}, log), 5min)) << unit;
        EXPECT_EQ(log.all.find("another program has changed") != std::string::npos, bench.state == DeviceState::Online);
    }
}

TEST(Dmc60cUpdate, SurvivesALossOfOneFrameInTenThousand)
{
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        Dmc60cUpdateBench bench("dmc60c:5", 1e-4, seed);
        expectDone(bench.update(demoImage()), "seed " + std::to_string(seed));
    }
}

TEST(Dmc60cUpdate, ReportsAFlashThatCannotBeWrittenAndSaysWhatToDo)
{
    Dmc60cUpdateBench bench("dmc60c:9,state=bootloader");
    const auto fails = bench.simulator->events().add([&](const SimulatorEvent &event) {
        if (event.what == "page-failed")
            bench.simulator->disturb("flash-fail", 1);
    });
    bench.simulator->disturb("flash-fail", 1);
    const auto report = bench.update(smallImage());
    ASSERT_TRUE(report);
    EXPECT_EQ(report->outcome, UpdateOutcome::Failed);
    EXPECT_FALSE(report->verified);
    EXPECT_NE(report->summary().english().find("run the update again"), std::string::npos) << report->evidence;
}

TEST(Dmc60cUpdate, NeverReportsSuccessWhenTheUnitVanishesBeforeItsVersionIsRead)
{
    Dmc60cUpdateBench bench("dmc60c:9,state=bootloader");
    const auto gone = bench.simulator->events().add([&](const SimulatorEvent &event) {
        if (event.what == "page-written" && event.value == 0.0)
            bench.clock.post([&] { bench.simulator->setPowered(false); });
    });
    const auto report = bench.update(smallImage());
    ASSERT_TRUE(report);
    EXPECT_EQ(report->outcome, UpdateOutcome::Failed);
    EXPECT_FALSE(report->verified);
    EXPECT_EQ(report->to, "");
}

TEST(Dmc60cUpdate, AnotherWayInIsRefusedWhicheverPartOfItIsNamed)
{
    for (const auto &[via, target] : {std::pair{"openocd:stlink", ""}, {"", "dmc60c"}, {"openocd:stlink", "dmc60c"}}) {
        Dmc60cUpdateBench bench("dmc60c:5");
        const auto report = bench.update(smallImage(), {.dryRun = false, .force = true, .via = via, .target = target});
        ASSERT_FALSE(report) << via << target;
        EXPECT_EQ(report.error().fault, Fault::Unsupported);
        EXPECT_TRUE(bench.pagesWritten().empty());
    }
}

/// The unit that hears the last reset is another one with the same number and session.
Result<UpdateReport> updateAndExchange(const std::string &other)
{
    Dmc60cUpdateBench bench("dmc60c:5,session=0x1234");
    Timer exchange(bench.clock);
    const Subscription watching = bench.host.traffic().add([&](const Traffic &traffic) {
        if (traffic.direction == Direction::Sent && toText(*traffic.can).starts_with("0206FC05#3412F100"))
            exchange.startIn(1us, [&] {
                bench.simulator.reset();
                bench.simulator = *bench.family.simulate(bench.port, bench.clock, *SimulatedUnit::parse(other));
            });
    });
    return bench.update(smallImage());
}

TEST(Dmc60cUpdate, AnotherVersionThanThatOfTheImageIsNoSuccess)
{
    const auto old = updateAndExchange("dmc60c:5,session=0x1234,firmware=1.23");
    ASSERT_TRUE(old) << old.error().text();
    EXPECT_EQ(old->outcome, UpdateOutcome::Failed);
    EXPECT_FALSE(old->verified);
    EXPECT_EQ(old->fault, Fault::BadCheck);
    EXPECT_NE(old->summary().english().find("version 1.23"), std::string::npos) << old->summary();
    const auto none = updateAndExchange("dmc60c:5,session=0x1234,state=bootloader");
    ASSERT_TRUE(none) << none.error().text();
    EXPECT_EQ(none->outcome, UpdateOutcome::Failed);
    EXPECT_FALSE(none->verified);
    EXPECT_NE(none->summary().english().find("no application"), std::string::npos) << none->summary();
}

TEST(Dmc60cUpdate, GoesOnWhenNobodyCanTellWhetherTheLastParametersAreStored)
{
    Dmc60cUpdateBench bench("dmc60c:5");
    bench.update(smallImage(), {.dryRun = true, .force = false, .via = {}, .target = {}});
    const auto index = *findParameter(bench.family.parameters, "slot0.p");
    ASSERT_TRUE(run(bench.clock, bench.device->write(index, 65536)));
    ASSERT_TRUE(run(bench.clock, bench.device->write(index, 131072)));
    bool cautioned = false;
    struct Heard final : Progress {
        Heard(VirtualCanBus &line, bool &caution)
            : bus(line)
            , told(caution)
        {
        }
        void step(const Message &, int, int) override { }
        void part(int, PartState) override { }
        void log(Severity severity, const Message &text) override
        {
            if (severity == Severity::Caution && text.english().starts_with("parameters that were changed")) {
                told = true;
                bus.setLoss(0.0);
            }
        }
        VirtualCanBus &bus;
        bool &told;
    } heard(bench.bus, cautioned);
    const Subscription watching = bench.host.traffic().add([&](const Traffic &traffic) {
        const bool asksSequence = traffic.direction == Direction::Sent && toText(*traffic.can).starts_with("0206FC05#")
            && traffic.can->data[2] == 0x62;
        if (asksSequence && !cautioned)
            bench.bus.setLoss(1.0);
    });
    const auto report = run(bench.clock, bench.family.update(*bench.device, smallImage(), {}, heard), 30min);
    EXPECT_TRUE(cautioned);
    expectDone(report);
}

TEST(Dmc60cUpdate, CancellingAtAnyMomentLeavesNoListener)
{
    Dmc60cUpdateBench bench("dmc60c:5");
    for (int steps = 0; steps < 4000; steps += 37) {
        bench.update(smallImage(), {.dryRun = true, .force = false, .via = {}, .target = {}});
        const std::size_t listeners = bench.host.received().size();
        NoProgress progress;
        UpdateOptions force;
        force.force = true;
        Task<UpdateReport> task = bench.family.update(*bench.device, smallImage(), force, progress);
        task.start();
        for (int i = 0; i < steps && !task.isFinished(); ++i)
            bench.clock.step();
        task.cancel();
        EXPECT_EQ(bench.host.received().size(), listeners) << "after " << steps << " steps";
        bench.clock.advance(2s);
    }
}

} // namespace
} // namespace mb
