// SPDX-License-Identifier: GPL-3.0-or-later
// The first minute with the real window and engine: the demo offers a story, and the story goes on when motors and flash say so.
#include "windowbench.h"

#include "app/firmwareshelf.h"
#include "app/helpdesk.h"
#include "app/keydesk.h"
#include "app/welcome.h"
#include "model/registry.h"
#include "support/windowtests.h"
#include "widgets/common/devicetext.h"
#include "widgets/connection/addlinkdialog.h"
#include "widgets/connection/overviewpage.h"
#include "widgets/connection/startpage.h"
#include "widgets/control/modepanel.h"
#include "widgets/control/tunepage.h"
#include "widgets/help/helpwindow.h"
#include "widgets/parameters/ramblock.h"
#include "widgets/start/guide.h"
#include "widgets/start/guidestrip.h"

#include <QAbstractButton>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTemporaryDir>
#include <QToolButton>

#include <algorithm>
#include <cmath>

using namespace mb;
using namespace mb::test;

namespace {

constexpr int storyTime = 120000; ///< ms, of a tuning in real time on a busy computer

void keepWindow(WindowBench &bench, const QString &name)
{
    const QString folder = qEnvironmentVariable("MOTORBENCH_PICTURES");
    if (!folder.isEmpty())
        bench.window().grab().save(folder + QLatin1Char('/') + name + QStringLiteral(".png"));
}

QPushButton *buttonOf(const QWidget &parent, const QString &text)
{
    for (QPushButton *button : parent.findChildren<QPushButton *>()) {
        if (button->text() == text)
            return button;
    }
    return nullptr;
}

void chooseMode(QWidget &window, const QString &name)
{
    for (QAbstractButton *button : window.findChild<ModePanel *>()->findChildren<QAbstractButton *>()) {
        if (button->text() == name)
            button->click();
    }
}

void type(QWidget &window, const QString &name, double value)
{
    for (QLineEdit *field : window.findChildren<QLineEdit *>()) {
        if (field->accessibleName() != name || !field->isVisible())
            continue;
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, QString::number(value, 'f', 0));
        QTest::keyClick(field, Qt::Key_Return);
    }
}

GuideStrip &stripOf(MainWindow &window, const char *name)
{
    return *window.findChild<GuideStrip *>(QLatin1String(name));
}

} // namespace

class WelcomeTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { qputenv("XDG_CONFIG_HOME", m_config.path().toUtf8()); }
    void theDemoBeginsOnAUnitThatCanBeTuned();
    void theOfferStandsOnTheOverviewOnly();
    void aStoryIsPlayedToItsEnd();
    void aStoryOfTheStartPageOpensTheBench();
    void theMotorThatStopsShortArrives();
    void aStoryNamesTheKeysAsTheyAre();
    void firmwareOnDiskIsCheckedAndOpened();
    void everyPageHasItsHelp();
    void everyFormHasItsHelp();

private:
    QTemporaryDir m_config;
};

void WelcomeTest::theDemoBeginsOnAUnitThatCanBeTuned()
{
    WindowBench bench;
    QTRY_VERIFY_WITH_TIMEOUT(bench.isFound(), patience);
    QTRY_COMPARE_WITH_TIMEOUT(bench.window().selection().device(), bench.device(WindowBench::tuned)->id, patience);
}

void WelcomeTest::theOfferStandsOnTheOverviewOnly()
{
    WindowBench bench;
    auto &strip = stripOf(bench.window(), "guideOffer");
    QTRY_VERIFY_WITH_TIMEOUT(bench.isFound() && strip.isVisible(), patience);
    keepWindow(bench, QStringLiteral("offer"));
    bench.window().showPage(PageId::Tune);
    QTRY_VERIFY_WITH_TIMEOUT(!strip.isVisible(), patience);
    bench.window().showPage(PageId::Overview);
    QTRY_VERIFY_WITH_TIMEOUT(strip.isVisible(), patience);
    buttonOf(strip, QStringLiteral("Not now"))->click();
    QTest::qWait(0);
    Q_EMIT bench.engine().changed();
    QVERIFY(!strip.isVisible());
}

