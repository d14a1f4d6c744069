// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tour.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/losses.h"
#include "widgets/firmware/firmwarepage.h"
#include "widgets/parameters/parameterspage.h"
#include "widgets/report/reportspage.h"

#include <QApplication>

#include <algorithm>
#include <cstdio>

namespace mb {
namespace {

using namespace std::chrono_literals;

constexpr auto tuned = &DemoUnits::tuned;
constexpr auto inBootloader = &DemoUnits::inBootloader;
constexpr std::chrono::seconds updateTime{60};
constexpr int partsDone = 15; ///< of an update, when its picture is taken

} // namespace

Tour::Tour(Workbench &workbench, MainWindow &window, ThemeSource &theme, const QString &folder, bool inOneTheme)
    : m_stage(workbench, window, theme, folder, inOneTheme)
    , m_tuning(m_stage)
    , m_motion(m_stage)
    , m_axes(m_stage)
    , m_service(m_stage)
{
}

void Tour::start()
{
    m_stage.picture("start");
    planOverview();
    planParameters();
    m_tuning.plan();
    m_motion.plan();
    m_axes.plan();
    planFirmware();
    planLog();
    m_service.planProduction();
    m_service.planFail();
    m_service.planJournal();
    m_stage.play([this](int status) {
        tellLosses();
        QMetaObject::invokeMethod(
            qApp, [status] { QCoreApplication::exit(status); }, Qt::QueuedConnection);
    });
}

void Tour::planOverview()
{
    m_stage.wait("find the bench", [this] {
        const DeviceView *first = m_stage.device(tuned);
        return first && m_stage.device(&DemoUnits::overshooting) && m_stage.device(inBootloader)
            && first->liveness.heard && !first->identity->serial.empty();
    });
    m_stage.act("select", [this] { m_stage.window().selection().select(m_stage.device(tuned)->id); });
    m_stage.picture("overview", 1500ms);
}

void Tour::planParameters()
{
    m_stage.add(
        "read parameters", [this] { m_stage.window().showPage(PageId::Parameters); },
        [this] { return isRead(*m_stage.device(tuned)); });
    m_stage.picture("parameters", 300ms);
    const auto showHistory = [this](bool on) { m_stage.page<ParametersPage>(PageId::Parameters).showHistory(on); };
    m_stage.act("history", [showHistory] { showHistory(true); });
    m_stage.picture("history", 500ms);
    m_stage.act("values", [showHistory] { showHistory(false); });
    m_service.planKeeping();
}

void Tour::planFirmware()
{
    m_stage.add(
        "update",
        [this] {
            m_stage.window().selection().select(m_stage.device(inBootloader)->id);
            m_stage.window().showPage(PageId::Firmware);
            auto &page = m_stage.page<FirmwarePage>(PageId::Firmware);
            page.loadImage(QStringLiteral(":/firmware/") + qt(m_stage.device(inBootloader)->family->demo->image));
            page.startUpdate();
        },
        [this] {
            const OperationView *operation = m_stage.workbench().snapshot().operation(m_stage.device(inBootloader)->id);
            const auto &parts = operation ? operation->status.parts : std::map<int, PartState>{};
            return std::ranges::count_if(parts, [&](const auto &entry) { return entry.second == PartState::Done; })
                >= partsDone;
        },
        updateTime);
    m_stage.picture("firmware-running");
    m_stage.wait(
        "update to the end",
        [this] {
            // The newest operation may already be the one that reads the parameters of the new application.
            const auto &operations = m_stage.workbench().snapshot().operations;
            return std::ranges::any_of(operations, [this](const OperationView &operation) {
                return operation.device == m_stage.device(inBootloader)->id && operation.update
                    && operation.update->outcome == UpdateOutcome::Done;
            });
        },
        updateTime);
    m_stage.picture("firmware", 500ms);
    m_service.planQueue();
}

void Tour::planLog()
{
    m_stage.act("log", [this] { m_stage.window().showPage(PageId::Log); });
    m_stage.picture("log", 200ms);
    m_stage.add(
        "reports", [this] { m_stage.window().showPage(PageId::Reports); },
        [this] { return !m_stage.page<ReportsPage>(PageId::Reports).previewText().isEmpty(); });
    m_stage.picture("reports", 200ms);
}

/// The bench loses nothing, however busy the computer is.
void Tour::tellLosses()
{
    for (const DeviceView &device : m_stage.workbench().snapshot().devices) {
        const SampleCount count = samplesOf(device);
        std::printf("%s: %llu samples, %llu lost\n", device.selector.c_str(),
            static_cast<unsigned long long>(count.kept), static_cast<unsigned long long>(count.lost));
    }
    std::fflush(stdout);
}

} // namespace mb
