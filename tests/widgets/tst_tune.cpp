// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/registry.h"
#include "support/windowtests.h"
#include "tunehand.h"
#include "widgets/common/iconbutton.h"
#include "widgets/control/driveoptions.h"
#include "widgets/control/gainspanel.h"
#include "widgets/control/modepanel.h"
#include "widgets/control/setpointpanel.h"
#include "widgets/control/tuneplot.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>

#include <algorithm>

using namespace mb;
using namespace mb::test;
using namespace std::chrono_literals;

namespace {

constexpr int atOnce = 0; ///< row of the list of slew times

} // namespace

class TestTune : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void runIsRefusedWhenNotArmed();
    void runSendsTheSetPointWithSlotAndFlags();
    void onlyOptionsThatMeanSomethingInTheModeAreOfferedAndSent_data();
    void onlyOptionsThatMeanSomethingInTheModeAreOfferedAndSent();
    void aSetPointWhosePresentValueNobodyTellsBeginsAtNothing();
    void aSetPointOfTheHandStartsWhereTheMotorIsAndMovesSlowly();
    void theWheelSteersNothingItPasses();
    void theSliderSteersAMotorThatMoves();
    void enterNeverStartsAMotor();
    void stopMotionStaysArmed();
    void nonsenseIsRefusedWithAMessage_data();
    void nonsenseIsRefusedWithAMessage();
    void positionStartsAtThePresentPosition();
    void whatChangesTheMeaningOfASetPointDisarms_data();
    void whatChangesTheMeaningOfASetPointDisarms();
    void theEditedSlotDoesNotDisarm();
    void aRunFromElsewhereIsShown();
    void aRunFromElsewhereDoesNotWriteOverWhatIsTyped();
};

void TestTune::runIsRefusedWhenNotArmed()
{
    TuneBench bench;
    bench.workbench.publish();
    auto *run = bench.page->findChild<CommandButton *>(s("run"));
    QVERIFY(!run->isEnabled());
    QVERIFY2(run->toolTip().contains(s("Hold the Arm button")), qPrintable(run->toolTip()));
    QTest::keyClick(bench.page.get(), Qt::Key_F5);
    bench.page->run();
    QVERIFY(bench.workbench.given<orders::StartMotion>().empty());
    QVERIFY(bench.workbench.lines.back().text.contains(QLatin1String("Not armed")));
}

void TestTune::runSendsTheSetPointWithSlotAndFlags()
{
    TuneBench bench;
    slot(bench, "Gain slot, edit and run", 1)->click();
    pick(bench.find<QComboBox>("How fast the set-point moves"), atOnce);
    pick(bench.find<QComboBox>("At zero output"), 2);
    for (const char *flag : {"Reverse sensor", "Override limits", "Reverse limit off"})
        bench.find<QCheckBox>(flag)->setChecked(true);
    type(bench.find<QLineEdit>("Set-point"), "-60000");
    bench.arm();
    QTest::keyClick(bench.page.get(), Qt::Key_F5);
    const auto starts = bench.workbench.given<orders::StartMotion>();
    QCOMPARE(starts.size(), 1U);
    SetPoint expected;
    expected.mode = Mode::Velocity;
    expected.target = -60000.0;
    expected.slot = 1;
    expected.brake = false;
    expected.reverseSensor = true;
    expected.overrideLimits = true;
    expected.disableReverseLimit = true;
    QVERIFY(starts[0].setPoint == expected);
}

void TestTune::onlyOptionsThatMeanSomethingInTheModeAreOfferedAndSent_data()
{
    QTest::addColumn<QString>("family");
    QTest::addColumn<int>("mode");
    QTest::addColumn<bool>("ramps");
    QTest::addColumn<bool>("brakes");
    QTest::newRow("a DMC60C ramps a duty") << s("dmc60c") << static_cast<int>(Mode::Duty) << true << true;
    QTest::newRow("its velocity has the ramp of the slot")
        << s("dmc60c") << static_cast<int>(Mode::Velocity) << false << true;
    QTest::newRow("an Abstract DC Drive ramps a duty")
        << s("abstractdc") << static_cast<int>(Mode::Duty) << true << false;
    QTest::newRow("and nothing else") << s("abstractdc") << static_cast<int>(Mode::Position) << false << false;
}

