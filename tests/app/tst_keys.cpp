// SPDX-License-Identifier: GPL-3.0-or-later
// Preferences with the key of every command: changed by pressing it, kept, in force at once, in every window that says it.
#include "app/keydesk.h"
#include "app/keyspanel.h"
#include "app/preferences.h"
#include "support/windowtests.h"
#include "widgets/common/commandpalette.h"
#include "widgets/service/productionpage.h"
#include "windowbench.h"

#include <QDialogButtonBox>
#include <QDir>
#include <QDockWidget>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTreeWidget>

using namespace mb;
using namespace mb::test;

namespace {

Preferences &open(MainWindow &window)
{
    QApplication::setActiveWindow(&window);
    QTest::keyClick(&window, Qt::Key_Comma, Qt::ControlModifier);
    return *window.findChild<Preferences *>();
}

void select(Preferences &dialog, const QString &does)
{
    auto *list = dialog.findChild<QTreeWidget *>(QStringLiteral("keyList"));
    const auto found = list->findItems(does, Qt::MatchExactly | Qt::MatchRecursive);
    QVERIFY2(found.size() == 1, qPrintable(does));
    list->setCurrentItem(found.front());
}

QString answer(const Preferences &dialog)
{
    return dialog.findChild<QLabel *>(QStringLiteral("keyAnswer"))->text();
}

void accept(Preferences &dialog, MainWindow &window)
{
    dialog.accept();
    QTRY_VERIFY(!window.findChild<Preferences *>());
    QApplication::setActiveWindow(&window);
}

Options plain()
{
    Options options;
    options.language = QStringLiteral("en");
    return options;
}

} // namespace

class KeysTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { qputenv("XDG_CONFIG_HOME", m_config.path().toUtf8()); }
    void theKeysAreThoseOfTheTable();
    void preferencesListEveryCommandOfEveryPage();
    void aKeyIsChangedByPressingItAndHoldsAtOnce();
    void aClashIsRefusedAndStopsStayStops();
    void noLabelNamesAKeyThatIsNoMore();
    void chosenKeysComeBackWithTheProgram();

private:
    QTemporaryDir m_config;
};

/// What people have learned, and what the documents say. The keys of the window go first.
void KeysTest::theKeysAreThoseOfTheTable()
{
    WindowBench bench;
    MainWindow &window = bench.window();
    const auto check = [](const QWidget &place, const char *keys) {
        const auto *table = place.findChild<PageKeys *>(QString(), Qt::FindDirectChildrenOnly);
        QVERIFY(table);
        QStringList has;
        for (const PageKeys::Row &row : table->rows()) {
            for (const QKeySequence &key : row.factory)
                has << key.toString(QKeySequence::PortableText);
        }
        for (const QString &key : QString::fromLatin1(keys).split(QLatin1Char(' ')))
            QVERIFY2(has.contains(key), qPrintable(place.objectName() + QLatin1Char(' ') + key));
    };
    check(window,
        "Esc Pause Space Ctrl+Shift+F12 F1 F2 F9 F10 F11 Ctrl+K Ctrl+S Ctrl+Shift+S Ctrl+1 Ctrl+2 Ctrl+3 Ctrl+4 Ctrl+5 "
        "Ctrl+6 Ctrl+7 Ctrl+8 Ctrl+9");
    check(*window.page(PageId::Parameters), "F5 Ctrl+F Ctrl+Z Ctrl+Y");
    check(*window.page(PageId::Tune), "F5 F7 Ctrl+P Ctrl+Z Ctrl+Y B G I S L P 0");
    check(*window.page(PageId::Design), "F5 F6 Ctrl+P");
    check(*window.page(PageId::Plots), "L P R 0");
    check(*window.page(PageId::Firmware), "F5");
    check(*window.page(PageId::Bus), "P R Ctrl+F");
    check(*window.page(PageId::Log), "Ctrl+F");
    check(*window.page(PageId::Reports), "Ctrl+P Ctrl+F");
    check(bench.part<ProductionPage>(), "F5 F8");
}

void KeysTest::preferencesListEveryCommandOfEveryPage()
{
    WindowBench bench;
    Preferences &dialog = open(bench.window());
    const auto *list = dialog.findChild<QTreeWidget *>(QStringLiteral("keyList"));
    QStringList listed;
    for (QTreeWidgetItemIterator it(const_cast<QTreeWidget *>(list)); *it; ++it)
        listed << (*it)->text(0);
    int rows = 0;
    for (const PageKeys *keys : bench.window().findChildren<PageKeys *>()) {
        for (const PageKeys::Row &row : keys->rows()) {
            QVERIFY2(listed.contains(row.does), qPrintable(row.does));
            ++rows;
        }
    }
    qInfo("%d commands", rows);
    QVERIFY(rows > 60);
    if (const QString folder = qEnvironmentVariable("MOTORBENCH_PICTURES"); !folder.isEmpty()) { // for looking at it
        dialog.findChild<QTabWidget *>()->setCurrentIndex(1);
        select(dialog, QStringLiteral("writes what is staged and runs"));
        dialog.grab().save(QDir(folder).filePath(QStringLiteral("preferences-keys.png")));
        QTest::keyClick(dialog.findChild<KeyField *>(), Qt::Key_F9);
        dialog.grab().save(QDir(folder).filePath(QStringLiteral("preferences-keys-taken.png")));
        dialog.findChild<QTabWidget *>()->setCurrentIndex(0);
        dialog.grab().save(QDir(folder).filePath(QStringLiteral("preferences-general.png")));
    }
    dialog.reject();
}

