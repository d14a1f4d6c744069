// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/application.h"

#include "app/closing.h"
#include "app/folders/userfolders.h"
#include "app/helpdesk.h"
#include "app/languages.h"
#include "app/productionface.h"
#include "app/projectdesk.h"
#include "app/sessiondesk.h"
#include "app/tour.h"
#include "app/welcome.h"
#include "app/windowhold.h"
#include "model/registry.h"
#include "widgets/common/applytheme.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/systemtheme.h"
#include "widgets/control/envelopepanel.h"
#include "widgets/control/tunecolumn.h"
#include "widgets/control/tuneform.h"
#include "widgets/control/tunepage.h"
#include "widgets/design/designpage.h"
#include "widgets/firmware/firmwarepage.h"
#include "widgets/firmware/queueboard.h"
#include "widgets/plots/plotspage.h"
#include "widgets/plots/recorder.h"
#include "widgets/service/productionpage.h"

#include <QCommandLineParser>
#include <QFileInfo>
#include <QLibraryInfo>
#include <QLocale>
#include <QScreen>
#include <QStandardPaths>
#include <QStyle>

#include <cerrno>
#include <cstdio>
#include <utility>

namespace mb {
namespace {

void declare(QCommandLineParser &parser)
{
    const auto tr = [](const char *text) { return QCoreApplication::translate("Options", text); };
    parser.addPositionalArgument(QStringLiteral("file"),
        tr(QT_TRANSLATE_NOOP("Options", "A recording to open: frames (.log, .asc) or samples (.mcap, .csv).")),
        QStringLiteral("[FILE...]"));
    parser.setApplicationDescription(
        tr(QT_TRANSLATE_NOOP("Options", "Tune and service brushed-DC motor controllers.")));
    parser.addOptions({
        {QStringLiteral("demo"), tr(QT_TRANSLATE_NOOP("Options", "Open the simulated bench."))},
        {QStringLiteral("tour"),
            tr(QT_TRANSLATE_NOOP("Options", "Drive the demo through every page and write a picture of each to DIR.")),
            QStringLiteral("DIR")},
        {QStringLiteral("theme"),
            tr(QT_TRANSLATE_NOOP("Options", "dark, light, contrast, or system: the desktop's colours.")),
            QStringLiteral("THEME")},
        {QStringLiteral("language"),
            tr(QT_TRANSLATE_NOOP("Options", "Of the window: %1.")).arg(spokenCodes().join(QStringLiteral(", "))),
            QStringLiteral("CODE")},
        {QStringLiteral("size"), tr(QT_TRANSLATE_NOOP("Options", "Size of the window, such as 1280x800.")),
            QStringLiteral("WxH")},
        {QStringLiteral("font-scale"),
            tr(QT_TRANSLATE_NOOP("Options", "Font size relative to the system's, 0.5 to 3.")),
            QStringLiteral("FACTOR")},
        {QStringLiteral("link"), tr(QT_TRANSLATE_NOOP("Options", "Open this link; may be repeated.")),
            QStringLiteral("LINK")},
        {QStringLiteral("plot"),
            tr(QT_TRANSLATE_NOOP(
                "Options", "Draw a recording (.mcap, .csv) into the picture of --out, without a window.")),
            QStringLiteral("FILE")},
        {QStringLiteral("report"),
            tr(QT_TRANSLATE_NOOP("Options", "Print a report (.html) into the PDF of --out, without a window.")),
            QStringLiteral("FILE")},
        {QStringLiteral("out"),
            tr(QT_TRANSLATE_NOOP("Options", "The picture of --plot: .png, .svg or .pdf; the PDF of --report.")),
            QStringLiteral("FILE")},
        {QStringLiteral("json"), tr(QT_TRANSLATE_NOOP("Options", "With --plot: say what was drawn as JSON."))},
        {{QStringLiteral("h"), QStringLiteral("help")}, tr(QT_TRANSLATE_NOOP("Options", "Show this help."))},
        {{QStringLiteral("v"), QStringLiteral("version")}, tr(QT_TRANSLATE_NOOP("Options", "Show the version."))},
    });
}

QString layoutFolder()
{
    return QString::fromStdString(settingsFolder() + "/plots");
}

Result<void> checkOptions(const Options &options)
{
    if (!options.theme.isEmpty() && !themeNames().contains(options.theme))
        return fail(Fault::OutOfRange, say("--theme takes dark, light, contrast or system"));
    if (options.fontScale
        && !(*options.fontScale >= 0.5 && *options.fontScale <= 3.0)) // not a number is out of range too
        return fail(Fault::OutOfRange, say("--font-scale takes 0.5 to 3"));
    if (!options.language.isEmpty() && !spokenCodes().contains(options.language))
        return fail(Fault::OutOfRange,
            say("--language takes one of %1", spokenCodes().join(QStringLiteral(", ")).toStdString()));
    const QStringList sides = options.size.split(QLatin1Char('x'));
    const auto isSide = [](const QString &text, int least) { return text.toInt() >= least && text.toInt() <= 16384; };
    if (!options.size.isEmpty() && (sides.size() != 2 || !isSide(sides[0], 320) || !isSide(sides[1], 200)))
        return fail(Fault::OutOfRange, say("--size takes WIDTHxHEIGHT, such as 1280x800"));
    for (const QString &link : options.links)
        MB_TRY_VOID(LinkAddress::parse(link.toStdString()));
    return {};
}

} // namespace

Result<Options> Options::parse(const QStringList &arguments)
{
    QCommandLineParser parser;
    declare(parser);
    if (!parser.parse(arguments))
        return fail(Fault::OutOfRange, Message::verbatim(parser.errorText().toStdString()));
    Options options;
    options.files = parser.positionalArguments();
    for (const QString &file : std::as_const(options.files)) {
        if (!QFileInfo(file).isFile())
            return fail(Fault::OutOfRange, say("there is no file '%1'", file.toStdString()),
                say("give a recording, or --help for what else there is"));
    }
    options.demo = parser.isSet(QStringLiteral("demo")) || parser.isSet(QStringLiteral("tour"));
    options.tour = parser.value(QStringLiteral("tour"));
    if (parser.isSet(QStringLiteral("tour")) && options.tour.isEmpty())
        return fail(Fault::OutOfRange, say("--tour needs a folder for its pictures"));
    options.theme = parser.value(QStringLiteral("theme"));
    options.language = parser.value(QStringLiteral("language"));
    options.size = parser.value(QStringLiteral("size"));
    options.links = parser.values(QStringLiteral("link"));
    if (parser.isSet(QStringLiteral("font-scale")))
        options.fontScale = parser.value(QStringLiteral("font-scale")).toDouble();
    options.plot = parser.value(QStringLiteral("plot"));
    options.out = parser.value(QStringLiteral("out"));
    options.report = parser.value(QStringLiteral("report"));
    options.json = parser.isSet(QStringLiteral("json"));
    if (options.hasNoWindow() == options.out.isEmpty() || (!options.plot.isEmpty() && !options.report.isEmpty())
        || (parser.isSet(QStringLiteral("out")) && options.out.isEmpty()))
        return fail(Fault::OutOfRange, say("--plot FILE or --report FILE, and --out FILE belong together"));
    MB_TRY_VOID(checkOptions(options));
    return options;
}

QString Options::help()
{
    QCommandLineParser parser;
    declare(parser);
    return parser.helpText();
}

Application::Application(QApplication &qt, const Options &options)
    : m_qt(qt)
    , m_endSignals([this] { m_window->closing().end(); })
    , m_options(options)
    , m_settings(!options.demo)
    , m_accessibility(qt)
{
    m_systemFont = QApplication::font();
    QObject::connect(&m_palette, &SystemPalette::changed, &qt, [this] { followDesktop(); });
    Look look = m_settings.look();
    if (!options.theme.isEmpty())
        look.theme = options.theme;
    if (!options.language.isEmpty())
        look.language = options.language;
    if (options.fontScale)
        look.fontScale = *options.fontScale;
    m_settings.wear(look);
    translate(look.language);
    dress(look);
    m_engine = std::make_unique<Engine>(families(), !options.demo);
    if (!options.demo)
        m_engine->post([](EngineCore &core) {
            core.session().memory().keepProfiles(profileFolder());
            core.keepTranscripts(transcriptFolder());
            core.session().memory().keepScans(scanFolder());
        });
    keepJournal();
    QObject::connect(
        m_engine.get(), &Engine::changed, m_engine.get(),
        [this] {
            if (m_lookWaits)
                followLook();
        },
        Qt::QueuedConnection); // the window that hears of it is made anew
    openLimits();
    makeWindow();
    if (const QStringList sides = options.size.split(QLatin1Char('x')); sides.size() == 2)
        m_window->resize(sides[0].toInt(), sides[1].toInt());
    else if (options.tour.isEmpty()) // whose pictures are larger than a screen that is not there
        fitScreen();
    qt.installEventFilter(&m_stopKeys);
    QObject::connect(
        &m_stopKeys, &StopKeys::stopPressed, &qt, [this](const QString &key) { m_window->arming().stopAll(key); });
}

Application::~Application() = default;

bool Application::end(std::chrono::milliseconds limit)
{
    m_tour.reset();
    m_recorder.reset();
    m_window.reset();
    m_sessions.reset();
    if (m_engine->end(limit))
        return true;
    (void)m_engine.release(); // whoever hangs uses it
    std::fprintf(stderr, "%s: an adapter or a disk has not let go: left behind, and every motor was told to stop\n",
        program_invocation_short_name);
    return false;
}

/// A window that would not fit with what the desktop draws around it takes the whole screen.
void Application::fitScreen()
{
    const QSize room = m_window->screen()->availableSize();
    const int title = m_window->style()->pixelMetric(QStyle::PM_TitleBarHeight);
    if (m_window->width() <= room.width() && m_window->height() + title <= room.height())
        return;
    m_window->resize(m_window->size().boundedTo(room - QSize(0, title)));
    m_window->setWindowState(m_window->windowState() | Qt::WindowMaximized);
}

void Application::makeWindow()
{
    m_window = std::make_unique<MainWindow>(*m_engine, *m_theme, m_settings);
    m_window->findChild<ProductionPage *>()->setSound(m_settings.look().sounds);
    setUpPlots();
    setUpLimits();
    setUpStart();
    QObject::connect(m_window.get(), &MainWindow::lookChosen, &m_qt, [this] { followLook(); });
}

/// The journal of service is where it was the last time.
void Application::keepJournal()
{
    QObject::connect(m_engine.get(), &Engine::journalChosen, &m_qt,
        [this](const QString &server, const QString &station) { m_settings.setJournal(server, station); });
    const QString server = m_settings.journalServer();
    const QString station = m_settings.station();
    if (server.isEmpty() && station.isEmpty())
        return;
    m_engine->send(orders::KeepJournal{server.toStdString(), station.toStdString()}, [this](const Result<void> &kept) {
        if (!kept)
            m_engine->report(Severity::Caution, {}, errorText(kept.error()));
    });
}

/// Language and sizes are in every widget: the window is made anew, on the same page with the same device, as soon as nothing holds it.
/// The engine and what it records go on, and what pages know is the workbench's.
void Application::followLook()
{
    if (isHeld(*m_window, *m_engine)) {
        if (!std::exchange(m_lookWaits, true))
            m_engine->report(Severity::Caution, {},
                MainWindow::tr(
                    "The preferences hold as soon as nothing is armed, no job runs and no other window is open."));
        return;
    }
    m_lookWaits = false;
    const PageId page = m_window->shownPage();
    const DeviceId device = m_window->selection().device();
    const int axis = m_window->selection().axis();
    const bool produces = m_window->production().isShown();
    const QByteArray geometry = m_window->saveGeometry();
    const QString help = m_window->help().shown();
    if (auto *plots = m_window->findChild<PlotsPage *>())
        plots->layoutBook().finish(); // the next one begins with them
    translate(m_settings.look().language);
    dress(m_settings.look());
    QApplication::setQuitOnLastWindowClosed(false);
    const std::unique_ptr<MainWindow> before = std::move(m_window);
    makeWindow();
    m_window->restoreGeometry(geometry);
    m_window->selection().select(device, axis);
    m_window->showPage(page);
    m_window->production().show(produces);
    m_window->show();
    if (!help.isEmpty())
        (void)m_window->help().open(help);
    before->hide();
    QApplication::setQuitOnLastWindowClosed(true);
}

/// What comes before the work: start page, sessions, the folder of a machine.
void Application::setUpStart()
{
    auto *welcome = new Welcome(*m_window, *m_engine, *m_theme, m_settings);
    if (!m_options.demo && !m_sessions)
        m_sessions = std::make_unique<SessionDesk>(*m_engine, *m_theme, QString::fromStdString(programFolder()));
    if (m_sessions)
        m_sessions->attach(*m_window, *welcome);
    auto *project = new ProjectDesk(*m_engine, m_limits, m_options.demo ? QString() : layoutFolder(), *m_window);
    QObject::connect(m_window.get(), &MainWindow::projectWanted, project,
        [project](bool open) { open ? project->askOpen() : project->askSave(); });
    QObject::connect(project, &ProjectDesk::folderChosen, m_window.get(), [this](const QString &folder) {
        m_machineFolder = folder;
        qobject_cast<FirmwarePage *>(m_window->page(PageId::Firmware))->queue().setRecipeFolder(folder);
    });
    QObject::connect(m_window.get(), &MainWindow::pageMade, m_window.get(), [this](PageId, QWidget *page) {
        if (const auto *firmware = qobject_cast<FirmwarePage *>(page))
            firmware->queue().setRecipeFolder(m_machineFolder);
    });
}

/// The recording begins with the program, not with a wish.
void Application::setUpPlots()
{
    if (!m_recorder) {
        QString folder = QString::fromStdString(programFolder());
        if (m_options.demo) {
            m_demoFolder = std::make_unique<QTemporaryDir>();
            folder = m_demoFolder->path();
        }
        m_recorder = std::make_unique<Recorder>(*m_engine, folder + QStringLiteral("/recordings"));
    }
    QObject::connect(m_window.get(), &MainWindow::pageMade, m_recorder.get(), [this](PageId id, QWidget *page) {
        auto *plots = qobject_cast<PlotsPage *>(page);
        if (id != PageId::Plots || !plots)
            return;
        if (!m_options.demo)
            plots->setLayoutFolder(layoutFolder());
        plots->setRecorder(m_recorder.get(),
            QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation) + QStringLiteral("/MotorBench"));
    });
}

