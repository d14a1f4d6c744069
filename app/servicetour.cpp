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

using namespace std::chrono_literals;

constexpr std::chrono::seconds queueTime{120};
constexpr int writtenShare = 40; ///< percent, when the picture of a queue is taken

} // namespace

QueueBoard &ServiceTour::board() const
{
    return m_stage.page<FirmwarePage>(PageId::Firmware).queue();
}

/// A limit that becomes wider.
void ServiceTour::loosen()
{
    const DeviceView *device = unit();
    const auto index = findParameter(device->family->parameters, device->family->demo->livelierLimit);
    const auto raw = index ? (*device->parameters)[index->value].raw : std::nullopt;
    if (raw)
        m_stage.workbench().send(orders::WriteParameters{device->id, {{*index, *raw / 6 * 7}}});
}

void ServiceTour::planKeeping()
{
    m_stage.add(
        "a limit that becomes wider", [this] { loosen(); },
        [this] { return !m_stage.workbench().snapshot().unconfirmed.empty(); });
    m_stage.picture("keep-or-revert", 300ms);
    m_stage.add(
        "it goes back", [this] { m_stage.window().findChild<KeepBar *>()->putBack(); },
        [this] { return m_stage.workbench().snapshot().unconfirmed.empty(); });
}

void ServiceTour::planQueue()
{
    m_stage.add(
        "a queue of units",
        [this] {
            m_stage.window().showPage(PageId::Firmware);
            m_stage.page<FirmwarePage>(PageId::Firmware).showQueue(true);
            (void)board().openImage(
                QStringLiteral(":/firmware/") + qt(m_stage.device(&DemoUnits::inBootloader)->family->demo->image));
            board().model().tickAll(true);
            board().start();
        },
        [this] {
            const auto &lines = board().model().lines();
            return !unit()->busy.empty() && std::ranges::any_of(lines, [](const QueueLine &line) {
                return line.state == service::RowState::Running && line.done.value_or(0) > writtenShare;
            });
        },
        queueTime);
    m_stage.picture("queue-running");
    m_stage.wait(
        "the queue to its end", [this] { return isOver(); }, queueTime);
    m_stage.picture("queue", 300ms);
}

bool ServiceTour::isOver() const
{
    const auto &lines = board().model().lines();
    return std::ranges::all_of(lines, [](const QueueLine &line) {
        return line.state == service::RowState::Passed || line.state == service::RowState::Failed
            || line.state == service::RowState::Refused;
    });
}

/// A screen that is not there is smaller than the pictures.
void ServiceTour::enterProduction()
{
    const QSize size = m_stage.window().size();
    m_stage.window().production().show(true);
    m_stage.window().setWindowState(m_stage.window().windowState() & ~Qt::WindowFullScreen);
    m_stage.window().resize(size);
}

/// The verdict on the unit that the queue served last, as the bench shows it; also without its colours.
void ServiceTour::planProduction()
{
    showVerdict("production-pass");
}

void ServiceTour::showVerdict(const char *name)
{
    m_stage.act("production", [this] { enterProduction(); });
    m_stage.picture(name, 300ms, true);
    m_stage.act("leave production", [this] { m_stage.window().production().show(false); });
}

/// A self-test whose limits nobody keeps, of one unit.
void ServiceTour::beginStrict()
{
    const DeviceView *device = unit();
    const QByteArray recipe = R"({"recipe":1,"name":"drive-base rev C","family":")"
        + QByteArray::fromStdString(std::string(device->family->key))
        + R"(","test":{"loop":"velocity","to":2000,"limits":{"travel":20000,"speed":20000,"duty":0.5,"current":40},
"accept":{"settle":0.02,"overshoot":0.6}}})";
    const QString path = m_folder.filePath(QStringLiteral("strict.json"));
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(recipe) != recipe.size())
        return;
    file.close();
    m_stage.window().showPage(PageId::Firmware);
    (void)board().openRecipe(path);
    board().model().tickAll(false);
    board().model().tick(device->id, true);
    board().start();
}

const QueueLine *ServiceTour::strictLine() const
{
    const DeviceView *device = unit();
    for (const QueueLine &line : board().model().lines()) {
        if (device && line.device == device->id)
            return &line;
    }
    return nullptr;
}

/// It waits until somebody arms, and then fails.
void ServiceTour::planFail()
{
    m_stage.add(
        "a self-test that waits for arming", [this] { beginStrict(); },
        [this] {
            const QueueLine *line = strictLine();
            return line && line->state == service::RowState::Running && line->glyph == GlyphState::Waiting;
        },
        queueTime);
    m_stage.picture("queue-waits-for-arm");
    m_stage.add(
        "a self-test out of its limits", [this] { Q_EMIT m_stage.window().findChild<Lamp *>()->armRequested(); },
        [this] {
            const QueueLine *line = strictLine();
            return line && line->state == service::RowState::Failed;
        },
        queueTime);
    showVerdict("production-fail");
}

void ServiceTour::planJournal()
{
    m_stage.add(
        "journal",
        [this] {
            m_stage.window().showPage(PageId::Reports);
            m_stage.page<ReportsPage>(PageId::Reports).setFilter(ReportsPage::Journal);
        },
        [this] {
            auto &reports = m_stage.page<ReportsPage>(PageId::Reports);
            return reports.list().count() > 2 && !reports.previewText().isEmpty();
        });
    m_stage.picture("journal", 300ms);
}

} // namespace mb