void KeysTest::aKeyIsChangedByPressingItAndHoldsAtOnce()
{
    WindowBench bench;
    MainWindow &window = bench.window();
    const auto *devices = window.findChild<QDockWidget *>(QStringLiteral("devicesDock"));
    Preferences &dialog = open(window);
    select(dialog, QStringLiteral("shows or hides the devices"));
    QTest::keyClick(dialog.findChild<KeyField *>(), Qt::Key_D, Qt::ControlModifier | Qt::AltModifier);
    accept(dialog, window);
    QVERIFY(devices->isVisible());
    QTest::keyClick(&window, Qt::Key_F9);
    QVERIFY2(devices->isVisible(), "the key it came with does nothing any more");
    QTest::keyClick(&window, Qt::Key_D, Qt::ControlModifier | Qt::AltModifier);
    QVERIFY(!devices->isVisible());
    QTest::keyClick(&window, Qt::Key_F1);
    auto *keys = window.findChild<QDialog *>(QStringLiteral("keys"));
    const auto labels = keys->findChildren<QLabel *>();
    QVERIFY(std::any_of(
        labels.begin(), labels.end(), [](const QLabel *l) { return l->text() == QLatin1String("Ctrl+Alt+D"); }));
    delete keys;
    QApplication::setActiveWindow(&window);
    QTest::keyClick(&window, Qt::Key_K, Qt::ControlModifier);
    auto *palette = window.findChild<CommandPalette *>();
    QVERIFY(
        palette->findChild<QListWidget *>()->findItems(QStringLiteral("Ctrl+Alt+D"), Qt::MatchContains).size() == 1);
    palette->close();
}

void KeysTest::aClashIsRefusedAndStopsStayStops()
{
    WindowBench bench;
    Preferences &dialog = open(bench.window());
    auto *field = dialog.findChild<KeyField *>();
    select(dialog, QStringLiteral("writes what is staged and runs"));
    QTest::keyClick(field, Qt::Key_F9);
    QVERIFY2(answer(dialog).contains(QStringLiteral("shows or hides the devices")), qPrintable(answer(dialog)));
    QTest::keyClick(field, Qt::Key_F12, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY2(answer(dialog).contains(QStringLiteral("arms")), qPrintable(answer(dialog)));
    QTest::keyClick(field, Qt::Key_Pause);
    QVERIFY2(answer(dialog).contains(QStringLiteral("stops every motor")), qPrintable(answer(dialog)));
    QVERIFY(dialog.keys().empty());
    select(dialog, QStringLiteral("stop every motor"));
    QVERIFY(!field->isEnabled());
    dialog.reject();
}

void KeysTest::noLabelNamesAKeyThatIsNoMore()
{
    WindowBench bench;
    QTRY_VERIFY_WITH_TIMEOUT(bench.isFound(), patience);
    bench.select(WindowBench::tuned);
    MainWindow &window = bench.window();
    KeyChoices choices;
    const std::pair<PageId, const char *> pages[]{{PageId::Parameters, "ParametersPage/Ctrl+Shift+W"},
        {PageId::Tune, "TunePage/F5"}, {PageId::Plots, "PlotsPage/L"}};
    for (const auto &[page, row] : pages) {
        (void)window.page(page);
        choices[QLatin1String(row)] = {QKeySequence(QStringLiteral("Alt+Shift+Q"))};
    }
    choices[QStringLiteral("ProductionPage/F8")] = {QKeySequence(QStringLiteral("Alt+Shift+Q"))};
    window.findChild<KeyDesk *>()->use(choices);
    bench.arming().arm(bench.device(WindowBench::tuned)->id);
    const auto says = [](const QWidget &place, const char *words) {
        const auto labels = place.findChildren<QLabel *>();
        return std::any_of(labels.begin(), labels.end(), [words](const QLabel *label) {
            return label->text().contains(QLatin1String(words)) || label->toolTip().contains(QLatin1String(words));
        });
    };
    window.showPage(PageId::Tune);
    QTRY_VERIFY_WITH_TIMEOUT(says(*window.page(PageId::Tune), "Run begins"), patience);
    QVERIFY(!says(*window.page(PageId::Tune), "F5"));
    QVERIFY(says(*window.page(PageId::Parameters), "Alt+Shift+Q write"));
    QVERIFY(says(*window.page(PageId::Plots), "Alt+Shift+Q cursors"));
    QVERIFY(says(bench.part<ProductionPage>(), "Alt+Shift+Q"));
    QVERIFY(!says(bench.part<ProductionPage>(), "F8"));
}

void KeysTest::chosenKeysComeBackWithTheProgram()
{
    for (const bool first : {true, false}) {
        Application application(*qApp, plain());
        application.start();
        MainWindow &window = application.window();
        const auto *devices = window.findChild<QDockWidget *>(QStringLiteral("devicesDock"));
        QApplication::setActiveWindow(&window);
        if (first) {
            Preferences &dialog = open(window);
            select(dialog, QStringLiteral("shows or hides the devices"));
            QTest::keyClick(dialog.findChild<KeyField *>(), Qt::Key_F4);
            accept(dialog, window);
        }
        const bool seen = devices->isVisible();
        QTest::keyClick(&window, Qt::Key_F9);
        QCOMPARE(devices->isVisible(), seen);
        QTest::keyClick(&window, Qt::Key_F4);
        QVERIFY(devices->isVisible() != seen);
        if (!first) {
            Preferences &dialog = open(window);
            select(dialog, QStringLiteral("shows or hides the devices"));
            for (QPushButton *button : dialog.findChildren<QPushButton *>()) {
                if (button->text() == QLatin1String("Default"))
                    button->click();
            }
            accept(dialog, window);
            QTest::keyClick(&window, Qt::Key_F9);
            QCOMPARE(devices->isVisible(), seen);
        }
    }
}

MB_WINDOW_TEST(KeysTest);
#include "tst_keys.moc"
