// SPDX-License-Identifier: GPL-3.0-or-later
// Values as text, staged edits, order of writing.
#include "parameterbench.h"

#include "support/windowtests.h"
#include "widgets/parameters/valuetext.h"

#include <QLocale>
#include <QTest>

#include <array>

using namespace mb;
using namespace mb::test;

namespace {

const Parameter &row(const char *key)
{
    return dmc60c().parameters[named(key).value];
}

/// With plain spaces, so that it can be compared.
ParsedValue parsed(const char *key, const char *text)
{
    ParsedValue value = parseValue(row(key), QString::fromUtf8(text));
    value.fault.replace(QChar(QChar::Nbsp), QLatin1Char(' '));
    value.remedy.replace(QChar(QChar::Nbsp), QLatin1Char(' '));
    return value;
}

std::vector<ParameterStore::Entry> defaults()
{
    return readDrive().parameters;
}

} // namespace

class TestParameters : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void bothDecimalSignsAreTaken();
    void percentagesOfFullOutputAreTaken();
    void refusalNamesFaultRangeAndNearestValue();
    void everyLegalValueSurvivesTheField();
    void everyLegalValueHasTheSignOfTheLanguageAndSurvives();
    void typingShowsAtOnceAndStagesOnCommit();
    void anEditThatSaysWhatTheDeviceHasIsNone();
    void anEditThatCameTrueIsGone();
    void undoAndRedoGoThroughEveryStep();
    void undoAfterAWriteStagesTheOldValue();
    void whatAWriteLeftIsTakenBackInTheOrderInWhichItWasStaged();
    void importIsOneStepOfUndo();
    void anImportOfWhatIsThereIsNoStepOfUndo();
    void limitsComeFirstAndDampingBeforeP();
    void loweringPComesBeforeLoweringD();
    void illegalAndUntickedChangesAreNotWritten();
};

void TestParameters::bothDecimalSignsAreTaken()
{
    QCOMPARE(parsed("slot1.p", "1,5").raw.value(), 98304);
    QCOMPARE(parsed("slot1.p", " 1.5 ").raw.value(), 98304);
    QCOMPARE(parsed("slot1.p", "−1.5").raw.value(), -98304);
    QCOMPARE(parsed("slot1.max_forward", "0x10").raw.value(), 16);
    QVERIFY(!parsed("slot1.p", "1,000.5").raw);
    QVERIFY(!parsed("slot1.p", "").raw);
    QCOMPARE(parsed("current_limit.enabled", "on").raw.value(), 1);
}

void TestParameters::percentagesOfFullOutputAreTaken()
{
    QCOMPARE(parsed("slot1.max_forward", "55 %").raw.value(), 18022);
    QCOMPARE(parsed("slot1.max_reverse", "-100%").raw.value(), -32768);
    QVERIFY(!parsed("slot1.max_forward", "101 %").raw);
    QVERIFY(!parsed("slot1.p", "50 %").raw); // of what?
}

void TestParameters::refusalNamesFaultRangeAndNearestValue()
{
    const ParsedValue high = parsed("slot1.max_forward", "40000");
    QCOMPARE(high.fault, QStringLiteral("40000 is above 32767 (100 %)."));
    QCOMPARE(high.remedy, QStringLiteral("Enter 0 … 32767, or a percentage such as 55 %."));
    QCOMPARE(high.nearest.value(), 32767);
    const ParsedValue low = parsed("current_limit.peak", "-3");
    QCOMPARE(low.fault, QStringLiteral("−3 is below 0."));
    QCOMPARE(low.nearest.value(), 0);
    const ParsedValue half = parsed("current_limit.peak_duration", "2.5");
    QCOMPARE(half.fault, QStringLiteral("2.5 is not a whole number."));
    QCOMPARE(half.nearest.value(), 3);
    QVERIFY(!parsed("slot1.p", "abc").nearest);
}

void TestParameters::everyLegalValueSurvivesTheField()
{
    for (const Parameter &p : dmc60c().parameters) {
        for (const double share : {0.0, 0.37, 1.0}) {
            const double wish = p.minimum + share * (p.maximum - p.minimum);
            const std::int64_t raw = toRaw(p, p.one == 1.0 ? std::floor(wish) : wish).value();
            QCOMPARE(parseValue(p, fieldText(p, raw)).raw.value(), raw);
            if (p.type != WireType::Boolean)
                QCOMPARE(parseValue(p, valueText(p, raw)).raw.value(), raw);
        }
    }
}

