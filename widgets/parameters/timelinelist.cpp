// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/timelinelist.h"

#include "model/unit.h"
#include "settings/history.h"
#include "widgets/common/clocktext.h"
#include "widgets/common/devicetext.h"
#include "widgets/parameters/timelinedelegate.h"

#include <QDateTime>
#include <QMouseEvent>

#include <algorithm>

namespace mb {
namespace {

/// "A  as found", below it its time and how it differs: for who hears it.
QString spoken(const QListWidgetItem &row)
{
    QString title = row.data(TitleRole).toString();
    for (const QChar badge : row.data(BadgesRole).toString())
        title.prepend(QString(badge) + QStringLiteral("  "));
    QStringList second;
    for (const int role : {ClockRole, DetailRole, CountRole}) {
        const QString part = row.data(role).toString();
        if (!part.isEmpty())
            second << part;
    }
    return second.isEmpty() ? title : title + QLatin1Char('\n') + second.join(QStringLiteral(" · "));
}

} // namespace

QString originText(settings::Origin origin)
{
    switch (origin) {
    case settings::Origin::Window: return TimelineList::tr("window");
    case settings::Origin::Console: return TimelineList::tr("console");
    case settings::Origin::Tuning: return TimelineList::tr("autotune");
    case settings::Origin::Recipe: return TimelineList::tr("recipe");
    case settings::Origin::Elsewhere: return TimelineList::tr("elsewhere");
    }
    return {};
}

TimelineList::TimelineList(const ThemeSource &theme, QWidget *parent)
    : QListWidget(parent)
    , m_theme(theme)
{
    setAccessibleName(tr("States of this unit"));
    setItemDelegate(new TimelineDelegate(theme, this));
    setResizeMode(Adjust);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setUniformItemSizes(false);
    connect(this, &QListWidget::currentRowChanged, this, [this](int row) {
        const QListWidgetItem *shown = item(row);
        if (shown && shown->data(PlaceRole).isValid())
            Q_EMIT chosen(shown->data(PlaceRole).toInt(), m_asA);
    });
}

void TimelineList::mousePressEvent(QMouseEvent *event)
{
    m_asA = event->modifiers().testFlag(Qt::ShiftModifier);
    const QListWidgetItem *under = itemAt(event->pos());
    if (under && under == currentItem() && under->data(PlaceRole).isValid())
        Q_EMIT chosen(under->data(PlaceRole).toInt(), m_asA);
    QListWidget::mousePressEvent(event);
    m_asA = false; // also where it chose nothing
}

void TimelineList::addHead(const QString &text)
{
    auto *head = new QListWidgetItem(text, this);
    head->setData(HeadRole, true);
    head->setFlags(Qt::NoItemFlags);
}

void TimelineList::addDay(const QDate &day)
{
    if (std::exchange(m_day, day) == day)
        return;
    addHead(day == QDate::currentDate() ? tr("Today, %1").arg(dayText(day)) : dayText(day));
}

QString TimelineList::countText(int place, int a) const
{
    if (a < 0 || place == a)
        return {};
    const auto &first = m_states[static_cast<std::size_t>(a)].side;
    const std::size_t count = settings::compare(first, m_states[static_cast<std::size_t>(place)].side).size();
    return count == 0 ? tr("like A") : tr("%n differ", nullptr, static_cast<int>(count));
}

void TimelineList::addState(int place)
{
    const UnitState &state = m_states[static_cast<std::size_t>(place)];
    auto *row = new QListWidgetItem(this);
    row->setData(PlaceRole, place);
    row->setData(TitleRole, state.title);
    row->setData(DetailRole, state.detail);
    row->setData(ClockRole, state.time);
    row->setData(SymbolRole, static_cast<int>(state.symbol));
    row->setText(spoken(*row));
    row->setToolTip(state.title + QLatin1Char('\n') + state.detail);
}

void TimelineList::addChange(const Family &family, const settings::SettingsChange &change)
{
    const QString values = messageText(settings::textOf(family, change));
    const QString when = clockText(momentOf(change.time));
    const QString who = change.origin == settings::Origin::Elsewhere
        ? originText(change.origin)
        : tr("%1, %2").arg(originText(change.origin), qt(change.person));
    QString what = values;
    if (change.purpose == settings::Purpose::Undo)
        what = tr("undone: %1").arg(values);
    else if (change.purpose == settings::Purpose::Redo)
        what = tr("done again: %1").arg(values);
    else if (change.purpose == settings::Purpose::Revert)
        what = tr("reverted: %1").arg(values);
    auto *row = new QListWidgetItem(when + QStringLiteral(" · ") + who + QLatin1Char('\n') + what, this);
    row->setFlags(Qt::ItemIsEnabled);
    row->setData(TitleRole, who);
    row->setData(DetailRole, what);
    row->setData(ClockRole, when);
    row->setToolTip(what);
}

/// Of the writes those that nobody has shown yet: the newest `left`, down to a time.
void TimelineList::addChangesSince(
    const Family &family, const SettingsTimeline &timeline, double time, std::size_t &left)
{
    for (; left > 0 && timeline.changes[left - 1].time >= time; --left) {
        const settings::SettingsChange &change = timeline.changes[left - 1];
        if (settings::textOf(family, change).empty()) // nothing was taken, or what was there was stored
            continue;
        addDay(momentOf(change.time).date());
        addChange(family, change);
    }
}

void TimelineList::show(const Family &family, const std::vector<UnitState> &states, const SettingsTimeline &timeline)
{
    const QSignalBlocker quiet(this);
    clear();
    m_states = states;
    m_day = {};
    if (!timeline.snapshots.empty() && unitByOf(timeline.snapshots.back().unit) == UnitBy::Place)
        addHead(tr("This place, not this unit"));
    std::size_t left = timeline.changes.size();
    for (int place = 0; place < static_cast<int>(states.size()); ++place) {
        const UnitState &state = states[static_cast<std::size_t>(place)];
        switch (state.kind) {
        case UnitState::Kind::Now: addDay(QDate::currentDate()); break;
        case UnitState::Kind::Snapshot: {
            const auto snapshot = std::ranges::find_if(timeline.snapshots,
                [&state](const settings::ParameterSnapshot &each) { return each.number == state.number; });
            const double time = snapshot == timeline.snapshots.end() ? 0.0 : snapshot->time;
            addChangesSince(family, timeline, time, left);
            addDay(momentOf(time).date());
            break;
        }
        case UnitState::Kind::Defaults:
            addChangesSince(family, timeline, 0.0, left);
            addHead(tr("Always there"));
            break;
        }
        addState(place);
    }
}

void TimelineList::mark(int a, int b)
{
    const QSignalBlocker quiet(this);
    for (int row = 0; row < count(); ++row) {
        QListWidgetItem &shown = *item(row);
        const QVariant place = shown.data(PlaceRole);
        if (!place.isValid())
            continue;
        shown.setData(BadgesRole,
            QString(place.toInt() == a ? QStringLiteral("A") : QString())
                + (place.toInt() == b ? QStringLiteral("B") : QString()));
        shown.setData(CountRole, countText(place.toInt(), a));
        shown.setText(spoken(shown));
        if (place.toInt() == b)
            setCurrentRow(row);
    }
}

} // namespace mb