void WelcomeTest::aStoryIsPlayedToItsEnd()
{
    WindowBench bench;
    auto &offer = stripOf(bench.window(), "guideOffer");
    auto &strip = stripOf(bench.window(), "guide");
    QTRY_VERIFY_WITH_TIMEOUT(bench.isFound() && offer.isVisible(), patience);
    QVERIFY(!strip.isVisible());
    buttonOf(offer, QStringLiteral("Begin"))->click();
    QVERIFY(strip.isVisible() && !offer.isVisible());
    Guide &guide = bench.part<Welcome>().guide();
    QVERIFY(guide.story());
    buttonOf(strip, QStringLiteral("Show me where"))->click(); // selects the unit, and shows its page
    QCOMPARE(bench.window().shownPage(), PageId::Tune);
    QTRY_COMPARE_WITH_TIMEOUT(guide.step(), std::size_t(1), patience);
    QTRY_VERIFY_WITH_TIMEOUT(bench.device(7)->mayNotMove.empty() && bench.isRead(7), patience);
    bench.arming().arm(bench.device(7)->id);
    QTRY_COMPARE_WITH_TIMEOUT(guide.step(), std::size_t(2), patience);
    QTest::qWait(200); // the page has to see the arming
    QTest::keyClick(&bench.window(), Qt::Key_F5);
    QTRY_COMPARE_WITH_TIMEOUT(guide.step(), std::size_t(3), storyTime);
    keepWindow(bench, QStringLiteral("guide"));
    QTRY_VERIFY_WITH_TIMEOUT(bench.arming().state() == LampState::Armed, patience);
    buttonOf(strip, QStringLiteral("Show me where"))->click();
    QCOMPARE(bench.window().shownPage(), PageId::Design);
    QTest::keyClick(&bench.window(), Qt::Key_F6);
    QTRY_VERIFY_WITH_TIMEOUT(guide.step() >= 4, storyTime);
    QVERIFY(!guide.isDone());
    buttonOf(strip, QStringLiteral("Show me where"))->click();
    QCOMPARE(bench.window().shownPage(), PageId::Parameters);
    auto &block = *bench.window().page(PageId::Parameters)->findChild<RamBlock *>();
    auto *store = buttonOf(block, QStringLiteral("Store and prove"));
    QTRY_VERIFY_WITH_TIMEOUT(store->isVisible() && store->isEnabled(), storyTime); // 15 s after the last change
    store->click();
    QTRY_VERIFY_WITH_TIMEOUT(guide.isDone(), storyTime);
    qInfo("%s", qPrintable(guide.result()));
    keepWindow(bench, QStringLiteral("guide-done"));
    buttonOf(strip, QStringLiteral("Close"))->click();
    QVERIFY(!strip.isVisible());
}

void WelcomeTest::aStoryOfTheStartPageOpensTheBench()
{
    Options options;
    options.language = QStringLiteral("en");
    Application application(*qApp, options); // no demo: nothing is open
    application.start();
    MainWindow &window = application.window();
    window.resize(1440, 900);
    auto *start = window.findChild<StartPage *>();
    QTRY_VERIFY_WITH_TIMEOUT(start->isVisible(), patience);
    const QString folder = qEnvironmentVariable("MOTORBENCH_PICTURES");
    if (!folder.isEmpty()) {
        QTRY_VERIFY(window.height() == 900 && !application.engine().listings().empty());
        QTest::qWait(100);
        window.grab().save(folder + QStringLiteral("/start.png"));
    }
    auto *card = start->findChild<QWidget *>(QStringLiteral("story-arrive"));
    card->findChild<QPushButton *>()->click();
    Guide &guide = window.findChild<Welcome *>()->guide();
    QTRY_VERIFY_WITH_TIMEOUT(guide.device(), patience);
    auto *strip = &stripOf(window, "guide");
    buttonOf(*strip, QStringLiteral("Show me where"))->click();
    QCOMPARE(window.shownPage(), PageId::Tune);
    QTRY_COMPARE_WITH_TIMEOUT(guide.step(), std::size_t(1), patience);
}

/// The motor that stops short, from the start page until it rests at its target: what the story says is what the bench does.
void WelcomeTest::theMotorThatStopsShortArrives()
{
    const auto all = stories();
    const Story &story = *std::find_if(all.begin(), all.end(), [](const Story &row) { return row.key == "arrive"; });
    const DemoUnits &demo = *storyFamily(story)->demo;
    WindowBench bench;
    MainWindow &window = bench.window();
    Guide &guide = bench.part<Welcome>().guide();
    const auto unit = [&guide] { return guide.device(); };
    guide.begin(story);
    QTRY_VERIFY_WITH_TIMEOUT(unit() && unit()->liveness.heard && unit()->mayNotMove.empty(), patience);
    buttonOf(stripOf(window, "guide"), QStringLiteral("Show me where"))->click();
    QCOMPARE(window.shownPage(), PageId::Tune);
    chooseMode(window, QStringLiteral("Position"));
    bench.arming().arm(unit()->id);
    QTRY_COMPARE_WITH_TIMEOUT(guide.step(), std::size_t(2), patience);
    auto &page = bench.page<TunePage>(PageId::Tune);
    // Pressed as a person does: again, where the page had not seen the arming yet.
    const auto runTo = [&](auto &&isThere) {
        for (int press = 0; press < 10 && !isThere(); ++press) {
            if (!QTest::qWaitFor([&] { return isThere() || page.status().mayRun; }, patience))
                return false;
            QTest::keyClick(&window, Qt::Key_F5);
            if (!QTest::qWaitFor([&] { return isThere() || bench.arming().isOnTrial(); }, 1000))
                continue;
            (void)QTest::qWaitFor([&] { return isThere() || !bench.arming().isOnTrial(); }, storyTime);
            (void)QTest::qWaitFor(isThere, 2000); // the guide looks with the next snapshot
        }
        return isThere();
    };
    type(window, QStringLiteral("To"), demo.shortStep);
    QVERIFY2(runTo([&] { return guide.step() == 3; }), qPrintable(page.status().cause));
    const QString short1 = guide.result();
    keepWindow(bench, QStringLiteral("guide-short"));
    const double rest = short1.section(QLatin1Char(' '), 0, 0).toDouble();
    QVERIFY2(std::abs(rest - demo.shortBy) <= demo.shortBy / 4.0, qPrintable(short1));
    for (const auto &[key, value] : demo.arrivingGains) {
        const Parameter &row = unit()->family->parameters[findParameter(unit()->family->parameters, key)->value];
        type(window, tableText(row.label), value);
    }
    QVERIFY2(runTo([&] { return guide.isDone(); }), qPrintable(page.status().cause));
    qInfo("%s", qPrintable(guide.result()));
    keepWindow(bench, QStringLiteral("guide-arrived"));
}

