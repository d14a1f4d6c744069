// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/numberformat.h"
#include "widgets/plots/autorange.h"
#include "widgets/plots/plotdecor.h"
#include "widgets/plots/plotframe.h"

#include <QDateTime>
#include <cmath>

namespace mb {

PlotFoot::PlotFoot(QCustomPlot &plot, const ThemeSource &theme)
    : QCPLayoutElement(&plot)
    , m_theme(theme)
{
    setLayer(QStringLiteral("axes"));
    setMinimumMargins({});
    setMargins({});
}

void PlotFoot::setTexts(const QString &left, const QString &right, bool loss)
{
    m_left = left;
    m_right = right;
    m_loss = loss;
}

QSize PlotFoot::minimumOuterSizeHint() const
{
    return {10, m_theme.theme().u(24)};
}

QSize PlotFoot::maximumOuterSizeHint() const
{
    return {QWIDGETSIZE_MAX, m_theme.theme().u(24)};
}

void PlotFoot::draw(QCPPainter *painter)
{
    const auto *frame = qobject_cast<const PlotFrame *>(parentPlot());
    if (frame && frame->stands())
        return;
    const Theme &theme = m_theme.theme();
    const QRectF box = rect();
    painter->setAntialiasing(false);
    painter->fillRect(QRectF(box.left(), box.top(), box.width(), 1), theme.line);
    const QFont font = theme.font(TextRole::Caption, parentPlot()->font());
    const QFontMetrics metrics(font);
    const QRectF line = box.adjusted(theme.u(12), 0, -theme.u(12), 0);
    const int leftWidth = metrics.horizontalAdvance(m_left) + theme.u(16);
    const int room = static_cast<int>(line.width()) - leftWidth;
    painter->setFont(font);
    painter->setPen(theme.dim);
    painter->drawText(line, Qt::AlignLeft | Qt::AlignVCenter, m_left);
    painter->setPen(m_loss ? theme.caution : theme.dim);
    painter->drawText(
        line, Qt::AlignRight | Qt::AlignVCenter, metrics.elidedText(m_right, Qt::ElideLeft, std::max(room, 0)));
}

double NumberTicker::getTickStep(const QCPRange &range)
{
    double step = QCPAxisTicker::getTickStep(range);
    const auto labels
        = [&range](double width) { return std::floor(range.upper / width) - std::ceil(range.lower / width) + 1; };
    while (range.size() > 0 && labels(step) < 2)
        step = roundStep(step * 0.5);
    return step;
}

QString NumberTicker::getTickLabel(double tick, const QLocale &, QChar, int)
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

double TimeTicker::getTickStep(const QCPRange &range)
{
    const double rough = range.size() / tickCount();
    constexpr std::array<double, 13> Clock{1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600};
    m_step = roundStep(rough * 1.5);
    if (rough > 0.7)
        m_step = *std::min_element(Clock.begin(), Clock.end(),
            [&](double a, double b) { return std::abs(std::log(a / rough)) < std::abs(std::log(b / rough)); });
    if (rough > 5400)
        m_step = std::ceil(rough / 3600) * 3600;
    return m_step;
}

QString TimeTicker::text(double key, double step) const
{
    const int decimals = step >= 1 ? 0 : static_cast<int>(std::ceil(-std::log10(step) - 1e-9));
    if (!m_unixAtZero)
        return formatNumber(std::abs(key) < step * 1e-6 ? 0.0 : key, decimals);
    const auto time = QDateTime::fromMSecsSinceEpoch(std::llround((key + *m_unixAtZero) * 1000));
    if (decimals == 0)
        return time.toString(QStringLiteral("HH:mm:ss"));
    return time.toString(QStringLiteral("ss.zzz")).left(3 + std::min(decimals, 3));
}

QString TimeTicker::getTickLabel(double tick, const QLocale &, QChar, int)
{
    return text(tick, m_step);
}

} // namespace mb