/// What people have entered outlives the program, and what cannot be written the window.
void Application::openLimits()
{
    if (m_options.demo)
        return;
    const auto opened = m_limits.open(QString::fromStdString(settingsFolder() + "/limits.json"));
    if (!opened)
        m_engine->report(Severity::Caution, {}, errorText(opened.error()));
}

/// Both pages that move motors go by the same limits.
void Application::setUpLimits()
{
    QObject::connect(&m_limits, &EnvelopeBook::failed, m_window.get(), [this](const QString &cause) {
        m_engine->report(Severity::Caution, {}, MainWindow::tr("the limits were not kept: %1").arg(cause));
    });
    QObject::connect(m_window.get(), &MainWindow::pageMade, m_window.get(), [this](PageId, QWidget *page) {
        if (auto *tune = qobject_cast<TunePage *>(page)) {
            tune->column().envelope().share(m_limits);
            tune->form().setRevolutions(m_settings.look().revolutions);
        } else if (auto *design = qobject_cast<DesignPage *>(page)) {
            design->envelope().share(m_limits);
        }
    });
}

void Application::translate(const QString &language)
{
    auto &[ours, ofQt] = m_translators;
    for (QTranslator &translator : m_translators)
        QCoreApplication::removeTranslator(&translator);
    const QLocale locale = language.isEmpty() ? QLocale::system() : QLocale(language);
    QLocale::setDefault(locale); // of dates and glyphs
    const QString folder = QStringLiteral(":/translations");
    if (ours.load(locale, QStringLiteral("motorbench"), QStringLiteral("_"), folder)) {
        if (ofQt.load(locale, QStringLiteral("qtbase"), QStringLiteral("_"),
                QLibraryInfo::location(QLibraryInfo::TranslationsPath)))
            m_qt.installTranslator(&ofQt);
        m_qt.installTranslator(&ours);
    } else if (ours.load(QStringLiteral("motorbench_en"), folder)) { // English has plural forms too
        m_qt.installTranslator(&ours);
    }
}

