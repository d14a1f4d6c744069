// SPDX-License-Identifier: GPL-3.0-or-later
// From the start of the program to its first painted window, warm: this program starts itself again and again as `motorbench --demo`
// starts, with all pages made before and with the one that is shown, and each prints what it waited for.
#include "app/application.h"

#include <QApplication>
#include <QProcess>
#include <QProcessEnvironment>
#include <QTimer>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <functional>
#include <vector>

namespace {

using namespace mb;

constexpr int starts = 15;
constexpr const char *begunKey = "MOTORBENCH_BEGUN";
constexpr const char *allKey = "MOTORBENCH_ALL_PAGES"; ///< makes every page before the window is shown
constexpr double target = 200.0;                       ///< ms

std::int64_t nanoseconds()
{
    return std::chrono::steady_clock::now().time_since_epoch().count();
}

double since(std::int64_t begun)
{
    return static_cast<double>(nanoseconds() - begun) / 1e6;
}

/// Ends the program behind the first paint event of the window.
class FirstPicture final : public QObject {
public:
    FirstPicture(QWidget &window, std::function<void()> painted)
        : m_window(window)
        , m_painted(std::move(painted))
    {
        qApp->installEventFilter(this);
    }
    bool eventFilter(QObject *watched, QEvent *event) override
    {
        const auto *widget = event->type() == QEvent::Paint ? qobject_cast<QWidget *>(watched) : nullptr;
        if (widget && widget->window() == &m_window && !m_seen) {
            m_seen = true;
            QTimer::singleShot(0, Qt::PreciseTimer, this, m_painted);
        }
        return false;
    }

private:
    QWidget &m_window;
    std::function<void()> m_painted;
    bool m_seen = false;
};

int start(int argc, char **argv, std::int64_t begun)
{
    const double loaded = since(begun);
    QApplication::setStyle(QStringLiteral("Fusion"));
    QApplication qt(argc, argv);
    const double qtReady = since(begun);
    Options options;
    options.demo = true;
    Application application(qt, options);
    if (!qEnvironmentVariableIsEmpty(allKey)) {
        for (const PageId id : {PageId::Overview, PageId::Parameters, PageId::Tune, PageId::Plots, PageId::Firmware,
                 PageId::Bus, PageId::Log})
            (void)application.window().page(id);
    }
    const double built = since(begun);
    application.start();
    const FirstPicture picture(application.window(), [&] {
        std::printf("%.1f %.1f %.1f %.1f\n", loaded, qtReady, built, since(begun));
        std::fflush(stdout);
        QApplication::quit();
    });
    return QApplication::exec();
}

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    return values.empty() ? 0.0 : values[values.size() / 2];
}

using Columns = std::array<std::vector<double>, 4>;

/// One start; false when it failed.
bool measure(bool allPages, Columns *columns)
{
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QString::fromLatin1(begunKey), QString::number(nanoseconds()));
    if (allPages)
        environment.insert(QString::fromLatin1(allKey), QStringLiteral("1"));
    QProcess program;
    program.setProcessEnvironment(environment);
    program.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    program.start(QCoreApplication::applicationFilePath(), QStringList());
    if (!program.waitForFinished(60'000))
        return false;
    const QList<QByteArray> words = program.readAllStandardOutput().simplified().split(' ');
    for (int column = 0; columns && column < words.size() && column < 4; ++column)
        (*columns)[static_cast<std::size_t>(column)].push_back(words[column].toDouble());
    return words.size() == 4;
}

void print(const char *name, const Columns &columns)
{
    std::printf("%-34s %9.0f %8.0f %12.0f %8.0f\n", name, median(columns[0]), median(columns[1]), median(columns[2]),
        median(columns[3]));
}

} // namespace

int main(int argc, char **argv)
{
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    if (const QByteArray begun = qgetenv(begunKey); !begun.isEmpty())
        return start(argc, argv, begun.toLongLong());
    const QCoreApplication core(argc, argv);
    Columns all;
    Columns first;
    for (int i = 0; i < starts; ++i) { // side by side; the first ones warm
        if (!measure(true, i > 0 ? &all : nullptr) || !measure(false, i > 0 ? &first : nullptr))
            return 1;
    }
    std::printf("start, median of %d in ms after the start of the process\n%-34s %9s %8s %12s %8s\n", starts - 1, "",
        "libraries", "Qt ready", "window built", "painted");
    print("all pages made before (as it was)", all);
    print("pages made when first shown", first);
    std::printf("to reach: painted after at most %.0f\n", target);
    return 0;
}
