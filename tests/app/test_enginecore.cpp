// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/engine/enginecore.h"
#include "async/virtualclock.h"
#include "heard.h"
#include "model/registry.h"

#include <gtest/gtest.h>

namespace mb {
namespace {

using namespace std::chrono_literals;

class Core : public testing::Test {
protected:
    void open(const char *address)
    {
        core.send(orders::OpenLink{*LinkAddress::parse(address)}, opened.finished());
        clock.advance(2s);
        ASSERT_TRUE(opened && *opened);
    }
    Device *device(int address, std::string_view family = "dmc60c")
    {
        for (Device *candidate : core.session().devices()) {
            if (candidate->identity().address == address && candidate->family().key == family)
                return candidate;
        }
        return nullptr;
    }
    DeviceId id(int address) { return core.session().idOf(*device(address)); }
    Simulator *unit(const char *name)
    {
        for (const Link *link : core.session().links()) {
            for (Simulator *candidate : core.session().bench(*link)->simulators()) {
                if (candidate->name() == name)
                    return candidate;
            }
        }
        return nullptr;
    }
    [[nodiscard]] bool said(const std::string &part) const
    {
        return std::any_of(
            lines.begin(), lines.end(), [&part](const std::string &l) { return l.find(part) != std::string::npos; });
    }
    int scansWithin(Duration time)
    {
        int scans = 0;
        bool before = core.snapshot().links.front().scanning;
        for (const Instant end = clock.now() + time; clock.now() < end; clock.advance(5ms)) {
            const bool scanning = core.snapshot().links.front().scanning;
            scans += scanning && !before ? 1 : 0;
            before = scanning;
        }
        return scans;
    }
    [[nodiscard]] static SetPoint duty(double target)
    {
        SetPoint setPoint;
        setPoint.mode = Mode::Duty;
        setPoint.target = target;
        return setPoint;
    }
    [[nodiscard]] static Finished into(const test::Heard<> &place) { return place.finished(); }
    [[nodiscard]] std::size_t unknown(int address)
    {
        const auto entries = device(address)->parameters().entries();
        return static_cast<std::size_t>(
            std::count_if(entries.begin(), entries.end(), [](const ParameterStore::Entry &e) { return !e.raw; }));
    }

