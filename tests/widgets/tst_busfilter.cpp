// SPDX-License-Identifier: GPL-3.0-or-later
// The language of the filter and what it says about mistakes.
#include "busbench.h"
#include "support/windowtests.h"
#include "widgets/monitor/framebits.h"
#include "widgets/monitor/frametext.h"

using namespace mb;
using namespace mb::test;

class BusFilterTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void wildcardsMatchWholeWords();
    void termsDecideByTheFrame_data();
    void termsDecideByTheFrame();
    void mistakesAreNamedWithTheirRemedy_data();
    void mistakesAreNamedWithTheirRemedy();
    void aFilterWithAMistakePassesEverything();
    void bothJoinsTwoFilters();
    void helpNamesEveryKey();
    void fieldsKnowTheirBits();
    void valuesAreForPeople();
    void aFilterOfThousandsOfBracketsIsRefused();
};

namespace {

TrafficRecord record(const char *text, Direction direction = Direction::Received)
{
    return {1, direction, canFrameFromText(text).value()};
}

bool passes(const QString &filter, const TrafficRecord &record)
{
    const FrameDecoder decoder(families());
    const FrameFilter read(filter);
    if (!read.problem().isEmpty())
        qWarning() << read.problem();
    return read.problem().isEmpty() && read.passes({record, decoder});
}

} // namespace

void BusFilterTest::wildcardsMatchWholeWords()
{
    QVERIFY(wildcardMatches("sts*", "STSGENERAL"));
    QVERIFY(wildcardMatches("*gen*", "STSGENERAL"));
    QVERIFY(wildcardMatches("s?sgeneral", "STSGENERAL"));
    QVERIFY(wildcardMatches("*a*b*", "xxayyb"));
    QVERIFY(wildcardMatches("*", ""));
    QVERIFY(!wildcardMatches("sts", "STSGENERAL"));
    QVERIFY(!wildcardMatches("?", ""));
    QVERIFY(!wildcardMatches("*a*b", "xxayybz"));
    QVERIFY(!wildcardMatches("", "x"));
}

static void filterRow(const char *filter, const char *frame, bool passes)
{
    QTest::newRow(qPrintable(QStringLiteral("%1 | %2").arg(QLatin1String(filter), QLatin1String(frame))))
        << QString::fromLatin1(filter) << QString::fromLatin1(frame) << passes;
}

static void combinedRows()
{
    filterRow("message:STS* device:5", generalOf7, false);
    filterRow("message:STS* and device:7", generalOf7, true);
    filterRow("device:5 or device:7", generalOf7, true);
    filterRow("not device:5", generalOf7, true);
    filterRow("-device:5", generalOf5, false);
    filterRow("!message:STS*", controlOf5, true);
    filterRow("not (device:5 or device:7)", unknown, true);
    filterRow("message:STS* (device:5 or device:7) not field.dtcApplied<25%", generalOf5, true);
    filterRow("message:STS* (device:5 or device:7) not field.dtcApplied<25%", generalOf7, false);
    filterRow("device:5 or device:7 message:ENUM*", generalOf5, true); // 'and' binds closer than 'or'
}

