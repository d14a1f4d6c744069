// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/svgplot.h"

#include "report/htmltext.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mb {
namespace {

constexpr double plotLeft = 66.0;
constexpr double plotRight = 10.0;
constexpr double legendRoom = 20.0; ///< over each pane
constexpr double footRoom = 34.0;
constexpr double paneGap = 12.0;
constexpr int mostTicks = 6;
constexpr double headRoom = 0.06; ///< of the range, above and below
const QString inkColour = QStringLiteral("#171C22");
const QString dimColour = QStringLiteral("#47525E");
const QString gridColour = QStringLiteral("#E0E4EA");

struct Range {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
    void take(double value)
    {
        if (!std::isfinite(value))
            return;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    [[nodiscard]] bool isValid() const { return low <= high; }
};

QString coordinate(double value)
{
    return QString::number(value, 'f', 1);
}

/// 1, 2 or 5 of a power of ten.
double stepFor(double length)
{
    const double rough = length / mostTicks;
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= rough)
            return factor * power;
    }
    return 10.0 * power;
}

std::vector<double> ticksOf(const Range &range)
{
    std::vector<double> ticks;
    const double step = stepFor(range.high - range.low);
    for (double tick = std::ceil(range.low / step) * step; tick <= range.high + 1e-9 * step; tick += step)
        ticks.push_back(std::abs(tick) < 1e-9 * step ? 0.0 : tick);
    return ticks;
}

/// 1, 2 and 5 of each decade.
std::vector<double> logTicksOf(const Range &range)
{
    std::vector<double> ticks;
    for (double power = std::pow(10.0, std::floor(std::log10(range.low))); power <= range.high; power *= 10.0) {
        for (const double factor : {1.0, 2.0, 5.0}) {
            if (factor * power >= range.low && factor * power <= range.high)
                ticks.push_back(factor * power);
        }
    }
    return ticks;
}

QString tickText(double value)
{
    QString text = QString::number(value, 'g', 6);
    if (text.contains(QLatin1Char('e')))
        text = QString::number(value, 'f', 0);
    return text.replace(QLatin1Char('-'), QChar(0x2212));
}

QString svgLine(double x1, double y1, double x2, double y2, const QString &colour, const QString &dash = {})
{
    return QStringLiteral("<line x1=\"%1\" y1=\"%2\" x2=\"%3\" y2=\"%4\" stroke=\"%5\" stroke-width=\"%6\"%7/>\n")
        .arg(coordinate(x1), coordinate(y1), coordinate(x2), coordinate(y2), colour,
            dash.isNull() ? QStringLiteral("1") : QStringLiteral("1.6"),
            dash.isEmpty() ? QString() : QStringLiteral(" stroke-dasharray=\"%1\"").arg(dash));
}

QString svgWords(double x, double y, const QString &text, const char *anchor, const QString &colour, int size = 10)
{
    return QStringLiteral("<text x=\"%1\" y=\"%2\" text-anchor=\"%3\" font-size=\"%4\" fill=\"%5\">%6</text>\n")
        .arg(coordinate(x), coordinate(y), QLatin1String(anchor))
        .arg(size)
        .arg(colour, escaped(text));
}

/// One pane with its place in the drawing.
class Pane {
public:
    Pane(const SvgPane &pane, const Range &x, bool logarithmic, double top)
        : m_pane(pane)
        , m_x(x)
        , m_logarithmic(logarithmic)
        , m_top(top)
    {
        for (const SvgCurve &curve : pane.curves) {
            for (const double value : curve.trace.y)
                m_y.take(value);
        }
        if (!m_y.isValid())
            m_y = {0.0, 1.0};
        const double room = std::max(headRoom * (m_y.high - m_y.low), 1e-6 * std::max(1.0, std::abs(m_y.high)));
        m_y = {m_y.low - room, m_y.high + room};
    }

    [[nodiscard]] double bottom() const { return m_top + m_pane.height; }
    [[nodiscard]] double xOf(double value) const
    {
        const double share = m_logarithmic
            ? (std::log10(value) - std::log10(m_x.low)) / (std::log10(m_x.high) - std::log10(m_x.low))
            : (value - m_x.low) / (m_x.high - m_x.low);
        return plotLeft + share * (svgWidth - plotLeft - plotRight);
    }
    [[nodiscard]] double yOf(double value) const
    {
        return bottom() - (value - m_y.low) / (m_y.high - m_y.low) * m_pane.height;
    }