void WelcomeTest::aStoryNamesTheKeysAsTheyAre()
{
    WindowBench bench;
    QTRY_VERIFY_WITH_TIMEOUT(bench.isFound(), patience);
    Guide &guide = bench.part<Welcome>().guide();
    auto &words = *stripOf(bench.window(), "guide").findChild<QLabel *>(QStringLiteral("guideWords"));
    guide.begin(stories().front());
    bench.select(7);
    QTRY_VERIFY_WITH_TIMEOUT(bench.device(7)->mayNotMove.empty(), patience);
    bench.arming().arm(bench.device(7)->id);
    QTRY_COMPARE_WITH_TIMEOUT(guide.step(), std::size_t(2), patience);
    QVERIFY2(words.text().startsWith(QStringLiteral("Press F5:")), qPrintable(words.text()));
    auto &desk = *bench.window().findChild<KeyDesk *>();
    desk.use({{QStringLiteral("TunePage/F5"), {QKeySequence(QStringLiteral("Ctrl+J"))}}});
    QVERIFY2(words.text().startsWith(QStringLiteral("Press Ctrl+J:")), qPrintable(words.text()));
    desk.use({{QStringLiteral("TunePage/F5"), {}}});
    QVERIFY2(words.text().startsWith(QStringLiteral("Press the button:")), qPrintable(words.text()));
    desk.use({});
    QVERIFY2(words.text().startsWith(QStringLiteral("Press F5:")), qPrintable(words.text()));
}

void WelcomeTest::firmwareOnDiskIsCheckedAndOpened()
{
    const QTemporaryDir folder;
    QVERIFY(QFile::copy(QStringLiteral(":/firmware/dmc60c-demo.hex"), folder.filePath(QStringLiteral("good.hex"))));
    QFile bad(folder.filePath(QStringLiteral("bad.hex")));
    QVERIFY(bad.open(QIODevice::WriteOnly));
    bad.write(":0000000100\n");
    bad.close();
    FirmwareShelf shelf(folder.path());
    shelf.look(folder.path());
    const auto isRead = [&shelf] {
        const auto rows = shelf.rows();
        return std::all_of(rows.begin(), rows.end(),
            [](const ListCard::Row &row) { return !row.words.contains(QStringLiteral("not read yet")); });
    };
    QTRY_VERIFY(isRead());
    for (const ListCard::Row &row : shelf.rows())
        QCOMPARE(row.words.contains(QStringLiteral("checked")), row.name == QStringLiteral("good.hex"));
}

void WelcomeTest::everyPageHasItsHelp()
{
    WindowBench bench;
    QTRY_VERIFY_WITH_TIMEOUT(bench.isFound(), patience);
    bench.select(WindowBench::tuned);
    HelpDesk &desk = bench.window().help();
    for (int i = 0; i <= static_cast<int>(PageId::Log); ++i) {
        bench.window().showPage(static_cast<PageId>(i));
        bench.window().findChild<QToolButton *>(QStringLiteral("pageHelp"))->click();
        auto *help = bench.window().findChild<HelpWindow *>();
        QVERIFY(help);
        QCOMPARE(help->topic(), desk.topicOf(static_cast<PageId>(i)));
    }
    QCOMPARE(desk.topicOf(PageId::Parameters), QStringLiteral("hardware/dmc60c"));
}

void WelcomeTest::everyFormHasItsHelp()
{
    WindowBench bench;
    bench.window().findChild<OverviewPage *>()->addLinkRequested();
    auto *form = bench.window().findChild<AddLinkDialog *>();
    QVERIFY(form);
    QTest::keyClick(form, Qt::Key_F1);
    auto *help = bench.window().findChild<HelpWindow *>();
    QVERIFY(help);
    QCOMPARE(help->topic(), QStringLiteral("connecting"));
    form->close();
    QApplication::setActiveWindow(&bench.window());
    QTest::keyClick(&bench.window(), Qt::Key_F1);
    auto *keys = bench.window().findChild<QDialog *>(QStringLiteral("keys"));
    QVERIFY(keys);
    QVERIFY(keys->findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Help));
}

MB_WINDOW_TEST(WelcomeTest);
#include "tst_welcome.moc"