void TestParameters::everyLegalValueHasTheSignOfTheLanguageAndSurvives()
{
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::German));
    everyLegalValueSurvivesTheField();
    const Parameter &gain = row("slot1.p");
    const QStringList shown{fieldText(gain, -98304), valueText(gain, -98304),
        rangeText(gain).section(QLatin1Char(' '), -2, -2), understoodValue(gain, QStringLiteral("1.5")),
        understoodValue(gain, QStringLiteral("1,5")), parsed("slot1.p", "40000").fault};
    const std::array both{parsed("slot1.p", "1,5").raw, parsed("slot1.p", "1.5").raw};
    QLocale::setDefault(before);
    QCOMPARE(shown,
        QStringList({QStringLiteral("-1,500"), QStringLiteral("−1,500"), QStringLiteral("32767,99998"),
            QStringLiteral("= 1,500"), QString(), QStringLiteral("40000 is above 32767,99998.")}));
    for (const auto &raw : both)
        QCOMPARE(raw, std::optional<std::int64_t>(98304));
}

void TestParameters::typingShowsAtOnceAndStagesOnCommit()
{
    StagedEdits edits(dmc60c());
    edits.setEntries(defaults());
    edits.type(named("slot1.max_forward"), QStringLiteral("40000"));
    QCOMPARE(edits.faults(), 1);
    QVERIFY(!edits.undoStack().canUndo());
    edits.endTyping(false);
    QCOMPARE(edits.count(), 0);
    edits.type(named("slot1.max_forward"), QStringLiteral("400"));
    edits.endTyping(true);
    QCOMPARE(edits.find(named("slot1.max_forward"))->value.raw.value(), 400);
    QVERIFY(edits.undoStack().canUndo());
}

void TestParameters::anEditThatSaysWhatTheDeviceHasIsNone()
{
    StagedEdits edits(dmc60c());
    edits.setEntries(defaults());
    edits.stage(named("current_limit.continuous"), QStringLiteral("40,0"));
    QCOMPARE(edits.count(), 0);
    QVERIFY(!edits.undoStack().canUndo());
}

void TestParameters::anEditThatCameTrueIsGone()
{
    StagedEdits edits(dmc60c());
    auto entries = defaults();
    edits.setEntries(entries);
    edits.stage(named("slot1.p"), QStringLiteral("2"));
    entries[named("slot1.p").value] = {rawOf("slot1.p", 2), ParameterState::Failed};
    edits.setEntries(entries);
    QCOMPARE(edits.count(), 1); // it was not read back
    entries[named("slot1.p").value].state = ParameterState::Ram;
    edits.setEntries(entries);
    QCOMPARE(edits.count(), 0);
}

void TestParameters::undoAndRedoGoThroughEveryStep()
{
    StagedEdits edits(dmc60c());
    edits.setEntries(defaults());
    edits.stage(named("slot1.p"), QStringLiteral("1"));
    edits.stage(named("slot1.p"), QStringLiteral("2"));
    edits.stage(named("slot1.d"), QStringLiteral("x"));
    edits.undoStack().undo();
    QVERIFY(!edits.find(named("slot1.d")));
    edits.undoStack().undo();
    QCOMPARE(edits.find(named("slot1.p"))->text, QStringLiteral("1"));
    edits.undoStack().undo();
    QCOMPARE(edits.count(), 0);
    edits.undoStack().redo();
    edits.undoStack().redo();
    QCOMPARE(edits.find(named("slot1.p"))->text, QStringLiteral("2"));
    edits.discard();
    QCOMPARE(edits.count(), 0);
    edits.undoStack().undo();
    QCOMPARE(edits.find(named("slot1.p"))->text, QStringLiteral("2"));
}

void TestParameters::undoAfterAWriteStagesTheOldValue()
{
    StagedEdits edits(dmc60c());
    auto entries = defaults();
    edits.setEntries(entries);
    edits.stage(named("current_limit.peak"), QStringLiteral("80"));
    entries[named("current_limit.peak").value] = {rawOf("current_limit.peak", 80), ParameterState::Ram};
    edits.setEntries(entries);
    QCOMPARE(edits.count(), 0);
    edits.undoStack().undo();
    QCOMPARE(edits.toWrite().size(), std::size_t{1});
    QCOMPARE(edits.toWrite().front().raw, rawOf("current_limit.peak", 60));
}

