// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/setpointslew.h"
#include "support/utf8.h"
#include "support/windowtests.h"
#include "tunebench.h"
#include "widgets/common/applytheme.h"
#include "widgets/control/gainunits.h"
#include "widgets/control/logslider.h"
#include "widgets/control/resolutionmeter.h"
#include "widgets/control/setpointpanel.h"
#include "widgets/control/stimulusbar.h"
#include "widgets/control/tuneplot.h"

#include <QAbstractButton>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QStackedWidget>
#include <QTest>

using namespace mb;
using namespace mb::test;
using namespace std::chrono_literals;

namespace {

double physical(const char *key, Mode mode, double number)
{
    return siGain(dmc60c(), dmc60c().parameters[named(key).value], mode, number, 4096.0)->value;
}

bool close(double value, double expected)
{
    return std::abs(value / expected - 1.0) < 1e-6;
}

} // namespace

class TestTunePage : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void thePlotShowsWhatIsRecorded();
    void countsBecomeRevolutions();
    void telemetryIsFastWhileArmedAndShownAndPutBack();
    void gainsAreReadOnceWhenTheyAreNotKnown();
    void everyStateHasItsWords_data();
    void everyStateHasItsWords();
    void aBootloaderHasNothingToTune();
    void theDeviceKeepsItsChoices();
    void theDeviceKeepsItsDriveOptionsAndTheFoldedPanelSaysThem();
    void theNextPageKnowsWhatWasChosen();
    void whereAPositionWasZeroedItsTargetIsForgotten();
    void physicalGainsMatchTheGoldenValues();
    void theMeterWarnsBelowFifty();
    void theSlewIsTheHandsLimit();
    void everyControlHasAName();
    void nothingIsCutAtTwiceTheFont();
    void theLivePlotScrollsBeforeItsStripsLieOverEachOther();
};

void TestTunePage::thePlotShowsWhatIsRecorded()
{
    TuneBench bench;
    bench.recording.setCommanded(true);
    bench.pass(2.0, 60000.0);
    QTRY_VERIFY2(bench.page->plot().stack().readings().summary().contains(s("Velocity 0\u00A0counts/s to 64")),
        qPrintable(bench.page->plot().stack().readings().summary()));
    const QString summary = bench.page->plot().stack().readings().summary();
    QVERIFY2(summary.contains(s("Set-point 60\u202F000\u00A0counts/s to 60\u202F000")), qPrintable(summary));
    QVERIFY2(summary.contains(s("Duty")) && summary.contains(s("Current")), qPrintable(summary));
}

void TestTunePage::countsBecomeRevolutions()
{
    TuneBench bench;
    bench.pass(2.0, 68266.6667); // 1000 rpm of 4096 counts
    auto *field = bench.find<QLineEdit>("Set-point");
    field->setText(s("40960"));
    Q_EMIT field->textEdited(field->text());
    bench.find<QAbstractButton>("rpm")->click();
    QCOMPARE(field->text(), s("600"));
    QTRY_VERIFY2(bench.page->plot().stack().readings().summary().contains(s("rpm")),
        qPrintable(bench.page->plot().stack().readings().summary()));
    auto *counts = bench.find<QLineEdit>("Counts per revolution");
    counts->setText(s("2048"));
    Q_EMIT counts->textEdited(counts->text());
    QCOMPARE(field->text(), s("1200"));
    counts->setText(s("0"));
    Q_EMIT counts->textEdited(counts->text());
    QCOMPARE(counts->property("state").toString(), s("error"));
    QCOMPARE(field->text(), s("1200"));
}

void TestTunePage::telemetryIsFastWhileArmedAndShownAndPutBack()
{
    TuneBench bench;
    bench.workbench.publish();
    QVERIFY(bench.workbench.given<orders::WishRates>().empty());
    bench.arm();
    QTRY_COMPARE(bench.workbench.given<orders::WishRates>().size(), 1U);
    const std::vector<RateWish> wishes = bench.workbench.given<orders::WishRates>().front().wishes;
    QCOMPARE(wishes.size(), 3U);
    QCOMPARE(wishes.at(0).hertz, 100.0);
    QCOMPARE(wishes.at(2).hertz, 50.0);
    bench.page->hide();
    QTRY_COMPARE(bench.workbench.given<orders::WishRates>().size(), 2U);
    QVERIFY(bench.workbench.given<orders::WishRates>().back().wishes.empty());
}

