// SPDX-License-Identifier: GPL-3.0-or-later
// Keys that people change: one table makes them, lists them and refuses what would take a stop key away.
#include "support/windowtests.h"
#include "widgets/common/commandpalette.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/keybook.h"
#include "widgets/common/keystrip.h"

#include <QAction>
#include <QDialog>
#include <QLabel>
#include <QShortcut>
#include <QTest>
#include <QTranslator>

using namespace mb;

namespace {

QKeySequence key(const char *text)
{
    return QKeySequence(QLatin1String(text), QKeySequence::PortableText);
}

/// A window with the keys that stop and arm, and two pages in it.
struct KeyBench {
    QWidget window;
    QWidget tune{&window};
    QWidget plots{&window};
    QAction palette{QStringLiteral("Commands"), &window};
    PageKeys everywhere{window};
    PageKeys ofTune{tune};
    PageKeys ofPlots{plots};
    QStringList done;

    KeyBench()
    {
        palette.setShortcut(key("Ctrl+K"));
        everywhere.note({Qt::Key_Escape, Qt::Key_Pause}, QStringLiteral("stop every motor"));
        everywhere.note({Qt::Key_Space}, QStringLiteral("stops unless words can be typed"));
        everywhere.note({key("Ctrl+Shift+F12")}, QStringLiteral("arms"));
        everywhere.add(
            {Qt::Key_F9}, QStringLiteral("shows the devices"), [this] { done << QStringLiteral("devices"); });
        everywhere.add(palette, QStringLiteral("lists everything"));
        ofTune.add({Qt::Key_F5}, QStringLiteral("runs"), [this] { done << QStringLiteral("run"); });
        ofTune.add({key("Ctrl+Y"), key("Ctrl+Shift+Z")}, QStringLiteral("does it again"), [] {});
        ofPlots.add({Qt::Key_P}, QStringLiteral("pauses"), [] {});
    }
    [[nodiscard]] KeyBook book() const
    {
        KeyBook book;
        book.add(QStringLiteral("Everywhere"), true, everywhere);
        book.add(QStringLiteral("Tune"), false, ofTune);
        book.add(QStringLiteral("Plots"), false, ofPlots);
        return book;
    }
};

std::size_t rowThat(const KeyBook &book, const char *does)
{
    std::size_t at = 0;
    while (book.rows()[at].does != QLatin1String(does))
        ++at;
    return at;
}

} // namespace

class KeyBookTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void everyCommandIsListedOnceWithItsKey();
    void aKeyThatAnotherHasIsRefusedWithItsName();
    void theSameKeyMayServeTwoPages();
    void stopAndArmKeepTheirKeys_data();
    void stopAndArmKeepTheirKeys();
    void aChosenKeyHoldsAtOnceEverywhere();
    void aKeyThatWasTakenAwayIsNamedNowhere();
    void aKeyOnAButtonIsInTheWordsOfTheLanguage();
    void aKeyThatIsHeldIsOneWish_data();
    void aKeyThatIsHeldIsOneWish();
    void theKeyItCameWithComesBackUnlessItIsTaken();
    void twoCommandsMayExchangeTheirKeys();
    void whatWasWrittenByHandTakesNoStopKeyAway();
};

void KeyBookTest::everyCommandIsListedOnceWithItsKey()
{
    const KeyBench bench;
    const KeyBook book = bench.book();
    QCOMPARE(book.rows().size(), std::size_t(8));
    const KeyBook::Row &palette = book.rows()[rowThat(book, "lists everything")];
    QVERIFY(palette.changeable && palette.everywhere);
    QCOMPARE(palette.keys, std::vector<QKeySequence>{key("Ctrl+K")});
    QVERIFY(!book.rows()[rowThat(book, "arms")].changeable);
    QVERIFY(book.choices().empty());
}

void KeyBookTest::aKeyThatAnotherHasIsRefusedWithItsName()
{
    const KeyBench bench;
    KeyBook book = bench.book();
    const std::size_t run = rowThat(book, "runs");
    QVERIFY(book.refusal(run, key("F9")).contains(QStringLiteral("shows the devices")));
    QVERIFY(book.refusal(run, key("Ctrl+K")).contains(QStringLiteral("lists everything")));
    QVERIFY(book.refusal(run, key("Ctrl+Shift+Z")).contains(QStringLiteral("does it again")));
    QVERIFY(!book.choose(run, key("F9")));
    QCOMPARE(book.rows()[run].keys, std::vector<QKeySequence>{key("F5")});
    QVERIFY(book.refusal(rowThat(book, "shows the devices"), key("P")).contains(QStringLiteral("Plots")));
}

void KeyBookTest::theSameKeyMayServeTwoPages()
{
    const KeyBench bench;
    KeyBook book = bench.book();
    QVERIFY(book.choose(rowThat(book, "pauses"), key("F5")));
    QCOMPARE(book.choices().size(), std::size_t(1));
}

