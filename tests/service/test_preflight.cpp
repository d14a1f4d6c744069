// SPDX-License-Identifier: GPL-3.0-or-later
// What keeps a unit from being served: looked at before anything is done to it.
#include "async/virtualclock.h"
#include "service/preflight.h"
#include "support/loosemotor.h"
#include "support/simulatedsession.h"

namespace mb::service {
namespace {

using namespace std::chrono_literals;

UpdateReport toldByDryRun;
std::optional<UpdateOptions> askedOfDryRun;

Task<UpdateReport> dryRunOf(Device &, const FirmwareImage &, UpdateOptions options, Progress &)
{
    askedOfDryRun = std::move(options);
    co_return toldByDryRun;
}

constexpr Family updatedFamily = [] {
    Family family = test::looseFamily;
    family.update = &dryRunOf;
    return family;
}();

/// In whatever state a test wants it.
class UnitInState final : public test::MuteDevice {
public:
    UnitInState(CanLink &link, Clock &clock, DeviceState state)
        : MuteDevice(updatedFamily, link, clock, identityIn(state))
    {
    }
    using Device::setLiveness;

private:
    static Identity identityIn(DeviceState state)
    {
        Identity identity;
        identity.address = 7;
        identity.state = state;
        return identity;
    }
    Result<void> doCommand(const SetPoint &) override { return {}; }
    void doStop() override { }
    [[nodiscard]] bool isSeenStopped() const override { return true; }
};

class Preflight : public testing::Test {
protected:
    Preflight()
    {
        EXPECT_TRUE(link.open());
        toldByDryRun = {};
        askedOfDryRun.reset();
    }
    Result<void> look(DeviceState state, const Liveness &liveness = {})
    {
        UnitInState unit(link, clock, state);
        unit.setLiveness(liveness);
        NoProgress unseen;
        return test::run(clock, preflight(unit, matter, nullptr, unseen));
    }
    static std::string why(const Result<void> &looked) { return looked ? "nothing" : looked.error().text(); }

    VirtualClock clock;
    test::LoggedLink link{clock, {Outlet::Form::CanSocket, 7}};
    RecipeMatter matter;
};

TEST_F(Preflight, AUnitWithoutANumberIsServedButNotTurned)
{
    EXPECT_TRUE(look(DeviceState::Unassigned));
    matter.recipe.test.emplace();
    const auto refused = look(DeviceState::Unassigned);
    EXPECT_EQ(refused.error().fault, Fault::Unsafe);
    EXPECT_NE(why(refused).find("no number yet"), std::string::npos) << why(refused);
    EXPECT_TRUE(look(DeviceState::Online));
}

TEST_F(Preflight, SeveralUnitsOfOneNumberAreNotServed)
{
    const auto refused = look(DeviceState::Duplicate);
    EXPECT_NE(why(refused).find("several units answer as number 7"), std::string::npos) << why(refused);
}

TEST_F(Preflight, AUnitInItsBootloaderNeedsFirmware)
{
    const auto refused = look(DeviceState::Bootloader);
    EXPECT_NE(why(refused).find("no firmware"), std::string::npos) << why(refused);
    matter.recipe.firmware.emplace();
    toldByDryRun.outcome = UpdateOutcome::Done;
    const Instant before = clock.now();
    EXPECT_TRUE(look(DeviceState::Bootloader));
    EXPECT_EQ(clock.now(), before) << "nobody drives it there";
}

TEST_F(Preflight, AUnitThatSomebodyDrivesOrThatTurnsIsNotServed)
{
    Liveness driven;
    driven.foreignMaster = true;
    EXPECT_NE(why(look(DeviceState::Online, driven)).find("another program"), std::string::npos);
    Liveness turning;
    turning.moving = true;
    EXPECT_NE(why(look(DeviceState::Online, turning)).find("turning"), std::string::npos);
}

TEST_F(Preflight, AnotherMasterIsListenedForLongEnoughToBeHeard)
{
    UnitInState unit(link, clock, DeviceState::Online);
    Timer master(clock);
    master.startIn(140ms, [&unit] {
        Liveness driven;
        driven.foreignMaster = true;
        unit.setLiveness(driven);
    });
    NoProgress unseen;
    EXPECT_EQ(test::run(clock, preflight(unit, matter, nullptr, unseen)).error().fault, Fault::Unsafe);
}

TEST_F(Preflight, FirmwareIsAskedWhetherItWouldGoAndNothingIsWritten)
{
    matter.recipe.firmware = FirmwareRule{"some.hex", "openocd:stlink?target=f1"};
    for (const UpdateOutcome good : {UpdateOutcome::Done, UpdateOutcome::UpToDate}) {
        toldByDryRun.outcome = good;
        EXPECT_TRUE(look(DeviceState::Online));
    }
    ASSERT_TRUE(askedOfDryRun);
    EXPECT_TRUE(askedOfDryRun->dryRun);
    EXPECT_EQ(askedOfDryRun->via, "openocd:stlink");
    EXPECT_EQ(askedOfDryRun->target, "f1");
    toldByDryRun.outcome = UpdateOutcome::Refused;
    EXPECT_EQ(look(DeviceState::Online).error().fault, Fault::Unsafe);
    toldByDryRun.outcome = UpdateOutcome::Failed;
    EXPECT_EQ(look(DeviceState::Online).error().fault, Fault::Refused);
    toldByDryRun.fault = Fault::Timeout;
    EXPECT_EQ(look(DeviceState::Online).error().fault, Fault::Timeout);
}

} // namespace
} // namespace mb::service