    [[nodiscard]] QString svg(const std::vector<double> &xTicks, const QString &mark) const
    {
        QString text;
        for (const double tick : xTicks)
            text += svgLine(xOf(tick), m_top, xOf(tick), bottom(), gridColour);
        for (const double tick : ticksOf(m_y)) {
            text += svgLine(plotLeft, yOf(tick), svgWidth - plotRight, yOf(tick), gridColour);
            text += svgWords(plotLeft - 6.0, yOf(tick) + 3.5, tickText(tick), "end", dimColour);
        }
        if (!mark.isEmpty())
            text += QStringLiteral("<text x=\"%1\" y=\"%2\" text-anchor=\"middle\" font-size=\"40\" "
                                   "font-weight=\"bold\" fill=\"#4A55C4\" fill-opacity=\"0.13\">%3</text>\n")
                        .arg(coordinate(0.5 * (plotLeft + svgWidth - plotRight)),
                            coordinate(m_top + 0.5 * m_pane.height + 14), escaped(mark));
        for (const SvgCurve &curve : m_pane.curves)
            text += curveSvg(curve);
        text += svgLine(plotLeft, m_top, plotLeft, bottom(), dimColour)
            + svgLine(plotLeft, bottom(), svgWidth - plotRight, bottom(), dimColour);
        text += svgWords(plotLeft, m_top - 6.0, m_pane.label, "start", dimColour);
        return text + legendSvg();
    }

private:
    /// The first, last, lowest and highest of what falls on one pixel.
    [[nodiscard]] QString curveSvg(const SvgCurve &curve) const
    {
        QString points;
        const tuning::Trace &trace = curve.trace;
        const auto put = [this, &points, &trace](std::size_t i) {
            const double y = std::clamp(yOf(trace.y[i]), m_top, bottom());
            points += coordinate(xOf(trace.t[i])) + QLatin1Char(',') + coordinate(y) + QLatin1Char(' ');
        };
        for (std::size_t i = 0; i < trace.size();) {
            if (trace.t[i] < m_x.low || trace.t[i] > m_x.high || !std::isfinite(trace.y[i])) {
                ++i;
                continue;
            }
            std::size_t end = i + 1;
            while (end < trace.size() && trace.t[end] <= m_x.high && xOf(trace.t[end]) - xOf(trace.t[i]) < 0.8)
                ++end;
            const auto begin = trace.y.begin();
            const auto [low, high]
                = std::minmax_element(begin + static_cast<std::ptrdiff_t>(i), begin + static_cast<std::ptrdiff_t>(end));
            std::vector<std::size_t> kept{
                i, static_cast<std::size_t>(low - begin), static_cast<std::size_t>(high - begin), end - 1};
            std::ranges::sort(kept);
            kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
            for (const std::size_t point : kept)
                put(point);
            i = end;
        }
        return QStringLiteral("<polyline fill=\"none\" stroke=\"%1\" stroke-width=\"1.6\"%2 points=\"%3\"/>\n")
            .arg(curve.colour,
                curve.dash.isEmpty() ? QString() : QStringLiteral(" stroke-dasharray=\"%1\"").arg(curve.dash),
                points.trimmed());
    }

    /// From the plotRight edge to the plotLeft, as wide as words usually are.
    [[nodiscard]] QString legendSvg() const
    {
        constexpr double letter = 5.9;
        constexpr double swatch = 26.0;
        double x = svgWidth - plotRight;
        QString text;
        for (auto curve = m_pane.curves.rbegin(); curve != m_pane.curves.rend(); ++curve) {
            if (curve->name.isEmpty())
                continue;
            text += svgWords(x, m_top - 6.0, curve->name, "end", inkColour);
            x -= letter * curve->name.size() + 6.0;
            text += svgLine(x - swatch, m_top - 9.5, x, m_top - 9.5, curve->colour,
                curve->dash.isEmpty() ? QStringLiteral("") : curve->dash);
            x -= swatch + 14.0;
        }
        return text;
    }

    const SvgPane &m_pane;
    Range m_x;
    Range m_y;
    bool m_logarithmic;
    double m_top;
};

} // namespace

QString svgOf(const SvgPlot &plot)
{
    Range x;
    std::size_t most = 0;
    for (const SvgPane &pane : plot.panes) {
        for (const SvgCurve &curve : pane.curves) {
            most = std::max(most, curve.trace.size());
            for (const double t : curve.trace.t) {
                if (!plot.logarithmic || t > 0.0)
                    x.take(t);
            }
        }
    }
    if (most < 2 || !x.isValid() || x.high <= x.low)
        return {};
    const std::vector<double> ticks = plot.logarithmic ? logTicksOf(x) : ticksOf(x);
    QString body;
    double top = legendRoom;
    double bottom = top;
    for (const SvgPane &pane : plot.panes) {
        const Pane placed(pane, x, plot.logarithmic, top);
        body += placed.svg(ticks, plot.mark);
        bottom = placed.bottom();
        top = bottom + paneGap + legendRoom;
        if (&pane != &plot.panes.back())
            continue;
        for (const double tick : ticks)
            body += svgWords(placed.xOf(tick), bottom + 14.0, tickText(tick), "middle", dimColour);
    }
    body += svgWords(svgWidth - plotRight, bottom + 29.0, plot.label, "end", dimColour);
    const int height = static_cast<int>(std::ceil(bottom + footRoom));
    return QStringLiteral("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%1\" height=\"%2\" viewBox=\"0 0 %1 %2\" "
                          "font-family=\"Noto Sans, DejaVu Sans, sans-serif\" role=\"img\"><title>%3</title>\n%4"
                          "</svg>")
        .arg(QString::number(svgWidth), QString::number(height), escaped(plot.description), body);
}

} // namespace mb
