// SPDX-License-Identifier: GPL-3.0-or-later
// What outlives a run of the program: its session, the report of a crash, and its name on a link that two windows have.
#include "windowbench.h"

#include "app/crashnotice.h"
#include "app/crashreport.h"
#include "app/linkowners.h"
#include "app/sessionbook.h"
#include "app/sessiondesk.h"
#include "app/sessionkeeper.h"
#include "app/settings.h"
#include "app/welcome.h"
#include "support/fakeworkbench.h"
#include "support/windowtests.h"
#include "widgets/connection/deviceactions.h"
#include "widgets/connection/startpage.h"

#include <QFile>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>

#include <algorithm>
#include <csignal>

#include <sys/wait.h>
#include <unistd.h>

using namespace mb;
using namespace mb::test;

namespace {

SessionRecord record(qint64 begun, bool ended)
{
    SessionRecord session;
    session.begun = session.changed = begun;
    session.ended = ended;
    session.links = QStringList{QStringLiteral("sim:can")};
    session.units = QStringList{QStringLiteral("DMC60C #7")};
    session.selected = QStringLiteral("sim:can/dmc60c:7");
    session.page = QStringLiteral("parameters");
    return session;
}

void write(const QString &folder, const SessionRecord &session)
{
    QDir().mkpath(folder);
    QFile file(QStringLiteral("%1/%2-1.json").arg(folder).arg(session.begun, 12, 10, QLatin1Char('0')));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(session.toJson());
}

/// A program of its own, which does this and then waits to be killed.
class OtherProgram {
public:
    explicit OtherProgram(const std::function<void()> &act)
    {
        int ready[2];
        if (::pipe(ready) != 0)
            qFatal("no pipe");
        m_process = ::fork();
        if (m_process == 0) {
            act();
            (void)!::write(ready[1], "x", 1);
            for (;;)
                ::pause();
        }
        char byte = 0;
        (void)!::read(ready[0], &byte, 1);
        ::close(ready[0]);
        ::close(ready[1]);
    }
    ~OtherProgram() { end(); }
    OtherProgram(const OtherProgram &) = delete;
    OtherProgram &operator=(const OtherProgram &) = delete;
    void end()
    {
        if (m_process > 0) {
            ::kill(m_process, SIGKILL);
            ::waitpid(m_process, nullptr, 0);
        }
        m_process = 0;
    }
    [[nodiscard]] pid_t process() const { return m_process; }

private:
    pid_t m_process = 0;
};

Options plainOptions()
{
    Options options;
    options.language = QStringLiteral("en");
    return options;
}

} // namespace

class SessionsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void init();
    void aSessionIsWrittenAndReadAsItWas();
    void aRunThatGoesOnIsNeitherEarlierNorCrashed();
    void oneThatNeitherRunsNorEndedHasCrashed();
    void aCrashLeavesAReport();
    void everyPageHasAName();
    void whoHasALinkIsSaid();
    void aFolderThatCannotBeWrittenIsNobodysLink();
    void whoHasAPortIsFound();
    void theWindowComesBackToWhereItWas();
    void aSessionTakesNobodysUnitAway_data();
    void aSessionTakesNobodysUnitAway();
    void aCrashedSessionIsOpenedAgain();
    void aLinkThatOneWindowKeepsIsNotLostByAnother();
    void timesAreSaidAsPeopleSayThem();

private:
    [[nodiscard]] QString sessions() const
    {
        return QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation)
            + QStringLiteral("/motorbench/sessions");
    }
    QTemporaryDir m_config;
};

void SessionsTest::initTestCase()
{
    qputenv("XDG_CONFIG_HOME", m_config.path().toUtf8());
    qputenv("XDG_RUNTIME_DIR", m_config.path().toUtf8());
}

void SessionsTest::init()
{
    QDir(sessions()).removeRecursively();
}

void SessionsTest::aSessionIsWrittenAndReadAsItWas()
{
    SessionRecord session = record(1000, false);
    session.geometry = QByteArray("\x00\xff window", 9);
    session.axis = 3;
    const auto read = SessionRecord::fromJson(session.toJson());
    QVERIFY(read);
    QVERIFY(*read == session);
    QVERIFY(!SessionRecord::fromJson("{\"links\":[]}"));
    QVERIFY(!SessionRecord::fromJson("no JSON"));
}

void SessionsTest::aRunThatGoesOnIsNeitherEarlierNorCrashed()
{
    const QTemporaryDir folder;
    const QString place = folder.path();
    OtherProgram other([place] {
        auto *book = new SessionBook(place); // lives as long as its program
        (void)book->begin(1000);
        (void)book->save(record(1000, false));
    });
    SessionBook book(place);
    QVERIFY(book.begin(2000));
    QVERIFY(book.save(record(2000, false)));
    QVERIFY(book.earlier().empty());
    QVERIFY(!book.crashed());
    other.end();
    QCOMPARE(book.earlier().size(), std::size_t(1));
    QVERIFY(book.crashed());
}

