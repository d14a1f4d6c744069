// SPDX-License-Identifier: GPL-3.0-or-later
// Where the journal of service is kept, as it is ordered: checked before anything changes, and told to whoever keeps it.
#include "app/engine/enginecore.h"
#include "async/virtualclock.h"
#include "heard.h"
#include "model/registry.h"

#include <gtest/gtest.h>

namespace mb {
namespace {

class JournalOrders : public testing::Test {
protected:
    JournalOrders()
    {
        core.service().setBooks({}, "computer 7");
        chosen = core.service().journalChosen().add([this](const JournalPlace &place, const orders::KeepJournal &) {
            stations.push_back(place.station);
            shared.push_back(place.server.has_value());
        });
    }
    [[nodiscard]] Result<void> keep(const std::string &server, const std::string &station)
    {
        test::Heard<> kept;
        core.send(orders::KeepJournal{server, station}, kept.finished());
        EXPECT_TRUE(kept.has_value());
        return kept ? *kept : fail(Fault::Timeout);
    }

    VirtualClock clock;
    EngineCore core{clock, families(), false};
    std::vector<std::string> stations;
    std::vector<bool> shared;
    Subscription chosen;
};

TEST_F(JournalOrders, AStationThatNobodyNamedHasTheNameOfItsComputer)
{
    ASSERT_TRUE(keep("", "bench 2"));
    ASSERT_TRUE(keep("", ""));
    EXPECT_EQ(stations, (std::vector<std::string>{"bench 2", "computer 7"}));
    EXPECT_EQ(shared, (std::vector<bool>{false, false}));
}

TEST_F(JournalOrders, AServerThatIsNoneIsRefusedAndNothingMoves)
{
    const auto kept = keep("ftp://bench-db", "bench 2");
    ASSERT_FALSE(kept);
    EXPECT_EQ(kept.error().fault, Fault::Usage);
    EXPECT_TRUE(stations.empty());
    ASSERT_TRUE(keep("postgresql://anna@bench-db/journal", "bench 2"));
    EXPECT_EQ(shared, std::vector<bool>{true});
}

TEST_F(JournalOrders, WithoutAJournalNothingIsServed)
{
    test::Heard<> begun;
    core.send(orders::ServeUnits{std::make_shared<const service::RecipeMatter>(), {"sim:can"}}, begun.finished());
    ASSERT_TRUE(begun.has_value());
    ASSERT_FALSE(*begun);
    EXPECT_EQ(begun->error().fault, Fault::Unsupported);
    EXPECT_FALSE(core.service().view().running);
}

} // namespace
} // namespace mb