void KeyBookTest::stopAndArmKeepTheirKeys_data()
{
    QTest::addColumn<QString>("wish");
    for (const char *wish :
        {"Esc", "Shift+Esc", "Ctrl+Esc", "Pause", "Ctrl+Pause", "Space", "Shift+Space", "Ctrl+Space", "Alt+Space",
            "Meta+Space", "Ctrl+Shift+F12", "Tab", "Return", "Enter", "Left", "Shift+Tab", "Backspace", "Home"})
        QTest::newRow(wish) << QString::fromLatin1(wish);
}

void KeyBookTest::stopAndArmKeepTheirKeys()
{
    QFETCH(QString, wish);
    const KeyBench bench;
    KeyBook book = bench.book();
    const KeyBook before = book;
    for (std::size_t row = 0; row < book.rows().size(); ++row) {
        QVERIFY2(!book.refusal(row, QKeySequence(wish, QKeySequence::PortableText)).isEmpty(), qPrintable(wish));
        QVERIFY(!book.choose(row, QKeySequence(wish, QKeySequence::PortableText)));
        QCOMPARE(book.rows()[row].keys, before.rows()[row].keys);
    }
    QVERIFY2(!book.choose(rowThat(book, "stop every motor"), key("F2")), "keys that stop cannot be remapped");
    QVERIFY(!book.choose(rowThat(book, "arms"), {}));
}

void KeyBookTest::aChosenKeyHoldsAtOnceEverywhere()
{
    KeyBench bench;
    const ThemeSource theme(darkTheme());
    auto *button = new CommandButton(theme, QStringLiteral("Run"), &bench.tune);
    button->setKeyHint(QStringLiteral("F5"));
    auto *icon = new IconButton(theme, Symbol::Fit, QStringLiteral("Run"), &bench.tune);
    icon->setKeyHint(QStringLiteral("F5"));
    bench.window.show();
    QApplication::setActiveWindow(&bench.window);
    KeyBook book = bench.book();
    QVERIFY(book.choose(rowThat(book, "runs"), key("Ctrl+R")));
    QVERIFY(book.choose(rowThat(book, "lists everything"), key("Ctrl+J")));
    for (PageKeys *table : {&bench.everywhere, &bench.ofTune, &bench.ofPlots})
        table->use(book.choices());
    QTest::keyClick(&bench.window, Qt::Key_F5);
    QVERIFY(bench.done.isEmpty());
    QTest::keyClick(&bench.window, Qt::Key_R, Qt::ControlModifier);
    QCOMPARE(bench.done, QStringList{QStringLiteral("run")});
    QCOMPARE(bench.palette.shortcut(), key("Ctrl+J"));
    QCOMPARE(PageKeys::textOf(bench.ofTune.rows()[0]), QStringLiteral("Ctrl+R")); // what F1 lists
    std::vector<Command> commands;
    addCommands(commands, QStringLiteral("Tune"), bench.ofTune, [] {});
    QCOMPARE(commands[0].key, QStringLiteral("Ctrl+R"));
    QCOMPARE(keyShown(*button, QStringLiteral("F5")), QStringLiteral("Ctrl+R"));
    QCOMPARE(icon->toolTip(), QStringLiteral("Run  Ctrl+R"));
    QCOMPARE(keyShown(bench.plots, QStringLiteral("F9")), QStringLiteral("F9"));
    bench.ofTune.use({});
    QCOMPARE(icon->toolTip(), QStringLiteral("Run  F5"));
    QTest::keyClick(&bench.window, Qt::Key_F5);
    QCOMPARE(bench.done.size(), 2);
}

void KeyBookTest::aKeyThatWasTakenAwayIsNamedNowhere()
{
    KeyBench bench;
    const ThemeSource theme(darkTheme());
    QLabel hint(&bench.tune);
    nameKeys(hint, QStringLiteral("%1 runs · Enter goes on · %2 turns"), {QStringLiteral("F5"), QStringLiteral("F9")});
    KeyStrip strip(theme,
        {{QStringLiteral("F5"), QStringLiteral("run")}, {QStringLiteral("Esc"), QStringLiteral("stop")}}, &bench.tune);
    const auto said = [&strip] {
        QStringList words;
        for (const QLabel *label : strip.findChildren<QLabel *>())
            words << (label->isVisibleTo(&strip) ? label->text() : QString());
        words.removeAll({});
        return words.join(QLatin1Char(' '));
    };
    KeyBook book = bench.book();
    QVERIFY(book.choose(rowThat(book, "runs"), {}));
    bench.ofTune.use(book.choices());
    QCOMPARE(hint.text(), QStringLiteral("Enter goes on · F9 turns"));
    QCOMPARE(said(), QStringLiteral("Esc stop"));
    showKeys(bench.window, QStringLiteral("Tune"), {&bench.ofTune});
    for (const QLabel *label : bench.window.findChild<QDialog *>(QStringLiteral("keys"))->findChildren<QLabel *>())
        QVERIFY(!label->text().isEmpty());
    bench.ofTune.use({});
    QCOMPARE(hint.text(), QStringLiteral("F5 runs · Enter goes on · F9 turns"));
    QCOMPARE(said(), QStringLiteral("F5 run Esc stop"));
}

