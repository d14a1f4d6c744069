// SPDX-License-Identifier: GPL-3.0-or-later
// A recording made and played in the real window, with the real engine.
#include "windowbench.h"

#include "support/windowtests.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/noticestrip.h"
#include "widgets/common/replaybar.h"
#include "widgets/connection/deviceactions.h"
#include "widgets/monitor/buspage.h"
#include "widgets/monitor/framemodel.h"
#include "widgets/monitor/recordstrip.h"
#include "widgets/plots/plotspage.h"

#include <QTemporaryDir>

using namespace mb;
using namespace mb::test;

class RecordingTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aRecordingOfTheBenchIsPlayedAndItsDevicesAppear();
    void aFolderThatIsNotThereIsOneNotice();

private:
    static void playsInThePlots(WindowBench &bench, const std::string &address);
    static void movesNothing(WindowBench &bench, const std::string &address);
};

namespace {

const LinkView *linkOf(WindowBench &bench, const std::string &address)
{
    return bench.engine().snapshot().link(address);
}

int devicesOn(WindowBench &bench, const std::string &address)
{
    const auto &all = bench.engine().snapshot().devices;
    return static_cast<int>(
        std::count_if(all.begin(), all.end(), [&](const DeviceView &device) { return device.link == address; }));
}

/// For people who want to look: MOTORBENCH_PICTURES names a folder.
void picture(WindowBench &bench, const char *name)
{
    if (qEnvironmentVariableIsSet("MOTORBENCH_PICTURES"))
        bench.window().grab().save(qEnvironmentVariable("MOTORBENCH_PICTURES") + QLatin1Char('/') + QLatin1String(name)
            + QStringLiteral(".png"));
}

} // namespace

void RecordingTest::aRecordingOfTheBenchIsPlayedAndItsDevicesAppear()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("run.asc"));
    const std::string address = "replay:" + path.toStdString();
    WindowBench bench(qEnvironmentVariable("MOTORBENCH_FONT_SCALE", QStringLiteral("1")).toDouble());
    QTRY_VERIFY_WITH_TIMEOUT(bench.isFound(), patience);
    auto &bus = bench.page<BusPage>(PageId::Bus);
    bus.showLink("sim:can");
    bus.recordStrip().recordTo(path);
    const auto frames
        = [&] { return linkOf(bench, "sim:can")->recording ? linkOf(bench, "sim:can")->recording->frames : 0U; };
    QTRY_VERIFY_WITH_TIMEOUT(frames() > 1500U, patience);
    QVERIFY(bus.recordStrip().isVisible());
    picture(bench, "recording");
    QTest::mouseClick(&bus.recordStrip().button(), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(linkOf(bench, "sim:can")->recording->finished, patience);
    QCOMPARE(linkOf(bench, "sim:can")->recording->lost, std::uint64_t{0});
    QVERIFY(!bus.recordStrip().isVisible());
    const auto written = linkOf(bench, "sim:can")->recording->frames;

    openRecording(bench.engine(), path, [&bus](const QString &opened) { bus.showLink(opened.toStdString()); });
    auto &bar = *bus.findChild<ReplayBar *>();
    QTRY_VERIFY_WITH_TIMEOUT(bar.isVisible() && linkOf(bench, address)->replay->running, patience);
    picture(bench, "replay");
    bench.engine().send(orders::SteerReplay{address, {0.0, std::nullopt, std::nullopt}});
    QTRY_VERIFY_WITH_TIMEOUT(linkOf(bench, address)->replay->ended, patience);
    QCOMPARE(devicesOn(bench, address), static_cast<int>(WindowBench::benchSize));
    QCOMPARE(linkOf(bench, address)->counters.rx + linkOf(bench, address)->counters.tx, written);
    playsInThePlots(bench, address);
    movesNothing(bench, address);
}

void RecordingTest::movesNothing(WindowBench &bench, const std::string &address)
{
    const DeviceView *device = bench.engine().snapshot().device(bench.window().selection().device());
    QVERIFY(device && device->link == address);
    bench.window().arming().arm(device->id);
    QVERIFY(bench.window().arming().state() == LampState::Safe);
    const auto &all = bench.engine().notices();
    QVERIFY(std::any_of(all.begin(), all.end(), [](const Notice &notice) {
        return notice.text.contains(QStringLiteral("not armed: run.asc is a recording"));
    }));
    QVERIFY(bench.window().findChild<DemoStripe *>()->accessibleName().contains(QStringLiteral("Replay  ·  run.asc")));
    bench.window().showPage(PageId::Tune);
    picture(bench, "tune");
}

void RecordingTest::playsInThePlots(WindowBench &bench, const std::string &address)
{
    auto &plots = bench.page<PlotsPage>(PageId::Plots);
    const auto &devices = bench.engine().snapshot().devices;
    const auto replayed = std::find_if(devices.begin(), devices.end(), [&](const DeviceView &device) {
        return device.link == address && device.identity->address == WindowBench::tuned
            && device.family->key == "dmc60c";
    });
    QVERIFY(replayed != devices.end());
    bench.window().selection().select(replayed->id);
    QTRY_COMPARE_WITH_TIMEOUT(QString::fromStdString(plots.board().link()), QString::fromStdString(address), patience);
    QTRY_VERIFY_WITH_TIMEOUT(plots.findChild<ReplayBar *>()->isVisible(), patience);
    QVERIFY(plots.board().present() == linkOf(bench, address)->time);
    picture(bench, "plots");
    auto &again = *plots.findChild<ReplayBar *>()->findChild<CommandButton *>();
    QTRY_COMPARE_WITH_TIMEOUT(again.text(), QStringLiteral("Play again"), patience);
    bench.engine().send(orders::SteerReplay{address, {1.0, std::nullopt, std::nullopt}});
    QTest::mouseClick(&again, Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(linkOf(bench, address)->replay->running, patience);
    QVERIFY(linkOf(bench, address)->replay->position < linkOf(bench, address)->replay->length);
}

void RecordingTest::aFolderThatIsNotThereIsOneNotice()
{
    WindowBench bench;
    QTRY_VERIFY_WITH_TIMEOUT(linkOf(bench, "sim:can"), patience);
    auto &bus = bench.page<BusPage>(PageId::Bus);
    bus.showLink("sim:can");
    const auto told = [&] {
        const auto &all = bench.engine().notices();
        return std::count_if(all.begin(), all.end(),
            [](const Notice &notice) { return notice.text.contains(QStringLiteral("nothing is recorded")); });
    };
    bus.recordStrip().recordTo(QStringLiteral("/nowhere/run.log"));
    QTRY_COMPARE_WITH_TIMEOUT(static_cast<int>(told()), 1, patience);
    QTest::qWait(300);
    QCOMPARE(static_cast<int>(told()), 1);
    QVERIFY(!linkOf(bench, "sim:can")->recording);
}

MB_WINDOW_TEST(RecordingTest);
#include "tst_recording.moc"