void TestTunePage::gainsAreReadOnceWhenTheyAreNotKnown()
{
    TuneBench bench;
    QVERIFY(bench.workbench.given<orders::ReadParameters>().empty());
    for (auto &entry : bench.device().parameters.edit())
        entry = {};
    ++bench.device().parameterRevision;
    bench.workbench.publish();
    bench.workbench.publish();
    QCOMPARE(bench.workbench.given<orders::ReadParameters>().size(), 1U);
    QVERIFY(!bench.find<QLineEdit>("P")->isEnabled()); // nothing known, nothing to edit
}

void TestTunePage::everyStateHasItsWords_data()
{
    QTest::addColumn<QString>("state");
    QTest::addColumn<QString>("words");
    QTest::newRow("safe") << s("safe") << s("Not armed: Hold the Arm button for 1 s to arm #5.");
    QTest::newRow("armed") << s("armed") << s("Armed: Run begins velocity 0\u00A0counts/s, slot 0");
    QTest::newRow("silent") << s("silent") << s("No answer from #5: The plot keeps what it has.");
    QTest::newRow("locked") << s("locked") << s("#5 cannot be armed: another master drives it");
    QTest::newRow("stopped") << s("stopped") << s("Stopped: key: Hold the Arm button for 1 s to arm again.");
    QTest::newRow("reading") << s("reading") << s("Reading gains: 23 of 55");
}

void TestTunePage::everyStateHasItsWords()
{
    QFETCH(QString, state);
    QFETCH(QString, words);
    TuneBench bench;
    if (state == s("armed") || state == s("stopped"))
        bench.arm();
    if (state == s("stopped"))
        bench.arming.stopAll(s("key"));
    bench.device().liveness.heard = state != s("silent");
    if (state == s("locked"))
        bench.device().mayNotMove = say("another master drives it");
    if (state == s("reading")) {
        for (auto &entry : bench.device().parameters.edit())
            entry = {};
        OperationView operation;
        operation.device = {1};
        operation.status.done = 23;
        operation.status.total = 55;
        bench.workbench.shot.operations.push_back(operation);
    }
    bench.workbench.publish();
    const auto now = bench.page->status();
    QCOMPARE(now.cause + s(": ") + now.remedy, words);
    QCOMPARE(now.mayRun, state == s("armed"));
}

void TestTunePage::aBootloaderHasNothingToTune()
{
    TuneBench bench;
    auto *pages = bench.page->findChild<QStackedWidget *>();
    QCOMPARE(pages->currentIndex(), 1);
    bench.device().identity.edit().state = DeviceState::Bootloader;
    bench.workbench.publish();
    QCOMPARE(pages->currentIndex(), 0);
    bench.workbench.shot.devices.clear();
    bench.workbench.publish();
    QCOMPARE(pages->currentIndex(), 0);
}

void TestTunePage::theDeviceKeepsItsChoices()
{
    TuneBench bench;
    bench.workbench.shot.devices.push_back(tunableDrive(std::make_shared<Telemetry>(dmc60c().channels), 2, 7));
    bench.workbench.publish();
    bench.find<QAbstractButton>("Current mode")->click();
    bench.find<QLineEdit>("P")->setFocus();
    QTest::keyClicks(bench.find<QLineEdit>("P"), s("9"));
    bench.selection.select({2});
    QVERIFY(bench.find<QAbstractButton>("Velocity mode")->isChecked());
    bench.selection.select({1});
    QVERIFY(bench.find<QAbstractButton>("Current mode")->isChecked());
    QVERIFY(bench.find<QAbstractButton>("Revert P")->isEnabled());
}

void TestTunePage::theDeviceKeepsItsDriveOptionsAndTheFoldedPanelSaysThem()
{
    TuneBench bench;
    bench.workbench.shot.devices.push_back(tunableDrive(std::make_shared<Telemetry>(dmc60c().channels), 2, 7));
    bench.workbench.publish();
    bench.find<QCheckBox>("Reverse sensor")->setChecked(true);
    const auto isSaid = [&bench] {
        const auto all = bench.page->findChildren<QPushButton *>();
        return std::any_of(all.begin(), all.end(),
            [](const QPushButton *button) { return button->text().contains(s("sensor reversed")); });
    };
    QVERIFY(isSaid());
    bench.selection.select({2});
    QVERIFY(!bench.find<QCheckBox>("Reverse sensor")->isChecked());
    QVERIFY2(!isSaid(), "the other unit has it as it is set");
    bench.selection.select({1});
    QVERIFY(bench.find<QCheckBox>("Reverse sensor")->isChecked());
    QVERIFY(isSaid());
    bench.arm();
    bench.page->run();
    QVERIFY(bench.workbench.given<orders::StartMotion>().at(0).setPoint.reverseSensor);
}

