// SPDX-License-Identifier: GPL-3.0-or-later
// What a session tells of its links: once each, to whoever it concerns. The lines are pseudo terminals.
#include "async/virtualclock.h"
#include "model/linkbook.h"
#include "support/heldbackground.h"
#include "support/pseudoterminal.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace mb {
namespace {

using ToldOfLinks = std::vector<std::string>;

struct LinkBooks : testing::Test {
    LinkBooks()
    {
        const auto tell = [this](const char *what, const Link &link) {
            told.push_back(std::string(what) + ' ' + std::to_string(static_cast<int>(link.state())));
        };
        subscriptions.push_back(book.opened().add([tell](Link &link) { tell("opened", link); }));
        subscriptions.push_back(book.lost().add([tell](Link &link) { tell("lost", link); }));
        subscriptions.push_back(book.changed().add([this] { told.emplace_back("changed"); }));
        subscriptions.push_back(book.batchEnded().add([this] { told.emplace_back("batch"); }));
        subscriptions.push_back(book.remarked().add([this](const Link &link, const Message &text) {
            told.push_back(link.address().text() + ": " + text.english());
        }));
    }
    [[nodiscard]] LinkAddress address(const std::string &options = {}) const
    {
        return *LinkAddress::parse("serial:" + terminal.path() + options);
    }
    ToldOfLinks toldSince() { return std::exchange(told, {}); }

    test::PseudoTerminal terminal;
    test::HeldBackground background; ///< ports are closed there, too
    VirtualClock clock;
    LinkBook book{clock, {}};
    ToldOfLinks told;
    std::vector<Subscription> subscriptions;
};

const std::string isOpenNow = std::to_string(static_cast<int>(LinkState::Open));
const std::string isLostNow = std::to_string(static_cast<int>(LinkState::Lost));

TEST_F(LinkBooks, AnOpeningIsToldOnceWithWhatItsUserShouldKnow)
{
    const LinkAddress switching = address("?rs485=1");
    const std::string remark = switching.text() + ": the driver of " + switching.shortName()
        + " cannot switch the direction of an RS-485 line, so the adapter has to do it by itself; if nothing answers, "
          "use "
          "one that does";
    const auto link = book.open(switching);
    ASSERT_TRUE(link);
    EXPECT_EQ(toldSince(), (ToldOfLinks{"opened " + isOpenNow, "changed", remark}));
    EXPECT_EQ(book.open(switching), link);
    EXPECT_EQ(toldSince(), ToldOfLinks{}) << "it is open";
    (*link)->close();
    EXPECT_EQ(toldSince(), ToldOfLinks{"changed"});
    EXPECT_EQ(book.open(switching), link);
    EXPECT_EQ(toldSince(), (ToldOfLinks{"opened " + isOpenNow, "changed", remark}));
    EXPECT_EQ(book.all(), std::vector<Link *>{*link});
    book.close(**link);
    EXPECT_EQ(toldSince(), (ToldOfLinks{"changed", "changed"})) << "it is closed, and gone";
    EXPECT_EQ(book.find(switching), nullptr);
    ASSERT_TRUE(book.open(address()));
    EXPECT_EQ(toldSince(), (ToldOfLinks{"opened " + isOpenNow, "changed"}));
}

TEST_F(LinkBooks, ALossIsToldToThoseWhomItConcerns)
{
    Link *const link = *book.open(address());
    link->close();
    (void)toldSince();
    link->closedFor(say("avrdude had the port"));
    EXPECT_EQ(toldSince(), (ToldOfLinks{"lost " + isLostNow, "changed"}));
    book.reopen(*link);
    EXPECT_EQ(toldSince(), (ToldOfLinks{"opened " + isOpenNow, "changed"}));
}

TEST_F(LinkBooks, ARemarkIsNotToldTwiceOnEnd)
{
    Link *const link = *book.open(address());
    (void)toldSince();
    const std::string name = link->address().text() + ": ";
    book.remark(*link, say("node 4 is silent"));
    book.remark(*link, say("node 4 is silent"));
    EXPECT_EQ(toldSince(), ToldOfLinks{name + "node 4 is silent"});
    book.remark(*link, say("node 5 is silent"));
    book.remark(*link, say("node 4 is silent"));
    EXPECT_EQ(toldSince(), (ToldOfLinks{name + "node 5 is silent", name + "node 4 is silent"}));
    LinkBook other(clock, {});
    other.remark(*link, say("node 4 is silent"));
    EXPECT_EQ(toldSince(), ToldOfLinks{}) << "a link of another book";
}

TEST_F(LinkBooks, ALinkIsMadeOnceAlsoWhereTwoOpenItInTheBackground)
{
    book.setBackground(&background);
    Task<Link *> first = book.openSoon(address("?rs485=1"));
    Task<Link *> second = book.openSoon(address("?rs485=1"));
    first.start();
    second.start();
    clock.advance(std::chrono::milliseconds(1));
    EXPECT_FALSE(first.isFinished() || second.isFinished());
    EXPECT_EQ(toldSince(), ToldOfLinks{});
    background.release();
    clock.advance(std::chrono::milliseconds(1));
    ASSERT_TRUE(first.isFinished());
    ASSERT_TRUE(first.result());
    Link *const link = *first.result();
    ASSERT_TRUE(second.isFinished()) << "no second port was opened: it would be in use";
    EXPECT_EQ(*second.result(), link);
    EXPECT_EQ(book.all(), std::vector<Link *>{link});
    EXPECT_EQ(toldSince().size(), 3U) << "opened, changed, and the remark";
    EXPECT_EQ(link->settings().background, &background);
    link->close();
    (void)toldSince();
    Task<Link *> again = book.openSoon(address("?rs485=1"));
    again.start();
    background.release();
    clock.advance(std::chrono::milliseconds(1));
    ASSERT_TRUE(again.isFinished());
    EXPECT_EQ(*again.result(), link);
    EXPECT_EQ(toldSince().size(), 3U);
}

} // namespace
} // namespace mb
