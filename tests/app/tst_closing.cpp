// SPDX-License-Identifier: GPL-3.0-or-later
// Closing the window cuts nothing: it asks about an update, waits out what must not be cut, and sees a motor stop first.
#include "support/fakeworkbench.h"
#include "support/windowtests.h"
#include "windowbench.h"

#include "app/closing.h"
#include "widgets/plots/exportjob.h"

#include <QCloseEvent>
#include <QMessageBox>
#include <QPushButton>

#include <csignal>
#include <optional>

using namespace mb;
using namespace mb::test;

Q_DECLARE_METATYPE(mb::OperationKind)
Q_DECLARE_METATYPE(mb::StopState)

class ClosingTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aWindowWithNothingToLoseClosesAtOnce();
    void anUpdateIsNotAbandonedWithoutAQuestion();
    void cancellingTheUpdateClosesOnceItHasEnded();
    void whatMustNotBeCutIsWaitedOut();
    void anUpdateThatEndsTakesItsQuestionAway();
    void aQueueIsNotAbandonedWithoutAQuestion();
    void anExportIsNotAbandonedWithoutAQuestion();
    void aMotorIsSeenStoppedBeforeTheWindowGoes();
    void aMotorThatDoesNotStopIsAskedAbout();
    void aMotorThatWasToldToStopBeforeIsAskedAboutToo_data();
    void aMotorThatWasToldToStopBeforeIsAskedAboutToo();
    void anEngineThatTellsNothingMoreDoesNotKeepTheWindowOpen();
    void anExperimentPutsBackWhatItChangedBeforeTheWindowGoes();
    void anExperimentThatDoesNotEndLeavesItsGainsOwed();
    void whatWritesToAUnitEndsBeforeTheWindowGoes_data();
    void whatWritesToAUnitEndsBeforeTheWindowGoes();
    void whatOnlyLooksAtAUnitHoldsNothingUp();
    void whoeverEndsTheProgramIsNotAskedAboutAnUpdate();
    void whoeverEndsTheProgramIsNotAskedAboutAQueue();
    void aQuestionThatStandsIsAnsweredByTheEndOfTheProgram();
    void theEndOfTheProgramNamesTheMotorThatWasNotSeenToStop();
    void theWindowStaysWhileTheBenchIsUpdated();
    void aSignalEndsATuningAsClosingDoes_data();
    void aSignalEndsATuningAsClosingDoes();
};

namespace {

class ClosingWindow : public QWidget {
public:
    ClosingWindow()
    {
        device.id = {1};
        device.family = findFamily(families(), "dmc60c");
        device.identity.edit().address = 5;
        device.link = "sim:can";
        device.liveness.heard = true;
        workbench.shot.devices.push_back(device);
        show();
    }
    [[nodiscard]] DeviceView &unit() { return workbench.device(0); }
    [[nodiscard]] OperationStatus &update() { return workbench.shot.operations.front().status; }
    void writing(bool mayInterrupt = true)
    {
        OperationView operation;
        operation.id = {3};
        operation.device = {1};
        operation.status.title = say("Update firmware");
        operation.status.kind = OperationKind::UpdateFirmware;
        operation.status.mayInterrupt = mayInterrupt;
        workbench.shot.operations = {operation};
        workbench.publish();
    }
    void working(OperationKind kind)
    {
        OperationView operation;
        operation.id = {4};
        operation.device = {1};
        operation.status.kind = kind;
        workbench.shot.operations = {operation};
        workbench.publish();
    }
    void moving()
    {
        unit().motion.running = true;
        workbench.publish();
    }
    /// As every motor that was told to stop, until it is seen to.
    void stopping()
    {
        unit().motion.running = false;
        unit().stop = StopState::Stopping;
        unit().stopsMotion = true;
        workbench.publish();
    }
    [[nodiscard]] QMessageBox *question() const
    {
        for (auto *box : findChildren<QMessageBox *>()) {
            if (box->isVisible())
                return box;
        }
        return nullptr;
    }
    void answer(const QString &text)
    {
        const auto buttons = question()->buttons();
        const auto found = std::find_if(
            buttons.begin(), buttons.end(), [&](const QAbstractButton *button) { return button->text() == text; });
        QVERIFY2(found != buttons.end(), qPrintable(text));
        (*found)->click();
    }

    FakeWorkbench workbench;
    DeviceView device;
    Arming arming{workbench};
    Closing closing{workbench, arming, *this};

protected:
    void closeEvent(QCloseEvent *event) override { event->setAccepted(closing.mayClose()); }
};

} // namespace

void ClosingTest::aWindowWithNothingToLoseClosesAtOnce()
{
    ClosingWindow window;
    QVERIFY(window.close());
    QVERIFY(!window.question());
}

