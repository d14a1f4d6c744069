// SPDX-License-Identifier: GPL-3.0-or-later
// The recorder and the replay of the Bus page, against a workbench that only notes what it is told.
#include "busbench.h"
#include "support/windowtests.h"
#include "widgets/common/applytheme.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/numberformat.h"
#include "widgets/common/replaybar.h"
#include "widgets/connection/deviceactions.h"
#include "widgets/monitor/buspage.h"
#include "widgets/monitor/recordstrip.h"

#include <QComboBox>
#include <QFileDialog>
#include <QSlider>

using namespace mb;
using namespace mb::test;

namespace {

/// The Bus page over a simulated link and a recording.
struct RecordingBench {
    FakeTraffic traffic;
    FakeWorkbench workbench;
    ThemeSource theme{darkTheme()};
    Arming arming{workbench};
    std::unique_ptr<BusPage> page;

    RecordingBench()
    {
        applyTheme(*qApp, theme.theme());
        LinkView replay = canLink(std::make_shared<TrafficLog>());
        replay.address = "replay:/logs/run.log";
        replay.name = "run.log";
        replay.simulated = false;
        replay.replay = ReplayState{};
        replay.replay->length = 90s;
        replay.replay->surveyed = 1.0;
        workbench.shot.links = {canLink(traffic.log), replay};
        page = std::make_unique<BusPage>(workbench, arming, theme);
        page->resize(1280, 760);
        page->show();
        workbench.publish();
    }
    [[nodiscard]] LinkView &live() { return workbench.shot.links[0]; }
    [[nodiscard]] ReplayState &replay() { return *workbench.shot.links[1].replay; }
    [[nodiscard]] RecordStrip &strip() const { return page->recordStrip(); }
    [[nodiscard]] ReplayBar &bar() const { return *page->findChild<ReplayBar *>(); }
    [[nodiscard]] CommandButton &play() const { return *bar().findChild<CommandButton *>(); }
    [[nodiscard]] QSlider &position() const { return *bar().findChild<QSlider *>(); }
    [[nodiscard]] QComboBox &speed() const { return *bar().findChild<QComboBox *>(); }
    void record(std::uint64_t frames, std::uint64_t lost)
    {
        RecordingState recording;
        recording.path = "/logs/live.log";
        recording.since = workbench.time;
        recording.frames = frames;
        recording.bytes = frames * 40;
        recording.lost = lost;
        live().recording = recording;
        workbench.time += 72s;
        workbench.publish();
    }
    void showReplay()
    {
        page->showLink("replay:/logs/run.log");
        workbench.publish();
    }
    [[nodiscard]] std::vector<ReplayOrder> orders() const
    {
        std::vector<ReplayOrder> given;
        for (const auto &call : workbench.given<orders::SteerReplay>())
            given.push_back(call.order);
        return given;
    }
};

QString textOf(const QWidget &widget)
{
    QString text;
    for (const QLabel *label : widget.findChildren<QLabel *>())
        text += label->text() + QLatin1Char('\n');
    return text;
}

} // namespace

class RecordingTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void theButtonAsksForAFile();
    void aRunningRecordingShowsTimeFramesAndLoss();
    void theButtonEndsARecording();
    void aRefusalIsReportedOnce();
    void aRecordingThatFailedSaysWhyUntilItWasRead();
    void aReplayIsNotRecordedAndHasATransportBar();
    void everyControlSpeaksAndIsReachedByKeys();
    void playPauseAndPlayAgain();
    void speedsAreOrderedAndShown();
    void thePositionIsSoughtOnceTheHandLetsGo();
    void keysSeekAtOnce();
    void nothingIsSteeredBeforeTheRecordingIsKnown();
    void aRecordingIsOpenedAsALink();
    void aNameThatNoAddressCanHoldIsRefused();
};

void RecordingTest::theButtonAsksForAFile()
{
    RecordingBench bench;
    QVERIFY(bench.strip().button().isVisible());
    QVERIFY(!bench.strip().isVisible());
    QTest::mouseClick(&bench.strip().button(), Qt::LeftButton);
    auto *dialog = bench.page->findChild<QFileDialog *>();
    QVERIFY(dialog);
    QCOMPARE(dialog->acceptMode(), QFileDialog::AcceptSave);
    QCOMPARE(dialog->nameFilters().size(), 2);
    QVERIFY(bench.workbench.given<orders::StartRecording>().empty());
    Q_EMIT dialog->fileSelected(QStringLiteral("/logs/live.asc"));
    const auto calls = bench.workbench.given<orders::StartRecording>();
    QCOMPARE(calls.size(), std::size_t{1});
    QCOMPARE(calls[0].link, std::string("sim:can"));
    QCOMPARE(calls[0].path, std::string("/logs/live.asc"));
    dialog->reject();
}

