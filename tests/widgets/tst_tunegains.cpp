// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/windowtests.h"
#include "tunehand.h"
#include "widgets/common/iconbutton.h"
#include "widgets/control/gainspanel.h"

#include <QSlider>

using namespace mb;
using namespace mb::test;

class TestTuneGains : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void anEditedGainGoesOutWithItsRawValue();
    void gainsGoOutInAnOrderThatIsNeverLivelier();
    void aGainOutOfRangeIsSaidAndNotWritten();
    void theSliderStagesAndRevertBringsBack();
    void editsOfAnotherSlotStayStaged();
    void writeAndRunWaitsForTheGains();
    void gainsThatWereNotWrittenStartNothing();
    void disarmedDuringTheWriteStartsNothing();
};

void TestTuneGains::anEditedGainGoesOutWithItsRawValue()
{
    TuneBench bench;
    QVERIFY(!bench.find<QAbstractButton>("Write gains")
        || !bench.page->findChild<CommandButton *>(s("writeGains"))->isEnabled());
    type(bench.find<QLineEdit>("P"), "1,2531");
    auto *button = bench.page->findChild<CommandButton *>(s("writeGains"));
    QCOMPARE(button->text(), s("Write P to slot 0"));
    QVERIFY(button->isEnabled());
    button->click();
    const auto writes = bench.workbench.given<orders::WriteParameters>();
    QCOMPARE(writes.size(), 1U);
    QCOMPARE(writes[0].changes.size(), 1U);
    QCOMPARE(writes[0].changes[0].index.value, named("slot0.p").value);
    QCOMPARE(writes[0].changes[0].raw, 82123);
    writes[0].finished({});
    bench.device().parameters.edit()[named("slot0.p").value] = {82123, ParameterState::Ram};
    ++bench.device().parameterRevision;
    bench.workbench.publish();
    QVERIFY(!button->isEnabled());
    QVERIFY(bench.workbench.given<orders::StartMotion>().empty());
}

void TestTuneGains::gainsGoOutInAnOrderThatIsNeverLivelier()
{
    TuneBench bench;
    type(bench.find<QLineEdit>("I"), "0.01");
    type(bench.find<QLineEdit>("P"), "0.5");
    type(bench.find<QLineEdit>("D"), "3");
    bench.page->write();
    const auto writes = bench.workbench.given<orders::WriteParameters>();
    QCOMPARE(writes.size(), 1U);
    QCOMPARE(writes[0].changes.size(), 3U);
    QCOMPARE(writes[0].changes[0].index.value, named("slot0.p").value); // lowered: first
    QCOMPARE(writes[0].changes[1].index.value, named("slot0.d").value);
    QCOMPARE(writes[0].changes[2].index.value, named("slot0.i").value); // raised: last
}

void TestTuneGains::aGainOutOfRangeIsSaidAndNotWritten()
{
    TuneBench bench;
    bench.arm();
    type(bench.find<QLineEdit>("P"), "40000");
    QVERIFY(!bench.page->findChild<CommandButton *>(s("writeGains"))->isEnabled());
    QVERIFY(!bench.page->status().mayRun);
    bench.page->write();
    bench.page->run();
    QVERIFY(bench.workbench.given<orders::WriteParameters>().empty());
    QVERIFY(bench.workbench.given<orders::StartMotion>().empty());
}

void TestTuneGains::theSliderStagesAndRevertBringsBack()
{
    TuneBench bench;
    auto *slider = bench.find<QSlider>("P, one decade either way");
    slider->setFocus();
    QTest::keyClick(slider, Qt::Key_Right);
    const double raised = *bench.page->column().gainsPanel().row(Role::Proportional)->number();
    QVERIFY(std::abs(raised / 1.165 - 1.02) < 1e-3);
    QTest::keyClick(slider, Qt::Key_Left, Qt::ShiftModifier);
    QVERIFY(
        std::abs(*bench.page->column().gainsPanel().row(Role::Proportional)->number() / 1.165 - 1.02 / 1.002) < 1e-3);
    click(bench, "Revert P");
    QCOMPARE(*bench.page->column().gainsPanel().row(Role::Proportional)->number(),
        static_cast<double>(rawOf("slot0.p", 1.165)) / 65536.0);
    QVERIFY(bench.page->column().gainsPanel().toWrite().empty());
}

void TestTuneGains::editsOfAnotherSlotStayStaged()
{
    TuneBench bench;
    type(bench.find<QLineEdit>("P"), "2");
    slot(bench, "Gain slot, edit and run", 1)->click();
    QVERIFY(bench.page->column().gainsPanel().toWrite().empty());
    QCOMPARE(*bench.page->column().gainsPanel().row(Role::FeedForward)->number(), 0.5);
    slot(bench, "Gain slot, edit and run", 0)->click();
    QCOMPARE(*bench.page->column().gainsPanel().row(Role::Proportional)->number(), 2.0);
}

void TestTuneGains::writeAndRunWaitsForTheGains()
{
    TuneBench bench;
    bench.arm();
    type(bench.find<QLineEdit>("P"), "2");
    auto *run = bench.page->findChild<CommandButton *>(s("run"));
    QCOMPARE(run->text(), s("Write and run"));
    run->click();
    QCOMPARE(bench.workbench.given<orders::WriteParameters>().size(), 1U);
    QVERIFY(bench.workbench.given<orders::StartMotion>().empty());
    QVERIFY(!run->isEnabled());
    bench.workbench.given<orders::WriteParameters>().at(0).finished({});
    QCOMPARE(bench.workbench.given<orders::StartMotion>().size(), 1U);
}

void TestTuneGains::gainsThatWereNotWrittenStartNothing()
{
    TuneBench bench;
    bench.arm();
    type(bench.find<QLineEdit>("P"), "2");
    bench.page->run();
    bench.workbench.given<orders::WriteParameters>().at(0).finished(fail(Fault::BadCheck, say("slot0.p reads 1")));
    QVERIFY(bench.workbench.given<orders::StartMotion>().empty());
    QVERIFY(bench.workbench.lines.back().text.contains(QLatin1String("slot0.p reads 1")));
    QCOMPARE(bench.page->column().gainsPanel().stagedNames(), QStringList{s("P")});
}

void TestTuneGains::disarmedDuringTheWriteStartsNothing()
{
    TuneBench bench;
    bench.arm();
    type(bench.find<QLineEdit>("P"), "2");
    bench.page->run();
    bench.arming.stopAll(s("test"));
    bench.workbench.given<orders::WriteParameters>().at(0).finished({});
    QVERIFY(bench.workbench.given<orders::StartMotion>().empty());
    QVERIFY2(problemOf(bench).startsWith(s("Stopped: test")), qPrintable(problemOf(bench)));
}

MB_WINDOW_TEST(TestTuneGains);
#include "tst_tunegains.moc"
