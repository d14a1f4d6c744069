// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/standstill.h"
#include "sessionlines.h"

namespace mb {
namespace {

using namespace std::chrono_literals;
using test::SessionLines;

/// Whatever is heard of it.
class SeenMotor final : public test::MuteDevice {
public:
    SeenMotor(Link &link, Clock &clock, Identity identity)
        : MuteDevice(test::wiredFamily, link, clock, std::move(identity))
    {
    }
    void see(bool moving, bool foreignMaster)
    {
        Liveness now = liveness();
        now.moving = moving;
        now.foreignMaster = foreignMaster;
        setLiveness(now);
    }

private:
    Result<void> doCommand(const SetPoint &) override { return {}; }
    void doStop() override { }
    [[nodiscard]] bool isSeenStopped() const override { return true; }
};

struct StandingStill : SessionLines {
    /// What is found after 150 ms, during which another master would have sent; empty: nothing forbids it.
    std::string found(SeenMotor &motor, Task<void> (*look)(Device &), Duration after = 150ms)
    {
        Task<void> looking = look(motor);
        looking.start();
        if (after > Duration::zero()) {
            clock.advance(after - 1ns);
            EXPECT_FALSE(looking.isFinished());
            clock.advance(1ns);
        }
        EXPECT_TRUE(looking.isFinished());
        if (looking.isFinished() && !looking.result()) {
            EXPECT_EQ(looking.result().error().fault, Fault::Unsafe);
            return looking.result().error().text();
        }
        return {};
    }
    static Identity identityOf(DeviceState state)
    {
        Identity identity;
        identity.family = "wired";
        identity.state = state;
        return identity;
    }
};

TEST_F(StandingStill, IsLookedForUntilAnotherMasterWouldHaveSent)
{
    SeenMotor motor(*links[0], clock, identityOf(DeviceState::Online));
    EXPECT_EQ(found(motor, hasNoOtherMaster), "");
    EXPECT_EQ(found(motor, standsStill), "");
    motor.see(true, false);
    EXPECT_EQ(found(motor, hasNoOtherMaster), "");
    EXPECT_EQ(found(motor, standsStill), "its motor is turning or driven already; bring it to rest first");
    motor.see(false, true);
    EXPECT_EQ(found(motor, hasNoOtherMaster), "another program or controller drives this unit; stop it there first");
    EXPECT_EQ(found(motor, standsStill), "another program or controller drives this unit; stop it there first");
}

TEST_F(StandingStill, IsWhatABootloaderDoes)
{
    SeenMotor motor(*links[0], clock, identityOf(DeviceState::Bootloader));
    motor.see(true, true);
    EXPECT_EQ(found(motor, hasNoOtherMaster, 0ns), "");
    EXPECT_EQ(found(motor, standsStill, 0ns), "");
}

TEST_F(StandingStill, IsNothingThatSeveralUnitsOfOneNumberCanDo)
{
    Identity identity = identityOf(DeviceState::Duplicate);
    identity.address = 7;
    SeenMotor motor(*links[0], clock, identity);
    EXPECT_EQ(found(motor, standsStill, 0ns),
        "several units answer as number 7; take the other one off, or give one of them another number");
}

} // namespace
} // namespace mb