void TestTune::onlyOptionsThatMeanSomethingInTheModeAreOfferedAndSent()
{
    QFETCH(QString, family);
    QFETCH(int, mode);
    QFETCH(bool, ramps);
    QFETCH(bool, brakes);
    const ThemeSource theme(lightTheme());
    SetPointPanel panel(theme);
    SetPointEntries entered;
    entered.options.ramp = 2.5;
    panel.show(*findFamily(families(), family.toStdString()), static_cast<Mode>(mode), entered);
    panel.setVisible(true);
    const auto *more = panel.findChild<QPushButton *>(s("driveOptions"));
    QCOMPARE(more->isVisible(), ramps || brakes);
    QCOMPARE(more->text().contains(s("ramp")), ramps);
    const auto *options = panel.findChild<DriveOptions *>();
    QCOMPARE(options->findChild<QComboBox *>()->isVisibleTo(options), brakes);
    QCOMPARE(options->findChild<QLineEdit *>()->isVisibleTo(options), ramps);
    const QList<QLabel *> labels = options->findChildren<QLabel *>();
    QVERIFY(std::ranges::any_of(labels, [&](const QLabel *label) {
        return label->text() == (family == s("abstractdc") ? s("duty/s, 0 = 4") : s("duty/s, 0 = none"));
    }));
    SetPoint sent;
    panel.apply(sent);
    QCOMPARE(sent.ramp, ramps ? 2.5 : 0.0);
    QCOMPARE(panel.entered().options.ramp, 2.5);
}

void TestTune::aSetPointWhosePresentValueNobodyTellsBeginsAtNothing()
{
    TuneBench bench; // nothing was heard yet
    type(bench.find<QLineEdit>("Set-point"), "60000");
    bench.arm();
    bench.page->run();
    const orders::StartMotion start = bench.workbench.given<orders::StartMotion>().at(0);
    QVERIFY(start.glide.rate > 0.0);
    QCOMPARE(start.glide.from, std::optional(0.0)); // not at 60 000
}

void TestTune::aSetPointOfTheHandStartsWhereTheMotorIsAndMovesSlowly()
{
    TuneBench bench;
    bench.pass(1.0, 0.0);
    type(bench.find<QLineEdit>("Set-point"), "60000");
    bench.arm();
    bench.page->run();
    const orders::StartMotion start = bench.workbench.given<orders::StartMotion>().at(0);
    QCOMPARE(start.setPoint.target, 60000.0);
    QCOMPARE(start.glide.from, std::optional(0.0)); // which is its first frame
    QCOMPARE(start.glide.rate, 200000.0);           // the full range of ± 100 000 takes 1 s
    bench.confirmMotion();
    bench.find<QSlider>("Set-point, slider")->setValue(-1000);
    const orders::UpdateMotion update = bench.workbench.given<orders::UpdateMotion>().back();
    QCOMPARE(update.setPoint.target, -100000.0);
    QCOMPARE(update.glide.rate, 200000.0);
}

