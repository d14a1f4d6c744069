// SPDX-License-Identifier: GPL-3.0-or-later
// What a unit has had: its states against each other, undo of what was written, snapshots.
#include "parameterbench.h"
#include "support/windowtests.h"

#include "model/parameterfile.h"
#include "model/unit.h"
#include "widgets/common/clocktext.h"
#include "widgets/parameters/differencedelegate.h"
#include "widgets/parameters/historypanel.h"
#include "widgets/parameters/timelinedelegate.h"

#include <QClipboard>
#include <QComboBox>
#include <QJsonDocument>
#include <QTableWidget>

using namespace mb;
using namespace mb::test;

namespace {

/// A drive with two snapshots: as it was found, and with another P and another current scale.
struct HistoryBench : ParameterBench {
    HistoryBench()
        : ParameterBench(linked())
    {
        const DeviceView &drive = workbench.device(0);
        const std::string unit = drive.unit;
        SettingsTimeline &kept = workbench.archive.kept[unit];
        kept.snapshots.push_back(snapshot(1, unit, "as found", drive));
        DeviceView other = drive;
        other.parameters.edit()[named("slot1.p").value].raw = rawOf("slot1.p", 2);
        other.parameters.edit()[named("slot1.max_forward").value].raw = 20000;
        other.parameters.edit()[named("current.adc_multiplier").value].raw = 2100;
        other.parameters.edit()[named("encoder.position").value].raw = 4711;
        kept.snapshots.push_back(snapshot(2, unit, "limits for the demo", other));
        settings::SettingsChange change;
        change.number = 1;
        change.time = 150.0;
        change.person = "anna";
        change.origin = settings::Origin::Console;
        change.values = {{"slot1.p", rawOf("slot1.p", 0), rawOf("slot1.p", 2), settings::Proof::Equal}};
        kept.changes.push_back(change);
        page->showHistory(true);
        QTRY_COMPARE(boxOf("State B")->count(), 4);
    }
    static DeviceView linked()
    {
        DeviceView device = readDrive();
        device.link = "socketcan:can0";
        device.unit = unitKeyOf(device.identity, *LinkAddress::parse(device.link));
        return device;
    }
    static settings::ParameterSnapshot snapshot(
        std::int64_t number, const std::string &unit, const char *name, const DeviceView &of)
    {
        settings::ParameterSnapshot kept;
        kept.number = number;
        kept.time = 100.0 * static_cast<double>(number);
        kept.unit = unit;
        kept.family = "dmc60c";
        kept.serial = of.identity->serial;
        kept.name = name;
        kept.count = static_cast<int>(of.parameters->size());
        if (kept.name == "as found")
            kept.occasion = settings::Occasion::Found;
        std::vector<ParameterIndex> all;
        for (std::uint16_t i = 0; i < of.parameters->size(); ++i)
            all.push_back({i});
        kept.file = QJsonDocument(
            parametersToJson(ParameterSource{*of.family, of.identity, of.selector, *of.parameters}, all))
                        .toJson()
                        .toStdString();
        return kept;
    }
    [[nodiscard]] QComboBox *boxOf(const char *name) const
    {
        for (QComboBox *box : page->history().findChildren<QComboBox *>()) {
            if (box->accessibleName() == QLatin1String(name))
                return box;
        }
        return nullptr;
    }
    [[nodiscard]] QTableWidget *table() const { return page->history().findChild<QTableWidget *>(); }
    /// Rows of parameters, without those of groups.
    [[nodiscard]] std::vector<int> rows() const
    {
        std::vector<int> found;
        for (int row = 0; row < table()->rowCount(); ++row) {
            if (table()->item(row, 1))
                found.push_back(row);
        }
        return found;
    }
    [[nodiscard]] int count() const { return static_cast<int>(rows().size()); }
    [[nodiscard]] QStringList column(int at) const
    {
        QStringList texts;
        for (const int row : rows())
            texts << table()->item(row, at)->text();
        return texts;
    }
    /// The cell with the box of a parameter, by its key.
    [[nodiscard]] QTableWidgetItem *tick(const char *key) const
    {
        for (const int row : rows()) {
            if (table()->item(row, 1)->text() == QLatin1String(key))
                return table()->item(row, 0);
        }
        return nullptr;
    }
    /// The row of a group, by what it says.
    [[nodiscard]] QTableWidgetItem *group(const QString &title) const
    {
        for (int row = 0; row < table()->rowCount(); ++row) {
            if (!table()->item(row, 1) && table()->item(row, 0)->text() == title)
                return table()->item(row, 0);
        }
        return nullptr;
    }
    [[nodiscard]] QString timeline() const
    {
        QStringList texts;
        const auto *list = page->history().findChild<TimelineList *>();
        for (int row = 0; row < list->count(); ++row)
            texts << list->item(row)->text();
        return texts.join(QLatin1Char('\n'));
    }
};

} // namespace

