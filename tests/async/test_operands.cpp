// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/sleep.h"
#include "async/task.h"
#include "async/virtualclock.h"

#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <string>
#include <utility>

using namespace mb;
using namespace std::chrono_literals;

namespace {

/// Notices an object that is destroyed twice, or never: compilers have done both to what is made in the operand of a co_await.
class Counted {
public:
    explicit Counted(std::map<const Counted *, int> &alive)
        : m_alive(&alive)
    {
        ++alive[this];
    }
    Counted(const Counted &other)
        : m_alive(other.m_alive)
    {
        ++(*m_alive)[this];
    }
    Counted(Counted &&other) noexcept
        : m_alive(other.m_alive)
    {
        ++(*m_alive)[this];
    }
    Counted &operator=(const Counted &) = delete;
    ~Counted()
    {
        EXPECT_EQ(1, (*m_alive)[this]) << "destroyed twice, or never made";
        m_alive->erase(this);
    }

private:
    std::map<const Counted *, int> *m_alive;
};

struct Wish {
    Counted counted;
    std::string text;
};

enum class End { Inline, Later, FailsInline, FailsLater };

struct Ground {
    std::map<const Counted *, int> alive{};
    VirtualClock clock{};
    End end = End::Inline;
};

Task<std::string> finish(Ground &ground, std::string text)
{
    if (ground.end == End::Later || ground.end == End::FailsLater)
        co_await Sleep(ground.clock, 1ms);
    if (ground.end == End::FailsInline || ground.end == End::FailsLater)
        co_return fail(Fault::Refused, say("now"));
    co_return text;
}

Task<std::string> takeObject(Ground &ground, Counted counted)
{
    (void)counted;
    co_return co_await finish(ground, "object that is longer than what a string keeps in itself");
}

Task<std::string> takeOptional(Ground &ground, std::optional<Counted> counted)
{
    EXPECT_TRUE(counted);
    co_return co_await finish(ground, "there, and longer than what a string keeps in itself");
}

Task<std::string> takeText(Ground &ground, std::string text)
{
    co_return co_await finish(ground, std::move(text));
}

Task<std::string> takeWish(Ground &ground, Wish wish)
{
    co_return co_await finish(ground, wish.text);
}

Task<std::size_t> askAll(Ground &ground)
{
    const Counted kept(ground.alive);
    const Wish wish = {kept, "a wish that is longer than what a string keeps in itself"};
    std::size_t length = (co_await takeObject(ground, kept)).size();
    Counted given(ground.alive);
    length += (co_await takeObject(ground, std::move(given))).size();
    length += (co_await takeObject(ground, Counted(ground.alive))).size();
    length += (co_await takeOptional(ground, kept)).size();
    length += (co_await takeText(ground, "text that is longer than what a string keeps in itself")).size();
    const std::string last = co_await takeWish(ground, wish);
    if (const auto attempt = co_await takeWish(ground, wish).attempt(); attempt)
        length += attempt->size();
    co_return length + last.size();
}

Task<void> attemptAll(Ground &ground)
{
    const Counted kept(ground.alive);
    const Wish wish = {kept, "a wish that is longer than what a string keeps in itself"};
    const auto object = co_await takeObject(ground, kept).attempt();
    const auto made = co_await takeObject(ground, Counted(ground.alive)).attempt();
    const auto optional = co_await takeOptional(ground, kept).attempt();
    const auto text = co_await takeText(ground, "text that is longer than what a string keeps in itself").attempt();
    if (auto wished = co_await takeWish(ground, wish).attempt(); !wished)
        co_return fail(wished.error());
    co_await takeObject(ground, Counted(ground.alive));
    co_return {};
}

Result<std::string> textOf(const Ground &ground, const std::string &text, Counted counted)
{
    (void)counted;
    if (ground.end == End::FailsInline || ground.end == End::FailsLater)
        return fail(Fault::Refused, say("now"));
    return text;
}

Task<std::string> awaitResults(Ground &ground)
{
    const Counted kept(ground.alive);
    if (ground.end == End::Later || ground.end == End::FailsLater)
        co_await Sleep(ground.clock, 1ms);
    const std::string text = co_await textOf(ground, "text that is longer than what a string keeps in itself", kept);
    if (const std::string again = co_await textOf(ground, text, Counted(ground.alive)); again != text)
        co_return "another";
    co_return co_await textOf(ground, "the last, longer than what a string keeps in itself", Counted(ground.alive));
}

Task<int> oneLess(Ground &ground, int from)
{
    (void)co_await finish(ground, "a step that is longer than what a string keeps in itself");
    co_return from - 1;
}

Task<int> countDown(Ground &ground, int from)
{
    int left = from;
    for (;;) {
        if (left == 0)
            co_return left;
        if (const auto asked = co_await takeText(ground, "a condition that is longer than a string keeps").attempt();
            !asked)
            co_return fail(asked.error());
        if (const std::string text = co_await takeText(ground, "the next"); text.empty())
            break;
        left = co_await oneLess(ground, left);
    }
    co_return -1;
}

Task<int> countTwice(Ground &ground)
{
    const int first = co_await countDown(ground, 3);
    if (first == 0)
        co_return co_await countDown(ground, 2);
    co_return co_await countDown(ground, 1).attempt();
}

class Operand : public testing::TestWithParam<End> {
protected:
    void SetUp() override { m_ground.end = GetParam(); }
    void TearDown() override
    {
        EXPECT_TRUE(m_ground.alive.empty()) << m_ground.alive.size() << " were never destroyed";
    }
    Ground m_ground;
};

} // namespace

