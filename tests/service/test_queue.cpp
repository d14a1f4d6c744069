// SPDX-License-Identifier: GPL-3.0-or-later
// Queues of simulated DMC60C in virtual time: one unit, and fifty with trouble of every kind.
#include "queuebench.h"

#include <set>
#include <utility>

namespace mb::service {
namespace {

using namespace std::chrono_literals;
using test::QueueRun;
using test::ServiceBooks;
using test::UnitRack;

TEST_F(ServiceQueues, OneUnitGoesThroughEveryStep)
{
    UnitRack rack({"dmc60c:5,serial=210334000001,firmware=1.23"});
    QueueRun run(rack, *books, load(rack));
    ASSERT_TRUE(run.run());
    const auto visits = books->visits();
    print(visits);
    ASSERT_EQ(visits.size(), 1U);
    const Visit &visit = visits[0];
    EXPECT_EQ(visit.outcome, Outcome::Passed);
    EXPECT_EQ(visit.from, "1.23");
    EXPECT_EQ(visit.to, "1.25");
    EXPECT_EQ(visit.number, 10);
    EXPECT_EQ(visit.device, "sim:can/dmc60c:10");
    EXPECT_EQ(visit.parameters, 2);
    EXPECT_TRUE(visit.snapshot);
    EXPECT_TRUE(visit.trial);
    EXPECT_EQ(visit.test.size(), 5U);
    EXPECT_EQ(run.permit.count, 1);
    EXPECT_EQ(run.queue.counts().passed, 1);
    std::vector<std::string> order;
    double update = 0.0;
    for (std::size_t i = 0; i < visit.steps.size(); ++i) {
        if (visit.steps[i].ended)
            order.emplace_back(toString(visit.steps[i].step));
        if (visit.steps[i].ended && visit.steps[i].step == Step::Firmware)
            update = visit.steps[i].time - visit.steps[i - 1].time;
    }
    EXPECT_EQ(order,
        (std::vector<std::string>{
            "preflight", "backup", "firmware", "parameters", "self-test", "number", "proof", "done"}));
    std::printf("one unit: update %.1f s and %.1f s for the rest\n", update, visit.seconds - update);
    EXPECT_LE(visit.seconds - update, 25.0);
    rack.putOn(std::nullopt); // what was proved is in its flash
    rack.clock.advance(1s);
    rack.putOn(0);
    rack.clock.advance(1s);
    const auto found = test::run(rack.clock, rack.session->scan(*rack.link));
    ASSERT_TRUE(found);
    ASSERT_EQ(found->size(), 1U);
    EXPECT_EQ(found->front()->identity().address, 10);
}

TEST_F(ServiceQueues, TheLastWordOfAStepIsNotSaidOfTheNext)
{
    UnitRack rack({"dmc60c:5,serial=210334000001,firmware=1.23"});
    QueueRun run(rack, *books, load(rack, shortText));
    std::set<std::pair<Step, std::string>> told;
    const Subscription listening = run.queue.changed().add([&] {
        for (const QueueRow &row : run.queue.rows()) {
            if (row.state == RowState::Running && !row.what.empty())
                told.emplace(row.visit.step, row.what.english());
        }
    });
    ASSERT_TRUE(run.run());
    EXPECT_TRUE(told.contains({Step::Parameters, "Written"}));
    EXPECT_FALSE(told.contains({Step::Test, "Written"}));
}

TEST_F(ServiceQueues, AUnitThatIsSwappedDuringItsUpdateIsNeitherSetUpNorTested)
{
    UnitRack rack({"dmc60c:5,serial=210334000001,firmware=1.23,session=0x1111",
        "dmc60c:5,serial=210334000002,firmware=1.23,session=0x2222"});
    const RecipeMatter matter = load(rack, shortText);
    QueueOptions options;
    options.units = 1;
    QueueRun run(rack, *books, matter, options);
    rack.putOn(0);
    run.queue.start();
    const auto isUpdating = [this] {
        const auto visits = books->visits();
        return !visits.empty() && visits.front().step == Step::Firmware;
    };
    ASSERT_TRUE(rack.clock.runUntil(isUpdating, 1min));
    rack.clock.advance(1s);
    rack.putOn(1);
    ASSERT_TRUE(rack.clock.runUntil([&] { return run.isEnded; }, 10min));
    const auto visits = books->visits();
    ASSERT_EQ(visits.size(), 1U);
    EXPECT_EQ(visits[0].outcome, Outcome::Failed) << visits[0].evidence.english();
    EXPECT_EQ(visits[0].step, Step::Firmware) << visits[0].cause.english();
    EXPECT_EQ(run.permit.count, 0) << "its motor must not turn";
}

/// A wire that loses frames while the motor turns, as often as it is asked to.
class LossyTests : public ServiceQueues {
protected:
    /// The visit of one unit whose first tests lose samples.
    Visit serve(int lossyTests, Duration after = {}, const QByteArray &recipe = shortText)
    {
        UnitRack rack({"dmc60c:5,serial=210334000001,firmware=1.23"});
        QueueRun run(rack, *books, load(rack, recipe));
        Bench &bench = *rack.session->bench(*rack.link);
        Timer losing(rack.clock);
        run.permit.asked = [&] {
            bench.setLoss(0.0);
            losing.startIn(after, [&] { bench.setLoss(run.permit.count <= lossyTests ? 0.2 : 0.0); });
        };
        EXPECT_TRUE(run.run());
        asked = run.permit.count;
        const auto visits = books->visits();
        print(visits);
        EXPECT_EQ(visits.size(), 1U);
        return visits.empty() ? Visit() : visits.front();
    }
    int asked = 0;
};

TEST_F(LossyTests, AreDoneAgainEachAnnouncedAndTheJournalSaysSo)
{
    const Visit visit = serve(1);
    EXPECT_EQ(visit.outcome, Outcome::Passed);
    EXPECT_EQ(asked, 2);
    EXPECT_NE(visit.evidence.english().find("at attempt 2: samples were lost before"), std::string::npos)
        << visit.evidence.english();
}

TEST_F(LossyTests, FailTheUnitWhenEveryOneOfThreeLosesSamples)
{
    const Visit visit = serve(3);
    EXPECT_EQ(visit.outcome, Outcome::Failed);
    EXPECT_EQ(visit.step, Step::Test);
    EXPECT_EQ(asked, 3);
    EXPECT_EQ(visit.cause.english().find("the unit was not heard during the self-test"), 0U) << visit.cause.english();
}

TEST_F(LossyTests, AreWhatAUnitFailsByThatHasNoWayLeftForAnother)
{
    const Visit visit = serve(1, 1s, QByteArray(shortText).replace("400000", "7400"));
    EXPECT_EQ(visit.outcome, Outcome::Failed);
    EXPECT_EQ(asked, 2);
    EXPECT_EQ(visit.cause.english().find("the unit was not heard during the self-test"), 0U) << visit.cause.english();
}

TEST_F(ServiceQueues, ADuplicateIsRefusedInItsRowsAndTheRestGoesOn)
{
    UnitRack rack({"dmc60c:5,serial=210334000001,session=0x1111", "dmc60c:5,serial=210334000002,session=0x2222",
        "dmc60c:7,serial=210334000003,product=601", "dmc60c:8,serial=210334000004,state=bootloader"});
    QueueRun run(rack, *books, load(rack, shortText));
    ASSERT_TRUE(run.run());
    print(books->visits());
    EXPECT_EQ(run.queue.counts().refused, 3);
    EXPECT_EQ(run.queue.counts().passed, 1); // also the one that waited in its bootloader
    const auto rows = run.queue.rows();
    ASSERT_EQ(rows.size(), 4U);
    for (const QueueRow &row : rows) {
        if (row.state == RowState::Refused) {
            EXPECT_FALSE(row.visit.cause.empty());
        }
    }
}

TEST_F(ServiceQueues, AUnitThatPassedInTheEndIsNoFailureOfTheRunThatIsGoneOnWith)
{
    UnitRack rack({"dmc60c:7,serial=210334000003,fault=encoder-reversed", "dmc60c:8,serial=210334000004"});
    const RecipeMatter matter = load(rack, shortText);
    QueueOptions options;
    {
        QueueRun run(rack, *books, matter);
        run.queue.start();
        ASSERT_TRUE(rack.clock.runUntil([&] { return run.isEnded; }, 5min));
        ASSERT_EQ(run.queue.counts().failed, 1);
        options.run = run.queue.run();
    }
    const auto visits = books->visits();
    const auto failed = std::find_if(
        visits.begin(), visits.end(), [](const Visit &visit) { return visit.outcome == Outcome::Failed; });
    ASSERT_NE(failed, visits.end());
    const Result<Visit> second = test::run(rack.clock, books->journal->open(*failed)); // as another try would write it
    ASSERT_TRUE(second);
    Visit passed = *second;
    passed.outcome = Outcome::Passed;
    ASSERT_TRUE(test::run(rack.clock, books->journal->write(passed)));
    QueueRun again(rack, *books, matter, options);
    again.queue.start();
    ASSERT_TRUE(rack.clock.runUntil([&] { return again.isEnded; }, 5min));
    EXPECT_EQ(again.queue.counts().failed, 0);
    EXPECT_EQ(again.queue.counts().passed, 2);
}

/// Puts units on one after the other, as a person does: the next when a unit has ended.
class Operator {
public:
    Operator(UnitRack &rack, std::vector<std::vector<std::size_t>> turns, ServiceQueue &queue)
        : m_rack(rack)
        , m_turns(std::move(turns))
        , m_timer(rack.clock)
        , m_ended(queue.unitEnded().add([this](const Visit &) {
            if (++m_endedNow >= m_current.size()) // the other one of two that were put on together may follow
                m_timer.startIn(200ms, [this] { next(); });
        }))
    {
        next();
    }

private:
    void next()
    {
        m_endedNow = 0;
        for (const std::size_t place : m_current)
            m_rack.unit(place).setPowered(false);
        if (m_at >= m_turns.size())
            return;
        m_current = m_turns[m_at++];
        for (const std::size_t place : m_current)
            m_rack.unit(place).setPowered(true);
    }
    UnitRack &m_rack;
    std::vector<std::vector<std::size_t>> m_turns;
    Timer m_timer;
    Subscription m_ended;
    std::vector<std::size_t> m_current;
    std::size_t m_at = 0;
    std::size_t m_endedNow = 0;
};

/// Trouble of every kind, by the place of the unit.
std::string troubleOf(int place)
{
    switch (place) {
    case 3: return ",fault=power-page@18";
    case 7: return ",product=601";
    case 11: return ",fault=encoder-dead@0";
    case 15: return ",fault=encoder-reversed";
    case 19: return ",motor=n20,load=5"; // self-test out of limits
    case 23: return ",state=bootloader";
    case 27: return ",session=0x7001"; // put on together with the next, under one number
    case 28: return ",session=0x7002";
    case 31: return ",fault=drop@40,fault=drop@90,fault=corrupt@140";
    case 35: return ",fault=silent@900";
    case 39: return ",fault=stall@0";
    case 43: return ",fault=delay@60:120";
    default: return {};
    }
}

TEST_F(ServiceQueues, FiftyUnitsOneAfterTheOtherTwelveOfThemInTrouble)
{
    std::vector<std::string> units;
    std::vector<std::string> names;
    std::vector<std::vector<std::size_t>> turns;
    for (int i = 0; i < 50; ++i) {
        char serial[16];
        std::snprintf(serial, sizeof serial, "2103340%05d", i);
        names.emplace_back(serial);
        units.push_back("dmc60c:5,serial=" + std::string(serial) + ",firmware=1.23" + troubleOf(i));
        if (i == 28)
            turns.back().push_back(28);
        else
            turns.push_back({static_cast<std::size_t>(i)});
    }
    UnitRack rack(units);
    rack.putOn(std::nullopt);
    const RecipeMatter matter = load(rack);
    QueueOptions options;
    options.units = 50;
    QueueRun run(rack, *books, matter, options);
    const Operator anna(rack, turns, run.queue);
    ASSERT_TRUE(run.run(2h));
    const auto visits = books->visits();
    print(visits);
    const QueueCounts counts = run.queue.counts();
    std::printf("fifty units: %d passed, %d failed, %d refused in %.0f s\n", counts.passed, counts.failed,
        counts.refused, std::chrono::duration<double>(rack.clock.now().time_since_epoch()).count());
    EXPECT_EQ(counts.passed, 42);
    EXPECT_EQ(counts.failed, 5);
    EXPECT_EQ(counts.refused, 3);
    ASSERT_EQ(visits.size(), 50U);
    std::set<std::string> serials;
    std::set<int> numbers;
    for (const Visit &visit : visits) {
        EXPECT_NE(visit.outcome, Outcome::Open);
        serials.insert(visit.serial);
        if (visit.number) {
            EXPECT_TRUE(numbers.insert(*visit.number).second) << *visit.number;
        }
        if (visit.outcome != Outcome::Passed) {
            EXPECT_FALSE(visit.cause.empty()) << visit.serial;
            EXPECT_FALSE(visit.number) << visit.serial;
        }
    }
    EXPECT_EQ(serials.size(), 50U);
    ASSERT_EQ(numbers.size(), 42U);
    EXPECT_EQ(*numbers.begin(), 10);
    EXPECT_EQ(*numbers.rbegin(), 51);
    int reached = 0;
    for (std::size_t i = 0; i < units.size(); ++i) { // every unit can be reached afterwards
        rack.putOn(std::nullopt);
        rack.clock.advance(1s);
        rack.unit(i).setPowered(true);
        rack.clock.advance(1s);
        const auto found = test::run(rack.clock, rack.session->scan(*rack.link));
        reached += found && found->size() == 1 && found->front()->identity().serial == names[i] ? 1 : 0;
    }
    EXPECT_EQ(reached, 49) << "all but the one that falls silent after so many frames by itself";
}

} // namespace
} // namespace mb::service
