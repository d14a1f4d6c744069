// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/windowtests.h"
#include "widgets/common/applytheme.h"
#include "widgets/common/commandpalette.h"
#include "widgets/common/holdbutton.h"
#include "widgets/common/pagekeys.h"

#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QTest>

using namespace mb;

class CommandPaletteTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void everyWordMustBeginAWordOfTheNameOrItsPlace();
    void aNameThatBeginsWithTheTextComesFirst();
    void enterRunsWhatIsChosenAndTheArrowsChoose();
    void nothingRunsWhereNothingMatches();
    void aPagesKeysAreCommandsAndWhatIsOnlySaidIsNot();
    void buttonsThatCannotBePressedAreLeftOut();
    void noRowIsCut();
};

void CommandPaletteTest::noRowIsCut()
{
    applyTheme(*qApp, darkTheme());
    QWidget parent;
    parent.resize(1280, 800);
    std::vector<Command> commands;
    for (int i = 0; i < 40; ++i)
        commands.push_back({QStringLiteral("Command %1").arg(i), QStringLiteral("Page"), {}, [] {}});
    auto *palette = new CommandPalette(std::move(commands), &parent);
    palette->open();
    QCoreApplication::processEvents();
    const auto *list = palette->findChild<QListWidget *>();
    QVERIFY2(list->viewport()->height() % list->sizeHintForRow(0) == 0,
        qPrintable(QStringLiteral("%1 of %2").arg(list->viewport()->height()).arg(list->sizeHintForRow(0))));
}

void CommandPaletteTest::everyWordMustBeginAWordOfTheNameOrItsPlace()
{
    const Command command{QStringLiteral("Read all values"), QStringLiteral("Parameters"), {}, {}};
    QVERIFY(matchOf(command, QStringLiteral("read")) > matchOf(command, QStringLiteral("val")));
    QVERIFY(matchOf(command, QStringLiteral("VAL")) > 0);
    QVERIFY(matchOf(command, QStringLiteral("param read")) > 0);
    QVERIFY(matchOf(command, {}) > 0);
    QCOMPARE(matchOf(command, QStringLiteral("ead")), 0);
    QCOMPARE(matchOf(command, QStringLiteral("read nothing")), 0);
}

void CommandPaletteTest::aNameThatBeginsWithTheTextComesFirst()
{
    QWidget parent;
    auto *palette = new CommandPalette({{QStringLiteral("Stop recording"), QStringLiteral("Plots"), {}, [] {}},
                                           {QStringLiteral("Recordings"), QStringLiteral("Menu"), {}, [] {}}},
        &parent);
    palette->findChild<QLineEdit *>()->setText(QStringLiteral("rec"));
    const auto *list = palette->findChild<QListWidget *>();
    QCOMPARE(list->count(), 2);
    QCOMPARE(list->item(0)->text(), QStringLiteral("Menu: Recordings"));
}

void CommandPaletteTest::enterRunsWhatIsChosenAndTheArrowsChoose()
{
    QWidget parent;
    QStringList run;
    const auto command = [&run](const QString &name) {
        return Command{name, QStringLiteral("Page"), {}, [&run, name] { run << name; }};
    };
    auto *palette = new CommandPalette({command(QStringLiteral("One")), command(QStringLiteral("Two"))}, &parent);
    palette->open();
    auto *text = palette->findChild<QLineEdit *>();
    QTest::keyClick(text, Qt::Key_Down);
    QTest::keyClick(text, Qt::Key_Down); // the end of the list
    QTest::keyClick(text, Qt::Key_Return);
    QVERIFY(run.isEmpty()); // once the dialog has gone
    QTRY_COMPARE(run, QStringList{QStringLiteral("Two")});
}

void CommandPaletteTest::nothingRunsWhereNothingMatches()
{
    QWidget parent;
    int runs = 0;
    auto *palette
        = new CommandPalette({{QStringLiteral("One"), QStringLiteral("Page"), {}, [&runs] { ++runs; }}}, &parent);
    palette->open();
    auto *text = palette->findChild<QLineEdit *>();
    text->setText(QStringLiteral("zzz"));
    const auto *list = palette->findChild<QListWidget *>();
    QCOMPARE(list->count(), 1); // it says so
    QCOMPARE(list->item(0)->text(), QStringLiteral("No command begins so"));
    QVERIFY(!(list->item(0)->flags() & Qt::ItemIsSelectable));
    QTest::keyClick(text, Qt::Key_Return);
    QCoreApplication::processEvents();
    QCOMPARE(runs, 0);
    QVERIFY(palette->isVisible());
}

void CommandPaletteTest::aPagesKeysAreCommandsAndWhatIsOnlySaidIsNot()
{
    QWidget page;
    QStringList order;
    PageKeys keys(page);
    keys.note({Qt::Key_Escape}, QStringLiteral("stop every motor"));
    keys.add({Qt::Key_F5}, QStringLiteral("reads all"), [&order] { order << QStringLiteral("read"); });
    std::vector<Command> commands;
    addCommands(commands, QStringLiteral("Parameters"), keys, [&order] { order << QStringLiteral("page"); });
    QCOMPARE(commands.size(), std::size_t{1});
    QCOMPARE(commands[0].name, QStringLiteral("Reads all"));
    QCOMPARE(commands[0].key, QStringLiteral("F5"));
    commands[0].run();
    QCOMPARE(order, (QStringList{QStringLiteral("page"), QStringLiteral("read")}));
}

void CommandPaletteTest::buttonsThatCannotBePressedAreLeftOut()
{
    QWidget page;
    QMenu menu(&page);
    menu.addAction(QStringLiteral("&Open…"));
    menu.addAction(QStringLiteral("Off"))->setEnabled(false);
    QPushButton good(QStringLiteral("Save"), &page);
    QPushButton off(QStringLiteral("Never"), &page);
    off.setEnabled(false);
    QPushButton held(QStringLiteral("Arm"), &page);
    const ThemeSource theme(darkTheme());
    HoldButton sends(theme, Symbol::Add, QStringLiteral("Hold to send"), &page);
    sends.setHoldNeeded(true);
    held.setFocusPolicy(Qt::NoFocus);
    page.show();
    std::vector<Command> commands;
    addButtons(commands, QStringLiteral("Page"), page);
    addCommands(commands, QStringLiteral("Menu"), menu);
    QCOMPARE(commands.size(), std::size_t{2});
    QCOMPARE(commands[0].name, QStringLiteral("Save"));
    QCOMPARE(commands[1].name, QStringLiteral("Open"));
}

MB_WINDOW_TEST(CommandPaletteTest);
#include "tst_commandpalette.moc"
