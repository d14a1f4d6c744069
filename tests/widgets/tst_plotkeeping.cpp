// SPDX-License-Identifier: GPL-3.0-or-later
#include "plotbench.h"
#include "support/fulldisk.h"
#include "support/windowtests.h"

#include <QDialog>
#include <QFileDialog>
#include <QMenu>
#include <QSet>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

using namespace mb;
using namespace mb::test;

class TestPlotKeeping : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void notesStandInThePlotAndInTheFile();
    void theWholeSessionIsExportedWithItsDevices();
    void anExportHasWhatWasSeenWhenItWasOrdered();
    void anExportCanBeCancelled();
    void theScrubberScrollsBackWhileRecording();
    void recordingBeginsBeforeItWasAskedFor();
    void whatIsKeptAndNotSavedIsWrittenWhenTheProgramEnds();
    void aFullDiskIsToldOnceAndNothingIsCalledWritten();
    void ordersDoNotPileUpWhileTheDiskHangs();
    void whatIsPlayedIsNotRecordedAgain();
    void whatIsKeptAndCannotBeSavedAtTheEndIsRecoveredAtTheNextStart();
    void recordingsOfOneSecondHaveNamesOfTheirOwn();
};

void TestPlotKeeping::notesStandInThePlotAndInTheFile()
{
    PlotBench bench;
    const QTemporaryDir folder;
    bench.pass(2.0, 60000.0);
    bench.board().addNote(1001.0, s("load pulse"));
    bench.board().addNote(1001.0, s("  "));
    QCOMPARE(bench.board().notes().size(), std::size_t{1});
    QSignalSpy wanted(&bench.stack().input(), &PlotInput::noteRequested);
    QTest::keyClick(&bench.stack(), Qt::Key_N);
    QCOMPARE(wanted.count(), 1);
    for (QWidget *dialog : QApplication::topLevelWidgets()) {
        if (dialog->windowTitle() == s("Note at this time"))
            dialog->close();
    }
    bench.page->exportBar().exportSamples({bench.stack().view().range(), false, folder.filePath(s("a.csv"))});
    QFile file(folder.filePath(s("a.csv")));
    QTRY_VERIFY(file.exists());
    QVERIFY(file.open(QIODevice::ReadOnly));
    QVERIFY(file.readAll().contains("load pulse"));
}

void TestPlotKeeping::theWholeSessionIsExportedWithItsDevices()
{
    PlotBench bench;
    const QTemporaryDir folder;
    bench.pass(3.0, 60000.0);
    bench.recording.telemetry()->lost(channel("velocity"), 9);
    bench.pass(1.0, 60000.0);
    bench.page->exportBar().exportSamples({std::nullopt, true, folder.filePath(s("a.mcap"))});
    QTRY_VERIFY(QFile::exists(folder.filePath(s("a.mcap"))));
    const auto loaded = loadRecording(folder.filePath(s("a.mcap")).toStdString());
    QVERIFY(loaded);
    const LoadedRecording &file = **loaded;
    QCOMPARE(file.table.size(), dmc60c().channels.size() * 2);
    QCOMPARE(file.about.at("device sim:can/dmc60c:5 2103343A79F2").at("name"), std::string("shooter"));
    QCOMPARE(
        file.about.at("parameters sim:can/dmc60c:5 2103343A79F2").at("slot0.p").substr(0, 5), std::string("1.165"));
    QCOMPARE(file.about.at("loss sim:can/dmc60c:5").at("velocity"), std::string("9 of 409"));
    QCOMPARE(file.telemetry->size({0}) > 0, true);
    QTRY_VERIFY(!bench.workbench.lines.empty());
    QTRY_VERIFY2(bench.workbench.lines.back().text.contains(s("lost")), qPrintable(bench.workbench.lines.back().text));
}