class TestHistory : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void theNewestStateIsComparedFirst();
    void whatIsTickedIsRestored();
    void aRestoreWaitsForTheDecisionAboutTheOneBefore();
    void ticksStayUntilAnotherStateIsChosen();
    void factoryDefaultsComeUnticked();
    void aRestoreDoesNotTurnTheComparisonRound();
    void whatBelongsToOneUnitIsCopiedOnlyIfItIsTickedItself();
    void theTimelineTellsWhoWroteWhatFromWhere();
    void theTimelineHasNoDayOfWhatWasOnlyStored();
    void theTimelineOfAPlaceSaysThatItIsNoUnits();
    void anyTwoStatesAreCompared();
    void undoTakesBackAnEditAndElseTheLastWrite();
    void aSnapshotIsTakenWhicheverPageIsShown();
    void historyKeyShowsAndHidesIt();
    void valuesStandBelowTheirGroupsAndWhatBelongsToOneUnitLast();
    void aGroupTicksItsRowsAndShowsHowManyAre();
    void enterTicksTheRow();
    void headsOfNumbersStandOverTheirNumbers();
    void theTimelineSaysHowAStateCameAbout();
    void aAndBAreExchanged();
    void differencesAreCopiedAsText();
    void aDayIsWrittenAsTheLanguageWritesIt();
};

void TestHistory::valuesStandBelowTheirGroupsAndWhatBelongsToOneUnitLast()
{
    HistoryBench bench;
    QTRY_COMPARE(bench.count(), 3);
    QStringList heads;
    for (int row = 0; row < bench.table()->rowCount(); ++row) {
        if (!bench.table()->item(row, 1))
            heads << bench.table()->item(row, 0)->text();
    }
    QCOMPARE(heads, (QStringList{QStringLiteral("Loop, slot 1"), QStringLiteral("This unit")}));
    QCOMPARE(
        bench.group(QStringLiteral("Loop, slot 1"))->data(GroupNoteRole).toString(), QStringLiteral("2 of 11 differ"));
    QVERIFY(bench.group(QStringLiteral("This unit"))
                ->data(GroupNoteRole)
                .toString()
                .contains(QStringLiteral("belongs to one unit")));
}

void TestHistory::aGroupTicksItsRowsAndShowsHowManyAre()
{
    HistoryBench bench;
    QTRY_COMPARE(bench.count(), 3);
    QTableWidgetItem *group = bench.group(QStringLiteral("Loop, slot 1"));
    QCOMPARE(group->checkState(), Qt::Checked);
    bench.tick("slot1.p")->setCheckState(Qt::Unchecked);
    QCOMPARE(group->checkState(), Qt::PartiallyChecked);
    group->setCheckState(Qt::Checked);
    QCOMPARE(bench.tick("slot1.p")->checkState(), Qt::Checked);
    group->setCheckState(Qt::Unchecked);
    QCOMPARE(bench.tick("slot1.p")->checkState(), Qt::Unchecked);
    QVERIFY(!button(bench, QStringLiteral("Restore 0"))->isEnabled());
    QVERIFY(!bench.group(QStringLiteral("This unit"))->flags().testFlag(Qt::ItemIsUserCheckable));
    bench.tick("current.adc_multiplier")->setCheckState(Qt::Checked);
    QVERIFY(!bench.group(QStringLiteral("This unit"))->flags().testFlag(Qt::ItemIsUserCheckable));
}