void KeyBookTest::aKeyOnAButtonIsInTheWordsOfTheLanguage()
{
    class German final : public QTranslator {
    public:
        [[nodiscard]] QString translate(const char *, const char *text, const char *, int) const override
        {
            return qstrcmp(text, "Ctrl") == 0 ? QStringLiteral("Strg") : QString();
        }
        [[nodiscard]] bool isEmpty() const override { return false; }
    } german;
    const KeyBench bench;
    QVERIFY(QCoreApplication::installTranslator(&german));
    const QStringList shown{keyShown(bench.tune, QStringLiteral("Ctrl+F")), keyShown(bench.tune, QStringLiteral("F5")),
        keyShown(bench.tune, QStringLiteral("· it is busy"))};
    QCoreApplication::removeTranslator(&german);
    QCOMPARE(shown, (QStringList{QStringLiteral("Strg+F"), QStringLiteral("F5"), QStringLiteral("· it is busy")}));
}

void KeyBookTest::aKeyThatIsHeldIsOneWish_data()
{
    QTest::addColumn<bool>("chosen");
    QTest::newRow("as it came") << false;
    QTest::newRow("after somebody chose keys") << true;
}

void KeyBookTest::aKeyThatIsHeldIsOneWish()
{
    KeyBench bench;
    int undone = 0;
    bench.ofTune.add({key("Ctrl+Z")}, QStringLiteral("undoes"), [&undone] { ++undone; });
    bench.window.show();
    QApplication::setActiveWindow(&bench.window);
    QFETCH(const bool, chosen);
    if (chosen)
        bench.ofTune.use({});
    const auto press = [&bench](bool again) {
        QTest::simulateEvent(&bench.window, true, Qt::Key_Z, Qt::ControlModifier, QString(), again);
    };
    press(false);
    for (int i = 0; i < 5; ++i)
        press(true);
    QCOMPARE(undone, 1); // what goes to a unit is ordered each time
    press(false);
    QCOMPARE(undone, 2);
}

void KeyBookTest::theKeyItCameWithComesBackUnlessItIsTaken()
{
    const KeyBench bench;
    KeyBook book = bench.book();
    const std::size_t run = rowThat(book, "runs");
    const std::size_t again = rowThat(book, "does it again");
    QVERIFY(book.choose(run, key("F2")));
    QVERIFY(book.choose(again, key("F5")));
    QVERIFY(book.reset(run).contains(QStringLiteral("does it again")));
    QCOMPARE(book.rows()[run].keys, std::vector<QKeySequence>{key("F2")});
    QVERIFY(book.reset(again).isEmpty());
    QCOMPARE(book.rows()[again].keys.size(), std::size_t(2));
    QVERIFY(book.reset(run).isEmpty());
    QVERIFY(book.choices().empty());
    QVERIFY(book.choose(run, {}));
    QCOMPARE(book.choices().size(), std::size_t(1));
    book.resetAll();
    QVERIFY(book.choices().empty());
}

void KeyBookTest::twoCommandsMayExchangeTheirKeys()
{
    const KeyBench bench;
    KeyBook book = bench.book();
    const std::size_t run = rowThat(book, "runs");
    const std::size_t again = rowThat(book, "does it again");
    QVERIFY(book.choose(run, {}));
    QVERIFY(book.choose(again, key("F5")));
    QVERIFY(book.choose(run, key("Ctrl+Y")));
    KeyBook another = bench.book();
    another.take(book.choices()); // at the next start
    QCOMPARE(another.rows()[run].keys, std::vector<QKeySequence>{key("Ctrl+Y")});
    QCOMPARE(another.rows()[again].keys, std::vector<QKeySequence>{key("F5")});
}

void KeyBookTest::whatWasWrittenByHandTakesNoStopKeyAway()
{
    const KeyBench bench;
    KeyBook book = bench.book();
    const QString run = book.rows()[rowThat(book, "runs")].id;
    const QString stop = book.rows()[rowThat(book, "stop every motor")].id;
    book.take({{run, {Qt::Key_Escape}}, {stop, {}}, {QStringLiteral("Nothing/F1"), {Qt::Key_F7}}});
    QVERIFY(book.choices().empty());
    QCOMPARE(book.rows()[rowThat(book, "runs")].keys, std::vector<QKeySequence>{key("F5")});
}

MB_WINDOW_TEST(KeyBookTest);
#include "tst_keybook.moc"
