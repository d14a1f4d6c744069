// SPDX-License-Identifier: GPL-3.0-or-later
#include "gallery.h"
#include "support/utf8.h"

#include "widgets/plots/fixedtrace.h"
#include "widgets/plots/plotstack.h"

#include <QVBoxLayout>
#include <cmath>

using namespace mb;

namespace {

template <typename Function>
std::shared_ptr<FixedTrace> sampled(double from, double to, double step, Function function, const QString &foot = {})
{
    std::vector<PlotPoint> points;
    for (int i = 0; from + i * step <= to; ++i)
        points.push_back({from + i * step, function(from + i * step)});
    return std::make_shared<FixedTrace>(std::move(points), foot);
}

double response(double t, double damping)
{
    if (t < 0)
        return 0;
    const double w = 14;
    const double wd = w * std::sqrt(1 - damping * damping);
    return 1500 * (1 - std::exp(-damping * w * t) * (std::cos(wd * t) + damping * w / wd * std::sin(wd * t)));
}

double noise(double t)
{
    return std::fmod(std::abs(std::sin(t * 12345.678) * 43758.5453), 1.0) - 0.5;
}

} // namespace

QWidget *livePlotPage(const ThemeSource &theme)
{
    auto *stack = new PlotStack(theme);
    stack->strips().setStrip(0, {s("DMC60C #5 velocity"), 1.6, true});
    stack->strips().setStrip(1, {s("DMC60C #5 current"), 1.0, true});
    stack->strips().setStrip(2, {s("QuadQuad2Drv ch2 elbow position"), 1.2, true});
    const auto gap = [](double t, double value) { return t > 106 && t < 106.84 ? std::nan("") : value; };
    stack->strips().addTrace({s("#5 velocity"), s("rpm"), TraceRole::Velocity, 0},
        sampled(
            95, 112, 0.01, [&](double t) { return gap(t, response(t - 101, 0.5) + 12 * noise(t)); },
            s("100 Hz, 84 of 1700 lost")));
    stack->strips().addTrace({s("#5 set-point"), s("rpm"), TraceRole::Setpoint, 0},
        sampled(95, 112, 0.005, [](double t) { return t < 101 ? 0.0 : 1500.0; }));
    stack->strips().addTrace({s("#5 current"), s("A"), TraceRole::Current, 1},
        sampled(
            95, 112, 0.001,
            [&](double t) { return gap(t, 4 + 30 * std::exp(-std::abs(t - 101.2) * 3) + 3 * noise(t)); },
            s("1 kHz, 0 lost")));
    stack->strips().addTrace({s("ch2 position"), s("t"), TraceRole::Position, 2},
        sampled(95, 112, 0.005, [](double t) { return 8192 * std::sin(t); }));
    stack->strips().addTrace({s("ch2 set-point"), s("t"), TraceRole::Setpoint, 2},
        sampled(95, 112, 0.005, [](double t) { return 8192 * std::sin(t + 0.3); }));
    stack->strips().annotate<PlotLimit>(
        1, {{60, s("peak limit 60 A"), TraceRole::Current}, {30, s("limit 30 A"), TraceRole::Current}});
    stack->strips().times().setClock(WallClock{std::chrono::seconds(1'718'100'000), {}});
    stack->strips().setWatermark(s("DEMO"));
    stack->view().setRange(100, 112);
    stack->setCursorsShown(true);
    return stack;
}

QWidget *trialPlotPage(const ThemeSource &theme)
{
    auto *stack = new PlotStack(theme);
    stack->strips().setStrip(0, {{}, 3.5, true});
    stack->strips().addTrace(
        {s("A #17 as found"), s("rpm"), TraceRole::Velocity, 0, TraceDash::Long, TraceMarker::HollowSquare},
        sampled(-0.1, 1.3, 0.001, [](double t) { return response(t, 0.4); }));
    stack->strips().addTrace(
        {s("B #21"), s("rpm"), TraceRole::Velocity, 0, TraceDash::Automatic, TraceMarker::Automatic, true},
        sampled(
            -0.1, 1.3, 0.001, [](double t) { return response(t, 0.8); }, s("1 kHz, mean of 4, 0 of 6400 lost")));
    stack->strips().addTrace({s("next, predicted"), s("rpm"), TraceRole::Neutral, 0, TraceDash::Dots},
        sampled(-0.1, 1.3, 0.001, [](double t) { return response(t, 0.7); }));
    stack->strips().addTrace({s("set-point"), s("rpm"), TraceRole::Setpoint, 0},
        sampled(-0.1, 1.3, 0.001, [](double t) { return t < 0 ? 0.0 : 1500.0; }));
    stack->strips().addTrace({s("duty"), s("%"), TraceRole::Duty, 1},
        sampled(-0.1, 1.3, 0.001, [](double t) { return t < 0 ? 0.0 : 29 + 20 * std::exp(-t * 6); }));
    stack->strips().addTrace({s("current"), s("A"), TraceRole::Current, 2},
        sampled(-0.1, 1.3, 0.001, [](double t) { return t < 0 ? 0.0 : 2.3 + 44 * std::exp(-t * 9); }));
    stack->strips().annotate<PlotBand>(0, {{1470, 1530, s("±2 % band"), Tone::Ok}});
    for (int strip = 0; strip < 3; ++strip)
        stack->strips().annotate<PlotSpan>(
            strip, {{0, 0.107, strip == 0 ? s("duty at 55 % limit, 107 ms (A)") : QString(), TraceRole::Current}});
    stack->strips().annotate<PlotNote>(0,
        {{0.22, 1880, s("A peak 1 880 · +25 %"), QPointF(14, -16), false},
            {0.38, 1510, s("B settles 286 ms"), QPointF(16, 90), true}});
    stack->strips().annotate<PlotLimit>(2, {{60, s("peak limit 60 A / 500 ms"), TraceRole::Current}});
    stack->setFootNote(s("t = 0 at measured duty edge"));
    stack->fit();
    return stack;
}
