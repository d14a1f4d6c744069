// SPDX-License-Identifier: GPL-3.0-or-later
// The Bus page at a full bus, 9 009 frames/s: what a frame costs the engine thread, what a look costs the GUI thread, and how late an event of
// the GUI thread comes while frames pour in. With a folder as argument it also saves pictures of the page under that load.
#include "model/registry.h"
#include "support/fakeworkbench.h"
#include "transport/qtclock.h"
#include "widgets/common/applytheme.h"
#include "widgets/control/arming.h"
#include "widgets/monitor/busbar.h"
#include "widgets/monitor/buspage.h"
#include "widgets/monitor/framemodel.h"
#include "widgets/monitor/sendpanel.h"
#include "widgets/monitor/trafficview.h"

#include <QApplication>
#include <QTimer>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <thread>

namespace mb {
namespace {

constexpr int framesPerSecond = 9009;

double seconds(Duration time)
{
    return std::chrono::duration<double>(time).count();
}

/// Status frames of eight drives, and now and then one that nobody knows.
CanFrame frameNumber(std::uint32_t number, Instant time)
{
    constexpr std::array bases{0x02061400U, 0x02061480U, 0x020614C0U};
    const std::uint32_t device = 1 + number % 8;
    const auto low = static_cast<std::uint8_t>(number);
    CanFrame frame = extendedFrame(number % 100 == 99 ? 0x0206144AU : bases.at(number / 8 % bases.size()) + device,
        {low, 0x25, 0x11, 0, 8, low, 0, 0});
    frame.time = time;
    return frame;
}

void appendCost()
{
    TrafficLog log;
    constexpr std::uint32_t count = 2'000'000;
    QtClock clock;
    const Instant start = clock.now();
    for (std::uint32_t i = 0; i < count; ++i)
        log.append(
            Direction::Received, frameNumber(i, start + i * Duration(std::chrono::seconds(1)) / framesPerSecond));
    std::printf("engine thread: %.0f ns a frame to log and count it (frame made up included)\n",
        seconds(clock.now() - start) * 1e9 / count);
}

struct Late {
    std::vector<double> events;
    std::vector<double> ticks;
    void print(const char *what, std::vector<double> &values) const
    {
        std::sort(values.begin(), values.end());
        const auto at = [&values](double part) {
            return values.empty()
                ? 0.0
                : values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))] * 1e3;
        };
        std::printf("  %-28s median %6.2f ms   p99 %6.2f ms   worst %6.2f ms   of %zu\n", what, at(0.5), at(0.99),
            at(1.0), values.size());
    }
};

struct Scene {
    const char *name;
    QSize size;
    const char *filter;
    Duration time;
    bool dark = true;
    double points = 10.0; ///< of the body font
    bool sends = false;   ///< the panel for sending is open
};

LinkView fullLink(std::shared_ptr<const TrafficLog> log)
{
    LinkView link;
    link.address = "can0";
    link.name = "can0";
    link.state = LinkState::Open;
    link.traffic = std::move(log);
    link.load = 1.0;
    return link;
}

void savePicture(BusPage &page, const char *name, const QString &folder)
{
    if (folder.isEmpty())
        return;
    for (auto *table : page.findChildren<TrafficView *>()) {
        if (table->model() == &page.model())
            table->selectRow(page.model().rowCount() - 5);
    }
    QCoreApplication::processEvents();
    page.grab().save(folder + QLatin1Char('/') + QLatin1String(name) + QStringLiteral(".png"));
}

/// A full bus, until it ends.
void fill(TrafficLog &log, const Clock &clock, const std::atomic<bool> &ends)
{
    const Instant start = clock.now();
    for (std::uint32_t i = 0; !ends; ++i) {
        const Instant due = start + i * Duration(std::chrono::seconds(1)) / framesPerSecond;
        while (!ends && clock.now() < due)
            std::this_thread::sleep_for(std::chrono::microseconds(200));
        log.append(Direction::Received, frameNumber(i, due));
    }
}

