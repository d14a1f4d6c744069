// SPDX-License-Identifier: GPL-3.0-or-later
// What belongs to the program rather than to a device: preferences, the list of commands, files that are opened, About.
#include "windowbench.h"

#include "app/about.h"
#include "app/folders/userfolders.h"
#include "app/guardian/client/guardianprocess.h"
#include "app/guardiancheck.h"
#include "app/languages.h"
#include "app/preferences.h"
#include "app/settings.h"
#include "support/windowtests.h"
#include "widgets/common/segmented.h"
#include "widgets/control/setpointpanel.h"
#include "widgets/control/tunecolumn.h"
#include "widgets/control/tuneform.h"
#include "widgets/control/tunepage.h"
#include "widgets/control/tuneplot.h"
#include "widgets/plots/exportjob.h"
#include "widgets/plots/plotspage.h"
#include "widgets/plots/sampleswindow.h"
#include "widgets/service/productionpage.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPointer>
#include <QProcess>
#include <QPushButton>
#include <QTemporaryDir>

#include <atomic>
#include <csignal>
#include <thread>

using namespace mb;
using namespace mb::test;

namespace {

/// A picture of it for people, where a folder is named.
void keepPicture(QWidget &widget, const QString &name)
{
    const QString folder = qEnvironmentVariable("MOTORBENCH_PICTURES");
    if (!folder.isEmpty())
        widget.grab().save(folder + QLatin1Char('/') + name + QStringLiteral(".png"));
}

QString firstTab(WindowBench &bench)
{
    return bench.part<PageTabs>().tabText(0);
}

void choosePreference(WindowBench &bench, int place, const QString &code)
{
    QTest::keyClick(&bench.window(), Qt::Key_Comma, Qt::ControlModifier);
    auto *dialog = bench.window().findChild<Preferences *>();
    QVERIFY(dialog);
    keepPicture(*dialog, QStringLiteral("preferences"));
    auto *box = dialog->findChildren<QComboBox *>().at(place);
    box->setCurrentIndex(box->findData(code));
    dialog->findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Ok)->click();
}

} // namespace

class ProgramTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void anotherLanguageIsSpokenAtOnceOnTheSamePageAndDevice_data();
    void anotherLanguageIsSpokenAtOnceOnTheSamePageAndDevice();
    void theLanguagesAreThoseThatAreTranslatedEachInItsOwnWord();
    void theWordsOfQtAreInTheLanguageToo();
    void unitsAndSoundsAreThePersonsChoice();
    void preferencesKnowWhatTheCommandLineChose();
    void preferencesNameTheFoldersWhereThingsAreKept();
    void theGuardianIsChecked();
    void theThemeMayBeTheDesktops();
    void nothingChangesWhileAMotorIsArmed();
    void preferencesWaitUntilAnUpdateIsOver();
    void preferencesWaitUntilAnExportIsWritten();
    void theNextWindowForgetsNothing();
    void preferencesWaitUntilAnExperimentHasPutBackItsGains();
    void aCommandIsFoundByItsNameAndRun();
    void recordedSamplesOpenInAWindowOfTheirOwn();
    void aFileThatIsNoRecordingSaysWhy();
    void aFileThatIsNotThereIsRefusedBeforeThereIsAWindow();
    void picturesOfATourAreAsLargeAsTheWindowThatWasAskedFor();
    void aSignalEndsTheProgramInOrder_data();
    void aSignalEndsTheProgramInOrder();
    void aboutTellsTheVersionsOfEverything();
};

void ProgramTest::anotherLanguageIsSpokenAtOnceOnTheSamePageAndDevice_data()
{
    QTest::addColumn<QString>("code");
    QTest::addColumn<QString>("tab");
    QTest::newRow("German") << QStringLiteral("de") << QStringLiteral("Übersicht");
    QTest::newRow("Spanish") << QStringLiteral("es") << QStringLiteral("Resumen");
    QTest::newRow("French") << QStringLiteral("fr") << QStringLiteral("Vue d’ensemble");
    QTest::newRow("Japanese") << QStringLiteral("ja") << QStringLiteral("概要");
    QTest::newRow("Chinese") << QStringLiteral("zh") << QStringLiteral("概览");
}