    VirtualClock clock;
    EngineCore core{clock, families(), false};
    test::Heard<> opened;
    std::vector<std::string> lines;
    Subscription listening = core.noticed().add([this](Severity, const std::string &device, const Message &text) {
        lines.push_back(device.empty() ? text.english() : device + ": " + text.english());
    });
};

TEST_F(Core, ShowsWhatItFoundInASnapshot)
{
    open("sim:can");
    const Snapshot shot = core.snapshot();
    ASSERT_EQ(shot.links.size(), 1U);
    EXPECT_TRUE(shot.links[0].simulated);
    EXPECT_FALSE(shot.links[0].scanning);
    std::string order;
    for (const DeviceView &view : shot.devices)
        order += std::string(view.family->key) + ':' + std::to_string(view.identity->address)
            + (view.mayNotMove.empty() ? " " : "! ");
    EXPECT_EQ(order, "abstractdc:3 abstractdc:4 abstractdc:5 dmc60c:5 dmc60c:7 dmc60c:9! ");
    EXPECT_GT(shot.links[0].traffic->newest(), 100U);
}

TEST_F(Core, TellsWhyALinkDoesNotOpen)
{
    core.send(orders::OpenLink{*LinkAddress::parse("sim:can?loss=7")}, into(opened));
    clock.advance(1ms);
    ASSERT_TRUE(opened);
    EXPECT_FALSE(*opened);
    EXPECT_EQ(lines.size(), 1U);
    EXPECT_TRUE(core.snapshot().links.empty());
}

TEST_F(Core, SaysWhatAMoveStoresAndMayPassBeforeItGoes)
{
    open("sim:serial");
    clock.advance(5s);
    for (const DeviceView &view : core.snapshot().devices) {
        if (view.identity->dialect != "D1")
            continue;
        SetPoint ramp;
        ramp.mode = Mode::RampPosition;
        ramp.target = 100.0;
        ramp.velocity = 800.0;
        core.send(orders::StartMotion{view.id, ramp, 500ms}, into(opened));
        EXPECT_FALSE(said("the device stores it")) << "it has this already";
        core.send(orders::StopMotion{view.id});
        clock.advance(1s);
        ramp.velocity = 3000.0;
        core.send(orders::StartMotion{view.id, ramp, 500ms}, into(opened));
    }
    EXPECT_TRUE(said("profile.velocity becomes 3000, it was 800: the device stores it"));
    EXPECT_TRUE(said("may pass the target"));
}

TEST_F(Core, KeepsTheDiagnosisOfALinkThatDoesNotOpenUntilItIsClosed)
{
    core.send(orders::OpenLink{*LinkAddress::parse("socketcan:nosuchcan9")}, into(opened));
    clock.advance(1ms);
    ASSERT_TRUE(opened && !*opened);
    const Snapshot shot = core.snapshot();
    ASSERT_EQ(shot.failed.size(), 1U);
    EXPECT_EQ(shot.failed[0].address, "socketcan:nosuchcan9");
    EXPECT_FALSE(shot.failed[0].diagnosis.isHealthy());
    core.send(orders::CloseLink{"socketcan:nosuchcan9"});
    EXPECT_TRUE(core.snapshot().failed.empty());
}

TEST_F(Core, ALostLinkHasADiagnosisUntilItIsBack)
{
    open("sim:can?fault=busoff@3");
    EXPECT_TRUE(core.snapshot().links[0].diagnosis.isHealthy());
    ASSERT_TRUE(clock.runUntil([&] { return core.session().links().front()->state() == LinkState::Lost; }, 5s));
    EXPECT_EQ(core.snapshot().links[0].diagnosis.ailment, Ailment::BusOff);
    clock.advance(3s);
    EXPECT_TRUE(core.snapshot().links[0].diagnosis.isHealthy());
}

TEST_F(Core, OpensALostLinkAgainAndSaysSo)
{
    open("sim:can?fault=busoff@3");
    const auto state = [this] { return core.session().links().front()->state(); };
    EXPECT_TRUE(clock.runUntil([&] { return state() == LinkState::Lost; }, 5s));
    EXPECT_TRUE(said("bus-off"));
    clock.advance(3s);
    EXPECT_EQ(state(), LinkState::Open);
    EXPECT_TRUE(said("is back"));
    EXPECT_TRUE(device(5)->liveness().heard);
    EXPECT_EQ(core.session().devices().size(), 6U);
}

TEST_F(Core, ScansAgainOnlyWhileNothingMoves)
{
    open("sim:can");
    EXPECT_GE(scansWithin(20s), 3);
    core.send(orders::StartMotion{id(5), duty(0.3), 60s}, into(opened));
    ASSERT_TRUE(*opened);
    clock.advance(500ms);
    EXPECT_EQ(scansWithin(20s), 0);
    core.stopAll(StopCause::User);
    clock.advance(10s);
    EXPECT_GE(scansWithin(20s), 3);
}

TEST_F(Core, ShowsAStopUntilItIsSeenAndThenThatItWas)
{
    open("sim:can");
    core.send(orders::StartMotion{id(5), duty(0.3), 60s}, into(opened));
    clock.advance(500ms);
    core.stopAll(StopCause::User);
    const auto view = [this] { return *core.snapshot().device(id(5)); };
    EXPECT_EQ(view().stop, StopState::Stopping);
    EXPECT_TRUE(view().stopsMotion);
    clock.advance(200ms);
    EXPECT_EQ(view().stop, StopState::Seen);
    EXPECT_FALSE(view().mayTurn);
    EXPECT_FALSE(core.snapshot().device(id(9))->mayNotBeStopped.empty()) << "it waits in its bootloader";
}

TEST_F(Core, SaysThatAMotorMayStillTurnWhenItsLineWasCutUntilItIsSeen)
{
    open("sim:can?fault=busoff@3.4");
    const DeviceId driven = core.session().idOf(*device(3, "abstractdc"));
    core.send(orders::StartMotion{driven, duty(0.3), 60s}, into(opened));
    ASSERT_TRUE(*opened);
    ASSERT_TRUE(clock.runUntil([&] { return core.session().links().front()->state() == LinkState::Lost; }, 5s));
    clock.advance(20ms);
    EXPECT_TRUE(core.snapshot().device(driven)->mayTurn);
    EXPECT_TRUE(said("cut its power"));
    ASSERT_TRUE(clock.runUntil([&] { return !core.snapshot().device(driven)->mayTurn; }, 10s));
    ASSERT_TRUE(clock.runUntil([&] { return said("was seen to stand"); }, 10s));
    EXPECT_FALSE(unit("abstractdc:3")->isOutputOn());
    EXPECT_TRUE(said("is back"));
}

TEST_F(Core, TakesNoSilentUnitForMuteWhoseMotorWasNotSeenToStand)
{
    open("sim:can");
    Bench &bench = *core.session().bench(*core.session().links().front());
    const auto find = [this] {
        test::Heard<DeviceId> found;
        core.send(orders::FindMute{"sim:can", "abstractdc", 3}, found.finished());
        EXPECT_TRUE(clock.runUntil([&found] { return found.has_value(); }, 2min));
        return found.value_or(fail(Fault::Cancelled));
    };
    core.send(orders::StartMotion{core.session().idOf(*device(3, "abstractdc")), duty(0.3), 60s}, into(opened));
    clock.advance(500ms);
    bench.setLoss(1.0);
    clock.advance(3s);
    const auto driven = find();
    ASSERT_FALSE(driven);
    EXPECT_EQ(driven.error().fault, Fault::Unsafe);
    ASSERT_TRUE(unit("abstractdc:3")->isOutputOn());
    bench.setLoss(0.0);
    EXPECT_TRUE(clock.runUntil([this] { return !unit("abstractdc:3")->isOutputOn(); }, 1500ms));
    EXPECT_TRUE(device(3, "abstractdc")->mayStop());
    clock.advance(5s);
    bench.setLoss(1.0);
    clock.advance(3s);
    EXPECT_TRUE(find()) << "it was seen to stand";
}

TEST_F(Core, DismissesWhatMayStillTurnByOrder)
{
    open("sim:can");
    core.send(orders::StartMotion{id(5), duty(0.3), 60s}, into(opened));
    clock.advance(200ms);
    device(5)->stopping().told();
    core.send(orders::DismissStops{});
    EXPECT_FALSE(core.snapshot().device(id(5))->mayTurn);
    EXPECT_TRUE(said("dismissed"));
}

TEST_F(Core, RefusesASecondJobWhileOneHasTheDevice)
{
    open("sim:can");
    test::Heard<> first;
    test::Heard<> second;
    test::Heard<> elsewhere;
    core.send(orders::Identify{id(5)}, into(first));
    core.send(orders::Identify{id(5)}, into(second));
    core.send(orders::Identify{id(7)}, into(elsewhere));
    ASSERT_TRUE(second) << "refused at once";
    ASSERT_FALSE(*second);
    EXPECT_EQ(second->error().fault, Fault::Unsafe);
    clock.advance(5s);
    ASSERT_TRUE(first && elsewhere);
    EXPECT_TRUE(*first);
    EXPECT_TRUE(*elsewhere);
    second.reset();
    core.send(orders::Identify{id(5)}, into(second));
    clock.advance(5s);
    ASSERT_TRUE(second);
    EXPECT_TRUE(*second) << "it is free again";
}

TEST_F(Core, AnswersForADeviceThatIsGone)
{
    open("sim:can");
    const DeviceId gone = id(5);
    core.send(orders::CloseLink{"sim:can"});
    test::Heard<> job;
    test::Heard<> motion;
    test::Heard<> change;
    core.send(orders::Identify{gone}, into(job));
    core.send(orders::StartMotion{gone, duty(0.1), 1s}, into(motion));
    core.send(orders::UpdateMotion{gone, duty(0.1)}, into(change));
    for (const auto *answer : {&job, &motion, &change}) {
        ASSERT_TRUE(*answer) << "every order is answered";
        EXPECT_FALSE(**answer);
    }
    core.send(orders::RenewMotion{gone});
    core.send(orders::StopMotion{gone});
    clock.advance(1s);
}

TEST_F(Core, ReadsARestartedUnitAgain)
{
    open("sim:can");
    core.send(orders::ReadParameters{id(7)});
    EXPECT_EQ(core.snapshot().operation(id(7))->status.kind, OperationKind::ReadParameters);
    clock.advance(2s);
    ASSERT_EQ(unknown(7), 0U);
    unit("dmc60c:7")->setPowered(false);
    clock.advance(1s);
    unit("dmc60c:7")->setPowered(true);
    EXPECT_TRUE(clock.runUntil([this] { return unknown(7) > 0; }, 10s))
        << "what was read before is not believed any more";
    clock.advance(5s);
    EXPECT_TRUE(said("restarted"));
    EXPECT_EQ(unknown(7), 0U);
    EXPECT_FALSE(device(7)->liveness().restarted);
    EXPECT_EQ(std::count_if(lines.begin(), lines.end(),
                  [](const std::string &l) { return l.find("restarted") != std::string::npos; }),
        1);
}

TEST_F(Core, EndsAMotionThatNobodyRenewsAndSaysSo)
{
    open("sim:can");
    core.send(orders::StartMotion{id(5), duty(0.3), 500ms});
    clock.advance(400ms);
    core.send(orders::RenewMotion{id(5)});
    clock.advance(400ms);
    EXPECT_TRUE(unit("dmc60c:5")->isOutputOn());
    clock.advance(200ms);
    EXPECT_FALSE(unit("dmc60c:5")->isOutputOn());
    EXPECT_TRUE(said("the window did not respond in time"));
    EXPECT_EQ(core.snapshot().device(id(5))->motion.end, SetPointStream::End::LeaseExpired);
}

TEST_F(Core, CountingFrom0ThatIsRefusedEndsNoMotion)
{
    open("sim:can");
    core.send(orders::StartMotion{id(5), duty(0.3), 60s}, into(opened));
    clock.advance(100ms);
    core.send(orders::ReadParameters{id(5)});
    test::Heard<> counted;
    core.send(orders::ZeroPosition{id(5)}, into(counted));
    ASSERT_TRUE(counted);
    EXPECT_FALSE(*counted) << "it is busy";
    clock.advance(50ms);
    EXPECT_TRUE(unit("dmc60c:5")->isOutputOn());
}

TEST_F(Core, ClosingALinkStopsItsMotorsAndEndsItsJobs)
{
    open("sim:can");
    core.send(orders::StartMotion{id(5), duty(0.3), 60s});
    core.send(orders::ReadParameters{id(7)});
    core.send(orders::ScanLinks{});
    core.send(orders::CloseLink{"sim:can"});
    EXPECT_TRUE(core.snapshot().links.empty());
    EXPECT_TRUE(core.snapshot().devices.empty());
    EXPECT_TRUE(core.snapshot().operations.empty());
    clock.advance(10s);
    open("sim:can");
    EXPECT_EQ(core.snapshot().devices.size(), 6U);
}

TEST_F(Core, ALinkStaysOpenWhileAUnitOnItIsUpdated)
{
    open("sim:can");
    core.send(orders::UpdateFirmware{id(7), std::make_shared<FirmwareImage>(), {}});
    test::Heard<> closed;
    core.send(orders::CloseLink{"sim:can"}, into(closed));
    ASSERT_TRUE(closed);
    ASSERT_FALSE(*closed);
    EXPECT_EQ(closed->error().fault, Fault::Unsafe);
    EXPECT_EQ(core.snapshot().links.size(), 1U);
    clock.advance(30s);
    closed.reset();
    core.send(orders::CloseLink{"sim:can"}, into(closed));
    ASSERT_TRUE(closed);
    EXPECT_TRUE(*closed) << "once it is over";
    EXPECT_TRUE(core.snapshot().links.empty());
}

TEST_F(Core, DoesNotLetAnythingElseTalkToAUnitDuringAnUpdate)
{
    open("sim:can");
    core.send(orders::UpdateFirmware{id(7), std::make_shared<FirmwareImage>(), {}});
    test::Heard<> motion;
    core.send(orders::StartMotion{id(7), duty(0.1), 1s}, into(motion));
    clock.advance(30s);
    ASSERT_TRUE(motion);
    const Snapshot shot = core.snapshot();
    const OperationView *operation = shot.operation(id(7));
    ASSERT_TRUE(operation && operation->update);
    EXPECT_NE(operation->update->outcome, UpdateOutcome::Done) << "an empty image is no success";
    EXPECT_FALSE(operation->update->verified);
    EXPECT_TRUE(device(7)->gate().busy().empty());
}

TEST_F(Core, AUnitThatAnotherMasterDrivesIsNeitherUpdatedNorStopped)
{
    open("sim:can");
    const auto other = core.session().bench(*core.session().links().front())->hostLink();
    ASSERT_TRUE(other->open());
    auto &master = dynamic_cast<CanLink &>(*other);
    int ours = 0;
    const Subscription heard
        = master.received().add([&ours](const CanFrame &frame) { ours += frame.id == 0x02060007U ? 1 : 0; });
    Timer timer(clock);
    std::function<void()> holding = [&] {
        ASSERT_TRUE(master.send(*canFrameFromText("02060007#0000000000000000"))); // duty 0
        timer.startIn(20ms, holding);
    };
    test::Heard<> answered;
    core.send(orders::UpdateFirmware{id(7), std::make_shared<FirmwareImage>(), {}}, into(answered));
    timer.startIn(10ms, holding); // a window that asked before it was heard
    ASSERT_TRUE(clock.runUntil([&] { return answered.has_value(); }, 30s));
    ASSERT_FALSE(*answered);
    EXPECT_EQ(answered->error().fault, Fault::Unsafe) << answered->error().text();
    EXPECT_EQ(ours, 0);
}

TEST_F(Core, TheLogTellsWhoWasFoundAndWhoFellSilent)
{
    open("sim:can");
    EXPECT_TRUE(said("DMC60C #5: found on sim:can"));
    EXPECT_FALSE(said("DMC60C #5: does not answer any more"));
    unit("dmc60c:5")->setPowered(false);
    clock.advance(10s);
    EXPECT_TRUE(said("DMC60C #5: does not answer any more"));
    unit("dmc60c:5")->setPowered(true);
    clock.advance(10s);
    EXPECT_TRUE(said("DMC60C #5: answers again"));
}

TEST_F(Core, TheLogTellsWhichKeyWasWrittenFromWhatToWhat)
{
    open("sim:can");
    const auto &family = device(7)->family();
    const auto index = *findParameter(family.parameters, "slot0.p");
    core.send(orders::ReadParameters{id(7)});
    clock.advance(5s);
    const auto before = device(7)->parameters().entries()[index.value].raw;
    ASSERT_TRUE(before);
    test::Heard<> written;
    core.send(orders::WriteParameters{id(7), {{index, 65536}}}, into(written));
    clock.advance(2s);
    ASSERT_TRUE(written && *written);
    EXPECT_TRUE(said("DMC60C #7: slot0.p: " + shownText(family.parameters[index.value], *before) + " → 1.000"));
}

TEST_F(Core, OneUpdateABusAndTheSecondIsRefusedWithWords)
{
    open("sim:can");
    const auto image = std::make_shared<FirmwareImage>();
    core.send(orders::UpdateFirmware{id(7), image, {}});
    EXPECT_EQ(core.snapshot().operation(id(7))->status.kind, OperationKind::UpdateFirmware);
    core.send(orders::UpdateFirmware{id(5), image, {}});
    EXPECT_FALSE(core.snapshot().operation(id(5)));
    EXPECT_TRUE(said("one update a bus: DMC60C #7 is being written; nothing was sent"));
    clock.advance(30s);
    core.send(orders::UpdateFirmware{id(5), image, {}});
    EXPECT_TRUE(core.snapshot().operation(id(5))) << "the bus is free again";
}

} // namespace
} // namespace mb
