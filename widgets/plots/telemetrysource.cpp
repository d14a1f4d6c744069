// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/telemetrysource.h"

#include "widgets/common/numberformat.h"
#include "widgets/plots/columnpath.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace mb {
namespace {

struct SourceText {
    Q_DECLARE_TR_FUNCTIONS(SourceText)
};

} // namespace

TelemetrySource::TelemetrySource(std::shared_ptr<const Telemetry> telemetry, ChannelIndex channel, Foot foot)
    : m_telemetry(std::move(telemetry))
    , m_channel(channel)
    , m_foot(foot)
{
}

void TelemetrySource::follow(double rate, Instant now)
{
    m_rate = rate;
    m_now = now;
}

void TelemetrySource::columns(double from, double to, int pixels, std::vector<PlotPoint> &points) const
{
    m_telemetry->columns(m_channel, instantOf(from), instantOf(to), pixels, m_window);
    const std::vector<Point> &found = m_window.points();
    const auto first
        = std::partition_point(found.begin(), found.end(), [this](const Point &point) { return point.time < m_since; });
    points.resize(static_cast<std::size_t>(found.end() - first));
    std::transform(first, found.end(), points.begin(), [scale = m_scale](const Point &point) {
        return PlotPoint{plotKey(point.time), point.value * scale};
    });
}

std::optional<double> TelemetrySource::latest() const
{
    const auto last = m_telemetry->last(m_channel);
    if (!last || last->isGap() || last->time < m_since)
        return std::nullopt;
    const double patience = m_rate > 0.0 ? std::max(2.0, 3.0 / m_rate) : 2.0;
    if (m_now != Instant{} && plotKey(m_now) - plotKey(last->time) > patience)
        return std::nullopt;
    return last->value * m_scale;
}

std::optional<TraceSource::Statistics> TelemetrySource::statistics(double from, double to) const
{
    const Instant begin = std::max(instantOf(std::min(from, to)), m_since);
    const auto found = m_telemetry->statistics(m_channel, begin, instantOf(std::max(from, to)));
    if (!found)
        return std::nullopt;
    const double size = std::abs(m_scale);
    const auto [low, high] = std::minmax({found->low * m_scale, found->high * m_scale});
    return Statistics{
        found->count, found->lost, found->mean * m_scale, found->deviation * size, found->rms * size, low, high};
}

std::optional<double> TelemetrySource::valueAt(double key) const
{
    const std::size_t after = m_telemetry->lowerBound(m_channel, instantOf(key));
    std::vector<Point> around; // with the gaps before each
    (void)m_telemetry->read(m_channel, after > 0 ? after - 1 : after, Instant::max(), 2, around);
    std::vector<PlotPoint> points;
    for (const Point &point : around) {
        if (point.time >= m_since)
            points.push_back({plotKey(point.time), point.value * m_scale});
    }
    return mb::valueAt(points, key);
}

QString TelemetrySource::foot() const
{
    if (!m_footText.isEmpty())
        return m_footText;
    const std::uint64_t missing = lost();
    if (m_foot == Foot::Never || (m_foot == Foot::WhenLossy && missing == 0))
        return {};
    const auto all = static_cast<qint64>(m_telemetry->size(m_channel) + missing);
    return SourceText::tr("%1 Hz, %2 of %3 lost")
        .arg(formatNumber(m_rate), formatCount(static_cast<qint64>(missing)), formatCount(all));
}

} // namespace mb
