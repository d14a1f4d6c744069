// SPDX-License-Identifier: GPL-3.0-or-later
// docs/names.md#numbers, what concerns plots, in one run: replot of 16 traces beside plain QCustomPlot with the
// same data, memory a sample, cost of storing one, and how late the window is while 16 channels come at 1 kHz.
#include "widgets/plots/plotstack.h"
#include "widgets/plots/telemetrysource.h"

#include <QApplication>
#include <QProcess>
#include <QTimer>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <random>
#include <thread>

namespace {

using namespace mb;
using namespace std::chrono_literals;
using Stopwatch = std::chrono::steady_clock;

constexpr std::uint16_t traceCount = 16;
constexpr int stripCount = 4;
constexpr int width = 1600;
constexpr int height = 900;
constexpr double twoPi = 6.283185307179586;

double milliseconds(Stopwatch::duration duration)
{
    return std::chrono::duration<double, std::milli>(duration).count();
}

/// Of this thread: what a replot costs where other programs take the processor away in between.
double processorMilliseconds()
{
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) / 1e6;
}

double percentile(std::vector<double> values, double part)
{
    std::sort(values.begin(), values.end());
    return values.empty() ? 0.0 : values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
}

const std::vector<Channel> &table()
{
    static const std::vector<Channel> channels(traceCount, Channel{"x", "V", "X", Quantity::Velocity});
    return channels;
}