void ClosingTest::anUpdateIsNotAbandonedWithoutAQuestion()
{
    ClosingWindow window;
    window.writing();
    QVERIFY(!window.close());
    QVERIFY(window.isVisible());
    QVERIFY(window.question());
    QVERIFY(window.question()->text().contains(QStringLiteral("DMC60C #5 on sim:can")));
    window.answer(QStringLiteral("Keep open"));
    window.workbench.publish();
    QVERIFY(window.isVisible());
    QVERIFY(window.workbench.given<orders::CancelOperation>().empty());
    QVERIFY(!window.close()); // and is asked about again
}

void ClosingTest::cancellingTheUpdateClosesOnceItHasEnded()
{
    ClosingWindow window;
    window.writing();
    QVERIFY(!window.close());
    window.answer(QStringLiteral("Cancel the update and close"));
    QCOMPARE(window.workbench.given<orders::CancelOperation>().at(0).operation.value, 3U);
    QVERIFY(window.isVisible());
    window.update().state = OperationStatus::State::Cancelled;
    window.workbench.publish();
    QVERIFY(!window.isVisible());
}

void ClosingTest::whatMustNotBeCutIsWaitedOut()
{
    ClosingWindow window;
    window.writing(false);
    QVERIFY(!window.close());
    QVERIFY(window.question()->informativeText().contains(QStringLiteral("must not be cut")));
    window.answer(QStringLiteral("Cancel the update and close"));
    window.workbench.publish();
    QVERIFY(window.workbench.given<orders::CancelOperation>().empty());
    QVERIFY(window.isVisible());
    window.update().state = OperationStatus::State::Done;
    window.workbench.publish();
    QVERIFY(!window.isVisible());
}

void ClosingTest::anUpdateThatEndsTakesItsQuestionAway()
{
    ClosingWindow window;
    window.writing();
    QVERIFY(!window.close());
    window.update().state = OperationStatus::State::Done;
    window.workbench.publish();
    QTRY_VERIFY(!window.question());
    QVERIFY(window.isVisible()); // nobody said that it should go
    QVERIFY(window.close());
}

void ClosingTest::aQueueIsNotAbandonedWithoutAQuestion()
{
    ClosingWindow window;
    service::QueueRow row;
    row.state = service::RowState::Running;
    row.mayInterrupt = false;
    window.workbench.serve({row});
    QVERIFY(!window.close());
    QVERIFY(window.question()->text().contains(QStringLiteral("Units are being served")));
    QVERIFY(window.question()->informativeText().contains(QStringLiteral("must not be cut")));
    window.answer(QStringLiteral("Cancel the queue and close"));
    QCOMPARE(window.workbench.given<orders::CancelService>().size(), 1U);
    window.workbench.publish();
    QVERIFY(window.isVisible()); // until the unit may be left
    window.workbench.serve({row}, false);
    QVERIFY(!window.isVisible());
}

void ClosingTest::anExportIsNotAbandonedWithoutAQuestion()
{
    ClosingWindow window;
    ExportJob job(&window);
    QVERIFY(job.start(
        [](const ExportProgress &progress) -> Result<ExportReport> {
            while (progress(0.5)) { }
            return fail(Fault::Cancelled, say("cancelled"));
        },
        QStringLiteral("samples.mcap")));
    QVERIFY(!window.close());
    QVERIFY(window.question()->text().contains(QStringLiteral("samples.mcap")));
    window.answer(QStringLiteral("Keep open"));
    QVERIFY(job.isRunning());
    QVERIFY(!window.close());
    window.answer(QStringLiteral("Cancel the export and close"));
    QTRY_VERIFY(!window.isVisible());
    QVERIFY(!job.isRunning());
}

void ClosingTest::aMotorIsSeenStoppedBeforeTheWindowGoes()
{
    ClosingWindow window;
    window.moving();
    QVERIFY(!window.close());
    QVERIFY(!window.question());
    QCOMPARE(window.workbench.given<orders::StopMotion>().size(), 1U);
    window.stopping();
    QVERIFY(window.isVisible()); // told to stop, and not seen to
    window.unit().stop = StopState::Seen;
    window.unit().stopsMotion = false;
    window.workbench.publish();
    QVERIFY(!window.isVisible());
}

void ClosingTest::aMotorThatDoesNotStopIsAskedAbout()
{
    ClosingWindow window;
    window.moving();
    QVERIFY(!window.close());
    window.workbench.time += Closing::patience;
    window.stopping();
    QVERIFY(!window.question());
    window.workbench.time += std::chrono::milliseconds(100);
    window.workbench.publish();
    QVERIFY(window.question()->text().contains(QStringLiteral("DMC60C #5 has not been seen to stop")));
    window.answer(QStringLiteral("Close anyway"));
    QVERIFY(!window.isVisible());
}

