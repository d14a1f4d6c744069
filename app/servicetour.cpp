// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/servicetour.h"

#include "app/productionface.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/headerbar.h"
#include "widgets/firmware/firmwarepage.h"
#include "widgets/firmware/queueboard.h"
#include "widgets/firmware/queuemodel.h"
#include "widgets/parameters/keepbar.h"
#include "widgets/report/reportspage.h"
#include "widgets/service/productionpage.h"
#include "widgets/service/verdictview.h"

#include <QFile>
#include <QListWidget>

#include <algorithm>

namespace mb {
namespace {

constexpr std::chrono::seconds queueTime{120};
constexpr std::string_view liveKey = "current_limit.peak"; ///< more of it makes a motor livelier
constexpr int writtenShare = 40;                           ///< percent, when the picture of a queue is taken

} // namespace

ServiceTour::ServiceTour(Workbench &workbench, MainWindow &window, TourScript &script, QObject *parent)
    : QObject(parent)
    , m_workbench(workbench)
    , m_window(window)
    , m_tour(script)
{
}

const DeviceView *ServiceTour::unit(int DemoUnits::*which) const
{
    const auto &devices = m_workbench.snapshot().devices;
    const auto found = std::find_if(devices.begin(), devices.end(),
        [which](const DeviceView &d) { return d.family->demo && d.identity.address == d.family->demo->*which; });
    return found == devices.end() ? nullptr : &*found;
}

QString ServiceTour::image() const
{
    return QStringLiteral(":/firmware/") + qt(unit(&DemoUnits::inBootloader)->family->demo->image);
}

QueueBoard &ServiceTour::board() const
{
    return *qobject_cast<FirmwarePage *>(m_window.page(PageId::Firmware))->queue();
}

ProductionPage &ServiceTour::bench() const
{
    return *m_window.findChild<ProductionPage *>();
}

/// A limit that becomes wider.
void ServiceTour::loosen()
{
    const DeviceView *device = unit(&DemoUnits::tuned);
    const auto index = findParameter(device->family->parameters, liveKey);
    const auto raw = index ? device->parameters[index->value].raw : std::nullopt;
    if (raw)
        m_workbench.send(orders::WriteParameters{device->id, {{*index, *raw / 6 * 7}}});
}

void ServiceTour::planKeeping()
{
    m_tour.add(
        QStringLiteral("a limit that becomes wider"), [this] { loosen(); },
        [this] { return !m_workbench.snapshot().unconfirmed.empty(); });
    m_tour.pause(std::chrono::milliseconds(300));
    m_tour.picture(QStringLiteral("keep-or-revert"));
    m_tour.add(
        QStringLiteral("it goes back"), [this] { m_window.findChild<KeepBar *>()->putBack(); },
        [this] { return m_workbench.snapshot().unconfirmed.empty(); });
}

void ServiceTour::planQueue()
{
    m_tour.add(
        QStringLiteral("a queue of units"),
        [this] {
            m_window.showPage(PageId::Firmware);
            qobject_cast<FirmwarePage *>(m_window.page(PageId::Firmware))->showQueue(true);
            (void)board().openImage(image());
            board().model().tickAll(true);
            board().start();
        },
        [this] {
            const auto &lines = board().model().lines();
            return !unit(&DemoUnits::tuned)->busy.empty()
                && std::any_of(lines.begin(), lines.end(), [](const QueueLine &line) {
                       return line.state == service::RowState::Running && line.done.value_or(0) > writtenShare;
                   });
        },
        queueTime);
    m_tour.picture(QStringLiteral("queue-running"));
    m_tour.add(
        QStringLiteral("the queue to its end"), [] {}, [this] { return isOver(); }, queueTime);
    m_tour.pause(std::chrono::milliseconds(300));
    m_tour.picture(QStringLiteral("queue"));
}

bool ServiceTour::isOver() const
{
    const auto &lines = board().model().lines();
    return std::all_of(lines.begin(), lines.end(), [](const QueueLine &line) {
        return line.state == service::RowState::Passed || line.state == service::RowState::Failed
            || line.state == service::RowState::Refused;
    });
}

/// A screen that is not there is smaller than the pictures.
void ServiceTour::enterProduction()
{
    const QSize size = m_window.size();
    m_window.production()->show(true);
    m_window.setWindowState(m_window.windowState() & ~Qt::WindowFullScreen);
    m_window.resize(size);
    bench().setSound(false);
}

void ServiceTour::serveOne(const QString &name, const QByteArray &accept)
{
    QFile file(m_folder.filePath(name + QStringLiteral(".json")));
    const QByteArray text = R"({"recipe":1,"name":"drive-base rev C","family":")"
        + QByteArray::fromStdString(std::string(unit(&DemoUnits::tuned)->family->key))
        + R"(","test":{"loop":"velocity","to":8000,"time":0.8,
"limits":{"travel":400000,"speed":40000,"duty":0.9,"current":60},"accept":)"
        + accept + "}}";
    if (file.open(QIODevice::WriteOnly) && file.write(text) == text.size())
        file.close();
    (void)bench().openRecipe(file.fileName());
    bench().setAside();
    bench().start();
}

/// One unit, armed as a person arms: the lamp is held once the page has said what will move.
void ServiceTour::planVerdict(const QString &name, const QByteArray &accept)
{
    Lamp &lamp = m_window.findChild<HeaderBar *>()->lamp();
    m_tour.add(
        name, [this, name, accept] { serveOne(name, accept); },
        [this, &lamp] {
            const LampState state = lamp.status().state;
            if (bench().isServing() && (state == LampState::Safe || state == LampState::Stopped))
                Q_EMIT lamp.armRequested();
            return lamp.status().state == LampState::Armed;
        });
    m_tour.add(
        name, [this] { bench().pause(); },
        [this] {
            const Verdict::Kind kind = bench().verdict().verdict().kind;
            return kind == Verdict::Kind::Passed || kind == Verdict::Kind::Failed;
        },
        queueTime);
    m_tour.pause(std::chrono::milliseconds(300));
    m_tour.picture(name, true);
    m_tour.add(
        name, [this] { bench().finish(); }, [this] { return !bench().isServing(); });
}

void ServiceTour::planProduction()
{
    m_tour.add(
        QStringLiteral("production"), [this] { enterProduction(); }, [] { return true; });
    m_tour.picture(QStringLiteral("production"));
    planVerdict(QStringLiteral("production-pass"),
        R"({"settle":0.9,"sse":0.05,"friction":[0.01,1.2],"resistance":[0.02,0.5],"encoder":true})");
    planVerdict(QStringLiteral("production-fail"), R"({"friction":[0.001,0.01],"resistance":[0.02,0.5]})");
    m_tour.add(
        QStringLiteral("leave production"), [this] { m_window.production()->show(false); }, [] { return true; });
}

void ServiceTour::planJournal()
{
    m_tour.add(
        QStringLiteral("journal"),
        [this] {
            m_window.showPage(PageId::Reports);
            qobject_cast<ReportsPage *>(m_window.page(PageId::Reports))->setFilter(ReportsPage::Journal);
        },
        [this] {
            auto *reports = qobject_cast<ReportsPage *>(m_window.page(PageId::Reports));
            return reports->list().count() > 3 && !reports->previewText().isEmpty();
        });
    m_tour.pause(std::chrono::milliseconds(300));
    m_tour.picture(QStringLiteral("journal"));
}

} // namespace mb