/// Sine plus noise of 1 % of the pane, or noise over its whole height; 1 kHz.
class Signal {
public:
    explicit Signal(bool noiseOnly)
        : m_noiseOnly(noiseOnly)
    {
        std::mt19937 random(1);
        std::uniform_real_distribution<double> noise(-1.0, 1.0);
        for (double &value : m_noise)
            value = noise(random);
    }
    [[nodiscard]] double at(std::int64_t i, int trace) const
    {
        const double noise = m_noise[static_cast<std::size_t>(i * 31 + trace * 977) % m_noise.size()];
        const double sine = std::sin(twoPi * static_cast<double>(i) / 300'000.0 + trace);
        return m_noiseOnly ? noise : sine + 0.01 * noise;
    }

private:
    bool m_noiseOnly;
    std::vector<double> m_noise = std::vector<double>(99'991);
};

struct Measured {
    double median = 0.0;
    double worst = 0.0;
    double processor = 0.0; ///< median
    double bytesPerSample = 0.0;
    double appendNanoseconds = 0.0;
};

/// As the page does it: each round brings 16 ms of samples, then a tick.
Measured ours(std::int64_t samples, bool noiseOnly, int rounds)
{
    const Signal signal(noiseOnly);
    auto telemetry = std::make_shared<Telemetry>(table());
    std::int64_t next = 0;
    const auto feed = [&](std::int64_t count) {
        for (const std::int64_t end = next + count; next < end; ++next) {
            for (std::uint16_t trace = 0; trace < traceCount; ++trace)
                telemetry->append({{trace}, Instant(next * 1ms), signal.at(next, trace)});
        }
        telemetry->commit();
    };
    const auto begun = Stopwatch::now();
    feed(samples);
    Measured measured;
    measured.appendNanoseconds
        = milliseconds(Stopwatch::now() - begun) * 1e6 / static_cast<double>(samples * traceCount);
    measured.bytesPerSample = static_cast<double>(telemetry->memoryUse()) / static_cast<double>(samples * traceCount);
    const ThemeSource theme(darkTheme());
    PlotStack stack(theme);
    stack.resize(width, height);
    for (std::uint16_t trace = 0; trace < traceCount; ++trace) {
        TraceStyle style{QString::number(trace), QStringLiteral("V"), static_cast<TraceRole>(1 + trace % 6)};
        style.strip = trace % stripCount;
        stack.strips().addTrace(style, std::make_shared<TelemetrySource>(telemetry, ChannelIndex{trace}));
    }
    stack.view().setWindow(static_cast<double>(samples) / 1000.0);
    stack.show();
    QApplication::processEvents();
    stack.refresh(static_cast<double>(next) / 1000.0);
    std::vector<double> times;
    std::vector<double> busy;
    for (int i = 0; i < rounds; ++i) {
        // One pixel column further each time: a tick in which nothing moves costs nothing and is not counted.
        feed(std::max<std::int64_t>(16, samples / (width - 100)));
        const auto start = Stopwatch::now();
        const double busyBefore = processorMilliseconds();
        stack.refresh(static_cast<double>(next) / 1000.0);
        busy.push_back(processorMilliseconds() - busyBefore);
        times.push_back(milliseconds(Stopwatch::now() - start));
    }
    measured.processor = percentile(busy, 0.5);
    measured.median = percentile(times, 0.5);
    measured.worst = percentile(times, 1.0);
    return measured;
}

/// The same picture with one QCPGraph a trace: 1 px pens, no antialiasing, adaptive sampling, as its manual advises.
Measured plain(std::int64_t samples, bool noiseOnly, int rounds)
{
    const Signal signal(noiseOnly);
    QCustomPlot plot;
    plot.resize(width, height);
    plot.plotLayout()->clear();
    std::vector<QCPAxisRect *> rects;
    for (int i = 0; i < stripCount; ++i) {
        rects.push_back(new QCPAxisRect(&plot));
        plot.plotLayout()->addElement(i, 0, rects.back());
        rects.back()->axis(QCPAxis::atLeft)->setRange(-1.2, 1.2);
    }
    plot.setNotAntialiasedElements(QCP::aeAll);
    std::vector<QCPGraph *> graphs;
    for (int trace = 0; trace < traceCount; ++trace) {
        QCPAxisRect &rect = *rects[static_cast<std::size_t>(trace % stripCount)];
        graphs.push_back(plot.addGraph(rect.axis(QCPAxis::atBottom), rect.axis(QCPAxis::atLeft)));
        QVector<QCPGraphData> data;
        data.reserve(static_cast<int>(samples));
        for (std::int64_t i = 0; i < samples; ++i)
            data.append({static_cast<double>(i) / 1000.0, signal.at(i, trace)});
        graphs.back()->data()->set(data, true);
    }
    plot.show();
    QApplication::processEvents();
    std::vector<double> times;
    for (int i = 0; i < rounds; ++i) {
        const double shift = static_cast<double>(samples) / 1000.0 / (width - 100) * i;
        for (QCPAxisRect *rect : rects)
            rect->axis(QCPAxis::atBottom)->setRange(shift, static_cast<double>(samples) / 1000.0 + shift);
        const auto start = Stopwatch::now();
        plot.replot();
        times.push_back(milliseconds(Stopwatch::now() - start));
    }
    return {percentile(times, 0.5), percentile(times, 1.0), 0.0, 0.0, 0.0};
}

void replots()
{
    std::printf(
        "replot, 16 traces in 4 panes, %d x %d, window scrolling by a pixel; median (worst) in ms\n", width, height);
    std::printf("%12s %18s %20s %8s %14s %12s\n", "samples", "MotorBench", "plain QCustomPlot", "ratio", "bytes/sample",
        "ns/append");
    for (const std::int64_t samples : {10'000, 100'000, 1'000'000, 3'600'000}) {
        const Measured own = ours(samples, false, 60);
        const Measured other = plain(samples, false, samples > 500'000 ? 7 : 30);
        std::printf("%12lld %10.2f (%5.2f) %12.2f (%6.2f) %8.1f %14.2f %12.1f\n", static_cast<long long>(samples),
            own.median, own.worst, other.median, other.worst, other.median / own.median, own.bytesPerSample,
            own.appendNanoseconds);
    }
    const Measured own = ours(3'600'000, true, 60);
    const Measured other = plain(3'600'000, true, 5);
    std::printf("%12s %10.2f (%5.2f) %12.2f (%6.2f) %8.1f   3 600 000 samples, noise over the whole height\n",
        "worst case", own.median, own.worst, other.median, other.worst, other.median / own.median);
    std::printf("to reach: at most 4 ms median and 25 times faster at 3 600 000; at most 16 bytes a sample\n\n");
}

/// Other programs that do nothing but work.
class BusyComputer {
public:
    explicit BusyComputer(int programs)
    {
        for (int i = 0; i < programs; ++i) {
            m_programs.push_back(std::make_unique<QProcess>());
            m_programs.back()->start(
                QStringLiteral("/bin/sh"), {QStringLiteral("-c"), QStringLiteral("while :; do :; done")});
            m_programs.back()->waitForStarted();
        }
    }
    ~BusyComputer()
    {
        for (const auto &program : m_programs) {
            program->kill();
            program->waitForFinished();
        }
    }
    BusyComputer(const BusyComputer &) = delete;
    BusyComputer &operator=(const BusyComputer &) = delete;

private:
    std::vector<std::unique_ptr<QProcess>> m_programs;
};

/// Posts a question to the window every 5 ms, which answers as soon as it comes to it.
void latency(int programs)
{
    const BusyComputer others(programs);
    auto telemetry = std::make_shared<Telemetry>(table());
    const Signal signal(false);
    const ThemeSource theme(darkTheme());
    PlotStack stack(theme);
    stack.resize(width, height);
    for (std::uint16_t trace = 0; trace < traceCount; ++trace) {
        TraceStyle style{QString::number(trace), QStringLiteral("V"), static_cast<TraceRole>(1 + trace % 6)};
        style.strip = trace % stripCount;
        stack.strips().addTrace(style, std::make_shared<TelemetrySource>(telemetry, ChannelIndex{trace}));
    }
    stack.view().setWindow(10.0);
    stack.show();
    const auto begun = Stopwatch::now();
    const auto now = [begun] { return std::chrono::duration<double>(Stopwatch::now() - begun).count(); };
    std::vector<double> waits;
    std::atomic<bool> end{false};
    std::thread feeder([&] {
        std::int64_t next = 0;
        while (!end) {
            std::this_thread::sleep_for(1ms);
            for (const auto present = static_cast<std::int64_t>(now() * 1000.0); next < present; ++next) {
                for (std::uint16_t trace = 0; trace < traceCount; ++trace)
                    telemetry->append({{trace}, Instant(next * 1ms), signal.at(next, trace)});
            }
            telemetry->commit();
        }
    });
    std::thread asker([&] {
        while (!end) {
            std::this_thread::sleep_for(5ms);
            const auto asked = Stopwatch::now();
            QMetaObject::invokeMethod(
                &stack, [&waits, asked] { waits.push_back(milliseconds(Stopwatch::now() - asked)); },
                Qt::QueuedConnection);
        }
    });
    int ticks = 0;
    QTimer tick;
    tick.setTimerType(Qt::PreciseTimer);
    tick.setInterval(16);
    QObject::connect(&tick, &QTimer::timeout, &stack, [&] {
        if (!stack.budget().isDue()) // as the pages do it
            return;
        ++ticks;
        stack.refresh(now());
    });
    tick.start();
    QTimer::singleShot(8000, qApp, &QApplication::quit);
    QApplication::exec();
    end = true;
    feeder.join();
    asker.join();
    std::printf(
        "16 channels at 1 kHz, replot at up to 60 Hz, %.0f s, %d other programs at work: %d ticks; an event of the "
        "window waits median %.2f ms, p99 %.2f ms (to reach: 30), at most %.2f ms\n",
        now(), programs, ticks, percentile(waits, 0.5), percentile(waits, 0.99), percentile(waits, 1.0));
}

} // namespace

int main(int argc, char **argv)
{
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(argc, argv);
    std::setvbuf(stdout, nullptr, _IOLBF, 0);
    if (argc > 1 && qstrcmp(argv[1], "latency") == 0) {
        for (const int programs : {0, 1})
            latency(programs);
        return 0;
    }
    if (argc > 1) { // for a profiler: bench_plot ROUNDS
        const Measured own = ours(3'600'000, false, std::max(1, std::atoi(argv[1])));
        std::printf(
            "3 600 000 samples: %.2f ms (%.2f), of processor time %.2f ms\n", own.median, own.worst, own.processor);
        return 0;
    }
    replots();
    for (const int programs : {0, 1})
        latency(programs);
    return 0;
}