void ProgramTest::anotherLanguageIsSpokenAtOnceOnTheSamePageAndDevice()
{
    QFETCH(QString, code);
    QFETCH(QString, tab);
    WindowBench bench;
    QTRY_VERIFY_WITH_TIMEOUT(bench.isFound(), patience);
    bench.select(WindowBench::tuned);
    bench.window().showPage(PageId::Parameters);
    QCOMPARE(firstTab(bench), QStringLiteral("Overview"));
    const QWidget *before = &bench.window();
    choosePreference(bench, 1, code);
    QTRY_COMPARE_WITH_TIMEOUT(firstTab(bench), tab, patience);
    QVERIFY(&bench.window() != before);
    QVERIFY(bench.window().isVisible());
    QCOMPARE(bench.window().shownPage(), PageId::Parameters);
    QCOMPARE(bench.window().selection().device(), bench.device(WindowBench::tuned)->id);
    QCOMPARE(bench.engine().snapshot().devices.size() >= WindowBench::benchSize, true); // nothing was closed
    bench.window().close(); // the new one answers like the old one
    QTRY_VERIFY_WITH_TIMEOUT(!bench.window().isVisible(), patience);
}

void ProgramTest::theLanguagesAreThoseThatAreTranslatedEachInItsOwnWord()
{
    QStringList names;
    for (const Language &language : languages())
        names += language.code + QLatin1Char(' ') + language.name;
    QCOMPARE(names,
        QStringList({QStringLiteral("de Deutsch"), QStringLiteral("en English"), QStringLiteral("es Español"),
            QStringLiteral("fr Français"), QStringLiteral("ja 日本語"), QStringLiteral("zh 简体中文")}));
    const auto refused
        = Options::parse({QStringLiteral("motorbench"), QStringLiteral("--language"), QStringLiteral("tlh")});
    QVERIFY(!refused);
    QCOMPARE(QString::fromStdString(refused.error().detail.english()),
        QStringLiteral("--language takes one of de, en, es, fr, ja, zh"));
}

void ProgramTest::theWordsOfQtAreInTheLanguageToo()
{
    WindowBench bench(1.0, QStringLiteral("de"));
    const QDialogButtonBox buttons(QDialogButtonBox::Close | QDialogButtonBox::Help);
    QCOMPARE(buttons.button(QDialogButtonBox::Close)->text().remove(QLatin1Char('&')), QStringLiteral("Schließen"));
    QCOMPARE(buttons.button(QDialogButtonBox::Help)->text().remove(QLatin1Char('&')), QStringLiteral("Hilfe"));
    const QString enter = QKeySequence(QStringLiteral("Ctrl+Return")).toString(QKeySequence::NativeText);
    QCOMPARE(enter, QStringLiteral("Strg+Enter"));
}

void ProgramTest::unitsAndSoundsAreThePersonsChoice()
{
    WindowBench bench;
    QTRY_VERIFY_WITH_TIMEOUT(bench.isFound(), patience);
    bench.select(WindowBench::tuned);
    const auto revolutions = [&bench] {
        auto &plot = *bench.page<TunePage>(PageId::Tune).findChild<TunePlot *>();
        for (Segmented *choice : plot.findChildren<Segmented *>()) {
            if (choice->accessibleName() == QStringLiteral("Units"))
                return choice->current() == 1;
        }
        return false;
    };
    QVERIFY(!revolutions());
    QTest::keyClick(&bench.window(), Qt::Key_Comma, Qt::ControlModifier);
    auto *dialog = bench.window().findChild<Preferences *>();
    auto *units = dialog->findChildren<QComboBox *>().at(3);
    units->setCurrentIndex(units->findData(true));
    for (QCheckBox *box : dialog->findChildren<QCheckBox *>())
        box->setChecked(box->accessibleName() != QStringLiteral("Sounds") && box->isChecked());
    dialog->findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Ok)->click();
    QTRY_VERIFY_WITH_TIMEOUT(revolutions(), patience); // in the window that is made anew
    QVERIFY(!bench.part<ProductionPage>().findChild<QCheckBox *>(QStringLiteral("sound"))->isChecked());
}