void TestHistory::enterTicksTheRow()
{
    HistoryBench bench;
    QTRY_COMPARE(bench.count(), 3);
    bench.table()->setFocus();
    bench.table()->setCurrentItem(bench.tick("slot1.p"));
    QTest::keyClick(bench.table(), Qt::Key_Return);
    QCOMPARE(bench.tick("slot1.p")->checkState(), Qt::Unchecked);
    QTest::keyClick(bench.table(), Qt::Key_Return);
    QCOMPARE(bench.tick("slot1.p")->checkState(), Qt::Checked);
}

void TestHistory::headsOfNumbersStandOverTheirNumbers()
{
    HistoryBench bench;
    for (const int column : {2, 3})
        QVERIFY((bench.table()->horizontalHeaderItem(column)->textAlignment() & Qt::AlignRight) != 0);
}

void TestHistory::theTimelineSaysHowAStateCameAbout()
{
    HistoryBench bench;
    QTRY_COMPARE(bench.count(), 3);
    const auto *list = bench.page->history().findChild<TimelineList *>();
    QStringList badges;
    QStringList details;
    for (int row = 0; row < list->count(); ++row) {
        if (list->item(row)->data(PlaceRole).isValid()) {
            badges << list->item(row)->data(BadgesRole).toString();
            details << list->item(row)->data(DetailRole).toString();
        }
    }
    QCOMPARE(badges, (QStringList{QStringLiteral("A"), QStringLiteral("B"), {}, {}}));
    QCOMPARE(details.at(1), QStringLiteral("by hand, 55 values"));
    QCOMPARE(details.at(2), QStringLiteral("automatic, 55 values"));
    QVERIFY(bench.timeline().contains(QStringLiteral("Always there")));
}

void TestHistory::aAndBAreExchanged()
{
    HistoryBench bench;
    QTRY_COMPARE(bench.count(), 3);
    const QString a = bench.boxOf("State A")->currentText();
    const QString b = bench.boxOf("State B")->currentText();
    for (auto *button : bench.page->history().findChildren<QAbstractButton *>()) {
        if (button->accessibleName() == QLatin1String("Exchange A and B"))
            button->click();
    }
    QCOMPARE(bench.boxOf("State A")->currentText(), b);
    QCOMPARE(bench.boxOf("State B")->currentText(), a);
}

void TestHistory::differencesAreCopiedAsText()
{
    HistoryBench bench;
    QTRY_COMPARE(bench.count(), 3);
    button(bench, QStringLiteral("Copy as text"))->click();
    const QStringList lines = QGuiApplication::clipboard()->text().split(QLatin1Char('\n'));
    QCOMPARE(lines.size(), 4);
    QCOMPARE(lines.at(1), QStringLiteral("slot1.p\t0\t2.000\tthrottle/error"));
}

void TestHistory::aDayIsWrittenAsTheLanguageWritesIt()
{
    const QDate day(QDate::currentDate().year(), 6, 11);
    QCOMPARE(dayText(day, QLocale(QLocale::German)), QStringLiteral("11. Juni"));
    QCOMPARE(dayText(day, QLocale(QLocale::English)), QStringLiteral("June 11"));
    QCOMPARE(dayText(day, QLocale(QLocale::Spanish)), QStringLiteral("11 de junio"));
    QCOMPARE(dayText(day, QLocale(QLocale::French)), QStringLiteral("11 juin"));
    QCOMPARE(dayText(day, QLocale(QLocale::Japanese)), QStringLiteral("6月11日"));
    QCOMPARE(dayText(day, QLocale(QLocale::Chinese)), QStringLiteral("6月11日"));
    QCOMPARE(dayText({1999, 6, 11}, QLocale(QLocale::German)), QStringLiteral("11. Juni 1999"));
}

