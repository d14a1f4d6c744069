// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/virtualclock.h"
#include "model/family.h"
#include "model/registry.h"
#include "model/unit.h"
#include "storage/reportmatter.h"
#include "storage/settingsbook.h"
#include "storage/visittable.h"
#include "support/coreapplication.h"
#include "support/simulatedsession.h"

#include <gtest/gtest.h>

#include <QTemporaryDir>

#include <set>

namespace mb {
namespace {

using tuning::Trial;

/// A notebook of unit 7: a push, a step, a tuning of the velocity loop of both, two steps after it; and one of unit 5.
class Reports : public testing::Test {
protected:
    Reports()
    {
        test::needCoreApplication();
        database = std::move(*Database::open(folder.path().toStdString() + "/motorbench.db"));
        book = std::make_unique<TrialBook>(*database, clock);
        keep("7", Mode::Duty);
        keep("7", Mode::Velocity);
        tuning::TuneReport tuned;
        tuned.device = "sim:can/dmc60c:7";
        tuned.unit = "simulated dmc60c SN7";
        tuned.trials = {1, 2};
        Trial proof;
        proof.number = 2;
        tuned.proof = {proof};
        EXPECT_TRUE(test::run(clock, book->keepTuning(tuned)));
        keep("7", Mode::Velocity);
        keep("7", Mode::Velocity);
        keep("5", Mode::Position);
    }
    void keep(const std::string &address, Mode mode, const tuning::Stimulus &stimulus = {})
    {
        Trial trial;
        trial.stimulus = stimulus;
        trial.device = "sim:can/dmc60c:" + address;
        trial.unit = "simulated dmc60c SN" + address;
        trial.firmware = "1.23";
        trial.simulated = true;
        trial.mode = mode;
        trial.reason = tuning::EndReason::Done;
        tuning::Trace trace;
        trace.add(0.0, 1.0);
        trial.signals = {{"velocity", "counts/s", trace}};
        const auto number = test::run(clock, book->begin(trial));
        EXPECT_TRUE(test::run(clock, book->complete(number.value_or(0), trial)));
    }
    [[nodiscard]] std::vector<ReportUnit> of(const ReportWish &wish)
    {
        auto units = reportUnits(*book, families(), wish);
        EXPECT_TRUE(units) << (units ? "" : units.error().text());
        return units ? std::move(*units) : std::vector<ReportUnit>();
    }
    [[nodiscard]] static std::vector<std::int64_t> numbersOf(const std::vector<KeptTrial> &trials)
    {
        std::vector<std::int64_t> numbers;
        for (const KeptTrial &kept : trials)
            numbers.push_back(kept.number);
        return numbers;
    }