void RecordingTest::aRunningRecordingShowsTimeFramesAndLoss()
{
    RecordingBench bench;
    bench.record(1204, 0);
    QVERIFY(bench.strip().isVisible());
    QString text = textOf(bench.strip());
    QVERIFY2(text.contains(QStringLiteral("1:12")), qPrintable(text));
    QVERIFY2(text.contains(formatCount(1204) + QStringLiteral(" frames")), qPrintable(text));
    QVERIFY2(text.contains(formatBytes(1204 * 40)), qPrintable(text));
    QVERIFY2(text.contains(QStringLiteral("0 lost")), qPrintable(text));
    QVERIFY2(text.contains(QStringLiteral("live.log")), qPrintable(text));
    bench.record(1300, 7);
    text = textOf(bench.strip());
    QVERIFY2(text.contains(QStringLiteral("7 lost")), qPrintable(text));
}

void RecordingTest::theButtonEndsARecording()
{
    RecordingBench bench;
    bench.record(10, 0);
    QTest::mouseClick(&bench.strip().button(), Qt::LeftButton);
    QCOMPARE(bench.workbench.given<orders::StopRecording>().size(), std::size_t{1});
    QVERIFY(!bench.page->findChild<QFileDialog *>());
    bench.live().recording->finished = true;
    bench.workbench.publish();
    QVERIFY(!bench.strip().isVisible());
}

void RecordingTest::aRefusalIsReportedOnce()
{
    RecordingBench bench;
    bench.strip().recordTo(QStringLiteral("/nowhere/a.log"));
    bench.workbench.given<orders::StartRecording>().front().finished(
        fail(Fault::LinkLost, say("no permission to write there")));
    QCOMPARE(bench.workbench.lines.size(), std::size_t{1});
    QVERIFY(bench.workbench.lines[0].severity == Severity::Danger);
    QVERIFY(bench.workbench.lines[0].text.contains(QStringLiteral("no permission to write there")));
    QVERIFY(!bench.strip().isVisible());
}

void RecordingTest::aRecordingThatFailedSaysWhyUntilItWasRead()
{
    RecordingBench bench;
    bench.record(500, 20);
    bench.live().recording->problem = say("/logs/live.log: no space left on the disk");
    bench.workbench.publish();
    QVERIFY(bench.strip().isVisible());
    QVERIFY(textOf(bench.strip()).contains(QStringLiteral("no space left")));
    auto *dismiss = bench.strip().findChild<QPushButton *>();
    for (QPushButton *button : bench.strip().findChildren<QPushButton *>()) {
        if (button->text() == QStringLiteral("Dismiss"))
            dismiss = button;
    }
    QTest::mouseClick(dismiss, Qt::LeftButton);
    bench.workbench.publish();
    QVERIFY(!bench.strip().isVisible());
    QCOMPARE(bench.strip().button().text(), QStringLiteral("Record…"));
}

void RecordingTest::aReplayIsNotRecordedAndHasATransportBar()
{
    RecordingBench bench;
    QVERIFY(!bench.bar().isVisible());
    bench.showReplay();
    QVERIFY(bench.bar().isVisible());
    QVERIFY(!bench.strip().button().isVisible());
    QVERIFY2(textOf(bench.bar()).contains(QStringLiteral("0:00.0 of 1:30.0")), qPrintable(textOf(bench.bar())));
    QVERIFY(textOf(bench.bar()).contains(QStringLiteral("REPLAY")));
}

void RecordingTest::everyControlSpeaksAndIsReachedByKeys()
{
    RecordingBench bench;
    bench.showReplay();
    QVERIFY(!bench.position().accessibleName().isEmpty() && !bench.speed().accessibleName().isEmpty());
    for (const QWidget *control :
        std::initializer_list<const QWidget *>{&bench.play(), &bench.position(), &bench.speed()}) {
        QVERIFY2(!control->toolTip().isEmpty(), qPrintable(control->accessibleName()));
        QVERIFY2((control->focusPolicy() & Qt::TabFocus) != 0, qPrintable(control->accessibleName()));
    }
    bench.play().setFocus();
    QTest::keyClick(&bench.play(), Qt::Key_Space);
    QVERIFY(bench.orders().back().run == true);
}

