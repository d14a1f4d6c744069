// SPDX-License-Identifier: GPL-3.0-or-later
// What of one unit concerns more than that unit, as the journal has it.
#include "model/unit.h"
#include "servicebench.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace mb::service {
namespace {

using namespace std::chrono_literals;
using test::QueueRun;
using test::ServiceBooks;
using test::UnitRack;

class Endings : public testing::Test {
protected:
    RecipeMatter load(UnitRack &rack, const QByteArray &text)
    {
        books.emplace(rack.clock);
        books->write("recipe.json", text);
        books->write("base_c.json", R"({"family":"dmc60c","parameters":{"slot1.d":{"raw":77}}})");
        auto matter = loadRecipe(books->path("recipe.json"), rack.list());
        EXPECT_TRUE(matter) << (matter ? "" : matter.error().text());
        return matter ? *matter : RecipeMatter{};
    }
    std::optional<ServiceBooks> books;
};

TEST_F(Endings, AStopThatNobodyHasSeenIsWrittenDownAsSuch)
{
    UnitRack rack({"dmc60c:5,serial=210334000001"});
    QueueRun run(rack, *books, load(rack, R"({"recipe":1,"name":"turn","family":"dmc60c",
"test":{"loop":"velocity","to":8000,"time":0.8,
"limits":{"travel":400000,"speed":40000,"duty":0.9,"current":60},"accept":{"settle":0.9}}})"));
    Timer cut(rack.clock);
    run.permit.asked = [&] { cut.startIn(500ms, [&rack] { rack.putOn(std::nullopt); }); };
    ASSERT_TRUE(run.run());
    const auto visits = books->visits();
    ASSERT_EQ(visits.size(), 1U);
    EXPECT_EQ(visits[0].outcome, Outcome::Failed);
    EXPECT_EQ(visits[0].step, Step::Test);
    EXPECT_EQ(visits[0].ending, Ending::StopUnconfirmed) << visits[0].cause.english();
}

TEST_F(Endings, ASelfTestThatIsHeldTooBrieflyIsToldFromAMotorThatIsSlow)
{
    for (const char *const accept : {"rise", "settle", "overshoot"}) {
        UnitRack rack({"dmc60c:5,serial=210334000001"});
        QueueRun run(rack, *books,
            load(rack,
                QByteArray(R"({"recipe":1,"name":"turn","family":"dmc60c",
"test":{"loop":"velocity","to":8000,"time":0.3,
"limits":{"travel":400000,"speed":40000,"duty":0.9,"current":60},"accept":{")")
                    + accept + R"(":0.9}}})"));
        ASSERT_TRUE(run.run());
        const auto visits = books->visits();
        ASSERT_EQ(visits.size(), 1U);
        EXPECT_EQ(visits[0].outcome, Outcome::Failed);
        EXPECT_TRUE(visits[0].cause.english().starts_with("it came to ")) << visits[0].cause.english();
        EXPECT_TRUE(visits[0].remedy.english().find("its time is enough") != std::string::npos)
            << visits[0].remedy.english();
    }
}

const QByteArray turnWithBase = R"({"recipe":1,"name":"turn","family":"dmc60c",
"parameters":{"file":"base_c.json"},"test":{"loop":"velocity","to":8000,"time":0.8,
"limits":{"travel":400000,"speed":40000,"duty":0.9,"current":60},"accept":{"settle":0.9}}})";