void ProgramTest::preferencesKnowWhatTheCommandLineChose()
{
    WindowBench bench(1.1, QStringLiteral("de"));
    QTest::keyClick(&bench.window(), Qt::Key_Comma, Qt::ControlModifier);
    auto *dialog = bench.window().findChild<Preferences *>();
    const Look worn = dialog->look();
    QCOMPARE(worn.language, QStringLiteral("de"));
    QCOMPARE(worn.fontScale, 1.1);
    const double size = bench.window().font().pointSizeF();
    const QWidget *before = &bench.window();
    for (QCheckBox *box : dialog->findChildren<QCheckBox *>())
        box->setChecked(!worn.sounds);
    dialog->findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Ok)->click();
    QTRY_VERIFY_WITH_TIMEOUT(&bench.window() != before, patience);
    QCOMPARE(firstTab(bench), QStringLiteral("Übersicht"));
    QCOMPARE(bench.window().font().pointSizeF(), size);
}

void ProgramTest::preferencesNameTheFoldersWhereThingsAreKept()
{
    WindowBench bench;
    QTest::keyClick(&bench.window(), Qt::Key_Comma, Qt::ControlModifier);
    QMap<QString, QString> named;
    for (const QLabel *label : bench.window().findChild<Preferences *>()->findChildren<QLabel *>())
        named[label->accessibleName()] = label->text();
    QCOMPARE(named[QStringLiteral("Notebook, recordings")],
        QFileInfo(QString::fromStdString(databaseFile())).absolutePath());
    Settings(true).setTheme(QStringLiteral("dark"));
    QCOMPARE(QDir(named[QStringLiteral("Settings, layouts")]).entryList(QDir::Files),
        QStringList(QStringLiteral("MotorBench.conf")));
}

void ProgramTest::theGuardianIsChecked()
{
    GuardianCheck there(QString::fromStdString(guardianBesideThisProgram()));
    there.check();
    auto *words = there.findChild<QLabel *>();
    QTRY_COMPARE_WITH_TIMEOUT(words->text(), QStringLiteral("It is in place and runs."), patience);
    QCOMPARE(words->accessibleName(), words->text());
    GuardianCheck missing(QStringLiteral("/nonexistent/guardian"));
    missing.check();
    QTRY_VERIFY_WITH_TIMEOUT(
        missing.findChild<QLabel *>()->text().startsWith(QStringLiteral("/nonexistent/guardian cannot be started")),
        patience);
    GuardianCheck another(QStringLiteral("/bin/true"));
    another.check();
    QTRY_COMPARE_WITH_TIMEOUT(
        another.findChild<QLabel *>()->text(), QStringLiteral("/bin/true does not run as it should."), patience);
}

void ProgramTest::theThemeMayBeTheDesktops()
{
    WindowBench bench;
    QTRY_VERIFY_WITH_TIMEOUT(bench.isFound(), patience);
    choosePreference(bench, 0, QStringLiteral("contrast"));
    QTRY_COMPARE_WITH_TIMEOUT(QApplication::palette().color(QPalette::Window), QColor(Qt::black), patience);
    QCOMPARE(QApplication::palette().color(QPalette::WindowText), QColor(Qt::white));
    keepPicture(bench.window(), QStringLiteral("contrast"));
    choosePreference(bench, 0, QStringLiteral("system"));
    QTRY_COMPARE_WITH_TIMEOUT(QApplication::palette().color(QPalette::Window).name(), QStringLiteral("#efefef"),
        patience); // Qt's own, without a desktop
    keepPicture(bench.window(), QStringLiteral("system"));
}