void RecordingTest::playPauseAndPlayAgain()
{
    RecordingBench bench;
    bench.showReplay();
    QTest::mouseClick(&bench.play(), Qt::LeftButton);
    bench.replay().running = true;
    bench.workbench.publish();
    QCOMPARE(bench.play().text(), QStringLiteral("Pause"));
    QTest::mouseClick(&bench.play(), Qt::LeftButton);
    bench.replay().running = false;
    bench.replay().ended = true;
    bench.replay().position = 90s;
    bench.workbench.publish();
    QCOMPARE(bench.play().text(), QStringLiteral("Play again"));
    QTest::mouseClick(&bench.play(), Qt::LeftButton);
    const auto orders = bench.orders();
    QCOMPARE(orders.size(), std::size_t{3});
    QVERIFY(orders[0].run == true && !orders[0].position);
    QVERIFY(orders[1].run == false && !orders[1].position);
    QVERIFY(orders[2].run == true && orders[2].position == Duration::zero());
}

void RecordingTest::speedsAreOrderedAndShown()
{
    RecordingBench bench;
    bench.showReplay();
    QCOMPARE(bench.speed().currentData().toDouble(), 1.0);
    bench.replay().pace = 3.0; // as the address says
    bench.workbench.publish();
    QCOMPARE(bench.speed().currentData().toDouble(), 3.0);
    const int fastest = bench.speed().findData(0.0);
    QVERIFY(fastest >= 0);
    Q_EMIT bench.speed().activated(fastest);
    QVERIFY(bench.orders().back().pace == 0.0 && !bench.orders().back().run);
}

void RecordingTest::thePositionIsSoughtOnceTheHandLetsGo()
{
    RecordingBench bench;
    bench.showReplay();
    bench.position().setSliderDown(true);
    bench.position().setValue(45000);
    QVERIFY(bench.orders().empty());
    QVERIFY(textOf(bench.bar()).contains(QStringLiteral("0:45.0 of")));
    bench.workbench.publish(); // does not pull it away
    QCOMPARE(bench.position().value(), 45000);
    bench.position().setSliderDown(false);
    QCOMPARE(bench.orders().size(), std::size_t{1});
    QVERIFY(bench.orders()[0].position == Duration(45s));
}

void RecordingTest::keysSeekAtOnce()
{
    RecordingBench bench;
    bench.showReplay();
    QTest::keyClick(&bench.position(), Qt::Key_PageUp);
    QVERIFY(bench.orders().back().position == Duration(10s));
}

void RecordingTest::nothingIsSteeredBeforeTheRecordingIsKnown()
{
    RecordingBench bench;
    bench.replay().surveyed = 0.4;
    bench.showReplay();
    QVERIFY(!bench.play().isEnabled());
    QVERIFY(!bench.position().isEnabled());
    QVERIFY2(textOf(bench.bar()).contains(QStringLiteral("40 %")), qPrintable(textOf(bench.bar())));
}

void RecordingTest::aRecordingIsOpenedAsALink()
{
    RecordingBench bench;
    QString opened;
    openRecording(
        bench.workbench, QStringLiteral("/logs/a run.log"), [&opened](const QString &address) { opened = address; });
    const auto calls = bench.workbench.given<orders::OpenLink>();
    QCOMPARE(calls.size(), std::size_t{1});
    QCOMPARE(calls[0].address.text(), std::string("replay:/logs/a run.log"));
    calls[0].finished({});
    QCOMPARE(opened, QStringLiteral("replay:/logs/a run.log"));
}

void RecordingTest::aNameThatNoAddressCanHoldIsRefused()
{
    RecordingBench bench;
    openRecording(bench.workbench, QStringLiteral("/logs/what?.log"), {});
    QVERIFY(bench.workbench.given<orders::OpenLink>().empty());
    QCOMPARE(bench.workbench.lines.size(), std::size_t{1});
    QVERIFY(bench.workbench.lines[0].text.contains(QStringLiteral("what?.log")));
}

MB_WINDOW_TEST(RecordingTest);
#include "tst_recording.moc"