void TestTune::theWheelSteersNothingItPasses()
{
    TuneBench bench;
    auto *slider = bench.find<QSlider>("Set-point, slider");
    bench.find<QLineEdit>("P")->setFocus();
    const QPoint middle = slider->rect().center();
    QWheelEvent passing(
        middle, slider->mapToGlobal(middle), {}, {0, 120}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(slider, &passing);
    QCOMPARE(slider->value(), 0);
    slider->setFocus();
    QApplication::sendEvent(slider, &passing);
    QVERIFY(slider->value() > 0);
}

void TestTune::theSliderSteersAMotorThatMoves()
{
    TuneBench bench;
    pick(bench.find<QComboBox>("How fast the set-point moves"), atOnce);
    auto *slider = bench.find<QSlider>("Set-point, slider");
    slider->setValue(200);
    QVERIFY(bench.workbench.given<orders::StartMotion>().empty());
    bench.arm();
    slider->setValue(250);
    QVERIFY(bench.workbench.given<orders::StartMotion>().empty()); // armed is not moving
    bench.page->run();
    QCOMPARE(bench.workbench.given<orders::StartMotion>().at(0).setPoint.target, 25000.0);
    bench.confirmMotion();
    slider->setValue(-500);
    QCOMPARE(bench.workbench.given<orders::UpdateMotion>().at(0).setPoint.target, -50000.0);
    QCOMPARE(bench.find<QLineEdit>("Set-point")->text(), s("-50000"));
}

void TestTune::enterNeverStartsAMotor()
{
    TuneBench bench;
    pick(bench.find<QComboBox>("How fast the set-point moves"), atOnce);
    bench.arm();
    type(bench.find<QLineEdit>("Set-point"), "1000\r");
    QVERIFY(bench.workbench.given<orders::StartMotion>().empty());
    bench.page->run();
    bench.confirmMotion();
    type(bench.find<QLineEdit>("Set-point"), "2000\r");
    QCOMPARE(bench.workbench.given<orders::UpdateMotion>().at(0).setPoint.target, 2000.0);
}

void TestTune::stopMotionStaysArmed()
{
    TuneBench bench;
    bench.arm();
    bench.page->run();
    bench.confirmMotion();
    bench.page->halt();
    QCOMPARE(bench.workbench.given<orders::StopMotion>().size(), 1U);
    QVERIFY(bench.arming.state() == LampState::Armed);
}

void TestTune::nonsenseIsRefusedWithAMessage_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("message");
    QTest::newRow("empty") << s("") << s("No set-point");
    QTest::newRow("words") << s("fast") << s("\"fast\" is no number");
    QTest::newRow("nan") << s("nan") << s("\"nan\" is no number");
    QTest::newRow("infinite") << s("inf") << s("\"inf\" is no number");
    QTest::newRow("overflow") << s("1e999") << s("is no number");
    QTest::newRow("beyond the range") << s("-100001") << s("beyond the range");
}

void TestTune::nonsenseIsRefusedWithAMessage()
{
    QFETCH(QString, text);
    QFETCH(QString, message);
    TuneBench bench;
    bench.arm();
    auto *field = bench.find<QLineEdit>("Set-point");
    field->setText(text);
    Q_EMIT field->textEdited(text);
    QVERIFY2(problemOf(bench).contains(message), qPrintable(problemOf(bench)));
    QVERIFY(!bench.page->findChild<CommandButton *>(s("run"))->isEnabled());
    bench.page->run();
    QVERIFY(bench.workbench.given<orders::StartMotion>().empty());
    QCOMPARE(field->property("state").toString(), s("error"));
}

void TestTune::positionStartsAtThePresentPosition()
{
    TuneBench bench;
    bench.pass(1.0, 50000.0);
    const double present = bench.recording.telemetry()->last(*bench.recording.telemetry()->find("position"))->value;
    QVERIFY(present > 40000.0); // beyond the usual range: no reason to refuse it
    click(bench, "Position mode");
    bench.workbench.publish();
    QCOMPARE(bench.find<QLineEdit>("Set-point")->text(), QString::number(present, 'f', 0));
    pick(bench.find<QComboBox>("How fast the set-point moves"), atOnce);
    type(bench.find<QLineEdit>("Set-point"), "1000");
    bench.arm();
    bench.page->run();
    const orders::StartMotion start = bench.workbench.given<orders::StartMotion>().at(0);
    QCOMPARE(start.glide.from, std::optional(present)); // not a jump, even at once
    QCOMPARE(start.setPoint.target, 1000.0);
}