void SessionsTest::oneThatNeitherRunsNorEndedHasCrashed()
{
    const QTemporaryDir folder;
    write(folder.path(), record(1000, true));
    write(folder.path(), record(2000, false));
    write(folder.path(), record(3000, true));
    SessionBook book(folder.path());
    QVERIFY(book.begin(4000));
    QCOMPARE(book.earlier().size(), std::size_t(3));
    QCOMPARE(book.earlier().front().record.begun, qint64(3000));
    QVERIFY(book.crashed());
    QCOMPARE(book.crashed()->record.begun, qint64(2000));
    book.settle(*book.crashed());
    QVERIFY(!book.crashed());
    for (qint64 begun = 5000; begun < 5000 + SessionBook::most + 5; ++begun)
        write(folder.path(), record(begun, true));
    SessionBook next(folder.path());
    QVERIFY(next.begin(9000));
    QVERIFY(next.earlier().size() <= static_cast<std::size_t>(SessionBook::most));
}

void SessionsTest::aCrashLeavesAReport()
{
    const QTemporaryDir folder;
    const pid_t process = ::fork();
    if (process == 0) {
        installCrashReport(folder.path(), QStringLiteral("MotorBench 0, a test\n"));
        ::raise(SIGSEGV);
        ::_exit(0);
    }
    int status = 0;
    QCOMPARE(::waitpid(process, &status, 0), process);
    QVERIFY(WIFSIGNALED(status)); // the signal took its course
    QCOMPARE(WTERMSIG(status), SIGSEGV);
    QFile report(newestCrashReport(folder.path()));
    QVERIFY(report.open(QIODevice::ReadOnly));
    const QString text = QString::fromUtf8(report.readAll());
    QVERIFY2(text.contains(QStringLiteral("SIGSEGV")), qPrintable(text));
    QVERIFY(text.contains(QStringLiteral("MotorBench 0, a test")));
    QVERIFY(text.section(QStringLiteral("innermost first:"), 1).count(QLatin1Char('\n')) > 3);
}

void SessionsTest::whoHasALinkIsSaid()
{
    const QTemporaryDir folder;
    FakeWorkbench here;
    LinkOwners owners(here, folder.path(), nullptr);
    QSignalSpy shared(&owners, &LinkOwners::shared);
    LinkView can;
    can.address = "socketcan:can0";
    can.name = "can0";
    const QString place = folder.path();
    OtherProgram other([place, can] {
        auto *there = new FakeWorkbench;
        new LinkOwners(*there, place, there);
        there->shot.links = {can};
        there->publish();
    });
    here.shot.links = {can};
    here.publish();
    QCOMPARE(shared.count(), 1);
    QVERIFY(shared.at(0).at(1).toString().contains(QString::number(other.process())));
    here.publish();
    QCOMPARE(shared.count(), 1); // said once
    other.end();
    here.shot.links.clear();
    here.publish();
    here.shot.links = {can};
    here.publish();
    QCOMPARE(shared.count(), 1); // it is ours now
    LinkView simulated;
    simulated.address = "sim:can";
    here.shot.links.push_back(simulated);
    here.publish();
    QCOMPARE(shared.count(), 1);
}

void SessionsTest::aFolderThatCannotBeWrittenIsNobodysLink()
{
    const QTemporaryDir folder;
    QFile inTheWay(folder.filePath(QStringLiteral("links")));
    QVERIFY(inTheWay.open(QIODevice::WriteOnly));
    FakeWorkbench here;
    LinkOwners owners(here, inTheWay.fileName(), nullptr);
    const QSignalSpy shared(&owners, &LinkOwners::shared);
    LinkView can;
    can.address = "socketcan:can0";
    here.shot.links = {can};
    here.publish();
    QCOMPARE(shared.count(), 0);
}

void SessionsTest::everyPageHasAName()
{
    QStringList names;
    for (int page = 0; page <= static_cast<int>(PageId::Reports); ++page)
        names << pageName(page);
    QCOMPARE(names.removeDuplicates(), 0);
    QVERIFY(!names.contains(QString()));
}

void SessionsTest::whoHasAPortIsFound()
{
    const QTemporaryDir folder;
    const QString port = folder.filePath(QStringLiteral("ttyUSB0"));
    QFile file(port);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.close();
    QVERIFY(holderOf(port).isEmpty());
    OtherProgram other([port] {
        auto *open = new QFile(port);
        (void)open->open(QIODevice::ReadOnly);
    });
    QVERIFY2(holderOf(port).contains(QString::number(other.process())), qPrintable(holderOf(port)));
}

