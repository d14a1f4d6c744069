// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/windowtests.h"
#include "tunebench.h"
#include "widgets/control/batterydialog.h"
#include "widgets/plots/curveplot.h"

#include <QAbstractButton>
#include <QApplication>
#include <QTableWidget>
#include <QTest>

using namespace mb;
using namespace mb::test;

namespace {

tuning::ExperimentPlan largest()
{
    tuning::ExperimentPlan plan;
    plan.mode = Mode::Velocity;
    plan.from = 0.0;
    plan.to = 50'000.0;
    return plan;
}

struct BatteryBench {
    FakeWorkbench workbench;
    ThemeSource theme{darkTheme()};
    Arming arming{workbench};
    Recording recording{workbench.time};
    BatteryOffer offer{{1}, tuning::batteryOf(largest(), 0.0, false), QStringLiteral("counts/s"), {}};
    BatteryDialog dialog{arming, [this] { return offer; }, theme, nullptr};

    BatteryBench()
    {
        workbench.shot.devices.push_back(tunableDrive(recording.telemetry()));
        dialog.showOffer();
        dialog.show();
    }
    /// The step that runs ends with this overshoot.
    void finish(double overshoot, tuning::EndReason reason = tuning::EndReason::Done, bool stopped = true)
    {
        const auto plan = workbench.given<orders::RunTrial>().back().plan;
        tuning::Trial trial;
        trial.simulated = true;
        trial.stimulus.from = plan.from.value_or(0.0);
        trial.stimulus.to = plan.to;
        trial.metrics.overshoot = overshoot;
        trial.reason = reason;
        trial.stopped = stopped;
        const auto finished = workbench.given<orders::RunTrial>().back().finished;
        finished(trial);
    }
};

} // namespace

class TestBattery : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void nothingMovesBeforeItIsArmedAndStarted();
    void whatIsShownIsWhatIsRun();
    void aMotorThatRestsACountFromWhereItWasIsRunAgainAtOnce();
    void theKeyThatOpenedItIsHeldAndStartsNothing();
    void tenStepsFollowEachOtherAndTheWorstStandsBelow();
    void aStopEndsItAndSaysSo();
    void aMotorThatIsNotSeenToStandEndsIt();
    void everyControlHasAName();
};

void TestBattery::nothingMovesBeforeItIsArmedAndStarted()
{
    BatteryBench bench;
    QVERIFY(bench.dialog.words().contains(QStringLiteral("counts/s")));
    bench.dialog.run();
    QVERIFY(bench.workbench.given<orders::RunTrial>().empty());
    bench.arming.arm({1});
    QVERIFY(bench.workbench.given<orders::RunTrial>().empty());
    bench.dialog.run();
    QCOMPARE(bench.workbench.given<orders::RunTrial>().size(), std::size_t(1));
}