TEST_P(Operand, ThatIsACallDestroysItsArgumentsOnce)
{
    Task<std::size_t> asking = askAll(m_ground);
    asking.start();
    m_ground.clock.advance(1s);
    ASSERT_TRUE(asking.isFinished());
    EXPECT_EQ(GetParam() == End::Inline || GetParam() == End::Later, asking.result().has_value());
    EXPECT_LT(300U, asking.result().value_or(1000U));
}

TEST_P(Operand, ThatIsAnAttemptDestroysItsArgumentsOnce)
{
    Task<void> asking = attemptAll(m_ground);
    asking.start();
    m_ground.clock.advance(1s);
    ASSERT_TRUE(asking.isFinished());
    EXPECT_EQ(GetParam() == End::Inline || GetParam() == End::Later, asking.result().has_value());
}

TEST_P(Operand, ThatIsAResultYieldsItsValueOrEndsTheCaller)
{
    Task<std::string> asking = awaitResults(m_ground);
    asking.start();
    m_ground.clock.advance(1s);
    ASSERT_TRUE(asking.isFinished());
    const bool fails = GetParam() == End::FailsInline || GetParam() == End::FailsLater;
    EXPECT_EQ(asking.result().value_or("fault").substr(0, 8), fails ? "fault" : "the last");
    if (fails) {
        EXPECT_EQ(asking.result().error().fault, Fault::Refused);
    }
}

TEST_P(Operand, ThatIsCancelledAnywhereDestroysItsArgumentsOnce)
{
    for (int steps = 0; steps < 8; ++steps) {
        Task<std::size_t> asking = askAll(m_ground);
        Task<void> attempting = attemptAll(m_ground);
        asking.start();
        attempting.start();
        m_ground.clock.advance(1ms * steps);
    }
}

TEST_P(Operand, ThatIsNamedInAConditionOrReturnedGoesTheWayThatItSays)
{
    Task<int> counting = countTwice(m_ground);
    counting.start();
    m_ground.clock.advance(1s);
    ASSERT_TRUE(counting.isFinished());
    const bool fails = GetParam() == End::FailsInline || GetParam() == End::FailsLater;
    EXPECT_EQ(fails ? -2 : 0, counting.result().value_or(-2));
}

INSTANTIATE_TEST_SUITE_P(Ends, Operand, testing::Values(End::Inline, End::Later, End::FailsInline, End::FailsLater));
