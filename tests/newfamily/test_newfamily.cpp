// SPDX-License-Identifier: GPL-3.0-or-later
// A made-up family is taken through the whole program, and nothing outside its folder knows it: scan, parameters, drive, telemetry,
// update, rows of the window, translation. The contract of every family (test_contract.cpp) runs over it in this same program.
// docs/adding-a-family.md tells this file.
#include "experiment/experiment.h"
#include "model/loopparameters.h"
#include "model/parametertransfer.h"
#include "model/snapshot.h"
#include "model/unknownframes.h"
#include "support/fakejournal.h"
#include "support/fakeworkbench.h"
#include "support/simulatedsession.h"
#include "tuning/adviser.h"
#include "tuning/evidence.h"
#include "tuning/gainscale.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/updates.h"
#include "widgets/connection/devicemodel.h"
#include "widgets/connection/linkchoices.h"
#include "widgets/control/gainunits.h"
#include "widgets/control/trialmodel.h"
#include "widgets/firmware/drawingview.h"
#include "widgets/firmware/firmwarepage.h"
#include "widgets/firmware/unitupdate.h"
#include "widgets/parameters/parametermodel.h"
#include "widgets/parameters/valuetext.h"
#include "widgets/start/story.h"

#include <QApplication>
#include <QSvgRenderer>
#include <QTemporaryDir>
#include <QTranslator>

#include <gtest/gtest.h>

