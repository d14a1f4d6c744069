// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tourstage.h"

#include "files/filebytes.h"
#include "widgets/plots/picturefile.h"

#include <algorithm>
#include <cstdio>

namespace mb {
namespace {

constexpr std::chrono::milliseconds pollTime{20};
constexpr int mostWaiting = 3; ///< pictures in memory

const DeviceView *firstOf(const Snapshot &shot, const std::function<bool(const DeviceView &)> &isIt)
{
    const auto found = std::ranges::find_if(shot.devices, isIt);
    return found == shot.devices.end() ? nullptr : &*found;
}

bool write(const QImage &image, const QString &path)
{
    if (saveFile(path.toStdString(), pngOf(image)))
        return true;
    std::fprintf(stderr, "motorbench: %s cannot be written\n", qPrintable(path));
    return false;
}

} // namespace

TourStage::TourStage(
    Workbench &workbench, MainWindow &window, ThemeSource &theme, const QString &folder, bool inOneTheme)
    : m_workbench(workbench)
    , m_window(window)
    , m_theme(theme)
    , m_folder(folder)
    , m_inOneTheme(inOneTheme)
    , m_saver(write)
{
    m_poll.setInterval(pollTime);
    connect(&m_poll, &QTimer::timeout, this, &TourStage::look);
}

void TourStage::add(
    const char *name, std::function<void()> act, std::function<bool()> done, std::chrono::milliseconds limit)
{
    m_steps.push_back({name, std::move(act), std::move(done), limit});
}

void TourStage::act(const char *name, std::function<void()> act)
{
    add(name, std::move(act), [] { return true; });
}

void TourStage::wait(const char *name, std::function<bool()> done, std::chrono::milliseconds limit)
{
    add(
        name, [] {}, std::move(done), limit);
}

void TourStage::pause(std::chrono::milliseconds time)
{
    wait(
        "wait", [this, time] { return m_workbench.now() - m_begunAt >= time; }, time + std::chrono::seconds(10));
}

void TourStage::picture(const char *name, std::chrono::milliseconds after, bool grey)
{
    if (after.count() > 0)
        pause(after);
    // A step for each: a theme takes its time, and the window must be able to renew a motion lease in between.
    const Theme before = m_theme.theme();
    act(name, [this] { ++m_pictures; });
    const double points = before.bodyPointSize;
    for (const Theme &theme :
        m_inOneTheme ? std::vector<Theme>{before} : std::vector<Theme>{darkTheme(points), lightTheme(points)}) {
        act(name, [this, theme] { m_theme.setTheme(theme); });
        add(
            name, [this, name, grey] { save(name, grey); }, [this] { return m_saver.waiting() < mostWaiting; });
    }
    act(name, [this, before] { m_theme.setTheme(before); });
}

void TourStage::arm(const char *name, std::function<const DeviceView *()> unit)
{
    add(
        name, [this, unit] { m_window.arming().arm(unit()->id); },
        [this, unit] { return m_window.arming().isArmed(unit()->id); });
}

void TourStage::play(std::function<void(int)> ended)
{
    m_ended = std::move(ended);
    if (!m_folder.mkpath(QStringLiteral("."))) {
        std::fprintf(stderr, "motorbench: %s cannot be made\n", qPrintable(m_folder.path()));
        m_steps = {};
        return m_ended(2);
    }
    begin(0);
    m_poll.start();
}

const DeviceView *TourStage::device(int DemoUnits::*unit) const
{
    return firstOf(m_workbench.snapshot(),
        [unit](const DeviceView &view) { return isDemoUnit(*view.family, view.identity->address, unit); });
}

const DeviceView *TourStage::board() const
{
    return firstOf(m_workbench.snapshot(), [](const DeviceView &view) { return view.family->capabilities.axes > 1; });
}

void TourStage::stopAll()
{
    m_window.arming().stopAll(tr("tour"));
}

void TourStage::save(const char *name, bool grey)
{
    const QString file = QStringLiteral("%1-%2-%3")
                             .arg(m_pictures, 2, 10, QLatin1Char('0'))
                             .arg(QString::fromLatin1(name), m_theme.theme().name);
    const QImage image = m_window.grab().toImage();
    m_saver.save(image, m_folder.filePath(file + QStringLiteral(".png")));
    if (grey)
        m_saver.save(
            image.convertToFormat(QImage::Format_Grayscale8), m_folder.filePath(file + QStringLiteral("-grey.png")));
    std::printf("%s.png\n", qPrintable(file));
    std::fflush(stdout);
}

void TourStage::begin(std::size_t step)
{
    m_current = step;
    m_begunAt = m_workbench.now();
    if (step == m_steps.size())
        finish(0);
    else
        m_steps[step].act();
}

void TourStage::look()
{
    if (m_current >= m_steps.size())
        return;
    const Step &step = m_steps[m_current];
    if (step.done()) {
        begin(m_current + 1);
    } else if (m_workbench.now() - m_begunAt > step.limit) {
        std::fprintf(stderr, "motorbench: the tour did not get past '%s'\n", step.name);
        save("failed", false);
        finish(1);
    }
}

void TourStage::finish(int status)
{
    m_poll.stop();
    m_current = m_steps.size();
    m_ended(m_saver.finish() ? status : 1);
}

bool isRead(const DeviceView &device)
{
    return std::all_of(device.parameters->begin(), device.parameters->end(),
        [](const ParameterStore::Entry &entry) { return entry.raw.has_value(); });
}

} // namespace mb