void TestHistory::theNewestStateIsComparedFirst()
{
    HistoryBench bench;
    QTRY_COMPARE(bench.column(1),
        (QStringList{
            QStringLiteral("slot1.p"), QStringLiteral("slot1.max_forward"), QStringLiteral("current.adc_multiplier")}));
    QCOMPARE(bench.column(3).at(0), QStringLiteral("2.000"));
    QCOMPARE(bench.tick("current.adc_multiplier")->checkState(), Qt::Unchecked);
}

void TestHistory::ticksStayUntilAnotherStateIsChosen()
{
    HistoryBench bench;
    QTRY_COMPARE(bench.count(), 3);
    bench.tick("current.adc_multiplier")->setCheckState(Qt::Checked); // of one unit
    bench.tick("slot1.p")->setCheckState(Qt::Unchecked);
    DeviceView &drive = bench.workbench.device(0);
    drive.parameters.edit()[named("slot1.i").value].raw = 77; // somebody writes, or the page reads
    ++drive.parameterRevision;
    bench.workbench.publish();
    QTRY_COMPARE(bench.count(), 4);
    QCOMPARE(bench.tick("current.adc_multiplier")->checkState(), Qt::Checked);
    QCOMPARE(bench.tick("slot1.p")->checkState(), Qt::Unchecked);
    auto *const b = bench.boxOf("State B");
    const int before = b->currentIndex();
    for (const int place : {before == 1 ? 2 : 1, before}) {
        b->setCurrentIndex(place);
        Q_EMIT b->activated(place);
    }
    QCOMPARE(bench.tick("current.adc_multiplier")->checkState(), Qt::Unchecked);
    QCOMPARE(bench.tick("slot1.p")->checkState(), Qt::Checked);
}

void TestHistory::factoryDefaultsComeUnticked()
{
    HistoryBench bench;
    QTRY_COMPARE(bench.count(), 3);
    DeviceView &drive = bench.workbench.device(0);
    drive.parameters.edit()[named("slot1.i").value].raw = 77;
    ++drive.parameterRevision;
    bench.workbench.publish();
    QTRY_COMPARE(bench.count(), 4);
    auto *const b = bench.boxOf("State B");
    const int defaults = b->findText(QStringLiteral("factory defaults"));
    QVERIFY(defaults >= 0);
    b->setCurrentIndex(defaults);
    Q_EMIT b->activated(defaults);
    QVERIFY(bench.count() > 0);
    for (const int row : bench.rows())
        QVERIFY2(bench.table()->item(row, 0)->checkState() == Qt::Unchecked,
            qPrintable(bench.table()->item(row, 1)->text()));
    QVERIFY(!button(bench, QStringLiteral("Restore 0"))->isEnabled());
}

void TestHistory::aRestoreDoesNotTurnTheComparisonRound()
{
    HistoryBench bench;
    QTRY_COMPARE(bench.count(), 3);
    const QString chosen = bench.boxOf("State B")->currentText();
    QVERIFY2(chosen.contains(QStringLiteral("limits for the demo")), qPrintable(chosen));
    button(bench, QStringLiteral("Restore 2"))->click();
    DeviceView &drive = bench.workbench.device(0);
    bench.workbench.archive.kept[drive.unit].snapshots.push_back(
        HistoryBench::snapshot(3, drive.unit, "before restore", drive));
    drive.parameters.edit()[named("slot1.p").value].raw = rawOf("slot1.p", 2);
    drive.parameters.edit()[named("slot1.max_forward").value].raw = 20000;
    ++drive.parameterRevision;
    bench.workbench.publish();
    QTRY_COMPARE(bench.boxOf("State B")->count(), 5);
    QCOMPARE(bench.boxOf("State B")->currentText(), chosen);
    QVERIFY(!button(bench, QStringLiteral("Restore 0"))->isEnabled());
}