void TestPlotKeeping::anExportHasWhatWasSeenWhenItWasOrdered()
{
    PlotBench bench;
    const QTemporaryDir folder;
    bench.pass(12.0, 60000.0);
    QMenu menu;
    bench.page->fillExportMenu(menu);
    const auto order = [&menu](const char *entry) {
        for (QAction *action : menu.actions()) {
            if (action->text() == s(entry))
                action->trigger();
        }
    };
    const auto [from, to] = bench.stack().view().range();
    const QByteArray seen = bench.stack().exporter().contentAs(s("svg"));
    order("Export SVG…");
    auto *drawing = bench.page->findChild<QFileDialog *>();
    bench.pass(8.0, 0.0);
    Q_EMIT drawing->fileSelected(folder.filePath(s("a.svg")));
    QFile file(folder.filePath(s("a.svg")));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QVERIFY(file.readAll() == seen);
    QVERIFY(bench.stack().exporter().contentAs(s("svg")) != seen);
    delete drawing;

    bench.stack().view().setRange(from, to);
    order("Export samples…");
    auto *choice = bench.page->findChild<QDialog *>();
    bench.stack().view().setLive(true);
    bench.pass(8.0, 0.0);
    choice->accept();
    bench.pass(8.0, 0.0);
    Q_EMIT bench.page->findChild<QFileDialog *>()->fileSelected(folder.filePath(s("a.mcap")));
    QTRY_VERIFY(QFile::exists(folder.filePath(s("a.mcap"))));
    const auto loaded = loadRecording(folder.filePath(s("a.mcap")).toStdString());
    QVERIFY(loaded);
    QVERIFY(plotKey((*loaded)->first) >= from - 0.1 && plotKey((*loaded)->last) <= to + 0.1);
}

