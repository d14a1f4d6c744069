// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/clocktext.h"

#include "widgets/common/workbench.h"

#include <QRegularExpression>

#include <cmath>

namespace mb {

QDateTime momentOf(double unixTime)
{
    return QDateTime::fromMSecsSinceEpoch(std::llround(unixTime * 1e3));
}

QDateTime momentOf(Workbench &workbench, Instant time)
{
    const Duration unixTime = workbench.wallClock().unixTime(time);
    return QDateTime::fromMSecsSinceEpoch(std::chrono::floor<std::chrono::milliseconds>(unixTime).count());
}

QString clockText(const QDateTime &moment, ClockPart part)
{
    switch (part) {
    case ClockPart::Minutes: return moment.toString(QStringLiteral("HH:mm"));
    case ClockPart::Seconds: break;
    case ClockPart::Milliseconds: return moment.toString(QStringLiteral("HH:mm:ss.zzz"));
    }
    return moment.toString(QStringLiteral("HH:mm:ss"));
}

QString dayText(const QDate &day, const QLocale &locale)
{
    static const QRegularExpression weekday(QStringLiteral("\\s*dddd,?\\s*"));
    static const QRegularExpression year(QStringLiteral(",?\\s*('de'\\s*)?yyyy年?\\s*"));
    QString form = locale.dateFormat(QLocale::LongFormat).remove(weekday);
    if (day.year() == QDate::currentDate().year())
        form.remove(year);
    return locale.toString(day, form);
}

QString dateAndClockText(const QDateTime &moment)
{
    return QLocale().toString(moment.date(), QLocale::ShortFormat) + QLatin1Char(' ')
        + clockText(moment, ClockPart::Minutes);
}

} // namespace mb