void ProgramTest::nothingChangesWhileAMotorIsArmed()
{
    WindowBench bench;
    QTRY_VERIFY_WITH_TIMEOUT(bench.isFound(), patience);
    bench.select(WindowBench::tuned);
    bench.arming().arm(bench.window().selection().device());
    QTRY_VERIFY_WITH_TIMEOUT(bench.arming().state() == LampState::Armed, patience);
    const QWidget *before = &bench.window();
    choosePreference(bench, 1, QStringLiteral("de"));
    QTest::qWait(0);
    QCoreApplication::processEvents();
    QCOMPARE(static_cast<const QWidget *>(&bench.window()), before);
    QCOMPARE(firstTab(bench), QStringLiteral("Overview"));
    QCOMPARE(bench.arming().state(), LampState::Armed);
    bench.arming().disarm();
    QTRY_COMPARE_WITH_TIMEOUT(firstTab(bench), QStringLiteral("Übersicht"), patience);
    QVERIFY(bench.window().isVisible());
}

void ProgramTest::preferencesWaitUntilAnUpdateIsOver()
{
    WindowBench bench;
    bench.beginUpdate();
    const DeviceId id = bench.device(WindowBench::inBootloader)->id;
    const auto update = [&bench, id] { return bench.engine().snapshot().operation(id); };
    QTRY_VERIFY_WITH_TIMEOUT(update() && update()->status.done > 1, patience);
    choosePreference(bench, 1, QStringLiteral("de"));
    QTest::qWait(100);
    QVERIFY(update()->status.state == OperationStatus::State::Running);
    QCOMPARE(firstTab(bench), QStringLiteral("Overview"));
    bench.engine().send(orders::CancelOperation{update()->id});
    QTRY_COMPARE_WITH_TIMEOUT(firstTab(bench), QStringLiteral("Übersicht"), patience);
    QCOMPARE(bench.window().shownPage(), PageId::Firmware);
}

void ProgramTest::preferencesWaitUntilAnExportIsWritten()
{
    WindowBench bench;
    std::atomic<bool> written{false};
    auto *job = new ExportJob(&bench.window());
    QVERIFY(job->start(
        [&written](const ExportProgress &progress) -> Result<ExportReport> {
            while (!written && progress(0.5))
                std::this_thread::yield();
            return ExportReport();
        },
        QStringLiteral("samples.mcap")));
    choosePreference(bench, 1, QStringLiteral("de"));
    QTest::qWait(100);
    QCOMPARE(firstTab(bench), QStringLiteral("Overview"));
    written = true;
    QTRY_COMPARE_WITH_TIMEOUT(firstTab(bench), QStringLiteral("Übersicht"), patience);
}

void ProgramTest::theNextWindowForgetsNothing()
{
    WindowBench bench;
    QTRY_VERIFY_WITH_TIMEOUT(bench.isFound(), patience);
    bench.select(WindowBench::tuned);
    auto &tune = bench.page<TunePage>(PageId::Tune);
    tune.showLive(true);
    tune.form().choose(Mode::Velocity, 3210.0);
    for (QCheckBox *box : tune.findChildren<QCheckBox *>()) {
        if (box->accessibleName() == QStringLiteral("Reverse sensor"))
            box->setChecked(true);
    }
    bench.page<PlotsPage>(PageId::Plots).board().addNote(1.0, QStringLiteral("belt on"));
    const QPointer<QWidget> before = &bench.window();
    choosePreference(bench, 1, QStringLiteral("de"));
    QTRY_VERIFY_WITH_TIMEOUT(!before, patience);
    QCOMPARE(bench.page<PlotsPage>(PageId::Plots).board().notes().size(), std::size_t{1});
    auto &next = bench.page<TunePage>(PageId::Tune);
    QVERIFY(next.isLive());
    const SetPointPanel &panel = next.column().setPointPanel();
    QCOMPARE(panel.target().value_or(0.0), 3210.0);
    QVERIFY(panel.entered().options.reverseSensor);
}