/// Pushes come before its step, and each of them counts its travel from the same place.
TEST_F(Endings, ASelfTestThatIdentifiesItsMotorStaysWithinTheTravelThatWasShown)
{
    UnitRack rack({"dmc60c:5,serial=210334000001"});
    QueueRun run(rack, *books, load(rack, R"({"recipe":1,"name":"turn","family":"dmc60c",
"test":{"loop":"velocity","to":8000,"time":0.8,"limits":{"travel":22000,"speed":200000,"duty":0.9,"current":60},
"accept":{"gain":1e8,"settle":0.9}}})"));
    const double start = rack.unit(0).position();
    double farthest = 0.0;
    Timer looking(rack.clock);
    const std::function<void()> look = [&] {
        farthest = std::max(farthest, std::abs(rack.unit(0).position() - start));
        looking.startIn(5ms, look);
    };
    look();
    ASSERT_TRUE(run.run());
    const auto visits = books->visits();
    ASSERT_EQ(visits.size(), 1U);
    EXPECT_EQ(visits[0].outcome, Outcome::Passed) << visits[0].cause.english();
    EXPECT_GT(farthest, 10'000.0);
    EXPECT_LE(farthest, 22'000.0);
}

TEST_F(Endings, ASelfTestThatIdentifiesItsMotorPushesNoHarderThanItsUnitAllows)
{
    UnitRack rack({"dmc60c:5,serial=210334000001"});
    rack.putOn(0);
    const auto found = test::run(rack.clock, rack.session->scan(*rack.link));
    ASSERT_TRUE(found && found->size() == 1U);
    const auto limit = findParameter(rack.family->parameters, "slot0.max_forward");
    ASSERT_TRUE(test::run(rack.clock, found->front()->write(*limit, 3276))); // 10 %
    QueueRun run(rack, *books, load(rack, R"({"recipe":1,"name":"turn","family":"dmc60c",
"test":{"loop":"velocity","to":8000,"time":0.8,"limits":{"travel":400000,"speed":200000,"current":60},
"accept":{"gain":1e8,"friction":1.2,"encoder":true}}})"));
    ASSERT_TRUE(run.run());
    const auto visits = books->visits();
    ASSERT_EQ(visits.size(), 1U);
    EXPECT_EQ(visits[0].outcome, Outcome::Passed) << visits[0].cause.english();
}

/// Somebody else, at the same unit: its first setting, and what keeps that from stopping the motor.
Task<void> moveSwitch(Device &device)
{
    for (const ParameterIndex place : {ParameterIndex{1}, ParameterIndex{0}}) {
        (void)co_await device.write(place, 1 - device.parameters().entry(place).raw.value_or(0));
    }
    co_return {};
}

TEST_F(Endings, WhatElseHasChangedMeanwhileIsCountedFromTheFirstSettingOn)
{
    UnitRack rack({"dmc60c:5,serial=210334000001"});
    QueueRun run(rack, *books, load(rack, turnWithBase));
    std::optional<Task<void>> other;
    run.permit.asked = [&] {
        other.emplace(moveSwitch(*rack.session->devices().front()));
        other->start();
    };
    ASSERT_TRUE(run.run());
    ASSERT_TRUE(other && other->isFinished() && other->result());
    const auto visits = books->visits();
    ASSERT_EQ(visits.size(), 1U);
    EXPECT_EQ(visits[0].outcome, Outcome::Passed) << visits[0].cause.english();
    std::string told = visits[0].evidence.english();
    for (const StepEntry &step : visits[0].steps)
        told += '\n' + step.detail.english();
    EXPECT_NE(told.find("2 settings besides those of the recipe differ from the backup"), std::string::npos) << told;
}

TEST_F(Endings, AUnitWhoseRecipeSomebodyChangedMeanwhileHasFailed)
{
    UnitRack rack({"dmc60c:5,serial=210334000001"});
    QueueRun run(rack, *books, load(rack, turnWithBase));
    std::optional<Task<std::int64_t>> other;
    run.permit.asked = [&] {
        Device &unit = *rack.session->devices().front();
        other.emplace(unit.write(*findParameter(unit.family().parameters, "slot1.d"), 78));
        other->start();
    };
    ASSERT_TRUE(run.run());
    ASSERT_TRUE(other && other->isFinished() && other->result());
    const auto visits = books->visits();
    ASSERT_EQ(visits.size(), 1U);
    EXPECT_EQ(visits[0].outcome, Outcome::Failed);
    EXPECT_EQ(visits[0].step, Step::Proof);
    EXPECT_EQ(visits[0].cause.english(), "1 setting of the recipe read back different, first slot1.d");
}

TEST_F(Endings, AUnitOnWhichAnExperimentLeftItsGainsIsRefusedAndNothingOfItIsKept)
{
    UnitRack rack({"dmc60c:5,serial=210334000001"});
    QueueRun run(rack, *books, load(rack, R"({"recipe":1,"name":"look","family":"dmc60c","number":{"first":10}})"));
    rack.putOn(0);
    const auto found = test::run(rack.clock, rack.session->scan(*rack.link));
    ASSERT_TRUE(found && found->size() == 1);
    Device *const unit = found->front();
    tuning::Trial trial;
    trial.device = unit->selector();
    trial.unit = unitKeyOf(*unit);
    const auto number = test::run(rack.clock, books->trials->begin(trial));
    ASSERT_TRUE(number);
    const ParameterIndex gain = *findParameter(unit->family().parameters, "slot0.p");
    const auto tried = test::run(rack.clock, unit->read(gain));
    ASSERT_TRUE(tried);
    ASSERT_TRUE(test::run(rack.clock, books->trials->owe(*number, trial.unit, {{"slot0.p", *tried + 7, *tried}})));
    books->trials->abandon(*number);
    ASSERT_TRUE(run.run());
    const auto visits = books->visits();
    ASSERT_EQ(visits.size(), 1U);
    EXPECT_EQ(visits[0].outcome, Outcome::Refused);
    EXPECT_NE(visits[0].cause.english().find("did not put back what it changed"), std::string::npos);
    EXPECT_NE(visits[0].remedy.english().find("slot0.p="), std::string::npos);
    EXPECT_FALSE(visits[0].snapshot);
}

TEST_F(Endings, NoUnitIsBegunAfterTheLastNumber)
{
    UnitRack rack({"dmc60c:5,serial=210334000001", "dmc60c:6,serial=210334000002", "dmc60c:7,serial=210334000003"});
    QueueRun run(rack, *books, load(rack, R"({"recipe":1,"name":"full","family":"dmc60c",
"parameters":{"file":"base_c.json"},"number":{"first":63}})"));
    ASSERT_TRUE(run.run());
    const auto visits = books->visits();
    ASSERT_EQ(visits.size(), 2U) << "the third has not begun";
    EXPECT_EQ(visits[0].ending, Ending::None) << visits[0].cause.english();
    EXPECT_EQ(visits[0].number, 63);
    EXPECT_EQ(visits[1].outcome, Outcome::Failed);
    EXPECT_EQ(visits[1].step, Step::Number);
    EXPECT_EQ(visits[1].ending, Ending::NumbersUsedUp) << visits[1].cause.english();
    ASSERT_TRUE(run.queue.trouble());
    EXPECT_EQ(run.queue.trouble()->detail, "all numbers are used up, the highest is 63");
}

TEST_F(Endings, NoUnitIsBegunAfterAsManyAsWereAskedFor)
{
    for (const int wanted : {1, 2, 0}) { // 0: as many as there are
        UnitRack rack({"dmc60c:5,serial=210334000001", "dmc60c:6,serial=210334000002", "dmc60c:7,serial=210334000003"});
        const auto matter
            = load(rack, R"({"recipe":1,"name":"some","family":"dmc60c","parameters":{"file":"base_c.json"}})");
        QueueOptions options;
        options.units = wanted;
        QueueRun run(rack, *books, matter, options);
        (void)run.run(2min);
        EXPECT_EQ(books->visits().size(), wanted == 0 ? 3U : static_cast<std::size_t>(wanted));
    }
}

} // namespace
} // namespace mb::service