void BusFilterTest::termsDecideByTheFrame_data()
{
    QTest::addColumn<QString>("filter");
    QTest::addColumn<QString>("frame");
    QTest::addColumn<bool>("passes");
    filterRow("", unknown, true);
    filterRow("id:02061405", generalOf5, true);
    filterRow("id:0x2061405", generalOf5, true);
    filterRow("id:2061405", generalOf7, false);
    filterRow("id:0x2061*", generalOf5, true);
    filterRow("id:0x2041*", generalOf5, false);
    filterRow("id:020614?5", generalOf5, true);
    filterRow("id:020614?5", generalOf7, false);
    filterRow("id:02061400..0206143F", generalOf7, true);
    filterRow("id:100..1FF", "123#00", true);
    filterRow("id:100..1FF", "200#00", false);
    filterRow("id:123,200", "200#00", true);
    filterRow("family:dmc60c", generalOf5, true);
    filterRow("fam:DMC*", generalOf5, true);
    filterRow("family:dmc60c", unknown, false);
    filterRow("message:STS*", generalOf5, true);
    filterRow("message:sts*,canctrl0", controlOf5, true);
    filterRow("msg:STS*", controlOf5, false);
    filterRow("device:5", generalOf5, true);
    filterRow("dev:6..9", generalOf5, false);
    filterRow("dev:1,6..9", generalOf7, true);
    filterRow("data:A125*", generalOf5, true);
    filterRow("data:A1", generalOf5, false);
    filterRow("data:??25*", generalOf5, true);
    filterRow("is:extended", generalOf5, true);
    filterRow("is:standard", generalOf5, false);
    filterRow("is:remote", "123#R", true);
    filterRow("is:unknown", unknown, true);
    filterRow("is:unknown", generalOf5, false);
    filterRow("is:known", generalOf5, true);
    filterRow("is:control", controlOf5, true);
    filterRow("is:control", generalOf5, false);
    filterRow("field.trgt", controlOf5, true);
    filterRow("field.trgt=10240", controlOf5, true);
    filterRow("field.trgt > 10240", controlOf5, false);
    filterRow("field.trgt>=0x2800", controlOf5, true);
    filterRow("field.trgt<10240.5", controlOf5, true);
    filterRow("field.trgt != 10240", controlOf5, false);
    filterRow("field.dtcApplied>25%", generalOf5, true);
    filterRow("field.dtcApplied>25%", generalOf7, false);
    filterRow("field.trgt>25%", controlOf5, false); // no fraction: % says nothing
    filterRow("field.dtc*=9633", generalOf5, true);
    filterRow("field.nothing", generalOf5, false);
    filterRow("general", generalOf5, true);
    filterRow("06140", generalOf5, true);
    filterRow("dmc", unknown, false);
    combinedRows();
}

void BusFilterTest::termsDecideByTheFrame()
{
    QFETCH(QString, filter);
    QFETCH(QString, frame);
    QFETCH(bool, passes);
    QCOMPARE(::passes(filter, record(qPrintable(frame))), passes);
}

void BusFilterTest::mistakesAreNamedWithTheirRemedy_data()
{
    QTest::addColumn<QString>("filter");
    QTest::addColumn<QString>("says");
    const auto filterRow = [](const char *filter, const char *says) {
        QTest::newRow(filter) << QString::fromLatin1(filter) << QString::fromLatin1(says);
    };
    filterRow("mesage:STS*", "'mesage:' is not known; 'message:' is");
    filterRow("colour:red", "id, family, message, device, dir, data, is and field. are");
    filterRow("id:xyz", "'xyz' is no identifier");
    filterRow("id:100..", "'100..' is no identifier");
    filterRow("id:", "nothing after the colon");
    filterRow("device:five", "'five' is no device number");
    filterRow("data:A 1", "");
    filterRow("data:GG", "'GG' are no bytes");
    filterRow("family:dmc61c", "no family is called 'dmc61c'; there is");
    filterRow("dir:up", "dir:rx and dir:tx are");
    filterRow("is:odd", "control are");
    filterRow("field.", "needs the name of a field");
    filterRow("field.trgt>", "'field.trgt>' needs a number behind it");
    filterRow("field.trgt>fast", "'fast' is no number");
    filterRow("trgt>5", "a comparison begins with field., such as field.trgt>5");
    filterRow("(device:5", "a ')' is missing");
    filterRow("device:5)", "')' has no '(' before it");
    filterRow("device:5 or", "a term is missing after 'or'");
    filterRow("or device:5", "'or' needs a term before it");
    filterRow("not", "a term is missing after 'not'");
    filterRow("()", "a term is missing after '('");
}

void BusFilterTest::mistakesAreNamedWithTheirRemedy()
{
    QFETCH(QString, filter);
    QFETCH(QString, says);
    const QString problem = FrameFilter(filter).problem();
    QVERIFY2(problem.contains(says), qPrintable(problem));
    QCOMPARE(problem.isEmpty(), says.isEmpty());
}

void BusFilterTest::aFilterWithAMistakePassesEverything()
{
    const FrameDecoder decoder;
    const FrameFilter filter(QStringLiteral("device:5 colour:red"));
    QVERIFY(filter.isEmpty());
    QVERIFY(filter.passes({record(unknown), decoder}));
}