void ProgramTest::preferencesWaitUntilAnExperimentHasPutBackItsGains()
{
    WindowBench bench;
    QTRY_VERIFY_WITH_TIMEOUT(bench.isFound(), patience);
    bench.select(WindowBench::tuned);
    bench.arming().arm(bench.window().selection().device());
    tuning::ExperimentPlan plan;
    plan.to = 20000.0;
    plan.gains = {{*findParameter(bench.device(WindowBench::tuned)->family->parameters, "slot0.p"), 1}};
    bool wasGerman = false;
    std::optional<Result<tuning::Trial>> ended;
    bench.arming().runTrial(plan, {}, [&](const Result<tuning::Trial> &trial) {
        wasGerman = firstTab(bench) == QStringLiteral("Übersicht");
        ended = trial;
    });
    QTRY_VERIFY_WITH_TIMEOUT(bench.device(WindowBench::tuned)->motion.running || ended, patience);
    choosePreference(bench, 1, QStringLiteral("de"));
    QTest::keyClick(&bench.window(), Qt::Key_Escape); // not armed any more, and it still runs
    QTRY_VERIFY_WITH_TIMEOUT(ended, patience);
    QVERIFY2(ended->has_value(), ended->has_value() ? "" : ended->error().text().c_str());
    QVERIFY(!wasGerman);
    QTRY_COMPARE_WITH_TIMEOUT(firstTab(bench), QStringLiteral("Übersicht"), patience);
}

void ProgramTest::aCommandIsFoundByItsNameAndRun()
{
    WindowBench bench;
    QTRY_VERIFY_WITH_TIMEOUT(bench.isFound(), patience);
    QTest::keyClick(&bench.window(), Qt::Key_K, Qt::ControlModifier);
    auto *palette = bench.window().findChild<QDialog *>(QStringLiteral("commands"));
    QTRY_VERIFY_WITH_TIMEOUT(palette && palette->isVisible(), patience);
    auto *text = palette->findChild<QLineEdit *>();
    keepPicture(*palette, QStringLiteral("commands"));
    QVERIFY(palette->findChild<QListWidget *>()->count() > 40);
    text->setText(QStringLiteral("shows page plots"));
    QTest::keyClick(text, Qt::Key_Return);
    QTRY_COMPARE_WITH_TIMEOUT(bench.window().shownPage(), PageId::Plots, patience);
}

void ProgramTest::recordedSamplesOpenInAWindowOfTheirOwn()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("run.csv"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("time_s,speed (counts/s),current (A)\n");
    for (int i = 0; i < 200; ++i)
        file.write(
            QByteArray::number(i * 0.01) + ',' + QByteArray::number(i * 10) + ',' + QByteArray::number(i % 7) + '\n');
    file.close();
    WindowBench bench;
    bench.window().openFile(path);
    auto *samples = bench.window().findChild<SamplesWindow *>();
    QVERIFY(samples && samples->isVisible());
    QTRY_VERIFY_WITH_TIMEOUT(samples->isLoaded(), patience);
    QCOMPARE(samples->stack().strips().traceCount(), 2);
    QVERIFY(samples->stack().view().range().second > 1.9);
    auto *channels = samples->findChild<QListWidget *>();
    QCOMPARE(channels->count(), 2);
    QVERIFY(QTest::qWaitForWindowExposed(samples));
    samples->stack().refresh(2.0);
    samples->stack().refresh(2.0);
    keepPicture(*samples, QStringLiteral("samples"));
    for (int i = 0; i < 2; ++i)
        QCOMPARE(channels->item(i)->checkState(), Qt::Checked);
    QVERIFY2(samples->stack().readings().summary().contains(QStringLiteral("speed")),
        qPrintable(samples->stack().readings().summary()));
    channels->item(0)->setCheckState(Qt::Unchecked);
    samples->stack().refresh(2.0);
    QVERIFY2(!samples->stack().readings().summary().contains(QStringLiteral("speed")),
        qPrintable(samples->stack().readings().summary()));
    QVERIFY(samples->stack().readings().summary().contains(QStringLiteral("current")));
    samples->close();
    QTRY_VERIFY_WITH_TIMEOUT(!bench.window().findChild<SamplesWindow *>(), patience);
    QVERIFY(bench.window().isVisible());
}

