// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tour.h"

#include "app/servicetour.h"
#include "files/filebytes.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/headerbar.h"
#include "widgets/common/losses.h"
#include "widgets/control/tunepage.h"
#include "widgets/firmware/firmwarepage.h"
#include "widgets/parameters/parameterspage.h"
#include "widgets/plots/picturefile.h"
#include "widgets/report/reportspage.h"

#include <QApplication>

#include <algorithm>
#include <cstdio>

namespace mb {
namespace {

constexpr std::chrono::milliseconds pollTime{20};
constexpr auto tuned = &DemoUnits::tuned;
constexpr auto overshooting = &DemoUnits::overshooting;
constexpr auto inBootloader = &DemoUnits::inBootloader;
constexpr std::chrono::milliseconds driveAgain{500};
constexpr double stepTarget = 60000.0; // counts/s

} // namespace

Tour::Tour(Workbench &workbench, MainWindow &window, ThemeSource &theme, const QString &folder, bool inOneTheme)
    : m_workbench(workbench)
    , m_window(window)
    , m_theme(theme)
    , m_folder(folder)
    , m_inOneTheme(inOneTheme)
    , m_service(new ServiceTour(workbench, window, *this, this))
{
    m_poll.setInterval(pollTime);
    connect(&m_poll, &QTimer::timeout, this, &Tour::look);
}

void Tour::start()
{
    if (!m_folder.mkpath(QStringLiteral("."))) {
        std::fprintf(stderr, "motorbench: %s cannot be made\n", qPrintable(m_folder.path()));
        QMetaObject::invokeMethod(
            qApp, [] { QCoreApplication::exit(2); }, Qt::QueuedConnection);
        return;
    }
    plan();
    begin(0);
    m_poll.start();
}

const DeviceView *Tour::device(int DemoUnits::*unit) const
{
    const auto &devices = m_workbench.snapshot().devices;
    const auto found = std::find_if(devices.begin(), devices.end(),
        [unit](const DeviceView &d) { return d.family->demo && d.identity.address == d.family->demo->*unit; });
    return found == devices.end() ? nullptr : &*found;
}

void Tour::add(
    const QString &name, std::function<void()> act, std::function<bool()> done, std::chrono::milliseconds limit)
{
    m_steps.push_back({name, std::move(act), std::move(done), limit});
}

void Tour::pause(std::chrono::milliseconds time)
{
    add(
        QStringLiteral("wait"), [] {}, [this, time] { return m_workbench.now() - m_begunAt >= time; },
        time + std::chrono::seconds(10));
}

void Tour::picture(const QString &name, bool grey)
{
    // A step for each: a theme takes its time, and the window must be able to renew a motion lease in between.
    const Theme before = m_theme.theme();
    add(
        name, [this] { ++m_pictures; }, [] { return true; });
    const double points = before.bodyPointSize;
    for (const Theme &theme :
        m_inOneTheme ? std::vector<Theme>{before} : std::vector<Theme>{darkTheme(points), lightTheme(points)}) {
        add(
            name, [this, theme] { m_theme.setTheme(theme); }, [] { return true; });
        add(
            name, [this, name, grey] { save(name, grey); }, [] { return true; });
    }
    add(
        name, [this, before] { m_theme.setTheme(before); }, [] { return true; });
}

void Tour::save(const QString &name, bool grey)
{
    const QString number = QStringLiteral("%1").arg(m_pictures, 2, 10, QLatin1Char('0'));
    const QString file = QStringLiteral("%1-%2-%3.png").arg(number, name, m_theme.theme().name);
    const QImage image = m_window.grab().toImage();
    const QString colourless = QString(file).replace(QStringLiteral(".png"), QStringLiteral("-grey.png"));
    if (!saveFile(m_folder.filePath(file).toStdString(), pngOf(image))
        || (grey
            && !saveFile(m_folder.filePath(colourless).toStdString(),
                pngOf(image.convertToFormat(QImage::Format_Grayscale8))))) {
        std::fprintf(stderr, "motorbench: %s cannot be written\n", qPrintable(m_folder.filePath(file)));
        finish(1);
        return;
    }
    std::printf("%s\n", qPrintable(file));
    std::fflush(stdout);
}

void Tour::drive()
{
    if (m_window.arming().isMoving() || m_workbench.now() - m_drivenAt < driveAgain)
        return;
    m_drivenAt = m_workbench.now();
    m_window.arming().arm(device(tuned)->id);
    SetPoint setPoint;
    setPoint.mode = Mode::Velocity;
    setPoint.target = stepTarget;
    m_window.arming().run(setPoint);
}

/// A picture, or a busy computer, may have outlasted the motion lease: then it is driven anew.
bool Tour::comesToSpeed()
{
    drive();
    const auto channel = device(tuned)->telemetry->find("velocity");
    const auto last = device(tuned)->telemetry->last(*channel);
    return last && last->value > 0.95 * stepTarget;
}

void Tour::plan()
{
    picture(QStringLiteral("start"));
    planOverview();
    planParameters();
    planMotion();
    planAxes();
    planFirmware();
    planEnd();
}

void Tour::planOverview()
{
    add(
        QStringLiteral("find the bench"), [] {},
        [this] {
            const DeviceView *first = device(tuned);
            return first && device(overshooting) && device(inBootloader) && first->liveness.heard
                && !first->identity.serial.empty();
        });
    add(
        QStringLiteral("select"), [this] { m_window.selection().select(device(tuned)->id); }, [] { return true; });
    pause(std::chrono::milliseconds(1500));
    picture(QStringLiteral("overview"));
}

void Tour::planParameters()
{
    add(
        QStringLiteral("read parameters"), [this] { m_window.showPage(PageId::Parameters); },
        [this] {
            const auto &entries = device(tuned)->parameters;
            return std::all_of(
                entries.begin(), entries.end(), [](const ParameterStore::Entry &e) { return e.raw.has_value(); });
        });
    pause(std::chrono::milliseconds(300));
    picture(QStringLiteral("parameters"));
    const auto showHistory = [this](bool on) {
        return [this, on] { qobject_cast<ParametersPage *>(m_window.page(PageId::Parameters))->showHistory(on); };
    };
    add(QStringLiteral("history"), showHistory(true), [] { return true; });
    pause(std::chrono::milliseconds(500));
    picture(QStringLiteral("history"));
    add(QStringLiteral("values"), showHistory(false), [] { return true; });
    m_service->planKeeping();
}

void Tour::planMotion()
{
    planTrials();
    planDesign();
    add(
        QStringLiteral("arm"),
        [this] {
            m_window.selection().select(device(tuned)->id);
            qobject_cast<TunePage *>(m_window.page(PageId::Tune))->showLive(true);
            m_window.arming().arm(device(tuned)->id);
        },
        [this] { return m_window.arming().isArmed(device(tuned)->id); });
    pause(std::chrono::milliseconds(1000));
    add(
        QStringLiteral("velocity step"), [] {}, [this] { return comesToSpeed(); });
    pause(std::chrono::milliseconds(1500));
    picture(QStringLiteral("tune-live"));
    add(
        QStringLiteral("plots"), [this] { m_window.showPage(PageId::Plots); }, [this] { return comesToSpeed(); });
    pause(std::chrono::milliseconds(1500));
    picture(QStringLiteral("plots"));
    planPlots();
    add(
        QStringLiteral("bus"), [this] { m_window.showPage(PageId::Bus); }, [this] { return comesToSpeed(); });
    pause(std::chrono::milliseconds(1000));
    picture(QStringLiteral("bus"));
    add(
        QStringLiteral("stop"), [this] { m_window.arming().stopAll(tr("tour")); },
        [this] { return !device(tuned)->liveness.moving; });
    picture(QStringLiteral("stopped"));
}

void Tour::planFirmware()
{
    add(
        QStringLiteral("update"),
        [this] {
            m_window.selection().select(device(inBootloader)->id);
            m_window.showPage(PageId::Firmware);
            auto *page = qobject_cast<FirmwarePage *>(m_window.page(PageId::Firmware));
            page->loadImage(QStringLiteral(":/firmware/") + qt(device(inBootloader)->family->demo->image));
            page->startUpdate();
        },
        [this] {
            const OperationView *operation = m_workbench.snapshot().operation(device(inBootloader)->id);
            const auto &parts = operation ? operation->status.parts : std::map<int, PartState>{};
            return std::count_if(parts.begin(), parts.end(), [](const auto &part) {
                return part.second == PartState::Done;
            }) >= 15;
        },
        std::chrono::seconds(60));
    picture(QStringLiteral("firmware-running"));
    add(
        QStringLiteral("update to the end"), [] {},
        [this] {
            // The newest operation may already be the one that reads the parameters of the new application.
            const auto &operations = m_workbench.snapshot().operations;
            return std::any_of(operations.begin(), operations.end(), [this](const OperationView &operation) {
                return operation.device == device(inBootloader)->id && operation.update
                    && operation.update->outcome == UpdateOutcome::Done;
            });
        },
        std::chrono::seconds(60));
    pause(std::chrono::milliseconds(500));
    picture(QStringLiteral("firmware"));
    m_service->planQueue();
}

void Tour::planEnd()
{
    add(
        QStringLiteral("log"), [this] { m_window.showPage(PageId::Log); }, [] { return true; });
    pause(std::chrono::milliseconds(200));
    picture(QStringLiteral("log"));
    add(
        QStringLiteral("reports"), [this] { m_window.showPage(PageId::Reports); },
        [this] { return !qobject_cast<ReportsPage *>(m_window.page(PageId::Reports))->previewText().isEmpty(); });
    pause(std::chrono::milliseconds(200));
    picture(QStringLiteral("reports"));
    m_service->planProduction();
    m_service->planFail();
    m_service->planJournal();
}

void Tour::begin(std::size_t step)
{
    m_current = step;
    m_begunAt = m_workbench.now();
    if (step == m_steps.size())
        finish(0);
    else
        m_steps[step].act();
}

void Tour::look()
{
    if (m_current >= m_steps.size())
        return;
    const Step &step = m_steps[m_current];
    if (step.done()) {
        begin(m_current + 1);
    } else if (m_workbench.now() - m_begunAt > step.limit) {
        std::fprintf(stderr, "motorbench: the tour did not get past '%s'\n", qPrintable(step.name));
        save(QStringLiteral("failed"), false);
        finish(1);
    }
}

/// The bench loses nothing, however busy the computer is.
void Tour::tellLosses() const
{
    for (const DeviceView &device : m_workbench.snapshot().devices) {
        const SampleCount count = samplesOf(device);
        std::printf("%s: %llu samples, %llu lost\n", device.selector.c_str(),
            static_cast<unsigned long long>(count.kept), static_cast<unsigned long long>(count.lost));
    }
    std::fflush(stdout);
}

void Tour::finish(int status)
{
    m_poll.stop();
    m_current = m_steps.size();
    tellLosses();
    QCoreApplication::exit(status);
}

} // namespace mb