void BusFilterTest::bothJoinsTwoFilters()
{
    const FrameDecoder decoder(families());
    const FrameFilter filter = FrameFilter::both(
        FrameFilter(QStringLiteral("device:5 or device:7")), FrameFilter(QStringLiteral("is:tx or is:control")));
    QVERIFY(!filter.passes({record(generalOf5), decoder}));
    QVERIFY(filter.passes({record(generalOf5, Direction::Sent), decoder}));
    QVERIFY(filter.passes({record(controlOf5), decoder}));
    QVERIFY(!filter.passes({record(unknown, Direction::Sent), decoder}));
    QVERIFY(FrameFilter::both({}, {}).isEmpty());
}

void BusFilterTest::helpNamesEveryKey()
{
    for (const char *key : {"id:", "family:", "message:", "device:", "data:", "dir:", "is:", "field.", "not", "or"})
        QVERIFY2(FrameFilter::help().contains(QLatin1String(key)), key);
}

void BusFilterTest::fieldsKnowTheirBits()
{
    const FrameDecoder decoder(families());
    const CanFrame frame = canFrameFromText(generalOf5).value();
    const auto meaning = decoder.decode(frame);
    const auto bits = fieldBits(frame, decoder);
    QCOMPARE(bits.size(), meaning->frame.fields.size());
    std::map<QString, QString> found;
    for (std::size_t i = 0; i < bits.size(); ++i)
        found[QString::fromUtf8(
            meaning->frame.fields[i].name.data(), static_cast<int>(meaning->frame.fields[i].name.size()))]
            = bitsText(bits[i]);
    // dmc60c/README.md#status-general
    QCOMPARE(found[QStringLiteral("dtcApplied")], QStringLiteral("0–1"));
    QCOMPARE(found[QStringLiteral("fFwdLimitHit")], QStringLiteral("2.1"));
    QCOMPARE(found[QStringLiteral("modeSelect")], QStringLiteral("4.3–6"));
    QCOMPARE(found[QStringLiteral("fDivErrBy256")], QStringLiteral("4.7"));
    QCOMPARE(found[QStringLiteral("errCLoop")], QStringLiteral("5–7"));
    QVERIFY(fieldBits(canFrameFromText(unknown).value(), decoder).empty());
    QCOMPARE(bitsText(0), QString());
    QCOMPARE(bitsText(0xFF00), QStringLiteral("1"));
    QCOMPARE(bitsText(0x0180), QStringLiteral("0.7–1.0"));
}

void BusFilterTest::valuesAreForPeople()
{
    QCOMPARE(fieldValue({"dtcApplied", 9633, "1/32767"}), QString::fromUtf8("29.4\u00A0%"));
    QCOMPARE(fieldValue({"velcnt", -10236, "counts/100 ms"}), QString::fromUtf8("−10\u202F236\u00A0counts/100 ms"));
    QCOMPARE(fieldValue({"vltgVbus", 12.4140625, "V"}), QString::fromUtf8("12.414\u00A0V"));
    QCOMPARE(fieldValue({"perc", 0, {}}), QStringLiteral("0"));
    QCOMPARE(fullScale("1/32767 per 0.5 ms").value_or(0.0), 32767.0);
    QCOMPARE(fieldValue({"vltgRampSet", 3276.7, "1/32767 per 0.5 ms"}), QString::fromUtf8("10.0\u00A0% per 0.5 ms"));
    QCOMPARE(hexId(canFrameFromText("123#").value()), QStringLiteral("123"));
    CanFrame error;
    error.error = true;
    error.id = 0x24;
    error.data[1] = 0x20;
    QCOMPARE(errorFrameText(error), QStringLiteral("nobody acknowledged, error-passive"));
}

void BusFilterTest::aFilterOfThousandsOfBracketsIsRefused()
{
    QVERIFY(!FrameFilter(QStringLiteral("(").repeated(30000)).problem().isEmpty());
    QVERIFY(!FrameFilter(QStringLiteral("not ").repeated(8000) + QStringLiteral("is:tx")).problem().isEmpty());
    QVERIFY(FrameFilter(QStringLiteral("(").repeated(20) + QStringLiteral("is:tx") + QStringLiteral(")").repeated(20))
                .problem()
                .isEmpty());
}

MB_WINDOW_TEST(BusFilterTest);
#include "tst_busfilter.moc"