void SessionsTest::theWindowComesBackToWhereItWas()
{
    write(sessions(), record(1000, true));
    Application application(*qApp, plainOptions());
    application.start();
    MainWindow &window = application.window();
    QVERIFY(!window.findChild<CrashNotice *>());
    QVERIFY(application.engine().snapshot().links.empty()); // nothing is opened by itself
    const QStringList buttons = [&window] {
        QStringList names;
        for (const QPushButton *button : window.findChild<StartPage *>()->findChildren<QPushButton *>())
            names += button->accessibleName();
        return names;
    }();
    QVERIFY(buttons.contains(QStringLiteral("Open: DMC60C #7")));
    for (QPushButton *button : window.findChild<StartPage *>()->findChildren<QPushButton *>()) {
        if (button->accessibleName() == QStringLiteral("Open: DMC60C #7"))
            button->click();
    }
    const auto selected = [&application, &window] {
        const DeviceView *device = application.engine().snapshot().device(window.selection().device());
        return device ? QString::fromStdString(device->selector) : QString();
    };
    QTRY_COMPARE_WITH_TIMEOUT(selected(), QStringLiteral("sim:can/dmc60c:7"), patience);
    QTRY_COMPARE_WITH_TIMEOUT(window.shownPage(), PageId::Parameters, patience);
}

void SessionsTest::aSessionTakesNobodysUnitAway_data()
{
    QTest::addColumn<bool>("selects");
    QTest::newRow("somebody has selected another") << true;
    QTest::newRow("somebody has turned the page") << false;
}

/// The unit of the session before answers late.
void SessionsTest::aSessionTakesNobodysUnitAway()
{
    QFETCH(const bool, selects);
    write(sessions(), record(1000, true));
    Application application(*qApp, plainOptions());
    application.start();
    MainWindow &window = application.window();
    const auto find = [&application](const char *selector) -> const DeviceView * {
        const auto &all = application.engine().snapshot().devices;
        const auto found = std::ranges::find(all, selector, &DeviceView::selector);
        return found == all.end() ? nullptr : &*found;
    };
    openAddress(application.engine(), QStringLiteral("sim:spi"), {});
    QTRY_VERIFY_WITH_TIMEOUT(find("sim:spi/quadquad2drv:0"), patience);
    const DeviceId mine = find("sim:spi/quadquad2drv:0")->id;
    QTRY_COMPARE_WITH_TIMEOUT(window.selection().device(), mine, patience); // the only one
    if (selects)
        window.selection().select(mine);
    else
        window.showPage(PageId::Bus);
    const PageId page = window.shownPage();
    openAddress(application.engine(), QStringLiteral("sim:can"), {});
    QTRY_VERIFY_WITH_TIMEOUT(find("sim:can/dmc60c:7"), patience);
    QCOMPARE(window.selection().device(), mine);
    QCOMPARE(window.shownPage(), page);
}

void SessionsTest::aCrashedSessionIsOpenedAgain()
{
    write(sessions(), record(1000, false));
    Application application(*qApp, plainOptions());
    application.start();
    MainWindow &window = application.window();
    auto *notice = window.findChild<CrashNotice *>();
    QTRY_VERIFY_WITH_TIMEOUT(notice && notice->isVisible(), patience);
    const QString folder = qEnvironmentVariable("MOTORBENCH_PICTURES");
    if (!folder.isEmpty())
        window.grab().save(folder + QStringLiteral("/crashed.png"));
    notice->findChildren<QPushButton *>().at(0)->click();
    QVERIFY(!notice->isVisible());
    QTRY_VERIFY_WITH_TIMEOUT(!application.engine().snapshot().devices.empty(), patience);
    QTRY_COMPARE_WITH_TIMEOUT(window.shownPage(), PageId::Parameters, patience);
    window.findChild<SessionKeeper *>()->save(true);
    QVERIFY(!SessionBook(sessions()).crashed());
}

void SessionsTest::aLinkThatOneWindowKeepsIsNotLostByAnother()
{
    const QString mine = QStringLiteral("can:can0");
    const QString theirs = QStringLiteral("serial:/dev/ttyUSB0");
    const QString later = QStringLiteral("can:can1");
    Settings settings(true);
    settings.addLink(mine);
    const OtherProgram other([theirs] { Settings(true).addLink(theirs); });
    settings.addLink(later);
    QCOMPARE(Settings(true).links(), QStringList({mine, theirs, later}));
    for (const QString &link : {mine, later})
        settings.removeLink(link);
    QCOMPARE(Settings(true).links(), QStringList(theirs));
    settings.removeLink(theirs);
}

void SessionsTest::timesAreSaidAsPeopleSayThem()
{
    const qint64 noon = QDateTime(QDate(2026, 6, 7), QTime(12, 0)).toSecsSinceEpoch();
    QVERIFY(whenText(noon - 3600, noon).startsWith(QStringLiteral("today")));
    QVERIFY(whenText(noon - 86400, noon).startsWith(QStringLiteral("yesterday")));
    QVERIFY(!whenText(noon - 10 * 86400, noon).contains(QStringLiteral("day ")));
}

MB_WINDOW_TEST(SessionsTest);
#include "tst_sessions.moc"