void TestParameters::whatAWriteLeftIsTakenBackInTheOrderInWhichItWasStaged()
{
    StagedEdits edits(dmc60c());
    edits.setEntries(defaults());
    for (const char *key : {"slot1.d", "slot0.i", "slot1.p", "slot0.p"})
        edits.stage(named(key), QStringLiteral("1"));
    edits.stage(named("slot0.i"), QStringLiteral("2"));
    edits.settle({{named("slot1.p"), rawOf("slot1.p", 1)}});
    for (const char *key : {"slot0.i", "slot0.p", "slot1.d"}) {
        QVERIFY(edits.find(named(key)));
        edits.undoStack().undo();
        QVERIFY2(!edits.find(named(key)), key);
    }
}

void TestParameters::importIsOneStepOfUndo()
{
    StagedEdits edits(dmc60c());
    edits.setEntries(defaults());
    edits.stageAll(
        {{named("slot1.p"), rawOf("slot1.p", 1)}, {named("slot1.i"), rawOf("slot1.i", 2)}}, QStringLiteral("file"));
    QCOMPARE(edits.count(), 2);
    edits.undoStack().undo();
    QCOMPARE(edits.count(), 0);
}

void TestParameters::anImportOfWhatIsThereIsNoStepOfUndo()
{
    StagedEdits edits(dmc60c());
    edits.setEntries(defaults());
    edits.stage(named("slot1.p"), QStringLiteral("1"));
    edits.stageAll({{named("slot1.p"), rawOf("slot1.p", 1)}}, QStringLiteral("file"));
    QCOMPARE(edits.undoStack().count(), 1);
}

void TestParameters::limitsComeFirstAndDampingBeforeP()
{
    StagedEdits edits(dmc60c());
    edits.setEntries(defaults());
    for (const char *key : {"slot1.i", "slot1.p", "slot1.d", "slot1.ramp", "current_limit.peak", "slot1.max_forward"})
        edits.stage(named(key), QStringLiteral("7"));
    edits.stage(named("current_limit.enabled"), QStringLiteral("on"));
    QStringList keys;
    for (const ParameterChange &change : edits.toWrite())
        keys += QString::fromUtf8(dmc60c().parameters[change.index.value].key.data());
    QCOMPARE(keys,
        (QStringList{QStringLiteral("slot1.max_forward"), QStringLiteral("current_limit.peak"),
            QStringLiteral("current_limit.enabled"), QStringLiteral("slot1.d"), QStringLiteral("slot1.ramp"),
            QStringLiteral("slot1.p"), QStringLiteral("slot1.i")}));
}

void TestParameters::loweringPComesBeforeLoweringD()
{
    StagedEdits edits(dmc60c());
    auto entries = defaults();
    for (const char *key : {"slot0.p", "slot0.i", "slot0.d"})
        entries[named(key).value].raw = rawOf(key, 9);
    edits.setEntries(entries);
    for (const char *key : {"slot0.d", "slot0.p", "slot0.i"})
        edits.stage(named(key), QStringLiteral("-1"));
    const auto changes = edits.toWrite();
    QVERIFY(changes[0].index == named("slot0.i"));
    QVERIFY(changes[1].index == named("slot0.p"));
    QVERIFY(changes[2].index == named("slot0.d"));
}

void TestParameters::illegalAndUntickedChangesAreNotWritten()
{
    StagedEdits edits(dmc60c());
    edits.setEntries(defaults());
    edits.stage(named("slot1.p"), QStringLiteral("1"));
    edits.stage(named("slot1.i"), QStringLiteral("2"));
    edits.stage(named("slot1.max_forward"), QStringLiteral("40000"));
    edits.setIncluded(named("slot1.i"), false);
    QCOMPARE(edits.toWrite().size(), std::size_t{1});
    QVERIFY(edits.toWrite().front().index == named("slot1.p"));
    QCOMPARE(edits.ordered().size(), std::size_t{2});
    QCOMPARE(edits.illegal().size(), std::size_t{1});
}

MB_WINDOW_TEST(TestParameters);
#include "tst_parameters.moc"
