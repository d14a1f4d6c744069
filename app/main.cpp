// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/about.h"
#include "app/application.h"
#include "app/crashreport.h"
#include "app/documents.h"
#include "app/folders/relativefolders.h"
#include "app/folders/userfolders.h"
#include "app/refusal.h"

#include <cerrno>
#include <chrono>
#include <clocale>
#include <csignal>
#include <cstdio>
#include <cstdlib>

namespace {

void putUnlessSet(const char *name, const char *value)
{
    if (!qEnvironmentVariableIsSet(name))
        qputenv(name, value);
}

/// What Qt asks the environment for before it has a window.
void choosePlatform(const mb::Options &options)
{
    if (options.hasNoWindow())
        qputenv("QT_QPA_PLATFORM", "offscreen");
    // A screen that is not there would have 100 dpi: pictures of a tour are as large as --size says, and not blurred.
    if (qEnvironmentVariable("QT_QPA_PLATFORM") == QLatin1String("offscreen"))
        putUnlessSet("QT_FONT_DPI", "96");
    // Nothing is drawn by OpenGL, whose driver takes 50 MB where it has a compiler.
    putUnlessSet("QT_XCB_GL_INTEGRATION", "none");
}

} // namespace

int main(int argc, char **argv)
{
    mb::ignoreRelativeFolders();
    std::signal(SIGPIPE, SIG_IGN); // a terminal or pager that went away
    std::signal(SIGXFSZ, SIG_IGN); // a file that may not grow is an error of the file
    QCoreApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
    QCoreApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
    // 144 dpi are 1.5, not 2: a window that is a third too large loses its right edge, and STOP with it.
    QGuiApplication::setHighDpiScaleFactorRoundingPolicy(Qt::HighDpiScaleFactorRoundingPolicy::PassThrough);
    QStringList arguments;
    for (int i = 0; i < argc; ++i)
        arguments += QString::fromLocal8Bit(argv[i]);
    // Before there is a window: a wrong call needs no display.
    const auto options = mb::Options::parse(arguments);
    if (!options)
        return mb::refuse(options.error(), arguments.contains(QStringLiteral("--json")));
    if (arguments.contains(QStringLiteral("--help")) || arguments.contains(QStringLiteral("-h"))) {
        const QCoreApplication core(argc, argv);
        std::fputs(qPrintable(mb::Options::help()), stdout);
        return 0;
    }
    if (arguments.contains(QStringLiteral("--version")) || arguments.contains(QStringLiteral("-v"))) {
        std::puts("motorbench " MOTORBENCH_VERSION);
        return 0;
    }
    choosePlatform(*options);
    QApplication::setStyle(QStringLiteral("Fusion"));
    QApplication qt(argc, argv);
    std::setlocale(LC_NUMERIC, "C"); // files have a dot whatever the locale; Qt asks nobody but itself
    std::setlocale(
        LC_MESSAGES, "C"); // what the system says of an error may not depend on more than the chosen language
    QApplication::setApplicationName(QStringLiteral("MotorBench"));
    QApplication::setApplicationVersion(QStringLiteral(MOTORBENCH_VERSION));
    if (!options->plot.isEmpty() || !options->report.isEmpty())
        mb::endOnSignals(options->json);
    if (!options->plot.isEmpty())
        return mb::plotFile(*options);
    if (!options->report.isEmpty())
        return mb::printReport(*options);
    if (!options->demo)
        mb::installCrashReport(QString::fromStdString(mb::programFolder() + "/crashes"), mb::versions());
    constexpr std::chrono::seconds endLimit(15); // of which lanes of the engine that hang take three each
    int status = 0;
    bool ended = false;
    {
        mb::Application application(qt, *options);
        application.start();
        status = application.exitStatus(QApplication::exec());
        ended = application.end(endLimit);
    }
    if (ended)
        return status;
    std::fflush(nullptr);
    std::_Exit(status);
}