void TestTune::whatChangesTheMeaningOfASetPointDisarms_data()
{
    QTest::addColumn<int>("what");
    QTest::newRow("mode") << 0;
    QTest::newRow("running slot") << 1;
    QTest::newRow("motor direction") << 2;
    QTest::newRow("sensor direction") << 3;
    QTest::newRow("limits") << 4;
    QTest::newRow("device") << 5;
}

void TestTune::whatChangesTheMeaningOfASetPointDisarms()
{
    QFETCH(int, what);
    TuneBench bench;
    bench.arm();
    bench.page->run();
    bench.confirmMotion();
    QVERIFY(bench.arming.isMoving());
    switch (what) {
    case 0: click(bench, "Duty mode"); break;
    case 1: slot(bench, "Gain slot, edit and run", 1)->click(); break;
    case 2: bench.find<QCheckBox>("Reverse motor")->setChecked(true); break;
    case 3: bench.find<QCheckBox>("Reverse sensor")->setChecked(true); break;
    case 4: bench.find<QCheckBox>("Override limits")->setChecked(true); break;
    default: bench.selection.select({2}); break;
    }
    QVERIFY(bench.arming.state() == LampState::Safe);
    QCOMPARE(bench.workbench.given<orders::StopMotion>().size(), 1U);
}

void TestTune::theEditedSlotDoesNotDisarm()
{
    TuneBench bench;
    bench.arm();
    click(bench, "Edit one slot while another runs");
    slot(bench, "Gain slot that is edited", 1)->click();
    QVERIFY(bench.arming.isArmed({1}));
    type(bench.find<QLineEdit>("P"), "2");
    QCOMPARE(bench.page->findChild<CommandButton *>(s("run"))->text(), s("Run")); // the slot that runs is not edited
    bench.page->run();
    QVERIFY(bench.workbench.given<orders::WriteParameters>().empty());
    QCOMPARE(bench.workbench.given<orders::StartMotion>().at(0).setPoint.slot, 0);
}

void TestTune::aRunFromElsewhereIsShown()
{
    TuneBench bench;
    bench.arm();
    SetPoint setPoint;
    setPoint.mode = Mode::Velocity;
    setPoint.target = 60000.0;
    bench.arming.run(setPoint);
    bench.confirmMotion();
    QCOMPARE(bench.find<QLineEdit>("Set-point")->text(), s("60000"));
    QVERIFY2(problemOf(bench).contains(s("Moving | velocity 60\u202F000\u00A0counts/s, slot 0")),
        qPrintable(problemOf(bench)));
    QCOMPARE(bench.workbench.given<orders::UpdateMotion>().size(), 0U);
}

void TestTune::aRunFromElsewhereDoesNotWriteOverWhatIsTyped()
{
    TuneBench bench;
    bench.arm();
    SetPoint setPoint;
    setPoint.mode = Mode::Velocity;
    setPoint.target = 60000.0;
    bench.arming.run(setPoint);
    bench.confirmMotion();
    auto *field = bench.find<QLineEdit>("Set-point");
    field->setFocus();
    type(field, "1");
    bench.pass(0.1, 60000.0);
    QCOMPARE(field->text(), s("1"));
    bench.device().motion.setPoint.target = 50000.0; // by whoever runs it
    bench.pass(0.1, 50000.0);
    QCOMPARE(field->text(), s("1"));
    bench.page->setFocus();
    bench.pass(0.1, 50000.0);
    QCOMPARE(field->text(), s("1"));
    bench.device().motion.setPoint.target = 40000.0;
    bench.pass(0.1, 40000.0);
    QCOMPARE(field->text(), s("40000"));
}

MB_WINDOW_TEST(TestTune);
#include "tst_tune.moc"