void TestBattery::whatIsShownIsWhatIsRun()
{
    BatteryBench bench;
    bench.arming.arm({1});
    tuning::ExperimentPlan other = largest();
    other.to = 80'000.0;
    bench.offer.battery = tuning::batteryOf(other, 0.0, false);
    const QString before = bench.dialog.words();
    bench.dialog.run();
    QVERIFY2(bench.workbench.given<orders::RunTrial>().empty(), "nobody has seen it");
    QVERIFY(bench.dialog.words() != before);
    bench.offer.motor = QStringLiteral("QuadQuad2Drv #0 · Axis 2");
    bench.dialog.followOffer();
    QVERIFY(bench.dialog.windowTitle().contains(bench.offer.motor));
    bench.dialog.run();
    QCOMPARE(bench.workbench.given<orders::RunTrial>().back().plan.to, 16'000.0);
    bench.finish(0.02, tuning::EndReason::Speed);
    const QString ending = bench.dialog.words();
    bench.offer.battery = tuning::batteryOf(largest(), 0.0, false);
    bench.dialog.followOffer();
    QCOMPARE(bench.dialog.words(), ending);
    QCOMPARE(bench.dialog.trials().size(), std::size_t(1));
}

void TestBattery::aMotorThatRestsACountFromWhereItWasIsRunAgainAtOnce()
{
    BatteryBench bench;
    tuning::ExperimentPlan place = largest();
    place.mode = Mode::Position;
    place.from.reset();
    place.to = 5'000.0;
    const auto standAt = [&bench, &place](double here) {
        bench.offer.battery = tuning::batteryOf(place, here, false);
        bench.offer.unit = QStringLiteral("counts");
        bench.dialog.followOffer();
    };
    const auto begun = [&bench] { return bench.workbench.given<orders::RunTrial>().size(); };
    bench.arming.arm({1});
    std::size_t ended = 0;
    for (const double here : {0.0, 1.0}) {
        standAt(here);
        bench.dialog.run();
        QCOMPARE(begun(), ended + 1);
        for (int i = 0; i < 10; ++i)
            bench.finish(0.01);
        ended += 10;
    }
    standAt(2'000.0); // turned by hand
    bench.dialog.run();
    QCOMPARE(begun(), ended);
    standAt(2'001.0);
    QVERIFY2(bench.dialog.words().startsWith(QStringLiteral("Not started")), qPrintable(bench.dialog.words()));
    bench.dialog.run();
    QCOMPARE(begun(), ended + 1);
}

void TestBattery::theKeyThatOpenedItIsHeldAndStartsNothing()
{
    BatteryBench bench;
    bench.arming.arm({1});
    QApplication::setActiveWindow(&bench.dialog);
    QTest::simulateEvent(&bench.dialog, true, Qt::Key_F7, Qt::NoModifier, {}, true);
    QVERIFY(bench.workbench.given<orders::RunTrial>().empty());
    QTest::keyClick(&bench.dialog, Qt::Key_F7);
    QCOMPARE(bench.workbench.given<orders::RunTrial>().size(), std::size_t(1));
}

void TestBattery::tenStepsFollowEachOtherAndTheWorstStandsBelow()
{
    BatteryBench bench;
    bench.arming.arm({1});
    bench.dialog.run();
    for (int i = 0; i < 10; ++i) {
        QCOMPARE(bench.workbench.given<orders::RunTrial>().size(), static_cast<std::size_t>(i + 1));
        QCOMPARE(bench.workbench.given<orders::RunTrial>().back().plan.to,
            (i % 2 == 0 ? 1.0 : -1.0) * 10'000.0 * (1 + i / 2));
        bench.finish(i == 3 ? 0.25 : 0.01 * i);
    }
    QVERIFY(!bench.dialog.isRunning());
    QCOMPARE(bench.dialog.table().rowCount(), 11);
    QCOMPARE(bench.dialog.table().item(10, 3)->text(), QStringLiteral("25.0"));
    QVERIFY2(bench.dialog.table().item(3, 3)->font().bold(), "where the worst comes from");
    QVERIFY(!bench.dialog.table().item(4, 3)->font().bold());
    QCOMPARE(bench.dialog.plot().curves().size(), std::size_t(10));
    QVERIFY(bench.arming.isArmed({1}));
}

void TestBattery::aStopEndsItAndSaysSo()
{
    BatteryBench bench;
    bench.arming.arm({1});
    bench.dialog.run();
    bench.finish(0.01);
    bench.finish(0.02, tuning::EndReason::Speed);
    QVERIFY(!bench.dialog.isRunning());
    QCOMPARE(bench.workbench.given<orders::RunTrial>().size(), std::size_t(2));
    QCOMPARE(bench.dialog.table().rowCount(), 3);
    bench.dialog.run();
    QCOMPARE(bench.workbench.given<orders::RunTrial>().size(), std::size_t(2)); // a guard's stop is latched
}

/// Though it was done.
void TestBattery::aMotorThatIsNotSeenToStandEndsIt()
{
    BatteryBench bench;
    bench.arming.arm({1});
    bench.dialog.run();
    bench.finish(0.01);
    QCOMPARE(bench.workbench.given<orders::RunTrial>().size(), std::size_t(2));
    bench.finish(0.02, tuning::EndReason::Done, false);
    QVERIFY(!bench.dialog.isRunning());
    QCOMPARE(bench.workbench.given<orders::RunTrial>().size(), std::size_t(2));
}

void TestBattery::everyControlHasAName()
{
    BatteryBench bench;
    for (const QWidget *widget : bench.dialog.findChildren<QWidget *>()) {
        if (widget->focusPolicy() == Qt::NoFocus || !widget->isVisible())
            continue;
        const auto *button = qobject_cast<const QAbstractButton *>(widget);
        QVERIFY2(!widget->accessibleName().isEmpty() || (button && !button->text().isEmpty()),
            widget->metaObject()->className());
    }
}

MB_WINDOW_TEST(TestBattery);
#include "tst_battery.moc"
