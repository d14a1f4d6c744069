// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plottickers.h"

#include "widgets/common/clocktext.h"
#include "widgets/common/numberformat.h"
#include "widgets/plots/autorange.h"
#include "widgets/plots/telemetrysource.h"

#include <QDateTime>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace mb {
namespace {

constexpr double nextRound = 2.6;         ///< times a round step, below the one after it
constexpr double fromLabelToLabel = 1.25; ///< heights of one
constexpr double wholeDecadesFrom = 1e3;  ///< of a range, which has enough of them

QString labelOf(double tick)
{
    if (tick != 0 && (std::abs(tick) >= 1e7 || std::abs(tick) < 1e-4))
        return QString::number(tick, 'g', 4)
            .replace(QLatin1Char('.'), decimalSign())
            .replace(QLatin1Char('-'), MinusSign);
    const double rounded = std::round(tick * 1e6) / 1e6;
    QString plain = QString::number(std::abs(rounded), 'f', 6);
    while (plain.endsWith(QLatin1Char('0')))
        plain.chop(1);
    const int decimals = plain.endsWith(QLatin1Char('.')) ? 0 : plain.size() - plain.indexOf(QLatin1Char('.')) - 1;
    return formatNumber(rounded, decimals);
}

} // namespace

double NumberTicker::getTickStep(const QCPRange &range)
{
    double step = QCPAxisTicker::getTickStep(range);
    const auto labels
        = [&range](double width) { return std::floor(range.upper / width) - std::ceil(range.lower / width) + 1; };
    while (range.size() > 0 && labels(step) < 2)
        step = roundStep(step * 0.5);
    while (step < leastStep(range) && labels(roundStep(step * nextRound)) > 0)
        step = roundStep(step * nextRound);
    return step;
}

bool NumberTicker::spaceLabels(int label, int axis)
{
    const double share = axis > 0 ? fromLabelToLabel * label / axis : 0.0;
    return std::exchange(m_labelShare, share) != share;
}

QString NumberTicker::getTickLabel(double tick, const QLocale &, QChar, int)
{
    return labelOf(tick);
}

QVector<double> DecadeTicker::createTickVector(double, const QCPRange &range)
{
    QVector<double> ticks;
    if (range.lower <= 0.0)
        return ticks;
    for (double decade = std::pow(10.0, std::floor(std::log10(range.lower))); decade <= range.upper; decade *= 10.0) {
        ticks.append(decade);
        if (range.upper < wholeDecadesFrom * range.lower)
            ticks << 2.0 * decade << 5.0 * decade;
    }
    return ticks;
}

QString DecadeTicker::getTickLabel(double tick, const QLocale &, QChar, int)
{
    return labelOf(tick);
}

double TimeTicker::getTickStep(const QCPRange &range)
{
    const double rough = range.size() / tickCount();
    constexpr std::array<double, 13> Clock{1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600};
    m_step = roundStep(rough * 1.5);
    if (rough > 0.7)
        m_step = *std::ranges::min_element(
            Clock, [&](double a, double b) { return std::abs(std::log(a / rough)) < std::abs(std::log(b / rough)); });
    if (rough > 5400)
        m_step = std::ceil(rough / 3600) * 3600;
    return m_step;
}

QString TimeTicker::text(double key, double step) const
{
    const int decimals = step >= 1 ? 0 : static_cast<int>(std::ceil(-std::log10(step) - 1e-9));
    if (!m_clock || m_event) {
        const double seconds = key - m_event.value_or(0.0);
        return formatNumber(std::abs(seconds) < step * 1e-6 ? 0.0 : seconds, decimals);
    }
    const QDateTime time = momentOf(key + clockShift(*m_clock, key));
    if (decimals == 0)
        return clockText(time);
    return localNumber(time.toString(QStringLiteral("ss.zzz")).left(3 + std::min(decimals, 3)));
}

void TimeTicker::setEvent(std::optional<double> key)
{
    m_event = key;
    setTickOrigin(key.value_or(0.0));
}

QString TimeTicker::getTickLabel(double tick, const QLocale &, QChar, int)
{
    return text(tick, m_step);
}

} // namespace mb
