// SPDX-License-Identifier: GPL-3.0-or-later
// Orders of an update around answers that come late: none may be taken for the answer to a later order.
#include "dmc60ccontrollerfixture.h"
#include "families/dmc60c/updatecontact.h"

#include <string>

namespace mb::dmc60c {
namespace {

class Dmc60cContact : public Dmc60cController {
protected:
    Dmc60cContact()
        : m_tap(host.traffic().add([this](const Traffic &traffic) {
            if (traffic.direction == Direction::Sent && toText(*traffic.can).starts_with("0206FC05"))
                lastSent = clock.now();
        }))
    {
    }
    /// How long an order waits before it is sent; its answer is `status`, or none.
    Duration waits(Command command)
    {
        const Instant begin = clock.now();
        lastSent = {};
        Task<VendorReply> task = contact.order(command);
        task.start();
        EXPECT_TRUE(clock.runUntil([this] { return lastSent != Instant{}; }, 10s));
        const Duration waited = lastSent - begin;
        EXPECT_TRUE(clock.runUntil([&task] { return task.isFinished(); }, 10s));
        answered = task.result().has_value();
        return waited;
    }
    UpdateContact contact{*device};
    Instant lastSent{};
    bool answered = false;

private:
    Subscription m_tap;
};

TEST_F(Dmc60cContact, AfterAnOrderWithoutAnswerTheNextOneWaitsUntilNoneCanComeAnyMore)
{
    unit.answer(getVersions, {versionsReply});
    EXPECT_LT(waits(Command::FlashLEDs), 1ms);
    EXPECT_FALSE(answered);
    EXPECT_LT(waits(Command::GetFwver), 1ms) << "a question has an answer of its own kind";
    EXPECT_TRUE(answered);
    Timer late(clock);
    late.startIn(400ms, [this] { unit.send("0206FCC5#00000000"); });
    const Duration waited = waits(Command::FlashLEDs);
    EXPECT_GE(waited, 900ms) << "half a second after the last late answer";
    EXPECT_LT(waited, 910ms);
}

TEST_F(Dmc60cContact, AnswersOfAnotherUnitAreNotWaitedFor)
{
    EXPECT_LT(waits(Command::FlashLEDs), 1ms);
    Timer late(clock);
    late.startIn(400ms, [this] { unit.send("0206FCC6#00000000"); });
    const Duration waited = waits(Command::FlashLEDs);
    EXPECT_GE(waited, 500ms);
    EXPECT_LT(waited, 510ms);
}

TEST_F(Dmc60cContact, WhereEveryOrderWasAnsweredNoneWaits)
{
    unit.answer(getVersions, {versionsReply});
    for (int i = 0; i < 3; ++i)
        EXPECT_LT(waits(Command::GetFwver), 1ms);
    contact.noteAnswerOwed();
    EXPECT_LT(waits(Command::GetFwver), 1ms);
    EXPECT_GE(waits(Command::FlashLEDs), 500ms) << "somebody else has noticed that one is owed";
}

} // namespace
} // namespace mb::dmc60c