void Application::dress(const Look &look)
{
    QFont font = m_systemFont;
    if (QGuiApplication::platformName() == QLatin1String("offscreen"))
        font.setPointSizeF(10.0); // no desktop has said what it likes
    font.setPointSizeF(font.pointSizeF() * look.fontScale);
    if (const QString glyphs = glyphsOf(QLocale()); !glyphs.isEmpty())
        font.setFamilies({font.family(), glyphs});
    QApplication::setFont(font);
    const double size = font.pointSizeF() > 0.0 ? font.pointSizeF() : 10.0;
    m_themeName = look.theme;
    Theme theme = themeNamed(m_themeName, m_palette.palette(), size);
    theme.reducedMotion = look.reducedMotion;
    if (m_theme) {
        m_theme->setTheme(theme);
        return;
    }
    m_theme = std::make_unique<ThemeSource>(theme);
    wearTheme();
    QObject::connect(m_theme.get(), &ThemeSource::changed, &m_qt, [this] {
        const Theme &worn = m_theme->theme();
        if (worn.name != themeNamed(m_themeName, m_palette.palette(), worn.bodyPointSize).name)
            m_themeName = worn.name; // chosen by its key
        wearTheme();
    });
}

void Application::wearTheme()
{
    applyTheme(m_qt, m_theme->theme());
    m_palette.keep();
}

