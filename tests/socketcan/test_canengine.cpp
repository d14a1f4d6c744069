// SPDX-License-Identifier: GPL-3.0-or-later
// The engine thread's half of the window while interfaces come and go. Runs where vcan0 and vcan1 are up
// (tests/socketcan/run).
#include "app/engine/enginecore.h"
#include "app/engine/links.h"
#include "model/registry.h"
#include "support/eventloop.h"
#include "transport/linkwatch.h"

#include <gtest/gtest.h>

#include <iostream>

#include <cstdlib>

#include <net/if.h>

using namespace mb;
using namespace std::chrono_literals;

namespace {

void shell(const std::string &command)
{
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
}

class CanEngine : public ::testing::Test {
protected:
    void SetUp() override
    {
        if (::if_nametoindex("vcan0") == 0) {
            if (std::getenv("MOTORBENCH_REQUIRE_VCAN") != nullptr)
                FAIL() << "there is no interface vcan0 here";
            GTEST_SKIP() << "no vcan0 here; tests/socketcan/run BUILD_DIR runs this where it is";
        }
        core.links().takeListings(listLinks());
    }
    [[nodiscard]] std::optional<LinkView> link(const std::string &address)
    {
        const Snapshot shot = core.snapshot();
        const LinkView *view = shot.link(address);
        return view ? std::optional(*view) : std::nullopt;
    }
    [[nodiscard]] bool isOpen(const std::string &address)
    {
        const auto view = link(address);
        return view && view->state == LinkState::Open;
    }
    /// What the user's order ends with.
    [[nodiscard]] Result<void> opened(const std::string &address)
    {
        std::optional<Result<void>> answer;
        core.send(orders::OpenLink{*LinkAddress::parse(address)},
            [&answer](Result<void> result) { answer = std::move(result); });
        if (!loop.runUntil([&answer] { return answer.has_value(); }, 5s))
            return fail(Fault::Timeout, say("%1: the order has no answer", address));
        return *answer;
    }

    test::EventLoop loop;
    EngineCore core{loop.clock(), families(), true};
    LinkWatch watch{loop.clock()}; // as in app/engine
    Subscription plugged = watch.changed().add([this] { core.links().takeListings(listLinks()); });
};

} // namespace

TEST_F(CanEngine, SeveralInterfacesAreOpenedAtOnce)
{
    EXPECT_TRUE(isOpen("socketcan:vcan0"));
    EXPECT_TRUE(isOpen("socketcan:vcan1"));
    EXPECT_TRUE(link("socketcan:vcan0")->diagnosis.isHealthy());
}

TEST_F(CanEngine, AnInterfaceThatIsPluggedInIsOpenedAndOneThatIsUnpluggedGoes)
{
    shell("ip link add vcan9 type vcan && ip link set vcan9 up");
    const Instant at = loop.clock().now();
    ASSERT_TRUE(loop.runUntil([this] { return isOpen("socketcan:vcan9"); }, 5s));
    std::cout << "opened " << std::chrono::duration_cast<std::chrono::milliseconds>(loop.clock().now() - at).count()
              << " ms after it came\n";
    shell("ip link del vcan9");
    EXPECT_TRUE(loop.runUntil([this] { return !link("socketcan:vcan9"); }, 5s)) << "nobody was found on it";
}

TEST_F(CanEngine, AnInterfaceThatIsUnpluggedWhileUnitsAreServedThereGoesOnceThatHasEnded)
{
    Session session{loop.clock(), families()};
    EngineLog log{session};
    Operations operations{loop.clock(), session, log};
    const EngineContext context{loop.clock(), session, log, operations};
    Motion motion{context, nullptr};
    Recordings recordings{context, motion};
    Scans scans{context, recordings};
    Links links{context, motion, recordings, scans, true};
    const auto vcan9 = [&session] { return session.linkBook().find(*LinkAddress::parse("socketcan:vcan9")); };
    shell("ip link add vcan9 type vcan && ip link set vcan9 up");
    links.takeListings(listLinks());
    ASSERT_TRUE(loop.runUntil([&] { return vcan9() && !operations.hasOn(*vcan9()); }, 5s));
    ASSERT_TRUE(operations.lend(*vcan9()));
    shell("ip link del vcan9");
    ASSERT_TRUE(loop.runUntil([&] { return !vcan9() || vcan9()->state() == LinkState::Lost; }, 5s));
    links.takeListings(listLinks());
    ASSERT_TRUE(vcan9());
    operations.takeBack(*vcan9());
    links.takeListings(listLinks());
    EXPECT_FALSE(vcan9());
}

TEST_F(CanEngine, ALinkThatIsSwitchedOffStaysWithCauseAndRemedyAndReturns)
{
    shell("ip link add vcan9 type vcan && ip link set vcan9 up");
    ASSERT_TRUE(loop.runUntil([this] { return isOpen("socketcan:vcan9"); }, 5s));
    shell("ip link set vcan9 down");
    ASSERT_TRUE(loop.runUntil([this] { return link("socketcan:vcan9")->diagnosis.ailment == Ailment::Down; }, 5s));
    EXPECT_EQ(link("socketcan:vcan9")->state, LinkState::Lost);
    EXPECT_EQ(link("socketcan:vcan9")->diagnosis.command, "sudo ip link set vcan9 up");
    shell("ip link set vcan9 up");
    EXPECT_TRUE(loop.runUntil([this] { return isOpen("socketcan:vcan9"); }, 5s));
    EXPECT_TRUE(link("socketcan:vcan9")->diagnosis.isHealthy());
    shell("ip link del vcan9");
}

TEST_F(CanEngine, AVanishedInterfaceThatTheUserAskedForStays)
{
    shell("ip link add vcan9 type vcan");
    EXPECT_FALSE(opened("socketcan:vcan9")) << "it is still off";
    shell("ip link set vcan9 up");
    const auto answer = opened("socketcan:vcan9");
    ASSERT_TRUE(answer) << answer.error().text();
    shell("ip link del vcan9");
    ASSERT_TRUE(loop.runUntil([this] { return link("socketcan:vcan9")->diagnosis.ailment == Ailment::Gone; }, 5s));
    shell("ip link add vcan9 type vcan && ip link set vcan9 up");
    EXPECT_TRUE(loop.runUntil([this] { return isOpen("socketcan:vcan9"); }, 5s));
    shell("ip link del vcan9");
}

TEST_F(CanEngine, SomebodyElsesFramesAreCountedAsUnknown)
{
    shell("cangen vcan0 -g 0 -n 300 -e -I 18FEF100 -L 8");
    EXPECT_TRUE(loop.runUntil([this] { return link("socketcan:vcan0")->unknown == 300; }, 5s));
    EXPECT_EQ(link("socketcan:vcan0")->counters.lost, 0U);
}
