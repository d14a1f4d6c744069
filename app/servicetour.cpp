// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/servicetour.h"

#include "app/productionface.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/lamp.h"
#include "widgets/firmware/firmwarepage.h"
#include "widgets/firmware/queueboard.h"
#include "widgets/firmware/queuemodel.h"
#include "widgets/parameters/keepbar.h"
#include "widgets/report/reportspage.h"

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
}

/// The verdict on the unit that the queue served last, as the bench shows it; also without its colours.
void ServiceTour::planProduction()
{
    showVerdict(QStringLiteral("production-pass"));
}

void ServiceTour::showVerdict(const QString &name)
{
    m_tour.add(
        QStringLiteral("production"), [this] { enterProduction(); }, [] { return true; });
    m_tour.pause(std::chrono::milliseconds(300));
    m_tour.picture(name, true);
    m_tour.add(
        QStringLiteral("leave production"), [this] { m_window.production()->show(false); }, [] { return true; });
}

/// A self-test whose limits nobody keeps, of one unit.
void ServiceTour::beginStrict()
{
    const DeviceView *device = unit(&DemoUnits::tuned);
    const QByteArray recipe = R"({"recipe":1,"name":"drive-base rev C","family":")"
        + QByteArray::fromStdString(std::string(device->family->key))
        + R"(","test":{"loop":"velocity","to":2000,"limits":{"travel":20000,"speed":20000,"duty":0.5,"current":40},
"accept":{"settle":0.02,"overshoot":0.6}}})";
    const QString path = m_folder.filePath(QStringLiteral("strict.json"));
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(recipe) != recipe.size())
        return;
    file.close();
    m_window.showPage(PageId::Firmware);
    (void)board().openRecipe(path);
    board().model().tickAll(false);
    board().model().tick(device->id, true);
    board().start();
}

const QueueLine *ServiceTour::strictLine() const
{
    const DeviceView *device = unit(&DemoUnits::tuned);
    for (const QueueLine &line : board().model().lines()) {
        if (device && line.device == device->id)
            return &line;
    }
    return nullptr;
}

/// It waits until somebody arms, and then fails.
void ServiceTour::planFail()
{
    m_tour.add(
        QStringLiteral("a self-test that waits for arming"), [this] { beginStrict(); },
        [this] {
            const QueueLine *line = strictLine();
            return line && line->state == service::RowState::Running && line->glyph == GlyphState::Waiting;
        },
        queueTime);
    m_tour.picture(QStringLiteral("queue-waits-for-arm"));
    m_tour.add(
        QStringLiteral("a self-test out of its limits"),
        [this] { Q_EMIT m_window.findChild<Lamp *>()->armRequested(); },
        [this] {
            const QueueLine *line = strictLine();
            return line && line->state == service::RowState::Failed;
        },
        queueTime);
    showVerdict(QStringLiteral("production-fail"));
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
            return reports->list().count() > 2 && !reports->previewText().isEmpty();
        });
    m_tour.pause(std::chrono::milliseconds(300));
    m_tour.picture(QStringLiteral("journal"));
}

} // namespace mb