namespace mb {
namespace {

using namespace std::chrono_literals;
using test::run;
using test::SimulatedSession;

class NewFamily : public testing::Test {
protected:
    void SetUp() override
    {
        bench.scan();
        unit = bench.device(3, "tinker");
        ASSERT_NE(unit, nullptr);
        bench.clock.advance(200ms);
    }
    [[nodiscard]] Simulator &simulated() { return *bench.simulator("tinker:3"); }
    /// The window's side, as the engine publishes it.
    void publish()
    {
        workbench.shot.links = {viewOf(*bench.link, bench.clock)};
        workbench.shot.devices = {viewOf(bench.session, *unit)};
        workbench.time = bench.clock.now();
        workbench.publish();
    }
    void moveTo(double counts)
    {
        SetPoint setPoint;
        setPoint.mode = Mode::Position;
        setPoint.target = counts;
        ASSERT_TRUE(bench.session.stream(*unit).start(setPoint, 10s));
    }
    SimulatedSession bench;
    Device *unit = nullptr;
    test::FakeWorkbench workbench;
};

TEST_F(NewFamily, IsTheOnlyOneOfThisRegistry)
{
    ASSERT_EQ(families().size(), 1U);
    EXPECT_EQ(families().front()->title, "Tinker One");
}

TEST_F(NewFamily, IsFoundWithItsVersion)
{
    EXPECT_EQ(bench.session.devices().size(), 2U);
    EXPECT_EQ(unit->identity().firmware, "1.0");
    EXPECT_EQ(unit->identity().state, DeviceState::Online);
}

TEST_F(NewFamily, KeepsWhatIsStoredAndLosesWhatIsNot)
{
    NoProgress progress;
    const auto gain = bench.index(*unit, "loop.stiffness");
    ASSERT_TRUE(run(bench.clock, writeParameters(*unit, {{gain, 7000}}, progress)));
    EXPECT_TRUE(run(bench.clock, unit->store(progress)).value_or(false));
    ASSERT_TRUE(run(bench.clock, writeParameters(*unit, {{gain, 9000}}, progress)));
    simulated().setPowered(false);
    simulated().setPowered(true);
    const auto kept = run(bench.clock, unit->read(gain));
    ASSERT_TRUE(kept);
    EXPECT_EQ(*kept, 7000);
}

TEST_F(NewFamily, DrivesToAPositionAndRecordsTheWay)
{
    moveTo(2000.0);
    bench.clock.advance(3s);
    EXPECT_NEAR(simulated().position(), 2000.0, 100.0);
    const auto position = unit->telemetry()->latest(*unit->telemetry()->find("position"));
    ASSERT_TRUE(position);
    EXPECT_NEAR(position->value, simulated().position(), 1.5);
    EXPECT_NEAR(unit->telemetry()->rate(*unit->telemetry()->find("position"), unit->clock().now()), 100.0, 2.0);
    bench.session.stopAll(StopCause::User);
    bench.clock.advance(50ms);
    EXPECT_FALSE(simulated().isOutputOn());
}

TEST_F(NewFamily, ItsFramesAreKnownByNameAndOthersAreNot)
{
    const auto decoded = families().front()->decodeCan(*canFrameFromText("0F5E0203#0110270000"), {});
    ASSERT_TRUE(decoded);
    EXPECT_EQ(decoded->message, "drive");
    EXPECT_EQ(decoded->address, 3);
    EXPECT_TRUE(decoded->control);
    EXPECT_EQ(decoded->fields.back().value, 10000.0);
    EXPECT_FALSE(families().front()->decodeCan(*canFrameFromText("0F5E0203#01102700"), {})) << "one byte short";
    EXPECT_FALSE(families().front()->decodeCan(*canFrameFromText("0F5F0203#0110270000"), {}));
}

TEST_F(NewFamily, IsUpdatedByHandAndAnswersWithTheNewVersion)
{
    const auto image = FirmwareImage::fromIntelHex(":0800000002050A0B0C0D0E0FA6\n:00000001FF\n");
    ASSERT_TRUE(image) << image.error().text();
    NoProgress progress;
    const Family &family = unit->family();
    const auto refused = run(bench.clock, family.update(*unit, *image, {}, progress));
    ASSERT_FALSE(refused);
    UpdateOptions options;
    options.via = family.routes.front().example;
    const auto report = run(bench.clock, family.update(*unit, *image, options, progress));
    ASSERT_TRUE(report) << report.error().text();
    EXPECT_EQ(report->outcome, UpdateOutcome::Done);
    EXPECT_EQ(report->to, "2.5");
    EXPECT_EQ(simulated().flash()[7], 0x0F);
}

TEST_F(NewFamily, HasItsRowsInTheWindow)
{
    simulated().disturb("stall", 1.0);
    simulated().disturb("end-switch", 1.0);
    moveTo(2000.0);
    bench.clock.advance(1s);
    publish();
    DeviceModel tree(workbench);
    publish();
    const QModelIndex row = tree.indexOf(workbench.shot.devices.front().id);
    ASSERT_TRUE(row.isValid());
    EXPECT_EQ(row.data().toString(), QStringLiteral("Tinker One #3"));
    EXPECT_TRUE(row.data(DeviceModel::LineRole).toString().contains(QStringLiteral("tinkered to a standstill")))
        << row.data(DeviceModel::LineRole).toString().toStdString();
    EXPECT_EQ(tree.rowCount(row), static_cast<int>(unit->family().channels.size()));
    EXPECT_EQ(alertsOf(workbench.shot.devices.front()), QStringList(QStringLiteral("tinkered end switch holds")));

    StagedEdits edits(unit->family());
    ParameterModel parameters;
    parameters.show(&unit->family(), &edits, true);
    EXPECT_EQ(parameters.index(0, 0).data().toString(), QStringLiteral("Tinkered loop"));
    EXPECT_EQ(parameters.rowCount(parameters.index(0, 0)), 3);
}

TEST_F(NewFamily, ItsGainsAreKnownByTheirRoles)
{
    const Family &family = unit->family();
    const GainSet set = gainSet(family, Mode::Position, 0);
    ASSERT_EQ(set.gains.size(), 2U);
    EXPECT_EQ(shortName(family.parameters[set.gains[0].value]), QStringLiteral("D")) << "in the family's own order";
    EXPECT_EQ(shortName(family.parameters[set.gains[1].value]), QStringLiteral("P"));
    EXPECT_EQ(usualRange(family.ranges, Mode::Position), 5000.0);
    EXPECT_EQ(parameterOf(family, Mode::Position, 1, 0, Role::Proportional), bench.index(*unit, "loop.stiffness"));
    EXPECT_EQ(parameterOf(family, Mode::Position, 1, 0, Role::Integral), std::nullopt);
}

TEST_F(NewFamily, ItsGainsAreScaledThereAndBack)
{
    const Family &family = unit->family();
    const tuning::TriedScale scale{.p = 0.001, .d = 0.002, .cycle = 1e-3};
    const auto scaled = tuning::scaleGains(*unit, Mode::Position, 1, 0, {.p = 0.01, .d = 0.004}, scale);
    ASSERT_TRUE(scaled) << scaled.error().text();
    tuning::KnownGains numbers;
    for (const tuning::ScaledGains::Row &row : scaled->rows)
        numbers.emplace_back(row.key, row.number);
    EXPECT_EQ(numbers, (tuning::KnownGains{{"loop.damping", 2.0}, {"loop.stiffness", 10.0}}));
    const auto made = tuning::gainsMadeBy(family, {}, Mode::Position, 1, 0, numbers, scale);
    ASSERT_TRUE(made);
    EXPECT_DOUBLE_EQ(made->made.p, 0.01);
    EXPECT_DOUBLE_EQ(made->made.d, 0.004);
}

TEST_F(NewFamily, AStepIsTriedWithOtherGainsAndAdvisedOn)
{
    const auto damping = bench.index(*unit, "loop.damping");
    tuning::ExperimentPlan plan;
    plan.mode = Mode::Position;
    plan.to = 2000.0;
    plan.gains = {{damping, 5}}; // raw: far too few of its steps, and it swings
    test::FakeJournal journal;
    tuning::DirectionBook directions;
    tuning::ExperimentSurroundings surroundings;
    surroundings.journal = &journal;
    surroundings.directions = &directions;
    Timer renewal(bench.clock);
    const std::function<void()> renew = [&] {
        bench.session.stream(*unit).renew();
        renewal.startIn(100ms, renew);
    };
    renew();
    const auto trial
        = run(bench.clock, tuning::runExperiment(*unit, bench.session.stream(*unit), std::move(plan), surroundings));
    ASSERT_TRUE(trial) << trial.error().text();
    EXPECT_EQ(trial->reason, tuning::EndReason::Done) << trial->detail;
    ASSERT_EQ(trial->gains.size(), 2U);
    const tuning::Evidence seen(unit->family(), *trial);
    EXPECT_EQ(seen.key(Role::Derivative), "loop.damping");
    EXPECT_EQ(seen.gain(Role::Derivative), 0.005);
    EXPECT_EQ(seen.gain(Role::Proportional), 5.0);
    const auto advice = tuning::advise(unit->family(), *trial);
    EXPECT_TRUE(std::any_of(advice.begin(), advice.end(),
        [](const tuning::Advice &one) { return one.cause == tuning::Cause::Resolution; }));
    EXPECT_EQ(run(bench.clock, unit->read(damping)).value_or(0), 200) << "put back";

    ThemeSource theme(lightTheme());
    TrialModel list(theme);
    list.setFamily(&unit->family());
    KeptTrial kept;
    kept.trial = *trial;
    list.setTrials({kept});
    EXPECT_EQ(list.index(0, TrialModel::GainP).data().toString().toDouble(), 5.0);
    EXPECT_TRUE(list.usesGain(TrialModel::GainD));
    EXPECT_FALSE(list.usesGain(TrialModel::GainI));
}

TEST_F(NewFamily, ShowsItsOwnStepsAndDrawingOnTheFirmwarePage)
{
    publish();
    Selection selection;
    ThemeSource theme(lightTheme());
    selection.select(workbench.shot.devices.front().id);
    FirmwarePage page(workbench, selection, families(), theme);
    page.show();
    publish();
    auto *const view = page.unit().findChild<DrawingView *>();
    ASSERT_NE(view, nullptr);
    ASSERT_EQ(view->drawing(), unit->family().routes.front().steps.front().drawing);
    EXPECT_EQ(view->accessibleName(), QStringLiteral("Drawing: a tinkered handle"));
    const QByteArray svg = DrawingView::svgOf(*view->drawing(), theme.theme());
    EXPECT_FALSE(svg.contains('{')) << svg.constData();
    EXPECT_TRUE(svg.contains(theme.theme().accent.name().toUtf8()));
    EXPECT_TRUE(QSvgRenderer(svg).isValid());
}

TEST_F(NewFamily, ASilentUnitIsHelpedInItsOwnWords)
{
    simulated().setPowered(false);
    bench.simulator("tinker:4")->setPowered(false);
    const auto silent
        = run(bench.clock, bench.session.connect({bench.link->address(), "tinker", 7, std::nullopt}, true));
    ASSERT_TRUE(silent) << silent.error().text();
    EXPECT_EQ((*silent)->identity().state, DeviceState::Bootloader);
    EXPECT_TRUE((*silent)->identity().detail.english().ends_with("update it, or turn the tinkered handle back"))
        << (*silent)->identity().detail;
}

TEST_F(NewFamily, WhatACutLeavesIsSaidInItsOwnWords)
{
    const UpdateWords &words = updateWords(unit->family());
    EXPECT_EQ(leftAfter(0, words), QStringLiteral("The tinkered loader then waits"));
    EXPECT_EQ(leftAfter(7, words), QStringLiteral("The tinkered loader then waits"))
        << "it says no more of one that was begun";
}

TEST_F(NewFamily, PlaysTheStoriesOfWhatItHasWithItsOwnMotor)
{
    ASSERT_EQ(stories().size(), 1U) << "nothing of it stops short, and no switch limits its current";
    const Story &story = stories().front();
    EXPECT_EQ(story.key, "tame");
    EXPECT_EQ(storyMotor(story), QStringLiteral("Tinkered motor"));
    EXPECT_EQ(storyParts(story), QStringLiteral("tinkered gear · Tinker One #4"));
    EXPECT_TRUE(storyText(story, story.steps.back().words).startsWith(QStringLiteral("Press Store and prove")))
        << "it does not store by itself";
}

TEST_F(NewFamily, IsNamedWhereItsBenchIsOffered)
{
    QStringList said;
    for (const LinkChoice &choice : linkChoices({}, {}))
        said += choice.words;
    EXPECT_TRUE(said.contains(QStringLiteral("Tinker One, at the real speed of their link.")))
        << said.join(QLatin1Char(';')).toStdString();
}

TEST_F(NewFamily, APartOfItsOutputMayBeEnteredInPercent)
{
    const Parameter &limit = unit->parameters().parameter(bench.index(*unit, "limit.duty"));
    EXPECT_EQ(parseValue(limit, QStringLiteral("50 %")).raw, 5000);
    const Parameter &gain = unit->parameters().parameter(bench.index(*unit, "loop.stiffness"));
    EXPECT_FALSE(parseValue(gain, QStringLiteral("50 %")).raw);
}

TEST_F(NewFamily, SpeaksGermanFromItsOwnFolder)
{
    QTranslator german;
    ASSERT_TRUE(german.load(QStringLiteral(TINKER_GERMAN)));
    QCoreApplication::installTranslator(&german);
    const Family &family = unit->family();
    EXPECT_EQ(faultText(family, "stalled"), QStringLiteral("stillgebastelt"));
    EXPECT_EQ(tableText(family.states.front().clause), QStringLiteral("gebastelter Endschalter hält"));
    EXPECT_EQ(tableText(updateWords(family).cut),
        QStringLiteral("Ein gebasteltes Gerät, das unterbrochen wird, wartet in seinem Lader."));
    const QByteArray svg = DrawingView::svgOf(*family.routes.front().steps.front().drawing, lightTheme());
    EXPECT_TRUE(svg.contains("gebastelte Kurbel"));
    QCoreApplication::removeTranslator(&german);
    EXPECT_EQ(faultText(family, "stalled"), QStringLiteral("tinkered to a standstill"));
}

} // namespace
} // namespace mb

int main(int argc, char **argv)
{
    const QTemporaryDir home; // what the program keeps of devices goes with the test
    for (const char *const folder : {"XDG_DATA_HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME"})
        qputenv(folder, home.path().toUtf8());
    QApplication application(argc, argv);
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
