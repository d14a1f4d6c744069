// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/timelinelist.h"

#include "settings/history.h"
#include "widgets/common/clocktext.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/icons.h"

#include <QDateTime>
#include <QMouseEvent>

#include <algorithm>

namespace mb {
namespace {

constexpr int statePlaceRole = Qt::UserRole;

Symbol stateSymbol(UnitState::Kind kind)
{
    switch (kind) {
    case UnitState::Kind::Now: return Symbol::Chip;
    case UnitState::Kind::Snapshot: return Symbol::Camera;
    case UnitState::Kind::Defaults: return Symbol::Document;
    }
    return Symbol::Chip;
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
    setWordWrap(true);
    setResizeMode(Adjust);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setUniformItemSizes(false);
    connect(this, &QListWidget::currentRowChanged, this, [this](int row) {
        const QListWidgetItem *shown = item(row);
        if (shown && shown->data(statePlaceRole).isValid())
            Q_EMIT chosen(shown->data(statePlaceRole).toInt(), std::exchange(m_asA, false));
    });
}

void TimelineList::mousePressEvent(QMouseEvent *event)
{
    m_asA = event->modifiers().testFlag(Qt::ShiftModifier);
    const QListWidgetItem *under = itemAt(event->pos());
    if (under && under == currentItem() && under->data(statePlaceRole).isValid())
        Q_EMIT chosen(under->data(statePlaceRole).toInt(), std::exchange(m_asA, false));
    QListWidget::mousePressEvent(event);
}

void TimelineList::addDay(const QDate &day)
{
    if (day == m_day)
        return;
    m_day = day;
    const bool today = day == QDate::currentDate();
    auto *head = new QListWidgetItem(today ? tr("Today, %1").arg(locale().toString(day, QLocale::ShortFormat))
                                           : locale().toString(day, QLocale::LongFormat),
        this);
    head->setFlags(Qt::NoItemFlags);
    QFont bold = font();
    bold.setBold(true);
    head->setFont(bold);
}

QString TimelineList::textOf(int place, int a, int b) const
{
    const UnitState &state = m_states[static_cast<std::size_t>(place)];
    QString title = state.title;
    if (place == a)
        title = QStringLiteral("A  ") + title;
    if (place == b)
        title = QStringLiteral("B  ") + title;
    QStringList second;
    if (!state.time.isEmpty())
        second << state.time;
    if (a >= 0 && place != a) {
        const auto &first = m_states[static_cast<std::size_t>(a)].side;
        const std::size_t count = settings::compare(first, state.side).size();
        second << (count == 0 ? tr("like A") : tr("%n differ from A", nullptr, static_cast<int>(count)));
    }
    return second.isEmpty() ? title : title + QLatin1Char('\n') + second.join(QStringLiteral(" · "));
}

void TimelineList::addState(int place)
{
    auto *row = new QListWidgetItem(
        symbolIcon(stateSymbol(m_states[static_cast<std::size_t>(place)].kind), m_theme.theme(), Tone::Dim),
        textOf(place, -1, -1), this);
    row->setData(statePlaceRole, place);
}

void TimelineList::addChange(const Family &family, const settings::SettingsChange &change)
{
    const QString values
        = messageText(settings::textOf(family, change)).replace(QStringLiteral("->"), QStringLiteral("→"));
    if (values.isEmpty())
        return;
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
        what = tr("put back: %1").arg(values);
    auto *row = new QListWidgetItem(when + QStringLiteral(" · ") + who + QLatin1Char('\n') + what, this);
    row->setFlags(Qt::ItemIsEnabled);
    row->setForeground(m_theme.theme().tone(Tone::Dim));
    row->setToolTip(what);
}

void TimelineList::show(const Family &family, const std::vector<UnitState> &states, const SettingsTimeline &timeline)
{
    const QSignalBlocker quiet(this);
    clear();
    m_states = states;
    m_day = {};
    auto snapshot = timeline.snapshots.rbegin();
    auto change = timeline.changes.rbegin();
    for (int place = 0; place < static_cast<int>(states.size()); ++place) {
        const UnitState &state = states[static_cast<std::size_t>(place)];
        if (state.kind == UnitState::Kind::Snapshot) {
            snapshot = std::find_if(snapshot, timeline.snapshots.rend(),
                [&state](const settings::ParameterSnapshot &each) { return each.number == state.number; });
            const double time = snapshot == timeline.snapshots.rend() ? 0.0 : snapshot->time;
            for (; change != timeline.changes.rend() && change->time >= time; ++change) {
                addDay(momentOf(change->time).date());
                addChange(family, *change);
            }
            addDay(momentOf(time).date());
        } else if (state.kind == UnitState::Kind::Defaults) {
            for (; change != timeline.changes.rend(); ++change) {
                addDay(momentOf(change->time).date());
                addChange(family, *change);
            }
        }
        addState(place);
    }
}

void TimelineList::mark(int a, int b)
{
    const QSignalBlocker quiet(this);
    for (int row = 0; row < count(); ++row) {
        const QVariant place = item(row)->data(statePlaceRole);
        if (!place.isValid())
            continue;
        item(row)->setText(textOf(place.toInt(), a, b));
        if (place.toInt() == b)
            setCurrentRow(row);
    }
}

} // namespace mb