void ProgramTest::aFileThatIsNoRecordingSaysWhy()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("wrong.mcap"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("this is no container");
    file.close();
    WindowBench bench;
    bench.window().openFile(path);
    auto *samples = bench.window().findChild<SamplesWindow *>();
    QTRY_VERIFY_WITH_TIMEOUT(!samples->failure().isEmpty(), patience);
    QVERIFY(samples->failure().contains(QStringLiteral("wrong.mcap")));
    QVERIFY(!samples->isLoaded());
    QCOMPARE(samples->stack().strips().traceCount(), 0);
}

void ProgramTest::aFileThatIsNotThereIsRefusedBeforeThereIsAWindow()
{
    const auto options = Options::parse({QStringLiteral("motorbench"), QStringLiteral("nowhere.mcap")});
    QVERIFY(!options);
    QVERIFY(options.error().text().find("nowhere.mcap") != std::string::npos);
}

void ProgramTest::picturesOfATourAreAsLargeAsTheWindowThatWasAskedFor()
{
    const QTemporaryDir folder;
    QProcess program;
    program.start(QCoreApplication::applicationDirPath() + QStringLiteral("/motorbench"),
        {QStringLiteral("--tour"), folder.path(), QStringLiteral("--size"), QStringLiteral("1100x700")});
    QImage first;
    const auto isSaved = [&] {
        const QStringList names = QDir(folder.path()).entryList({QStringLiteral("*.png")});
        return !names.isEmpty() && first.load(folder.filePath(names.first()));
    };
    QTRY_VERIFY_WITH_TIMEOUT(isSaved(), patience);
    QCOMPARE(first.size(), QSize(1100, 700));
    program.terminate();
    QVERIFY(program.waitForFinished(patience));
    QCOMPARE(program.exitStatus(), QProcess::NormalExit);
    QCOMPARE(program.exitCode(), 1); // it is not all there
}

void ProgramTest::aSignalEndsTheProgramInOrder_data()
{
    QTest::addColumn<int>("number");
    QTest::newRow("SIGINT") << SIGINT;
    QTest::newRow("SIGTERM") << SIGTERM;
    QTest::newRow("SIGHUP") << SIGHUP;
}

void ProgramTest::aSignalEndsTheProgramInOrder()
{
    QFETCH(int, number);
    const QTemporaryDir home;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char *name : {"XDG_DATA_HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME", "XDG_RUNTIME_DIR"})
        environment.insert(QLatin1String(name), home.path());
    QProcess program;
    program.setProcessEnvironment(environment);
    program.start(QCoreApplication::applicationDirPath() + QStringLiteral("/motorbench"),
        {QStringLiteral("--link"), QStringLiteral("sim:can")});
    const QDir sessions(home.filePath(QStringLiteral("motorbench/sessions")));
    const auto kept = [&sessions] {
        const QStringList names = sessions.entryList({QStringLiteral("*.json")});
        QFile file(sessions.filePath(names.value(0)));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    };
    QTRY_VERIFY_WITH_TIMEOUT(kept().contains("dmc60c:5"), patience);
    QVERIFY(!kept().contains("\"ended\": true"));
    QCOMPARE(::kill(static_cast<pid_t>(program.processId()), number), 0);
    QVERIFY(program.waitForFinished(patience));
    QCOMPARE(program.exitStatus(), QProcess::NormalExit);
    QCOMPARE(program.exitCode(), 0);
    QVERIFY(kept().contains("\"ended\": true")); // the next start does not speak of a crash
}

void ProgramTest::aboutTellsTheVersionsOfEverything()
{
    WindowBench bench;
    About about(&bench.window());
    about.show();
    keepPicture(about, QStringLiteral("about"));
    const QString text = about.findChild<QPlainTextEdit *>()->toPlainText();
    for (const char *word : {"MotorBench", "Qt 5", "QCustomPlot 2", "kernel", "dmc60c", "quadquad2drv", "GPL-3.0"})
        QVERIFY2(text.contains(QLatin1String(word)), word);
}

MB_WINDOW_TEST(ProgramTest);
#include "tst_program.moc"
