// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/utf8.h"
#include "support/windowtests.h"
#include "widgets/common/clocktext.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/numberformat.h"

#include <QLocale>
#include <QTest>
#include <cmath>

using namespace mb;

namespace {

/// In the tables a plain blank stands for the thin space and for the no-break space.
QString withPlainBlanks(QString text)
{
    return text.replace(ThinSpace, QLatin1Char(' ')).replace(QChar(QChar::Nbsp), QLatin1Char(' '));
}

} // namespace

class NumberFormatTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void formatsNumbers_data();
    void formatsNumbers();
    void formatsTheRest();
    void parsesWhatUsersType_data();
    void parsesWhatUsersType();
    void refusesWhatIsAmbiguous_data();
    void refusesWhatIsAmbiguous();
    void understandsPercentOnlyWithAFullScale();
    void parsesIntegers();
    void editTextReadsBackEqual();
    void aLanguageWithACommaWritesAndUnderstandsIt();
    void everyLanguageUnderstandsWhatItWrites_data();
    void everyLanguageUnderstandsWhatItWrites();
    void theTimeOfDayHasTwentyFourHoursInEveryLanguage_data();
    void theTimeOfDayHasTwentyFourHoursInEveryLanguage();
};

void NumberFormatTest::formatsNumbers_data()
{
    QTest::addColumn<double>("value");
    QTest::addColumn<int>("decimals");
    QTest::addColumn<QString>("text");
    QTest::newRow("zero") << 0.0 << 0 << s("0");
    QTest::newRow("three digits stay together") << 999.0 << 0 << s("999");
    QTest::newRow("four digits are grouped") << 1500.0 << 0 << s("1 500");
    QTest::newRow("millions are grouped twice") << 1204331.0 << 0 << s("1 204 331");
    QTest::newRow("the minus is a minus") << -20480.0 << 0 << s("−20 480");
    QTest::newRow("a negative of three digits has no stray group") << -880.0 << 0 << s("−880");
    QTest::newRow("decimals are not grouped") << 12345.6789 << 4 << s("12 345.6789");
    QTest::newRow("minus zero is zero") << -0.004 << 2 << s("0.00");
    QTest::newRow("unknown is a dash, never zero") << std::nan("") << 2 << s("–");
    QTest::newRow("infinite is unknown") << HUGE_VAL << 0 << s("–");
}

void NumberFormatTest::formatsNumbers()
{
    QFETCH(double, value);
    QFETCH(int, decimals);
    QFETCH(QString, text);
    QCOMPARE(withPlainBlanks(formatNumber(value, decimals)), text);
}

void NumberFormatTest::formatsTheRest()
{
    QCOMPARE(withPlainBlanks(formatCount(-1402118)), s("−1 402 118"));
    QCOMPARE(withPlainBlanks(formatSignificant(0.003464, 4)), s("0.003464"));
    QCOMPARE(withPlainBlanks(formatSignificant(1499.6, 4)), s("1 500"));
    QCOMPARE(withPlainBlanks(formatSignificant(-2.5e-6, 2)), s("−2.5e−06"));
    QCOMPARE(withPlainBlanks(formatValue(12.434, 2, s("V"))), s("12.43 V"));
    QCOMPARE(withPlainBlanks(formatValue(std::nan(""), 2, s("V"))), s("–"));
    QCOMPARE(withPlainBlanks(formatDifference(55, 0)), s("+55"));
    QCOMPARE(withPlainBlanks(formatDifference(-18.2, 1)), s("−18.2"));
    QCOMPARE(withPlainBlanks(formatDifference(0.001, 1)), s("0.0"));
    QCOMPARE(withPlainBlanks(formatDuration(0.42)), s("420 ms"));
    QCOMPARE(withPlainBlanks(formatDuration(12.41)), s("12.4 s"));
    QCOMPARE(withPlainBlanks(formatDuration(272)), s("4:32"));
    QCOMPARE(withPlainBlanks(formatDuration(3723)), s("1:02:03"));
    QCOMPARE(withPlainBlanks(formatBytes(512)), s("512 B"));
    QCOMPARE(withPlainBlanks(formatBytes(38'000'000)), s("38 MB"));
    QCOMPARE(withPlainBlanks(formatBytes(1'240'000)), s("1.2 MB"));
}

void NumberFormatTest::parsesWhatUsersType_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<double>("value");
    QTest::newRow("whole") << s("40000") << 40000.0;
    QTest::newRow("dot") << s("1.1650") << 1.165;
    QTest::newRow("comma") << s("1,1650") << 1.165;
    QTest::newRow("blanks around") << s("  7 ") << 7.0;
    QTest::newRow("hyphen") << s("-18022") << -18022.0;
    QTest::newRow("true minus") << s("−18022") << -18022.0;
    QTest::newRow("plus") << s("+3") << 3.0;
    QTest::newRow("no leading zero") << s(".5") << 0.5;
    QTest::newRow("no trailing digit") << s("5,") << 5.0;
    QTest::newRow("exponent") << s("2.49e-3") << 2.49e-3;
}

void NumberFormatTest::parsesWhatUsersType()
{
    QFETCH(QString, text);
    QFETCH(double, value);
    const auto parsed = parseNumber(text);
    QVERIFY(parsed.has_value());
    QCOMPARE(*parsed, value);
}