void TestPlotKeeping::anExportCanBeCancelled()
{
    PlotBench bench;
    const QTemporaryDir folder;
    for (int i = 0; i < 400'000; ++i)
        bench.recording.telemetry()->append({channel("velocity"), bench.workbench.time + i * 1ms, 1.0});
    bench.recording.telemetry()->commit();
    bench.workbench.time += 400s;
    bench.page->exportBar().exportSamples({std::nullopt, false, folder.filePath(s("a.csv"))});
    for (QPushButton *button : bench.page->findChildren<QPushButton *>()) {
        if (button->text() == s("Cancel"))
            button->click();
    }
    QTRY_VERIFY(!bench.workbench.lines.empty() && bench.workbench.lines.back().text.contains(s("cancelled")));
    QVERIFY(!QFile::exists(folder.filePath(s("a.csv"))));
    QVERIFY(!QFile::exists(folder.filePath(s("a.csv.part"))));
}

void TestPlotKeeping::theScrubberScrollsBackWhileRecording()
{
    PlotBench bench;
    bench.pass(120.0, 60000.0);
    auto *scrubber = bench.page->findChild<PlotScrubber *>();
    QTest::mouseClick(scrubber, Qt::RightButton, Qt::NoModifier, QPoint(scrubber->width() / 2, scrubber->height() / 3));
    QVERIFY(bench.stack().view().isLive());
    QTest::mouseClick(scrubber, Qt::LeftButton, Qt::NoModifier, QPoint(scrubber->width() / 2, scrubber->height() / 3));
    QVERIFY(!bench.stack().view().isLive());
    const auto [from, to] = bench.stack().view().range();
    QVERIFY2(from > 1030.0 && to < 1090.0, QByteArray::number(from));
    bench.pass(1.0, 60000.0);
    QCOMPARE(bench.stack().view().range(), std::make_pair(from, to));
    QTest::keyClick(scrubber, Qt::Key_End);
    QVERIFY(bench.stack().view().isLive());
}

void TestPlotKeeping::recordingBeginsBeforeItWasAskedFor()
{
    PlotBench bench;
    const QTemporaryDir folder;
    Recorder recorder(bench.workbench, folder.path() + s("/rolling"));
    bench.page->setRecorder(&recorder, folder.path() + s("/kept"));
    bench.pass(5.0, 60000.0);
    QTRY_VERIFY(recorder.state().samples > 100);
    QCOMPARE(recorder.state().failure, QString());
    QTest::keyClick(bench.page.get(), Qt::Key_R);
    QTRY_VERIFY(recorder.state().keeping);
    const auto before = recorder.state().samples;
    bench.pass(2.0, 60000.0);
    QTRY_VERIFY(recorder.state().samples >= before + before / 3); // these two of seven seconds are on the disk, too
    QSignalSpy saved(&recorder, &Recorder::saved);
    QTest::keyClick(bench.page.get(), Qt::Key_R);
    QTRY_COMPARE(saved.count(), 1);
    QCOMPARE(saved.first().at(1).toString(), QString());
    const auto loaded = loadRecording(saved.first().at(0).toString().toStdString());
    QVERIFY(loaded);
    QVERIFY(std::chrono::duration<double>((*loaded)->last - (*loaded)->first).count() > 6.0);
    bench.page->setRecorder(nullptr, {});
}

void TestPlotKeeping::whatIsKeptAndNotSavedIsWrittenWhenTheProgramEnds()
{
    PlotBench bench;
    const QTemporaryDir folder;
    auto recorder = std::make_unique<Recorder>(bench.workbench, folder.path() + s("/rolling"));
    bench.page->setRecorder(recorder.get(), folder.path() + s("/kept"));
    bench.pass(5.0, 60000.0);
    QTRY_VERIFY(recorder->state().samples > 100);
    QTest::keyClick(bench.page.get(), Qt::Key_R);
    QTRY_VERIFY(recorder->state().keeping);
    bench.pass(2.0, 60000.0);
    bench.page->setRecorder(nullptr, {});
    recorder.reset(); // before it has looked again
    const QFileInfoList files = QDir(folder.path() + s("/kept")).entryInfoList(QDir::Files);
    QCOMPARE(files.size(), 1);
    const auto loaded = loadRecording(files.first().filePath().toStdString());
    QVERIFY(loaded);
    QVERIFY(std::chrono::duration<double>((*loaded)->last - (*loaded)->first).count() > 6.5);
}

void TestPlotKeeping::aFullDiskIsToldOnceAndNothingIsCalledWritten()
{
    PlotBench bench;
    const QTemporaryDir folder;
    Recorder recorder(bench.workbench, folder.path() + s("/rolling"));
    bench.page->setRecorder(&recorder, folder.path() + s("/kept"));
    bench.pass(2.0, 60000.0);
    QTRY_VERIFY(recorder.state().samples > 100);
    QTest::keyClick(bench.page.get(), Qt::Key_R);
    QTRY_VERIFY(recorder.state().keeping);
    bench.workbench.lines.clear();
    const auto told = [&bench] { return bench.workbench.lines; };
    QSignalSpy saved(&recorder, &Recorder::saved);
    {
        const FullDisk full(1);
        QTRY_VERIFY((bench.pass(0.1, 60000.0), !told().empty()));
        QVERIFY2(told().front().text.contains(s("not recorded on disk")), qPrintable(told().front().text));
        QTest::keyClick(bench.page.get(), Qt::Key_R);
        QTRY_COMPARE(saved.count(), 1);
        QVERIFY(saved.first().at(1).toString().contains(s("greatest size")));
        QVERIFY(QDir(folder.path() + s("/kept")).isEmpty());
        QCOMPARE(told().size(), std::size_t{2}); // the state, and the order
    }
    QTRY_VERIFY((bench.pass(0.1, 60000.0), recorder.state().failure.isEmpty()));
    QTest::keyClick(bench.page.get(), Qt::Key_R);
    QTRY_COMPARE(saved.count(), 2);
    QCOMPARE(saved.last().at(1).toString(), QString());
    QVERIFY(loadRecording(saved.last().at(0).toString().toStdString()));
    bench.page->setRecorder(nullptr, {});
}

void TestPlotKeeping::ordersDoNotPileUpWhileTheDiskHangs()
{
    PlotBench bench;
    const QTemporaryDir folder;
    QVERIFY(QDir(folder.path()).mkpath(s("rolling/killed")));
    QVERIFY(QFile(folder.filePath(s("rolling/killed/lock"))).open(QIODevice::WriteOnly));
    const std::string pipe = folder.filePath(s("rolling/killed/segment-000000.mcap")).toStdString();
    QCOMPARE(::mkfifo(pipe.c_str(), 0600), 0); // whoever reads it waits for who writes it
    Recorder recorder(bench.workbench, folder.path() + s("/rolling"));
    const QSignalSpy looked(&recorder, &Recorder::changed);
    const auto held = [&] { return bench.workbench.device(0).telemetry.use_count(); };
    const auto looks = [&](int times) { return QTest::qWaitFor([&] { return looked.count() >= times; }, 60'000); };
    bool hangs = looks(1);
    const long once = held();
    hangs = looks(5) && hangs;
    const long often = held();
    const int end = ::open(pipe.c_str(), O_WRONLY | O_CLOEXEC);
    ::unlink(pipe.c_str());
    ::close(end);
    QVERIFY(hangs);
    QCOMPARE(often, once);
    QTRY_VERIFY((bench.pass(1.0, 60000.0), recorder.state().samples > 100));
}

void TestPlotKeeping::whatIsPlayedIsNotRecordedAgain()
{
    PlotBench bench;
    const QTemporaryDir folder;
    LinkView live;
    live.address = "sim:can";
    LinkView played;
    played.address = "replay:/logs/run.log";
    played.replay.emplace();
    bench.workbench.shot.links = {live, played};
    bench.workbench.device(0).link = "sim:can";
    bench.workbench.device(1).link = "replay:/logs/run.log";
    Recorder recorder(bench.workbench, folder.path() + s("/rolling"));
    bench.page->setRecorder(&recorder, folder.path() + s("/kept"));
    bench.pass(5.0, 60000.0);
    QTRY_VERIFY(recorder.state().samples > 100);
    recorder.startKeeping(folder.path());
    QSignalSpy saved(&recorder, &Recorder::saved);
    recorder.save(folder.filePath(s("a.mcap")));
    QTRY_COMPARE(saved.count(), 1);
    const auto loaded = loadRecording(folder.filePath(s("a.mcap")).toStdString());
    QVERIFY(loaded);
    QCOMPARE((*loaded)->table.size(), dmc60c().channels.size());
    bench.page->setRecorder(nullptr, {});
}

void TestPlotKeeping::whatIsKeptAndCannotBeSavedAtTheEndIsRecoveredAtTheNextStart()
{
    PlotBench bench;
    const QTemporaryDir folder;
    QFile taken(folder.filePath(s("kept"))); // no folder can be there
    QVERIFY(taken.open(QIODevice::WriteOnly));
    for (const bool again : {false, true}) {
        auto recorder = std::make_unique<Recorder>(bench.workbench, folder.path() + s("/rolling"));
        bench.page->setRecorder(recorder.get(), folder.filePath(s("kept")));
        bench.pass(5.0, 60000.0);
        QTRY_VERIFY(recorder->state().samples > 100);
        if (!again)
            recorder->startKeeping(folder.filePath(s("kept")));
        if (again)
            QTRY_VERIFY(!bench.workbench.lines.empty());
        bench.page->setRecorder(nullptr, {});
        recorder.reset();
    }
    QVERIFY2(
        bench.workbench.lines.front().text.contains(s("recovered-")), qPrintable(bench.workbench.lines.front().text));
    const QFileInfoList files = QDir(folder.filePath(s("rolling"))).entryInfoList({s("recovered-*.mcap")}, QDir::Files);
    QCOMPARE(files.size(), 1);
    QVERIFY(loadRecording(files.first().filePath().toStdString()));
}

void TestPlotKeeping::recordingsOfOneSecondHaveNamesOfTheirOwn()
{
    const QTemporaryDir folder;
    QSet<QString> names;
    for (int i = 0; i < 20; ++i)
        names << recordingIn(folder.filePath(s("kept")));
    QCOMPARE(names.size(), 20);
}

MB_WINDOW_TEST(TestPlotKeeping);
#include "tst_plotkeeping.moc"