/// Somebody has chosen other colours for the whole desktop. Who has a theme of the program keeps it, also where the desktop's colours
/// were set over it.
void Application::followDesktop()
{
    const Theme &before = m_theme->theme();
    Theme theme = themeNamed(m_themeName, m_palette.palette(), before.bodyPointSize);
    theme.reducedMotion = before.reducedMotion;
    if (theme.name == systemThemeName() || before.name == systemThemeName())
        m_theme->setTheme(theme);
    if (!m_palette.isOurs())
        wearTheme();
}

void Application::openLinks()
{
    QStringList links = m_options.links;
    if (m_options.demo)
        links += QStringLiteral("sim:");
    else
        links += m_settings.links();
    for (const QString &link : links) {
        if (const auto address = LinkAddress::parse(link.toStdString()))
            m_engine->send(orders::OpenLink{*address});
    }
}

void Application::start()
{
    openLinks();
    m_window->show();
    for (const QString &file : std::as_const(m_options.files))
        m_window->openFile(file);
    if (!m_options.tour.isEmpty()) {
        m_tour = std::make_unique<Tour>(*m_engine, *m_window, *m_theme, m_options.tour, !m_options.theme.isEmpty());
        m_tour->start();
    }
}

int Application::exitStatus(int status) const
{
    const QString turning = m_window->closing().unstopped().join(QStringLiteral(", "));
    if (turning.isEmpty())
        return m_tour && m_window->closing().isEnding() ? 1 : status; // a tour that was cut off
    std::fprintf(stderr, "%s: %s has not been seen to stop: cut its power\n", program_invocation_short_name,
        qPrintable(turning));
    return 4;
}

} // namespace mb