void NumberFormatTest::refusesWhatIsAmbiguous_data()
{
    QTest::addColumn<QString>("text");
    for (const char *text :
        {"", "-", ".", "1,000.5", "1.000,5", "1 000", "1 000", "0x1A", "12a", "--1", "nan", "inf", "1e", "1e999", "%"})
        QTest::newRow(text) << s(text);
}

void NumberFormatTest::refusesWhatIsAmbiguous()
{
    QFETCH(QString, text);
    QVERIFY(!parseNumber(text, 1.0).has_value());
}

void NumberFormatTest::understandsPercentOnlyWithAFullScale()
{
    QVERIFY(!parseNumber(s("55 %")).has_value());
    QCOMPARE(parseNumber(s("55 %"), 32767.0).value_or(0), 0.55 * 32767);
    QCOMPARE(parseNumber(s("−5,5%"), 100.0).value_or(0), -5.5);
    QCOMPARE(parseNumber(s("55"), 32767.0).value_or(0), 55.0);
}

void NumberFormatTest::parsesIntegers()
{
    QCOMPARE(parseInteger(s("−42")).value_or(0), qint64(-42));
    QCOMPARE(parseInteger(s("0x1a")).value_or(0), qint64(26));
    for (const char *text : {"1.0", "1 000", "0x", "", "99999999999999999999"})
        QVERIFY2(!parseInteger(s(text)).has_value(), text);
}

void NumberFormatTest::editTextReadsBackEqual()
{
    for (const double value : {0.0, -18022.0, 0.003464, 1.0 / 3.0, 1204331.5, -2.49e-9}) {
        const QString text = editText(value);
        QVERIFY(!text.contains(ThinSpace) && !text.contains(MinusSign));
        QCOMPARE(parseNumber(text).value_or(std::nan("")), value);
    }
}

void NumberFormatTest::aLanguageWithACommaWritesAndUnderstandsIt()
{
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::German));
    const QStringList shown{formatNumber(-20480.25, 2), formatSignificant(0.003464, 4), formatSignificant(2.5e12, 3),
        formatValue(12.43, 2, QStringLiteral("V")), editText(0.25), editText(-1.5, 3), asWritten(QStringLiteral("1.5")),
        understoodText(QStringLiteral("1.5")), understoodText(QStringLiteral("1,5")),
        messageText(say("ended at %1", 0.5)), messageText(say("ended at %1", 0.5), QLatin1Char('.'))};
    const auto back = parseNumber(editText(0.125));
    QLocale::setDefault(before);
    QCOMPARE(shown,
        QStringList({QStringLiteral("−20\u202f480,25"), QStringLiteral("0,003464"), QStringLiteral("2,50e+12"),
            QStringLiteral("12,43\u00a0V"), QStringLiteral("0,25"), QStringLiteral("-1,500"), QStringLiteral("1,5"),
            QStringLiteral("= 1,5"), QString(), QStringLiteral("ended at 0,5"), QStringLiteral("ended at 0.5")}));
    QCOMPARE(back, std::optional(0.125));
}

void NumberFormatTest::everyLanguageUnderstandsWhatItWrites_data()
{
    QTest::addColumn<QLocale>("locale");
    for (const char *name : {"en_US", "de_DE", "fa_IR", "ar_EG", "ja_JP"})
        QTest::newRow(name) << QLocale(QString::fromLatin1(name));
}

void NumberFormatTest::everyLanguageUnderstandsWhatItWrites()
{
    QFETCH(QLocale, locale);
    const QLocale before;
    QLocale::setDefault(locale);
    const auto shown = parseNumber(editText(12.5));
    const auto typed = parseNumber(asWritten(QStringLiteral("0.7")));
    QLocale::setDefault(before);
    QCOMPARE(shown, std::optional(12.5));
    QCOMPARE(typed, std::optional(0.7));
}

void NumberFormatTest::theTimeOfDayHasTwentyFourHoursInEveryLanguage_data()
{
    QTest::addColumn<QLocale>("locale");
    QTest::newRow("hours to twelve") << QLocale(QLocale::English, QLocale::UnitedStates);
    QTest::newRow("hours to twenty-four") << QLocale(QLocale::German);
    QTest::newRow("twelve with words") << QLocale(QLocale::Chinese, QLocale::Taiwan);
}

void NumberFormatTest::theTimeOfDayHasTwentyFourHoursInEveryLanguage()
{
    QFETCH(QLocale, locale);
    const QDateTime evening(QDate(2026, 11, 26), QTime(18, 5, 7, 89));
    const QLocale before;
    QLocale::setDefault(locale);
    const QString both = dateAndClockText(evening);
    const QString day = QLocale().toString(evening.date(), QLocale::ShortFormat);
    QLocale::setDefault(before);
    QCOMPARE(both, day + QStringLiteral(" 18:05"));
    QCOMPARE(clockText(evening), QStringLiteral("18:05:07"));
    QCOMPARE(clockText(evening, ClockPart::Milliseconds), QStringLiteral("18:05:07.089"));
    QCOMPARE(clockText(momentOf(static_cast<double>(evening.toMSecsSinceEpoch()) * 1e-3)), QStringLiteral("18:05:07"));
}

MB_WINDOW_TEST(NumberFormatTest);
#include "tst_numberformat.moc"
