// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameterbench.h"
#include "support/windowtests.h"
#include "widgets/common/numberfield.h"
#include "widgets/parameters/stagededits.h"
#include "widgets/parameters/valuetext.h"

#include <QComboBox>
#include <QPlainTextEdit>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>

using namespace mb;

class NumberFieldTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void numbersAreTypedAndWordsAreNot_data();
    void numbersAreTypedAndWordsAreNot();
    void whatIsNoNumberYetCanStillBeEntered();
    void lettersAreTakenWhereWordsAre();
    void whatIsUnderstoodIsShownBeforeItIsWritten_data();
    void whatIsUnderstoodIsShownBeforeItIsWritten();
    void aTableFieldShowsWhatWillBeWritten();
};

void NumberFieldTest::numbersAreTypedAndWordsAreNot_data()
{
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("stays");
    const auto row = [](const char *name, const char *typed, const char *stays) {
        QTest::newRow(name) << QString::fromUtf8(typed) << QString::fromUtf8(stays);
    };
    row("a negative number", "-12.5", "-12.5");
    row("a comma", "0,25", "0,25");
    row("an exponent", "1e-5", "1e-5");
    row("a percentage", "55 %", "55 %");
    row("hexadecimal", "0x1F", "0x1F");
    row("words", "stop", "");
    row("a unit behind", "5 A", "5 ");
}

void NumberFieldTest::numbersAreTypedAndWordsAreNot()
{
    QFETCH(QString, typed);
    QFETCH(QString, stays);
    NumberField field;
    QTest::keyClicks(&field, typed);
    QCOMPARE(field.text(), stays);
}

void NumberFieldTest::whatIsNoNumberYetCanStillBeEntered()
{
    NumberField field;
    QSignalSpy entered(&field, &QLineEdit::returnPressed);
    for (const char *text : {"", "-", "1.2.3", "\u22123"}) {
        field.setText(QString::fromUtf8(text));
        QTest::keyClick(&field, Qt::Key_Return);
    }
    QCOMPARE(entered.count(), 4); // the fault is said beside the field
}

void NumberFieldTest::lettersAreTakenWhereWordsAre()
{
    NumberField number;
    QLineEdit text;
    QPlainTextEdit note;
    QSpinBox spin;
    QComboBox choice;
    QComboBox typed;
    typed.setEditable(true);
    QVERIFY(!acceptsLetters(&number));
    QVERIFY(!acceptsLetters(&spin));
    QVERIFY(!acceptsLetters(&choice));
    QVERIFY(!acceptsLetters(nullptr));
    QVERIFY(acceptsLetters(&text));
    QVERIFY(acceptsLetters(&note));
    QVERIFY(acceptsLetters(&typed));
    text.setReadOnly(true);
    note.setReadOnly(true);
    QVERIFY(!acceptsLetters(&text));
    QVERIFY(!acceptsLetters(&note));
}

void NumberFieldTest::whatIsUnderstoodIsShownBeforeItIsWritten_data()
{
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("note");
    QTest::addColumn<QString>("stays");
    const auto row = [](const char *typed, const char *note, const char *stays) {
        QTest::newRow(typed) << QString::fromUtf8(typed) << QString::fromUtf8(note) << QString::fromUtf8(stays);
    };
    row("1,5", "= 1.5", "1.5");
    row("1,500", "= 1.5", "1.500"); // never fifteen hundred
    row("1.500", "", "1.500");
    row("-0,25", "= -0.25", "-0.25");
    row("0x1F", "= 31", "0x1F");
    row("1e3", "= 1000", "1e3");
    row("5,5 %", "= 5.5 %", "5.5 %");
    row("1,2,3", "", "1,2,3");
    row("12", "", "12");
}

void NumberFieldTest::whatIsUnderstoodIsShownBeforeItIsWritten()
{
    QFETCH(QString, typed);
    QFETCH(QString, note);
    NumberField field;
    field.resize(240, 30);
    field.show();
    const auto *shown = field.findChild<UnderstoodNote *>();
    QTest::keyClicks(&field, typed);
    QCOMPARE(shown->text(), note);
    QCOMPARE(shown->isVisible(), !note.isEmpty());
    QCOMPARE(field.accessibleDescription(), note);
    QTest::keyClick(&field, Qt::Key_Return);
    QTEST(field.text(), "stays");
}

void NumberFieldTest::aTableFieldShowsWhatWillBeWritten()
{
    const Parameter &gain = test::dmc60c().parameters[test::named("slot0.p").value];
    QCOMPARE(understoodValue(gain, QStringLiteral("1,5")), QStringLiteral("= 1.500"));
    QCOMPARE(understoodValue(gain, QStringLiteral("1,500")), QStringLiteral("= 1.500"));
    QCOMPARE(understoodValue(gain, QStringLiteral("1.5")), QString());
    QVERIFY(understoodValue(gain, QStringLiteral("1.2345678")).startsWith(QStringLiteral("= 1.2345")));
    QCOMPARE(understoodValue(gain, QStringLiteral("-")), QString());
    StagedEdits edits(test::dmc60c());
    edits.type(test::named("slot0.p"), QStringLiteral("1,5"));
    edits.endTyping(true);
    QCOMPARE(edits.find(test::named("slot0.p"))->text, QStringLiteral("1.5"));
}

MB_WINDOW_TEST(NumberFieldTest);
#include "tst_numberfield.moc"
