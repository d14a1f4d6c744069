// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/windowtests.h"
#include "widgets/common/numberfield.h"

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

MB_WINDOW_TEST(NumberFieldTest);
#include "tst_numberfield.moc"
