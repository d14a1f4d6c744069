// SPDX-License-Identifier: GPL-3.0-or-later
// Times of what is shown, copied and exported, over a sleep of the computer.
#include "buspagebench.h"
#include "plotbench.h"
#include "support/windowtests.h"
#include "widgets/monitor/noticemodel.h"

using namespace mb;
using namespace mb::test;

class SleepTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void anExportHasTheTimesOfBeforeAndAfterTheComputerSlept();
    void axisAndTableHaveTheTimesOfBeforeAndAfterTheComputerSlept();
    void aRecordingHasItsOwnTimesHoweverLongTheComputerSlept();
    void whatPassedBeforeTheComputerSleptIsCopiedAndLoggedWithItsTime();
    void framesOfARecordingAreCopiedWithItsTimesHoweverLongTheComputerSlept();
};

namespace {

/// A second before the computer sleeps for so long, and one after it; yields the last moment before.
Instant passOverASleep(PlotBench &bench, Duration sleep)
{
    bench.workbench.slept.look(bench.workbench.time, {});
    bench.pass(1.0, 60000.0);
    bench.workbench.slept.look(bench.workbench.time, {});
    const Instant before = bench.workbench.time;
    bench.workbench.slept.look(bench.workbench.time + 1ms, sleep);
    bench.pass(1.0, 60000.0);
    return before;
}

} // namespace

void SleepTest::anExportHasTheTimesOfBeforeAndAfterTheComputerSlept()
{
    PlotBench bench;
    const QTemporaryDir folder;
    const Instant before = passOverASleep(bench, 3600s);
    const Instant after = bench.workbench.time;
    bench.page->exportBar().exportSamples({std::nullopt, false, folder.filePath(s("a.mcap"))});
    QTRY_VERIFY(QFile::exists(folder.filePath(s("a.mcap"))));
    const auto loaded = loadRecording(folder.filePath(s("a.mcap")).toStdString());
    QVERIFY(loaded);
    QVERIFY((*loaded)->first < before);
    QVERIFY((*loaded)->last > before + 3600s && (*loaded)->last <= after + 3600s);
}

void SleepTest::axisAndTableHaveTheTimesOfBeforeAndAfterTheComputerSlept()
{
    PlotBench bench;
    const QTemporaryDir folder;
    const double before = plotKey(passOverASleep(bench, 600s));
    bench.stack().view().setRange(before - 0.5, before + 0.5);
    QVERIFY(bench.stack().exporter().exportTo(folder.filePath(s("a.csv"))));
    QFile file(folder.filePath(s("a.csv")));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QStringList lines = QString::fromUtf8(file.readAll()).split(QLatin1Char('\n'));
    QVERIFY2(lines.first().endsWith(s("(Unix %1)").arg(before - 0.5, 0, 'f', 6)), qPrintable(lines.first()));
    const double last = lines[lines.size() - 2].section(QLatin1Char(','), 0, 0).toDouble();
    QVERIFY2(last > 600.5 && last < 601.1, qPrintable(QString::number(last)));
    const QCPAxis &axis = *bench.stack().findChild<QCustomPlot *>()->axisRect()->axis(QCPAxis::atBottom);
    const auto labelAt = [&axis](double key) {
        QVector<double> ticks;
        QVector<QString> labels;
        axis.ticker()->generate({key, key + 20.0}, {}, QLatin1Char('g'), 6, ticks, nullptr, &labels);
        return labels.value(0);
    };
    const double step = 20.0; // both begin at a whole one
    const QTime early = QTime::fromString(labelAt(before - step), s("HH:mm:ss"));
    QVERIFY(early.isValid());
    QCOMPARE(early.secsTo(QTime::fromString(labelAt(before + step), s("HH:mm:ss"))), 600 + 2 * 20);
}

void SleepTest::aRecordingHasItsOwnTimesHoweverLongTheComputerSlept()
{
    PlotBench bench;
    const QTemporaryDir folder;
    LinkView played;
    played.address = "replay:/logs/run.log";
    played.replay.emplace();
    played.replay->start = 1'718'000'000s;
    played.time = bench.workbench.time;
    bench.workbench.shot.links = {played};
    for (DeviceView &device : bench.workbench.shot.devices)
        device.link = played.address;
    bench.workbench.slept.look(bench.workbench.time - 2s, {});
    bench.workbench.slept.look(bench.workbench.time - 1s, 8h);
    bench.pass(1.0, 60000.0);
    const double begin = plotKey(played.time);
    bench.stack().view().setRange(begin, begin + 1.0);
    QVERIFY(bench.stack().exporter().exportTo(folder.filePath(s("a.csv"))));
    QFile table(folder.filePath(s("a.csv")));
    QVERIFY(table.open(QIODevice::ReadOnly));
    const QByteArray head = table.readLine().trimmed();
    QVERIFY2(head.endsWith("(Unix 1718000000.000000)"), head.constData());
    bench.page->exportBar().exportSamples({bench.stack().view().range(), false, folder.filePath(s("b.mcap"))});
    QTRY_VERIFY(QFile::exists(folder.filePath(s("b.mcap"))));
    const auto loaded = loadRecording(folder.filePath(s("b.mcap")).toStdString());
    QVERIFY(loaded);
    QVERIFY((*loaded)->first >= Instant(1'718'000'000s) && (*loaded)->last <= Instant(1'718'000'001s));
}

void SleepTest::whatPassedBeforeTheComputerSleptIsCopiedAndLoggedWithItsTime()
{
    BusBench bench;
    bench.workbench.shot.links.front().simulated = false;
    const Instant begin = bench.workbench.time;
    bench.workbench.slept.look(begin, {});
    bench.workbench.report(Severity::Info, {}, QStringLiteral("something"));
    NoticeModel log(bench.workbench, bench.theme);
    const QModelIndex cell = log.index(0, NoticeModel::Time);
    const QString noted = cell.data().toString();
    bench.traffic.add(generalOf5);
    bench.publish();
    bench.named<TrafficView>("Frames")->selectAll();
    const QString copied = bench.page->selectedText();
    bench.workbench.slept.look(bench.workbench.time, {});
    bench.workbench.time += 1ms;
    bench.workbench.slept.look(bench.workbench.time, 3600s);
    QCOMPARE(bench.page->selectedText(), copied);
    QCOMPARE(cell.data().toString(), noted);
}

void SleepTest::framesOfARecordingAreCopiedWithItsTimesHoweverLongTheComputerSlept()
{
    BusBench bench;
    bench.workbench.slept.look(bench.workbench.time, {});
    bench.workbench.slept.look(bench.workbench.time + 1ms, 8h);
    bench.workbench.time += 2ms;
    bench.traffic.add(generalOf5);
    LinkView &link = bench.workbench.shot.links.front();
    link.simulated = false;
    link.replay.emplace();
    link.replay->start = 1'718'000'000s;
    link.replay->position = 5s;
    link.time = bench.traffic.now;
    bench.publish();
    bench.named<TrafficView>("Frames")->selectAll();
    const QString recorded = QStringLiteral("(1718000005.000000) sim:can 02061405#A125110008070000\n");
    QCOMPARE(bench.page->selectedText(), recorded);
    bench.workbench.shot.links.clear();
    bench.publish();
    QCOMPARE(bench.page->selectedText(), recorded); // what it has left
}

MB_WINDOW_TEST(SleepTest);
#include "tst_sleep.moc"
