// SPDX-License-Identifier: GPL-3.0-or-later
// Which frames a person may send by hand: of those that make a motor move, only what STOP can reach and what ends by itself.
#include "model/framepermit.h"
#include "support/simulatedsession.h"

#include <functional>

namespace mb {
namespace {

constexpr std::string_view controlOfFive = "02060005#7100000000280000";

class FramePermits : public testing::Test {
public:
    void SetUp() override
    {
        bench.scan();
        shot.links = {viewOf(*bench.link, bench.clock)};
        shot.devices = {viewOf(bench.session, *bench.device(5)), viewOf(bench.session, *bench.device(7))};
        armed = five().id;
    }
    DeviceView &five() { return shot.devices.front(); }
    [[nodiscard]] FramePermit ask(std::string_view frame) const
    {
        return permitFor(*canFrameFromText(frame), "sim:can", shot, families(),
            [this](DeviceId device) { return armed && device == *armed; });
    }
    [[nodiscard]] std::string refusal(std::string_view frame = controlOfFive) const
    {
        const auto refused = ask(frame).refusal;
        return refused ? refused->text() : std::string();
    }

    test::SimulatedSession bench;
    Snapshot shot;
    std::optional<DeviceId> armed;
};

TEST_F(FramePermits, AControlFrameOfAnArmedDeviceGoesAndNamesIt)
{
    const FramePermit permit = ask(controlOfFive);
    EXPECT_EQ(refusal(), "");
    EXPECT_TRUE(permit.control);
    EXPECT_EQ(permit.device, five().id);
    ASSERT_TRUE(permit.meaning);
    EXPECT_EQ(permit.meaning->frame.address, 5);
}

TEST_F(FramePermits, WhatMovesNothingNeedsAnOpenLinkOnly)
{
    armed.reset();
    five().motion.running = true;
    const FramePermit unknown = ask("123#0102");
    EXPECT_FALSE(unknown.refusal || unknown.control || unknown.meaning);
    EXPECT_EQ(refusal("02061805#34123D"), "") << "a question";
    shot.links.front().state = LinkState::Lost;
    EXPECT_EQ(refusal("123#0102"), "no open CAN link is shown; open one first");
    shot.links.front().reason = say("the adapter went away");
    EXPECT_EQ(refusal("123#0102"), "the adapter went away");
}

TEST_F(FramePermits, AControlFrameIsRefusedWhereStopWouldNotReachItOrSomebodyElseDrives)
{
    static const Family unguarded = [] {
        Family family = *findFamily(families(), "dmc60c");
        family.capabilities.watchdog = false;
        return family;
    }();
    struct Row {
        std::function<void(FramePermits &)> when;
        std::string_view says;
    };
    const std::array<Row, 6> rows{{
        {[](FramePermits &t) { t.armed = t.shot.devices.back().id; }, "DMC60C #5 is not armed"},
        {[](FramePermits &t) { t.shot.devices.push_back(t.five()); }, "two units answer as DMC60C #5"},
        {[](FramePermits &t) { t.five().motion.running = true; }, "DMC60C #5 is driven already"},
        {[](FramePermits &t) { t.five().busy = say("firmware update"); }, "DMC60C #5 is busy: firmware update"},
        {[](FramePermits &t) { t.five().mayNotMove = say("it is in its bootloader"); }, "it is in its bootloader"},
        {[](FramePermits &t) { t.five().family = &unguarded; }, "it has no watchdog"},
    }};
    const Snapshot good = shot;
    for (const Row &row : rows) {
        shot = good;
        armed = five().id;
        row.when(*this);
        EXPECT_NE(refusal().find(row.says), std::string::npos) << refusal();
        EXPECT_TRUE(ask(controlOfFive).control);
    }
    shot = good;
    EXPECT_EQ(refusal("0206000C#7100000000280000"),
        "no DMC60C #12 is known on this link, so STOP could not reach it; scan first");
}

} // namespace
} // namespace mb