    QTemporaryDir folder;
    VirtualClock clock;
    std::unique_ptr<Database> database;
    std::unique_ptr<TrialBook> book;
};

TEST_F(Reports, TrialsOfTwoUnitsGiveTwoUnitsWithTheirHistories)
{
    const auto units = of({{3, 5}, {}, false});
    ASSERT_EQ(units.size(), 2U);
    EXPECT_EQ(numbersOf(units[0].trials), (std::vector<std::int64_t>{3}));
    EXPECT_EQ(units[0].trials[0].trial.signals.size(), 1U);
    EXPECT_TRUE(units[0].tunings.empty());
    EXPECT_EQ(numbersOf(units[0].history), (std::vector<std::int64_t>{1, 2, 3, 4}));
    EXPECT_EQ(units[0].identity.serial, "SN7");
    EXPECT_EQ(units[0].identity.address, 7);
    EXPECT_EQ(units[0].identity.firmware, "1.23");
    ASSERT_NE(units[0].family, nullptr);
    EXPECT_EQ(units[0].family->key, "dmc60c");
    EXPECT_TRUE(units[0].simulated);
    EXPECT_EQ(numbersOf(units[1].history), (std::vector<std::int64_t>{5}));
}

TEST_F(Reports, ATrialOfATuningBringsTheTuningWithTheSignalsOfItsProof)
{
    for (const bool tuningsOnly : {false, true}) {
        const auto units = of({{2}, {}, tuningsOnly});
        ASSERT_EQ(units.size(), 1U);
        EXPECT_EQ(units[0].trials.size(), tuningsOnly ? 0U : 1U);
        ASSERT_EQ(units[0].tunings.size(), 1U);
        ASSERT_EQ(units[0].tunings[0].report.proof.size(), 1U);
        EXPECT_EQ(units[0].tunings[0].report.proof[0].signals.size(), 1U);
    }
}

TEST_F(Reports, ATuningIsReportedThoughATrialOfItWasForgotten)
{
    ASSERT_TRUE(book->remove(2));
    const auto units = of({{1, 2}, "simulated dmc60c SN7", true});
    ASSERT_EQ(units.size(), 1U);
    ASSERT_EQ(units[0].tunings.size(), 1U);
    EXPECT_TRUE(units[0].tunings[0].report.proof.empty());
    EXPECT_EQ(numbersOf(units[0].history), (std::vector<std::int64_t>{1, 3, 4}));
}

TEST_F(Reports, TheNewestSinesOfAUnitAreItsFrequencyResponse)
{
    const auto sine
        = [](double hertz) { return *tuning::Stimulus::make(tuning::Profile::Sine, 0.1, 0.3, 6.0 / hertz, 0.001); };
    for (const double hertz : {0.5, 1.0, 2.0, 0.6, 1.2}) // one sweep, and a newer one
        keep("9", Mode::Duty, sine(hertz));
    keep("9", Mode::Velocity);
    const auto units = of({{}, "simulated dmc60c SN9", false});
    ASSERT_EQ(units.size(), 1U);
    ASSERT_EQ(units[0].sines.size(), 2U);
    EXPECT_NEAR(units[0].sines[0].trial.stimulus.period, 1.0 / 0.6, 1e-6);
    EXPECT_NEAR(units[0].sines[1].trial.stimulus.period, 1.0 / 1.2, 1e-6);
    EXPECT_EQ(units[0].sines[1].trial.signals.size(), 1U);
    EXPECT_EQ(units[0].trials.size(), 1U) << "a sine is no step of a loop";
}

TEST_F(Reports, OfAUnitTheNewestTrialOfEachLoopStandsBesideItsTunings)
{
    const auto units = of({{}, "simulated dmc60c SN7", false});
    ASSERT_EQ(units.size(), 1U);
    EXPECT_EQ(units[0].tunings.size(), 1U);
    EXPECT_EQ(numbersOf(units[0].trials), (std::vector<std::int64_t>{4}));
    EXPECT_EQ(units[0].history.size(), 4U);
    EXPECT_TRUE(of({{}, "nobody", false}).front().history.empty());
}

TEST_F(Reports, AUnitWithoutASerialNumberHasTheServicesOfItsPlaceAndOfNoOtherUnitThere)
{
    const auto serve = [this](const std::string &id, std::optional<int> number, const std::string &unit) {
        service::Visit visit;
        visit.id = id;
        visit.unit = unit;
        visit.number = number;
        EXPECT_TRUE(putVisits(*database, {{visit, 1}}));
    };
    const std::string fresh = "simulated place sim:serial supermodified:4"; // where they stand when they come
    serve("moved to 10", 10, fresh);
    serve("the next one there", 11, fresh);
    serve("has its number", std::nullopt, "simulated place sim:serial supermodified:10");
    serve("on another line", 10, "simulated place sim:serial2 supermodified:4");
    serve("has a serial number", 10, "simulated supermodified SN10");
    const auto units = of({{}, "simulated place sim:serial supermodified:10", false});
    ASSERT_EQ(units.size(), 1U);
    std::set<std::string> ids;
    for (const service::Visit &visit : units[0].visits)
        ids.insert(visit.id);
    EXPECT_EQ(ids, (std::set<std::string>{"has its number", "moved to 10"}));
}

TEST_F(Reports, OfOneServiceOfManyTheReportEndsWithItAndThatOfAPlaceHasNoOther)
{
    const auto idsOf = [this](const std::string &unit, const std::string &visit) {
        std::vector<std::string> ids;
        for (const ReportUnit &one : of({{}, unit, false, visit})) {
            for (const service::Visit &served : one.visits)
                ids.push_back(served.id);
        }
        return ids;
    };
    const std::string place = "simulated place sim:serial supermodified:4";
    for (const auto &[id, unit] :
        {std::pair("march", "simulated dmc60c SN7"), std::pair("june", "simulated dmc60c SN7"),
            std::pair("first there", place.c_str()), std::pair("second there", place.c_str())}) {
        service::Visit visit;
        visit.id = id;
        visit.unit = unit;
        visit.number = 10; // from its next power cycle on
        visit.time = std::chrono::duration<double>(clock.now().time_since_epoch()).count();
        EXPECT_TRUE(putVisits(*database, {{visit, 1}}));
        clock.advance(std::chrono::minutes(1));
    }
    using Ids = std::vector<std::string>;
    EXPECT_EQ(idsOf("simulated dmc60c SN7", "march"), Ids{"march"});
    EXPECT_EQ(idsOf("simulated dmc60c SN7", "june"), (Ids{"march", "june"}));
    EXPECT_EQ(idsOf("simulated dmc60c SN7", ""), (Ids{"march", "june"}));
    EXPECT_EQ(idsOf(place, "first there"), Ids{"first there"});
    EXPECT_EQ(idsOf(place, "second there"), Ids{"second there"});
}

TEST_F(Reports, AUnitWithATagIsFoundByItsPlaceWithItsTrialsAndServices)
{
    const std::string place = "simulated place sim:serial supermodified:4";
    ASSERT_TRUE(SettingsBook(*database, clock, "somebody").setTag(place, "arm A"));
    Trial trial;
    trial.device = "sim:serial/supermodified:4";
    trial.unit = place;
    ASSERT_TRUE(test::run(clock, book->begin(trial)));
    service::Visit visit;
    visit.id = "served";
    visit.unit = place;
    ASSERT_TRUE(putVisits(*database, {{visit, 1}}));
    for (const ReportWish &wish : {ReportWish{{6, 3}, place}, ReportWish{{}, place}, ReportWish{{6}, {}}}) {
        const auto units = of(wish);
        ASSERT_EQ(units.size(), 1U) << "trial 3 is of another unit";
        EXPECT_EQ(units[0].unit, taggedUnitKey(place, "arm A"));
        EXPECT_EQ(numbersOf(units[0].history), (std::vector<std::int64_t>{6}));
        EXPECT_EQ(units[0].trials.size(), wish.trials.empty() ? 0U : 1U) << "it was cut off";
        EXPECT_EQ(units[0].visits.size(), 1U);
    }
}

TEST_F(Reports, ANumberThatIsNotThereIsSaidSo)
{
    const auto units = reportUnits(*book, families(), {{3, 99}, {}, false});
    ASSERT_FALSE(units);
    EXPECT_NE(units.error().text().find("there is no trial 99"), std::string::npos);
}

} // namespace
} // namespace mb