void ClosingTest::aMotorThatWasToldToStopBeforeIsAskedAboutToo_data()
{
    QTest::addColumn<StopState>("stop");
    QTest::addColumn<bool>("listed");
    QTest::newRow("it runs out") << StopState::Stopping << true;
    QTest::newRow("it does not confirm") << StopState::Unconfirmed << true;
    QTest::newRow("its cable came out") << StopState::Owed << true;
    QTest::newRow("its link is closed") << StopState::Owed << false;
    QTest::newRow("its watchdog has stopped it") << StopState::ByWatchdog << true;
}

void ClosingTest::aMotorThatWasToldToStopBeforeIsAskedAboutToo()
{
    QFETCH(const StopState, stop);
    QFETCH(const bool, listed);
    for (const bool byHand : {true, false}) {
        ClosingWindow window;
        window.stopping();
        window.unit().stop = stop;
        if (!listed) {
            window.workbench.shot.devices.clear();
            window.workbench.shot.owedStops.push_back({"sim:can/dmc60c:5", false});
        }
        byHand ? static_cast<void>(window.close()) : window.closing.end();
        QCOMPARE(window.isVisible(), stop != StopState::ByWatchdog);
        if (stop == StopState::ByWatchdog)
            continue;
        window.workbench.time += Closing::patience + std::chrono::milliseconds(100);
        window.workbench.publish();
        QCOMPARE(window.isVisible(), byHand);
        QCOMPARE(window.question() != nullptr, byHand);
        QCOMPARE(window.closing.unstopped().isEmpty(), byHand);
    }
}

void ClosingTest::anEngineThatTellsNothingMoreDoesNotKeepTheWindowOpen()
{
    ClosingWindow window;
    window.moving();
    QVERIFY(!window.close());
    window.workbench.time += Closing::patience + std::chrono::milliseconds(100);
    QTRY_VERIFY(window.question());
    window.answer(QStringLiteral("Close anyway"));
    QVERIFY(!window.isVisible());
}

void ClosingTest::anExperimentPutsBackWhatItChangedBeforeTheWindowGoes()
{
    ClosingWindow window;
    window.working(OperationKind::Trial); // between two motions
    QVERIFY(!window.close());
    QVERIFY(!window.question());
    QCOMPARE(window.workbench.given<orders::CancelOperation>().size(), 1U);
    window.workbench.time += Closing::patience + std::chrono::milliseconds(100);
    window.workbench.publish();
    QVERIFY(window.isVisible());
    window.update().state = OperationStatus::State::Done;
    window.workbench.publish();
    QVERIFY(!window.isVisible());
}

void ClosingTest::anExperimentThatDoesNotEndLeavesItsGainsOwed()
{
    ClosingWindow window;
    window.working(OperationKind::Trial);
    QVERIFY(!window.close());
    window.workbench.time += Closing::longestJob + std::chrono::milliseconds(100);
    window.workbench.publish();
    QVERIFY(!window.isVisible());
}

void ClosingTest::whatWritesToAUnitEndsBeforeTheWindowGoes_data()
{
    QTest::addColumn<OperationKind>("kind");
    QTest::newRow("a write, a number, a store") << OperationKind::Other;
    QTest::newRow("settings that are written again") << OperationKind::RewriteSettings;
    QTest::newRow("an experiment of the family") << OperationKind::FamilyExperiment;
}

void ClosingTest::whatWritesToAUnitEndsBeforeTheWindowGoes()
{
    QFETCH(const OperationKind, kind);
    for (const bool byHand : {true, false}) {
        ClosingWindow window;
        window.working(kind);
        byHand ? static_cast<void>(window.close()) : window.closing.end();
        QVERIFY(window.isVisible());
        QVERIFY(!window.question());
        QCOMPARE(window.workbench.given<orders::CancelOperation>().size(),
            kind == OperationKind::FamilyExperiment ? 1U : 0U);
        window.update().state = OperationStatus::State::Done;
        window.workbench.publish();
        QVERIFY(!window.isVisible());
    }
}

void ClosingTest::whatOnlyLooksAtAUnitHoldsNothingUp()
{
    for (const OperationKind kind : {OperationKind::Look, OperationKind::ReadParameters}) {
        ClosingWindow window;
        window.working(kind);
        QVERIFY(window.close());
    }
}