void TestHistory::whatBelongsToOneUnitIsCopiedOnlyIfItIsTickedItself()
{
    HistoryBench bench;
    QTRY_COMPARE(bench.count(), 3);
    button(bench, QStringLiteral("Restore 2"))->click();
    bench.tick("current.adc_multiplier")->setCheckState(Qt::Checked);
    button(bench, QStringLiteral("Restore 3"))->click();
    const auto calls = bench.workbench.given<orders::RestoreParameters>();
    QCOMPARE(calls.size(), std::size_t{2});
    const auto copies = [](const auto &call) {
        return std::any_of(call.changes.begin(), call.changes.end(),
            [](const ParameterChange &change) { return change.index == named("current.adc_multiplier"); });
    };
    QVERIFY(!copies(calls[0]));
    QVERIFY(copies(calls[1]));
}

void TestHistory::whatIsTickedIsRestored()
{
    HistoryBench bench;
    QTRY_COMPARE(bench.count(), 3);
    bench.tick("slot1.max_forward")->setCheckState(Qt::Unchecked);
    button(bench, QStringLiteral("Restore 1"))->click();
    const auto calls = bench.workbench.given<orders::RestoreParameters>();
    QCOMPARE(calls.size(), std::size_t{1});
    QCOMPARE(calls[0].changes.size(), std::size_t{1});
    QVERIFY(calls[0].changes[0].index == named("slot1.p"));
    QCOMPARE(calls[0].changes[0].raw, rawOf("slot1.p", 2));
    calls[0].finished(fail(Fault::BadCheck, say("slot1.p was written as 2 but reads 1")));
    QVERIFY(says(bench, QStringLiteral("slot1.p was written as 2 but reads 1")));
}

void TestHistory::aRestoreWaitsForTheDecisionAboutTheOneBefore()
{
    HistoryBench bench;
    QTRY_COMPARE(bench.count(), 3);
    QVERIFY(button(bench, QStringLiteral("Restore 2"))->isEnabled());
    UnconfirmedView open;
    open.device = bench.workbench.device(0).id;
    bench.workbench.shot.unconfirmed = {open};
    bench.workbench.publish();
    const QAbstractButton *const waits = button(bench, QStringLiteral("Keep or revert first"));
    QVERIFY(waits && !waits->isEnabled());
    bench.workbench.shot.unconfirmed.clear();
    bench.workbench.publish();
    QVERIFY(button(bench, QStringLiteral("Restore 2"))->isEnabled());
}

void TestHistory::theTimelineTellsWhoWroteWhatFromWhere()
{
    HistoryBench bench;
    QTRY_VERIFY(bench.timeline().contains(QStringLiteral("limits for the demo")));
    const QString text = bench.timeline();
    QVERIFY2(text.contains(QStringLiteral("console, anna\nslot1.p: 0 → 2")), qPrintable(text));
    QVERIFY(text.indexOf(QStringLiteral("limits for the demo")) < text.indexOf(QStringLiteral("console, anna")));
    QVERIFY(text.indexOf(QStringLiteral("console, anna")) < text.indexOf(QStringLiteral("as found")));
    QVERIFY(text.contains(QStringLiteral("3 differ")));
    QVERIFY(text.contains(QStringLiteral("like A")));
}

void TestHistory::theTimelineHasNoDayOfWhatWasOnlyStored()
{
    settings::SettingsChange stored;
    stored.time = 86400.0 * 10;
    stored.purpose = settings::Purpose::Store;
    settings::SettingsChange written;
    written.time = 86400.0 * 20;
    written.values = {{"slot1.p", rawOf("slot1.p", 0), rawOf("slot1.p", 2), settings::Proof::Equal}};
    SettingsTimeline kept;
    kept.changes = {stored, written};
    UnitState defaults;
    defaults.kind = UnitState::Kind::Defaults;
    const ThemeSource theme{lightTheme()};
    TimelineList list(theme, nullptr);
    list.show(dmc60c(), {defaults}, kept);
    QStringList texts;
    for (int row = 0; row < list.count(); ++row)
        texts << list.item(row)->text();
    const auto dayOf = [](double time) { return dayText(momentOf(time).date()); };
    QVERIFY2(texts.contains(dayOf(written.time)), qPrintable(texts.join(QLatin1Char('|'))));
    QVERIFY2(!texts.contains(dayOf(stored.time)), qPrintable(texts.join(QLatin1Char('|'))));
}