void TestTunePage::theNextPageKnowsWhatWasChosen()
{
    TuneBench bench;
    bench.workbench.publish();
    bench.page->form().choose(Mode::Velocity, 3210.0);
    bench.find<QCheckBox>("Reverse sensor")->setChecked(true);
    bench.page->form().setRepeats(4);
    bench.workbench.publish();
    bench.openNext();
    QVERIFY(bench.page->isLive());
    QVERIFY(bench.find<QCheckBox>("Reverse sensor")->isChecked());
    QCOMPARE(bench.page->column().setPointPanel().target().value_or(0.0), 3210.0);
    QCOMPARE(bench.page->stimulus().choice().repeat, 4);
    bench.arm();
    bench.page->run();
    QVERIFY(bench.workbench.given<orders::StartMotion>().at(0).setPoint.reverseSensor);
}

void TestTunePage::whereAPositionWasZeroedItsTargetIsForgotten()
{
    TuneBench bench;
    bench.workbench.shot.devices.push_back(tunableDrive(bench.recording.telemetry(), 2, 7));
    const auto target = [&bench] { return bench.page->column().setPointPanel().target().value_or(0.0); };
    for (const std::uint32_t id : {1U, 2U}) {
        bench.selection.select({id});
        bench.pass(0.1, 0.0);
        bench.page->form().choose(Mode::Position, 5000.0);
        bench.workbench.publish();
        QCOMPARE(target(), 5000.0);
    }
    ++bench.workbench.device(1).origin; // by an experiment, say
    bench.workbench.publish();
    QCOMPARE(target(), 0.0);
    bench.selection.select({1});
    QCOMPARE(target(), 5000.0);
    bench.selection.select({2});
    QCOMPARE(target(), 0.0);
    ++bench.workbench.device(0).origin; // while it is not shown
    bench.workbench.publish();
    bench.selection.select({1});
    QCOMPARE(target(), 0.0);
}

/// docs/names.md#integer-gains, "Golden, cpr 4096".
void TestTunePage::physicalGainsMatchTheGoldenValues()
{
    QVERIFY(close(physical("slot0.p", Mode::Velocity, 1.00527897), 0.002));
    QVERIFY(close(physical("slot0.i", Mode::Velocity, 0.00251320), 0.01)
        || std::abs(physical("slot0.i", Mode::Velocity, 0.00251320) - 0.01) < 1e-7);
    QVERIFY(close(physical("slot0.f", Mode::Velocity, 0.90475107), 0.0018));
    QVERIFY(close(physical("slot0.p", Mode::Position, 5.02639485), 0.1));
    QVERIFY(close(physical("slot0.d", Mode::Position, 1005.27896953), 0.01));
    QVERIFY(!siGain(dmc60c(), dmc60c().parameters[named("slot0.i_zone").value], Mode::Velocity, 1.0, 4096.0));
    QVERIFY(!siGain(dmc60c(), dmc60c().parameters[named("slot0.p").value], Mode::Duty, 1.0, 4096.0));
}

void TestTunePage::theMeterWarnsBelowFifty()
{
    QCOMPARE(ResolutionMeter::barsOf(10), 0);
    QCOMPARE(ResolutionMeter::barsOf(11), 1);
    QCOMPARE(ResolutionMeter::barsOf(501), 3);
    QCOMPARE(ResolutionMeter::barsOf(5001), 4);
    QVERIFY(ResolutionMeter::toneOf(9) == Tone::Danger);
    QVERIFY(ResolutionMeter::toneOf(10) == Tone::Caution);
    QVERIFY(ResolutionMeter::toneOf(49) == Tone::Caution);
    QVERIFY(ResolutionMeter::toneOf(50) == Tone::Ok);
    QVERIFY(ResolutionMeter::toneOf(0) == Tone::Faint);
}

