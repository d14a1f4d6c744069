// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sessionkeeper.h"

#include "app/mainwindow.h"
#include "async/seconds.h"
#include "widgets/common/devicetext.h"
#include "widgets/connection/deviceactions.h"

#include <algorithm>
#include <array>
#include <utility>

namespace mb {
namespace {

constexpr std::chrono::seconds writingTime{2};
constexpr std::array pageNames{
    "overview", "parameters", "tune", "design", "plots", "firmware", "bus", "log", "reports"};
static_assert(pageNames.size() == static_cast<std::size_t>(PageId::Reports) + 1);

} // namespace

QString pageName(int page)
{
    return page >= 0 && page < static_cast<int>(pageNames.size())
        ? QString::fromLatin1(pageNames[static_cast<std::size_t>(page)])
        : QString();
}

SessionKeeper::SessionKeeper(MainWindow &window, Workbench &workbench, SessionBook &book, qint64 begun)
    : QObject(&window)
    , m_window(window)
    , m_workbench(workbench)
    , m_book(book)
    , m_begun(begun)
{
    m_time.setInterval(writingTime);
    connect(&m_time, &QTimer::timeout, this, &SessionKeeper::follow);
    connect(&workbench, &Workbench::changed, this, &SessionKeeper::takeUp);
    connect(&window.selection(), &Selection::kept, this, [this] { m_wanted = {}; });
    m_time.start();
}

qint64 SessionKeeper::unixNow() const
{
    return static_cast<qint64>(unixSeconds(m_workbench));
}

SessionRecord SessionKeeper::present() const
{
    SessionRecord record;
    record.begun = m_begun;
    const Snapshot &shot = m_workbench.snapshot();
    for (const LinkView &link : shot.links)
        record.links += QString::fromStdString(link.address);
    for (const DeviceView &device : shot.devices)
        record.units += titleOf(device);
    if (const DeviceView *device = shot.device(m_window.selection().device()))
        record.selected = QString::fromStdString(device->selector);
    record.axis = m_window.selection().axis();
    record.page = pageName(static_cast<int>(m_window.shownPage()));
    record.geometry = m_window.saveGeometry();
    return record;
}

void SessionKeeper::follow()
{
    if (!present().isSameView(m_written))
        save(false);
}

void SessionKeeper::save(bool ended)
{
    SessionRecord record = present();
    if (ended && !record.isWorthKeeping())
        record = m_written; // links were closed one after the other
    record.begun = m_begun;
    record.changed = unixNow();
    record.ended = ended;
    m_disk.order(
        QStringLiteral("session"), [&book = m_book, record] { return book.save(record); },
        [this](const Result<void> &saved) {
            if (!saved && !std::exchange(m_told, true))
                m_workbench.report(
                    Severity::Caution, {}, tr("This session cannot be kept: %1").arg(errorText(saved.error())));
        });
    m_written = record;
    if (ended)
        m_time.stop();
}

void SessionKeeper::restore(const SessionRecord &record)
{
    const Snapshot &shot = m_workbench.snapshot();
    for (const QString &link : record.links) {
        if (!shot.link(link.toStdString()))
            openAddress(m_workbench, link, {});
    }
    comeBack(record);
}

void SessionKeeper::comeBack(const SessionRecord &record)
{
    m_wanted = record;
    m_wantedAt = m_workbench.now();
    takeUp();
}

void SessionKeeper::takeUp()
{
    if (m_wanted.selected.isEmpty())
        return;
    if (m_workbench.now() - m_wantedAt > patience) {
        m_wanted = {};
        return;
    }
    const auto &devices = m_workbench.snapshot().devices;
    const auto found = std::ranges::find_if(
        devices, [this](const DeviceView &device) { return device.selector == m_wanted.selected.toStdString(); });
    if (found == devices.end())
        return;
    const SessionRecord wanted = std::exchange(m_wanted, {});
    m_window.selection().select(found->id, wanted.axis);
    for (int page = 0; page < static_cast<int>(pageNames.size()); ++page) {
        if (pageName(page) == wanted.page)
            m_window.showPage(static_cast<PageId>(page));
    }
}

} // namespace mb
