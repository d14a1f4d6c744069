// SPDX-License-Identifier: GPL-3.0-or-later
// Gains that an experiment could not put back, as the engine's half offers them. Virtual time.
#include "trialcore.h"

#include <string>
#include <vector>

namespace mb {
namespace {

using namespace std::chrono_literals;
using test::TrialCore;
using tuning::Keep;

TEST_F(TrialCore, GainsThatAProgramCouldNotPutBackAreOfferedAndPaidAfterAsking)
{
    const std::int64_t before = stored();
    journal.debtor = unitKeyOf(*device());
    test::Heard<> written;
    core.send(orders::WriteParameters{id(), {{p(), 30'000}}}, written.finished());
    ASSERT_TRUE(clock.runUntil([&written] { return written.has_value(); }, 10s));
    journal.owed = {{"slot0.p", before}};
    core.send(orders::CloseLink{"sim:can"});
    EXPECT_TRUE(core.owedGains().empty());
    core.send(orders::OpenLink{*LinkAddress::parse("sim:can")});
    ASSERT_TRUE(clock.runUntil([this] { return device() && device()->liveness().heard; }, 10s));
    clock.advance(3s);
    // A bench that is opened anew is as from the factory: it has what it is owed, and nobody is asked.
    EXPECT_TRUE(core.owedGains().empty());
    EXPECT_TRUE(journal.owed.empty());

    journal.owed = {{"slot0.p", before + 1000}};
    core.send(orders::CloseLink{"sim:can"});
    core.send(orders::OpenLink{*LinkAddress::parse("sim:can")});
    ASSERT_TRUE(clock.runUntil([this] { return device() && core.owedGains().count(id()) == 1; }, 20s));
    EXPECT_EQ(stored(), before) << "nothing is written unasked";
    SetPoint byHand;
    byHand.mode = Mode::Duty;
    core.send(orders::StartMotion{id(), byHand, 500ms});
    test::Heard<> refused;
    core.send(orders::PayGains{id(), core.owedGains().at(id()).front().trial}, refused.finished());
    clock.advance(1s);
    EXPECT_TRUE(refused && !*refused);
    EXPECT_TRUE(core.session().stream(*device()).isRunning()) << "who drives it is not disturbed";
    core.send(orders::StopMotion{id()});
    clock.advance(1s);
    test::Heard<> paid;
    core.send(orders::PayGains{id(), core.owedGains().at(id()).front().trial}, paid.finished());
    ASSERT_TRUE(clock.runUntil([&paid] { return paid.has_value(); }, 20s));
    ASSERT_TRUE(*paid) << paid->error().detail;
    EXPECT_EQ(stored(), before + 1000);
    EXPECT_TRUE(core.owedGains().empty());
    EXPECT_TRUE(journal.owed.empty());
}

TEST_F(TrialCore, GainsThatALivingProgramTriesAreAskedAfterWithoutAnOperation)
{
    journal.debtor = unitKeyOf(*device());
    journal.owed = {{"slot0.p", stored() + 1000}};
    journal.isUnderWay = true;
    core.send(orders::CloseLink{"sim:can"});
    core.send(orders::OpenLink{*LinkAddress::parse("sim:can")});
    ASSERT_TRUE(clock.runUntil([this] { return device() && device()->liveness().heard; }, 10s));
    clock.advance(3s);
    const std::size_t operations = core.snapshot().operations.size();
    clock.advance(20s);
    EXPECT_EQ(core.snapshot().operations.size(), operations);
    EXPECT_TRUE(core.owedGains().empty());
    journal.isUnderWay = false;
    EXPECT_TRUE(clock.runUntil([this] { return core.owedGains().count(id()) == 1; }, 20s)) << "that program has ended";
}

TEST_F(TrialCore, ANotebookThatDidNotAnswerIsAskedAgainForGainsThatAreOwed)
{
    journal.debtor = unitKeyOf(*device());
    journal.owed = {{"slot0.p", stored() + 1000}};
    std::vector<std::string> lines;
    const Subscription noticed = core.noticed().add([&lines](Severity, const std::string &, const Message &text) {
        if (text.english().find("the disk is full") != std::string::npos)
            lines.push_back(text.english());
    });
    journal.isFull = true;
    core.send(orders::CloseLink{"sim:can"});
    core.send(orders::OpenLink{*LinkAddress::parse("sim:can")});
    ASSERT_TRUE(clock.runUntil([this] { return device() && device()->liveness().heard; }, 10s));
    clock.advance(30s);
    EXPECT_TRUE(core.owedGains().empty());
    EXPECT_EQ(lines.size(), 5U) << "one of each unit that runs, not one a question";
    journal.isFull = false;
    EXPECT_TRUE(clock.runUntil([this] { return core.owedGains().count(id()) == 1; }, 10s));
}

TEST_F(TrialCore, GainsAreOfferedNoMoreOnceATrialHasKeptOthers)
{
    journal.debtor = unitKeyOf(*device());
    journal.owed = {{"slot0.p", stored() + 1000}};
    core.send(orders::CloseLink{"sim:can"});
    core.send(orders::OpenLink{*LinkAddress::parse("sim:can")});
    ASSERT_TRUE(clock.runUntil([this] { return device() && core.owedGains().count(id()) == 1; }, 20s));
    start(Keep::WhenDone);
    ASSERT_TRUE(ends());
    ASSERT_TRUE(*ended);
    ASSERT_EQ((**ended).reason, tuning::EndReason::Done) << (**ended).detail;
    EXPECT_TRUE(journal.owed.empty());
    EXPECT_TRUE(clock.runUntil([this] { return core.owedGains().empty(); }, 5s));
}

} // namespace
} // namespace mb