void TestHistory::theTimelineOfAPlaceSaysThatItIsNoUnits()
{
    const ThemeSource theme{lightTheme()};
    TimelineList list(theme, nullptr);
    UnitState defaults;
    defaults.kind = UnitState::Kind::Defaults;
    SettingsTimeline kept;
    kept.snapshots.resize(1);
    for (const bool isPlace : {true, false}) {
        kept.snapshots[0].unit = isPlace ? "place can0 abstractdc:3" : "tag abstractdc left arm";
        list.show(dmc60c(), {defaults}, kept);
        QCOMPARE(list.item(0)->text() == QStringLiteral("This place, not this unit"), isPlace);
    }
}

void TestHistory::anyTwoStatesAreCompared()
{
    HistoryBench bench;
    QTRY_COMPARE(bench.count(), 3);
    QComboBox *a = bench.boxOf("State A");
    a->setCurrentIndex(3); // the data sheet's
    Q_EMIT a->activated(3);
    QCOMPARE(bench.count(), 3);
    QVERIFY(!button(bench, QStringLiteral("Restore 2"))->isEnabled());
    QComboBox *b = bench.boxOf("State B");
    b->setCurrentIndex(2);
    Q_EMIT b->activated(2);
    QCOMPARE(bench.count(), 0);
}

void TestHistory::undoTakesBackAnEditAndElseTheLastWrite()
{
    ParameterBench bench;
    bench.stage("slot1.p", "2");
    bench.page->undo(false);
    QCOMPARE(bench.edits().count(), 0);
    QVERIFY(bench.workbench.given<orders::UndoWrite>().empty());
    bench.page->undo(true);
    bench.page->write();
    bench.workbench.given<orders::WriteParameters>()[0].finished({});
    QTest::keyClick(bench.page.get(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(bench.workbench.given<orders::UndoWrite>().size(), std::size_t{1});
    QVERIFY(!bench.workbench.given<orders::UndoWrite>()[0].again);
    QCOMPARE(bench.edits().count(), 0);
    QTest::keyClick(bench.page.get(), Qt::Key_Y, Qt::ControlModifier);
    QCOMPARE(bench.workbench.given<orders::UndoWrite>().size(), std::size_t{2});
    QVERIFY(bench.workbench.given<orders::UndoWrite>()[1].again);
    bench.workbench.given<orders::UndoWrite>()[1].finished(fail(Fault::Refused, say("there is nothing to do again")));
    QVERIFY(says(bench, QStringLiteral("there is nothing to do again")));
}

void TestHistory::aSnapshotIsTakenWhicheverPageIsShown()
{
    ParameterBench bench;
    bench.page->hide();
    bench.page->takeSnapshot();
    QCOMPARE(bench.workbench.given<orders::TakeSnapshot>().size(), std::size_t{1});
    QVERIFY(bench.workbench.given<orders::WriteParameters>().empty());
}

void TestHistory::historyKeyShowsAndHidesIt()
{
    HistoryBench bench;
    QVERIFY(bench.page->history().isVisible());
    QVERIFY(!bench.view().isVisible());
    QTest::keyClick(bench.page.get(), Qt::Key_H, Qt::ControlModifier);
    QVERIFY(!bench.page->history().isVisible());
    QVERIFY(bench.view().isVisible());
}

MB_WINDOW_TEST(TestHistory);
#include "tst_history.moc"