/// Frames from another thread, the event loop running; every event that was due is timed.
void pageUnderLoad(const Scene &scene, const QString &folder)
{
    QtClock clock;
    QFont font = QApplication::font();
    font.setPointSizeF(scene.points);
    QApplication::setFont(font);
    ThemeSource theme(scene.dark ? darkTheme(scene.points) : lightTheme(scene.points));
    applyTheme(*qApp, theme.theme());
    test::FakeWorkbench workbench;
    Arming arming(workbench);
    BusPage page(workbench, arming, theme);
    const auto log = std::make_shared<TrafficLog>();
    workbench.shot.links = {fullLink(log)};
    page.resize(scene.size);
    page.show();
    page.bar().setFilterText(QString::fromLatin1(scene.filter));
    page.bar().setSendShown(scene.sends);
    if (scene.sends)
        page.findChild<SendPanel *>()->setFrame(*canFrameFromText("02060005#7100000000280000"));
    std::atomic<bool> ends = false;
    std::thread bus([&] { fill(*log, clock, ends); });
    Late late;
    Instant due = clock.now();
    QTimer beat;
    beat.setTimerType(Qt::PreciseTimer);
    QObject::connect(&beat, &QTimer::timeout, &page, [&] {
        const Instant now = clock.now();
        late.events.push_back(std::max(0.0, seconds(now - due)));
        due = now + std::chrono::milliseconds(5);
    });
    beat.start(5);
    QTimer snapshots;
    QObject::connect(&snapshots, &QTimer::timeout, &page, [&] {
        workbench.time = clock.now();
        workbench.shot.links[0].counters.rx = log->newest();
        workbench.publish();
    });
    snapshots.start(33);
    QTimer::singleShot(
        std::chrono::duration_cast<std::chrono::milliseconds>(scene.time), qApp, &QCoreApplication::quit);
    QCoreApplication::exec();
    beat.stop();
    snapshots.stop();
    for (int i = 0; i < 40; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        const Instant before = clock.now();
        workbench.time = before;
        page.tick();
        page.repaint();
        late.ticks.push_back(seconds(clock.now() - before));
    }
    ends = true;
    bus.join();
    page.tick();
    std::printf("%s, %d x %d, filter '%s': %llu frames came, %llu not kept, %d shown\n", scene.name, scene.size.width(),
        scene.size.height(), scene.filter, static_cast<unsigned long long>(log->newest()),
        static_cast<unsigned long long>(page.model().skipped()), page.model().rowCount());
    late.print("an event comes late by", late.events);
    late.print("take 450 frames and repaint", late.ticks);
    savePicture(page, scene.name, folder);
}

} // namespace
} // namespace mb

int main(int argc, char **argv)
{
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication app(argc, argv);
    mb::appendCost();
    using namespace std::chrono_literals;
    const QString folder = app.arguments().value(1);
    mb::pageUnderLoad({"bus-full", {1280, 700}, "", 13s}, folder);
    mb::pageUnderLoad({"bus-filtered", {1280, 700}, "field.dtcApplied>10%", 5s}, folder);
    mb::pageUnderLoad({"bus-4k", {3840, 2000}, "", 5s}, folder);
    if (folder.isEmpty())
        return 0;
    mb::pageUnderLoad({"bus-light", {1280, 700}, "message:STS*", 2s, false}, folder);
    mb::pageUnderLoad({"bus-narrow", {1048, 684}, "", 2s}, folder);
    mb::pageUnderLoad({"bus-200", {1048, 684}, "", 2s, true, 20.0}, folder);
    mb::pageUnderLoad({"bus-200-wide", {3600, 2000}, "", 2s, false, 20.0}, folder);
    mb::pageUnderLoad({"bus-send", {1280, 700}, "device:3..5", 2s, true, 10.0, true}, folder);
    return 0;
}