void TestTunePage::theSlewIsTheHandsLimit()
{
    SetPointSlew slew;
    const Instant start{10s};
    slew.start(100.0, start);
    slew.setRate(50.0);
    slew.setTarget(-100.0);
    QCOMPARE(slew.advance(start), 100.0);
    QCOMPARE(slew.advance(start + 1s), 50.0);
    QCOMPARE(slew.advance(start + 500ms), 50.0); // a clock that stands still or falls back moves nothing
    QCOMPARE(slew.advance(start + 10s), -100.0);
    QVERIFY(slew.isThere());
    slew.setRate(0.0);
    slew.setTarget(7.0);
    QCOMPARE(slew.advance(start + 10s), 7.0);
}

void TestTunePage::everyControlHasAName()
{
    TuneBench bench;
    for (const auto *widget : bench.page->findChildren<QWidget *>()) {
        const bool control = qobject_cast<const QAbstractButton *>(widget) || qobject_cast<const QLineEdit *>(widget)
            || qobject_cast<const QComboBox *>(widget) || qobject_cast<const QAbstractSlider *>(widget);
        const bool ours = !widget->objectName().startsWith(s("qt_")) && !widget->inherits("QTableCornerButton")
            && !qobject_cast<const QScrollBar *>(widget);
        const auto *button = qobject_cast<const QAbstractButton *>(widget);
        const bool spoken = !widget->accessibleName().isEmpty() || (button && !button->text().isEmpty());
        if (control && ours)
            QVERIFY2(spoken, qPrintable(QLatin1String(widget->metaObject()->className()) + widget->objectName()));
    }
}

void TestTunePage::nothingIsCutAtTwiceTheFont()
{
    const QFont before = QApplication::font();
    QFont large = before;
    large.setPointSizeF(20);
    QApplication::setFont(large);
    applyTheme(*qApp, lightTheme(20));
    {
        TuneBench bench(lightTheme(20), {1800, 1200});
        auto *field = bench.find<QLineEdit>("P");
        field->setText(s("40000"));
        Q_EMIT field->textEdited(field->text());
        for (auto *button : bench.page->findChildren<QAbstractButton *>()) {
            if (button->text().startsWith(s("Limits of")) || button->text().startsWith(s("Drive options")))
                button->click();
        }
        QCoreApplication::processEvents();
        for (const auto *label : bench.page->findChildren<QWidget *>()) {
            const bool text = qobject_cast<const QAbstractButton *>(label)
                || (qobject_cast<const QLabel *>(label) && !label->inherits("mb::ElidedLabel"));
            if (!text || !label->isVisible())
                continue;
            const QByteArray name = label->property("text").toByteArray();
            QVERIFY2(label->width() >= label->minimumSizeHint().width(), name);
            QVERIFY2(label->height() >= label->minimumSizeHint().height(), name);
        }
        for (const char *name : {"P", "Set-point", "Range of the set-point, either way"}) {
            const auto *edit = bench.find<QLineEdit>(name);
            QVERIFY2(edit->width() > edit->fontMetrics().horizontalAdvance(s("100000")), name);
        }
    }
    QApplication::setFont(before);
    applyTheme(*qApp, lightTheme());
}

void TestTunePage::theLivePlotScrollsBeforeItsStripsLieOverEachOther()
{
    TuneBench bench;
    QScrollArea area; // as every page stands in one
    area.setWidgetResizable(true);
    area.setWidget(bench.page.get());
    area.resize(560, 260);
    area.show();
    for (int i = 0; i < 4; ++i)
        QCoreApplication::processEvents();
    const auto *const stack = bench.page->findChild<QWidget *>(QStringLiteral("tuneStack"));
    QVERIFY(stack->isVisible());
    QVERIFY2(stack->height() >= 200, qPrintable(QString::number(stack->height())));
    QVERIFY(area.verticalScrollBar()->maximum() > 0);
    const auto *const span = bench.find<QComboBox>("Length of the time axis");
    QVERIFY(span->width() >= span->sizeHint().width());
    area.resize(1208, 760);
    for (int i = 0; i < 4; ++i)
        QCoreApplication::processEvents();
    QCOMPARE(area.verticalScrollBar()->maximum(), 0);
    (void)area.takeWidget();
}

MB_WINDOW_TEST(TestTunePage);
#include "tst_tunepage.moc"
