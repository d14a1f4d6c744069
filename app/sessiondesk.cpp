// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sessiondesk.h"

#include "app/crashnotice.h"
#include "app/crashreport.h"
#include "app/linkowners.h"
#include "app/mainwindow.h"
#include "app/sessionkeeper.h"
#include "app/welcome.h"
#include "widgets/common/banner.h"
#include "widgets/common/clocktext.h"
#include "widgets/common/devicetext.h"
#include "widgets/connection/startpage.h"

#include <QBoxLayout>
#include <QCoreApplication>
#include <QDateTime>
#include <QFileInfo>
#include <QLocale>
#include <QStandardPaths>

namespace mb {
namespace {

constexpr int mostRecent = 4;

QString ownersFolder()
{
    return QStandardPaths::writableLocation(QStandardPaths::RuntimeLocation) + QStringLiteral("/motorbench/links");
}

} // namespace

QString whenText(qint64 unixTime, qint64 now)
{
    const QDateTime then = QDateTime::fromSecsSinceEpoch(unixTime);
    const QDate today = QDateTime::fromSecsSinceEpoch(now).date();
    const QString clock = clockText(then, ClockPart::Minutes);
    if (then.date() == today)
        return SessionDesk::tr("today %1").arg(clock);
    if (then.date() == today.addDays(-1))
        return SessionDesk::tr("yesterday %1").arg(clock);
    return SessionDesk::tr("%1, %2").arg(QLocale().toString(then.date(), QLocale::ShortFormat), clock);
}

SessionDesk::SessionDesk(Workbench &workbench, const ThemeSource &theme, const QString &folder)
    : m_workbench(workbench)
    , m_theme(theme)
    , m_folder(folder)
    , m_book(folder + QStringLiteral("/sessions"))
    , m_owners(new LinkOwners(workbench, ownersFolder(), this))
    , m_begun(QDateTime::currentSecsSinceEpoch())
{
    m_earlier = m_book.earlier();
    if (const auto begun = m_book.begin(m_begun); !begun)
        workbench.report(Severity::Caution, {}, errorText(begun.error()));
    connect(qApp, &QCoreApplication::aboutToQuit, this, [this] {
        if (m_keeper)
            m_keeper->save(true);
    });
}

SessionDesk::~SessionDesk() = default;

void SessionDesk::attach(MainWindow &window, Welcome &welcome)
{
    m_keeper = new SessionKeeper(window, m_workbench, m_book, m_begun);
    connect(m_keeper, &QObject::destroyed, this, [this](const QObject *gone) {
        if (m_keeper == gone)
            m_keeper = nullptr;
    });
    connect(m_owners, &LinkOwners::shared, &window, [&window](const QString &link, const QString &owner) {
        window.banners().post(QStringLiteral("shared/") + link, BannerKind::Caution,
            tr("%1 is used by %2 too").arg(link, owner), tr("agree who drives: two masters disturb each other"));
    });
    fillRecent(welcome);
    if (!std::exchange(m_first, false))
        return;
    if (m_book.crashed())
        offerCrashed(window);
    else if (!m_earlier.empty())
        m_keeper->comeBack(m_earlier.front().record);
}

void SessionDesk::offerCrashed(MainWindow &window)
{
    const SessionBook::Entry entry = *m_book.crashed();
    const QString words = tr("The program ended unexpectedly (%1). What was measured is kept. Open again: %2?")
                              .arg(whenText(entry.record.changed, m_begun),
                                  (entry.record.units.isEmpty() ? entry.record.links : entry.record.units)
                                      .mid(0, mostRecent)
                                      .join(QStringLiteral(", ")));
    const QString report = newestCrashReport(m_folder + QStringLiteral("/crashes"));
    const bool ofThis = !report.isEmpty() && QFileInfo(report).lastModified().toSecsSinceEpoch() >= entry.record.begun;
    auto *notice = new CrashNotice(words, ofThis ? report : QString(), m_theme, &window);
    window.addAbovePages(*notice);
    connect(notice, &CrashNotice::restoreWanted, this, [this, entry] { m_keeper->restore(entry.record); });
    connect(notice, &CrashNotice::dismissed, this, [this, entry] { m_book.settle(entry); });
}

ListCard::Row SessionDesk::rowOf(const SessionRecord &record) const
{
    ListCard::Row row;
    row.symbol = Symbol::Clock;
    row.name = (record.units.isEmpty() ? record.links : record.units).join(QStringLiteral(", "));
    row.tooltip = row.name;
    row.words = QStringList{whenText(record.changed, m_begun), tr("%n unit(s)", nullptr, record.units.size()),
        record.links.join(QStringLiteral(", "))}
                    .join(QStringLiteral(" · "));
    row.action = tr("Open");
    return row;
}

void SessionDesk::fillRecent(Welcome &welcome)
{
    std::vector<ListCard::Row> rows;
    for (const SessionBook::Entry &entry : m_earlier) {
        if (rows.size() < mostRecent)
            rows.push_back(rowOf(entry.record));
    }
    welcome.start().setRecent(rows);
    connect(&welcome.start(), &StartPage::recentWanted, m_keeper,
        [this](int row) { m_keeper->restore(m_earlier.at(static_cast<std::size_t>(row)).record); });
}

} // namespace mb