void ClosingTest::whoeverEndsTheProgramIsNotAskedAboutAnUpdate()
{
    ClosingWindow window;
    window.writing(false);
    window.closing.end();
    QVERIFY(!window.question());
    QVERIFY(window.isVisible());
    QVERIFY(window.workbench.given<orders::CancelOperation>().empty()); // it must not be cut
    window.update().mayInterrupt = true;
    window.workbench.publish();
    QCOMPARE(window.workbench.given<orders::CancelOperation>().size(), 1U);
    window.update().state = OperationStatus::State::Cancelled;
    window.workbench.publish();
    QVERIFY(!window.isVisible());
    QVERIFY(window.closing.unstopped().isEmpty());
}

void ClosingTest::whoeverEndsTheProgramIsNotAskedAboutAQueue()
{
    ClosingWindow window;
    window.workbench.serve({service::QueueRow()});
    window.closing.end();
    QVERIFY(!window.question());
    QCOMPARE(window.workbench.given<orders::CancelService>().size(), 1U);
    QVERIFY(window.isVisible());
    window.workbench.serve({}, false);
    QVERIFY(!window.isVisible());
}

void ClosingTest::aQuestionThatStandsIsAnsweredByTheEndOfTheProgram()
{
    ClosingWindow window;
    window.writing();
    QVERIFY(!window.close());
    QVERIFY(window.question());
    window.closing.end();
    QVERIFY(!window.question());
    QCOMPARE(window.workbench.given<orders::CancelOperation>().size(), 1U);
    window.update().state = OperationStatus::State::Cancelled;
    window.workbench.publish();
    QVERIFY(!window.isVisible());
}

void ClosingTest::theEndOfTheProgramNamesTheMotorThatWasNotSeenToStop()
{
    ClosingWindow window;
    window.moving();
    window.closing.end();
    QCOMPARE(window.workbench.given<orders::StopMotion>().size(), 1U);
    window.workbench.time += Closing::patience + std::chrono::milliseconds(100);
    window.stopping();
    QVERIFY(!window.question());
    QVERIFY(!window.isVisible());
    QCOMPARE(window.closing.unstopped(), QStringList{QStringLiteral("DMC60C #5")});
}

void ClosingTest::theWindowStaysWhileTheBenchIsUpdated()
{
    WindowBench bench;
    bench.beginUpdate();
    const DeviceId id = bench.device(WindowBench::inBootloader)->id;
    const auto update = [&bench, id] { return bench.engine().snapshot().operation(id); };
    QTRY_VERIFY_WITH_TIMEOUT(update() && update()->status.done > 1, patience);
    QVERIFY(!bench.window().close());
    QVERIFY(bench.window().isVisible());
    auto *box = bench.window().findChild<QMessageBox *>();
    QVERIFY(box && box->isVisible());
    const auto buttons = box->buttons();
    for (QAbstractButton *button : buttons) {
        if (button->text() == QStringLiteral("Cancel the update and close"))
            button->click();
    }
    QTRY_VERIFY_WITH_TIMEOUT(!bench.window().isVisible(), patience);
    QVERIFY(update()->status.state == OperationStatus::State::Cancelled);
}

void ClosingTest::aSignalEndsATuningAsClosingDoes_data()
{
    QTest::addColumn<int>("number");
    QTest::newRow("closed by hand") << 0;
    QTest::newRow("SIGINT") << SIGINT;
    QTest::newRow("SIGTERM") << SIGTERM;
    QTest::newRow("SIGHUP") << SIGHUP;
}

void ClosingTest::aSignalEndsATuningAsClosingDoes()
{
    QFETCH(int, number);
    if (number != 0)
        std::signal(number, SIG_DFL); // as in a program that is no test
    WindowBench bench;
    QTRY_VERIFY_WITH_TIMEOUT(bench.isFound() && bench.isRead(WindowBench::tuned), patience);
    bench.select(WindowBench::tuned);
    const auto gain = [&bench] { return *bench.parameter(WindowBench::tuned, "slot1.p").raw; };
    const std::int64_t before = gain();
    bench.arming().arm(bench.device(WindowBench::tuned)->id);
    std::optional<Result<tuning::TuneReport>> ended;
    bench.arming().runTuning({}, [&ended](const Result<tuning::TuneReport> &report) { ended = report; });
    QTRY_VERIFY_WITH_TIMEOUT(gain() != before || ended, 2 * patience); // it proves what it has found
    QVERIFY(!ended);
    number != 0 ? static_cast<void>(std::raise(number)) : static_cast<void>(bench.window().close());
    QTRY_VERIFY_WITH_TIMEOUT(!bench.window().isVisible(), patience);
    QVERIFY(!bench.isOutputOn());
    QVERIFY(ended);
    QCOMPARE(gain(), before);
    QVERIFY(bench.window().closing().unstopped().isEmpty());
}

MB_WINDOW_TEST(ClosingTest);
#include "tst_closing.moc"
