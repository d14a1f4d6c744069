// SPDX-License-Identifier: GPL-3.0-or-later
// Updates of units that are served: cables, cancels, deaths and pauses in the middle of them. Virtual time.
#include "servedbench.h"

#include <QFile>

#include <algorithm>

namespace mb {
namespace {

using namespace std::chrono_literals;
using test::Served;

/// The firmware of the bench, over all three units that take it.
class Updated : public Served {
protected:
    [[nodiscard]] std::shared_ptr<const service::RecipeMatter> update()
    {
        service::Recipe recipe;
        recipe.name = "demo";
        recipe.family = &device(7)->family();
        recipe.firmware = service::FirmwareRule{inSourceTree("resources/firmware/dmc60c-demo.hex"), {}};
        auto matter = service::gatherMatter(std::move(recipe), folder.path().toStdString());
        EXPECT_TRUE(matter) << (matter ? "" : matter.error().text());
        return matter ? std::make_shared<const service::RecipeMatter>(std::move(*matter)) : nullptr;
    }
    [[nodiscard]] std::vector<DeviceId> units()
    {
        return {core->session().idOf(*device(5)), core->session().idOf(*device(7)), core->session().idOf(*device(9))};
    }
    [[nodiscard]] service::QueueRow row(int address)
    {
        const Device *unit = device(address);
        for (const service::QueueRow &row : view().rows) {
            if (unit && row.device == core->session().idOf(*unit))
                return row;
        }
        return {};
    }
    [[nodiscard]] Simulator *simulated(int address)
    {
        for (const Link *link : core->session().links()) {
            for (Simulator *unit : core->session().bench(*link)->simulators()) {
                if (unit->name() == "dmc60c:" + std::to_string(address))
                    return unit;
            }
        }
        return nullptr;
    }
    /// Pages of the unit of this number are being written.
    [[nodiscard]] bool writes(int address)
    {
        return clock.runUntil(
            [this, address] {
                const service::QueueRow now = row(address);
                return now.state == service::RowState::Running && now.mayInterrupt && now.done > 5 && now.total > 20;
            },
            5min);
    }
    void expectAllEnded()
    {
        ASSERT_TRUE(clock.runUntil([this] { return !view().running; }, 20min));
    }
};

TEST_F(Updated, ACableThatComesOutInTheMiddleFailsItsRowAndTheRestGoesOn)
{
    ASSERT_TRUE(serve({update(), {"sim:can"}, std::nullopt, units()}));
    ASSERT_TRUE(writes(5));
    simulated(5)->setPowered(false);
    expectAllEnded();
    const service::QueueRow failed = row(5);
    EXPECT_EQ(failed.state, service::RowState::Failed);
    EXPECT_FALSE(failed.visit.cause.empty());
    ASSERT_TRUE(failed.log);
    EXPECT_FALSE(failed.log->empty());
    EXPECT_EQ(row(7).state, service::RowState::Passed);
    EXPECT_EQ(row(9).state, service::RowState::Passed) << row(9).visit.cause.english();
    EXPECT_EQ(view().counts.failed, 1);
    simulated(5)->setPowered(true);
    clock.advance(2s);
    core->send(orders::RetryFailedUnits{});
    EXPECT_TRUE(view().running);
    expectAllEnded();
    EXPECT_EQ(view().counts.passed, 3) << row(5).visit.cause.english();
    EXPECT_EQ(device(5)->identity().firmware, "1.25");
}

TEST_F(Updated, CancelEndsWhereNothingMustNotBeCutAndTheRunGoesOnFromTheJournal)
{
    ASSERT_TRUE(serve({update(), {"sim:can"}, std::nullopt, units()}));
    ASSERT_TRUE(writes(5));
    const std::string run = view().run;
    core->send(orders::CancelService{});
    ASSERT_TRUE(clock.runUntil([this] { return !view().running; }, 1min));
    EXPECT_EQ(view().counts.ended(), 0);
    service::VisitFilter filter;
    filter.run = run;
    auto visits = journal->list(filter);
    ASSERT_TRUE(visits);
    ASSERT_EQ(visits->size(), 1U);
    EXPECT_EQ(visits->front().outcome, service::Outcome::Open);
    ASSERT_TRUE(serve({update(), {"sim:can"}, std::nullopt, std::vector<DeviceId>(), run}));
    expectAllEnded();
    EXPECT_EQ(view().counts.passed, 1) << "what was cut off only";
    EXPECT_EQ(journal->list(filter)->size(), 1U) << "no visit twice";
    ASSERT_TRUE(serve({update(), {"sim:can"}, std::nullopt, units(), run}));
    expectAllEnded();
    EXPECT_EQ(view().counts.passed, 3);
    EXPECT_EQ(journal->list(filter)->size(), 3U);
}

TEST_F(Updated, AProgramThatDiesInTheMiddleGoesOnFromTheJournal)
{
    ASSERT_TRUE(serve({update(), {"sim:can"}, std::nullopt, units()}));
    ASSERT_TRUE(clock.runUntil([this] { return view().counts.passed == 1; }, 5min));
    clock.advance(2s);
    const std::string run = view().run;
    core->service().setBooks({}, "bench 1"); // nothing is said to anybody
    clock.advance(5s);
    core->service().setBooks({journal.get(), settings.get(), trials.get()}, "bench 1");
    ASSERT_TRUE(serve({update(), {"sim:can"}, std::nullopt, units(), run}));
    expectAllEnded();
    EXPECT_EQ(view().counts.passed, 3);
    service::VisitFilter filter;
    filter.run = run;
    EXPECT_EQ(journal->list(filter)->size(), 3U);
    for (const int address : {5, 7, 9})
        EXPECT_EQ(device(address)->identity().firmware, "1.25") << address;
}

TEST_F(Updated, PausedAfterThisUnitNothingBeginsUntilItGoesOn)
{
    ASSERT_TRUE(serve({update(), {"sim:can"}, std::nullopt, units()}));
    ASSERT_TRUE(writes(5));
    core->send(orders::PauseService{true});
    ASSERT_TRUE(clock.runUntil([this] { return view().counts.ended() == 1; }, 5min));
    clock.advance(1min);
    EXPECT_EQ(view().counts.ended(), 1);
    EXPECT_TRUE(view().running && view().pausing);
    core->send(orders::SkipUnit{row(7).id});
    core->send(orders::PauseService{false});
    expectAllEnded();
    EXPECT_EQ(row(7).state, service::RowState::Skipped);
    EXPECT_EQ(view().counts.passed, 2);
    EXPECT_FALSE(core->service().mustStayAwake()) << "simulated units end with the program";
}

} // namespace
} // namespace mb
