// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/accessibility.h"
#include "app/endsignals.h"
#include "app/engine.h"
#include "app/mainwindow.h"
#include "app/stopkeys.h"
#include "app/systempalette.h"
#include "widgets/control/envelopebook.h"

#include <QApplication>
#include <QTemporaryDir>
#include <QTranslator>

#include <array>
#include <optional>

namespace mb {

class Recorder;
class SessionDesk;
class Tour;

/// What the command line asked for.
struct Options {
    bool demo = false;
    QString tour;                    ///< folder for pictures; empty: no tour
    QString theme;                   ///< of themeNames(), or empty
    QString language;                ///< of languages(), or empty for the system's
    QString size;                    ///< "1280x800" or empty
    std::optional<double> fontScale; ///< of the system's font; empty: as it was chosen
    QStringList links;               ///< opened at the start
    QString plot;                    ///< a recording to draw into a picture, without a window; empty: none
    QString report;                  ///< HTML of a report to print into a PDF, without a window; empty: none
    QString out;                     ///< where that picture goes: png, svg or pdf; or that PDF
    QStringList files;               ///< recordings to open
    bool json = false;               ///< what it says on standard output is JSON

    /// It is asked for a file and nothing else.
    [[nodiscard]] bool hasNoWindow() const { return !plot.isEmpty() || !report.isEmpty(); }
    /// One line about what is wrong with the arguments.
    [[nodiscard]] static Result<Options> parse(const QStringList &arguments);
    [[nodiscard]] static QString help();
};

/// Composes the program: theme, translation, engine, window. Lives in main().
class Application {
public:
    Application(QApplication &qt, const Options &options);
    ~Application();

    void start();
    /// What the process ends with after its loop ended with `status`: 4, and a line on standard error, where a signal ended it and a motor
    /// was not seen to stop; 1 of a tour that did not come to its end.
    [[nodiscard]] int exitStatus(int status) const;
    /// The last: closes the window and ends the engine. False, and a line on standard error, where that hangs (an adapter that does not
    /// come back): its thread runs on, so that the process must end without tidying up.
    [[nodiscard]] bool end(std::chrono::milliseconds limit);
    [[nodiscard]] Engine &engine() { return *m_engine; }
    [[nodiscard]] MainWindow &window() { return *m_window; }

private:
    void translate(const QString &language);
    void dress(const Look &look);
    void wearTheme();
    void followDesktop();
    void openLinks();
    void fitScreen();
    void makeWindow();
    void keepJournal();
    void setUpPlots();
    void openLimits();
    void setUpLimits();
    void setUpStart();
    void followLook();

    QApplication &m_qt;
    EndSignals m_endSignals; ///< until everything else has ended
    Options m_options;
    QFont m_systemFont;
    QString m_themeName; ///< as it was chosen; empty: not yet
    SystemPalette m_palette;
    std::array<QTranslator, 2> m_translators; ///< of the program, and of Qt's own words
    Settings m_settings;
    std::unique_ptr<ThemeSource> m_theme;
    std::unique_ptr<Engine> m_engine;
    EnvelopeBook m_limits;                   ///< of experiments
    QString m_machineFolder;                 ///< chosen by its user; empty: none
    std::unique_ptr<SessionDesk> m_sessions; ///< none in a demo
    std::unique_ptr<MainWindow> m_window;
    bool m_lookWaits = false;                    ///< preferences were chosen, and are not in force
    std::unique_ptr<QTemporaryDir> m_demoFolder; ///< a demo leaves nothing behind
    std::unique_ptr<Recorder> m_recorder;
    std::unique_ptr<Tour> m_tour;
    StopKeys m_stopKeys;
    Accessibility m_accessibility;
};

} // namespace mb
