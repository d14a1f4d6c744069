// SPDX-License-Identifier: GPL-3.0-or-later
// What can be handed out about the units that are here: listed, searched, looked at, written.
#include "model/registry.h"
#include "support/windowtests.h"
#include "tunebench.h"
#include "widgets/common/searchfield.h"
#include "widgets/report/reportdrawings.h"
#include "widgets/report/reportorder.h"
#include "widgets/report/reportspage.h"

#include <QAbstractTextDocumentLayout>
#include <QComboBox>
#include <QFile>
#include <QLineEdit>
#include <QListWidget>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextLayout>

using namespace mb;
using namespace mb::test;

namespace {

QLineEdit *noteOf(const ReportsPage &page)
{
    const auto fields = page.findChildren<QLineEdit *>();
    const auto found = std::find_if(
        fields.begin(), fields.end(), [](const QLineEdit *field) { return !qobject_cast<const SearchField *>(field); });
    return found == fields.end() ? nullptr : *found;
}

struct ReportsPageBench {
    FakeWorkbench workbench;
    Selection selection;
    ThemeSource theme{darkTheme()};
    std::unique_ptr<ReportsPage> page;

    ReportsPageBench()
    {
        workbench.shot.devices.push_back(tunableDrive(std::make_shared<Telemetry>(dmc60c().channels), 1, 5));
        workbench.device(0).selector = "sim:can/dmc60c:5";
        workbench.device(0).link = "sim:can";
        workbench.device(0).identity.edit().serial = "2103343A79F2";
        ReportUnit unit;
        unit.family = &dmc60c();
        unit.identity = workbench.device(0).identity;
        unit.selector = workbench.device(0).selector;
        unit.simulated = true;
        workbench.device(0).unit = "simulated dmc60c 2103343A79F2";
        unit.unit = workbench.device(0).unit;
        KeptTrial trial;
        trial.number = 17;
        trial.time = 1'718'100'000.0;
        trial.note = "before the new gearbox";
        unit.history.push_back(trial);
        workbench.book.matter = std::vector<ReportUnit>{unit};
        page = std::make_unique<ReportsPage>(workbench, selection, families(), theme, nullptr);
        page->resize(1208, 700);
        page->show();
    }
    /// Two units that were served; the second one passed, and is not here any more.
    void serve()
    {
        service::Visit failed;
        failed.id = "a";
        failed.time = 1'718'200'000.0;
        failed.unit = workbench.book.matter->front().unit;
        failed.serial = "2103343A79F2";
        failed.device = "sim:can/dmc60c:5";
        failed.family = "dmc60c";
        failed.recipe = "drive-base rev C";
        failed.outcome = service::Outcome::Failed;
        failed.cause = Message::verbatim("friction 0.61 V, at most 0.4");
        failed.station = "bench 2";
        service::Visit passed = failed;
        passed.id = "b";
        passed.time += 600.0;
        passed.unit = "dmc60c 2103343A7B2E";
        passed.serial = "2103343A7B2E";
        passed.number = 36;
        passed.outcome = service::Outcome::Passed;
        passed.cause = {};
        passed.from = "1.23";
        passed.to = "1.25";
        ReportUnit gone;
        gone.unit = passed.unit;
        gone.visits = {passed};
        workbench.book.matter->push_back(gone);
        workbench.visited.entries = {failed, passed};
        Q_EMIT workbench.unitEnded(passed);
    }
};

} // namespace

class TestReportsPage : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void unitsAndTheirTrialsAreListed();
    void theSearchLeavesWhatItNames();
    void whatIsChosenIsLookedAt();
    void itIsWrittenAsItIsLookedAt();
    void withoutUnitsItSaysSo();
    void theJournalIsListedNewestFirst();
    void aUnitThatIsNotHereHasItsCardFromTheJournal();
    void aLabelIsAChoice();
    void theJournalThatIsListedIsATable();
    void aNoteIsKept();
    void aNoteHasRoomToBeRead();
    void nothingIsScrolledSideways();
    void aWidePreviewIsAPageStill();
    void aNoteGoesToTheEntryItWasBegunFor();
    void aNoteThatWasBegunIsKeptWhenItsEntryIsNotListedAnyMore();
    void whatIsWrittenIsWhatWasChosenBeforeAnotherUnitEnded();
    void whatIsChosenStaysSoWhileUnitsComeAndGetNumbers();
    void whoSelectsADeviceSeesItsCard();
    void thePreviewIsAsLargeAsTheTextAroundIt();
    void aCardIsThatOfTheUnitAsItIsNow();
    void aBookThatCannotBeReadIsToldOnce();
};

void TestReportsPage::nothingIsScrolledSideways()
{
    ReportsPageBench bench;
    for (int i = 0; i < 60; ++i) { // more than the list is high
        KeptTrial more = bench.workbench.book.matter->front().history.front();
        more.number = 100 + i;
        bench.workbench.book.matter->front().history.push_back(more);
    }
    bench.page->hide();
    bench.page->show();
    QTRY_VERIFY(bench.page->list().count() > 60);
    QVERIFY(!bench.page->list().horizontalScrollBar()->isVisible());
    auto *preview = bench.page->findChild<QTextBrowser *>();
    ReportDrawings drawings;
    const QString html = drawings.takeFrom(QStringLiteral("<p><svg xmlns=\"http://www.w3.org/2000/svg\" width=\"2000\" "
                                                          "height=\"400\"><rect width=\"9\" height=\"9\"/></svg></p>"));
    preview->document()->documentLayout()->registerHandler(QTextFormat::ImageObject, &drawings);
    preview->setHtml(html);
    QCOMPARE(preview->horizontalScrollBar()->maximum(), 0); // a drawing is as wide as there is room
    preview->setHtml(html + QStringLiteral("<p>a line</p>").repeated(200));
    QTRY_VERIFY(preview->verticalScrollBar()->isVisible());
    QTRY_COMPARE(preview->horizontalScrollBar()->maximum(), 0); // nor beside the bar of a long report
    bench.page->resize(1048, 660);
    QTRY_COMPARE(preview->horizontalScrollBar()->maximum(), 0);
}

void TestReportsPage::aWidePreviewIsAPageStill()
{
    ReportsPageBench bench;
    bench.page->resize(3400, 1800);
    QTRY_VERIFY(bench.page->list().count() > 0);
    const auto *preview = bench.page->findChild<QTextBrowser *>();
    QVERIFY(preview->document()->textWidth() < 1000.0); // a line that is longer is not read
}

void TestReportsPage::unitsAndTheirTrialsAreListed()
{
    ReportsPageBench bench;
    QTRY_COMPARE(bench.page->list().count(), 2);
    QVERIFY(bench.page->list().item(0)->text().contains(QStringLiteral("2103343A79F2")));
    QVERIFY(bench.page->list().item(1)->text().contains(QStringLiteral("#17")));
}

void TestReportsPage::theSearchLeavesWhatItNames()
{
    ReportsPageBench bench;
    QTRY_COMPARE(bench.page->list().count(), 2);
    bench.page->findChild<SearchField *>()->setText(QStringLiteral("GEARBOX"));
    QCOMPARE(bench.page->list().count(), 1);
    QVERIFY(bench.page->list().item(0)->text().contains(QStringLiteral("#17")));
}

void TestReportsPage::whatIsChosenIsLookedAt()
{
    ReportsPageBench bench;
    QTRY_VERIFY2(bench.page->previewText().contains(QStringLiteral("2103343A79F2")),
        qPrintable(bench.page->previewText().left(400)));
}

void TestReportsPage::itIsWrittenAsItIsLookedAt()
{
    ReportsPageBench bench;
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("card.html"));
    QTRY_COMPARE(bench.page->list().count(), 2);
    QSignalSpy written(&bench.page->order(), &ReportOrder::written);
    bench.page->write(path);
    QTRY_COMPARE(written.size(), 1);
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QVERIFY(file.readAll().contains("2103343A79F2"));
}

void TestReportsPage::withoutUnitsItSaysSo()
{
    FakeWorkbench workbench;
    const ThemeSource theme(darkTheme());
    const Selection selection;
    ReportsPage page(workbench, selection, families(), theme, nullptr);
    page.show();
    QCOMPARE(page.list().count(), 0);
    QVERIFY(!page.list().isVisible());
}

void TestReportsPage::theJournalIsListedNewestFirst()
{
    ReportsPageBench bench;
    QTRY_COMPARE(bench.page->list().count(), 2);
    bench.serve();
    QTRY_COMPARE(bench.page->list().count(), 4);
    bench.page->setFilter(ReportsPage::Journal);
    QCOMPARE(bench.page->list().count(), 2);
    QVERIFY(bench.page->list().item(0)->text().contains(QStringLiteral("2103343A7B2E #36 passed: drive-base rev C")));
    QVERIFY(bench.page->list().item(1)->text().contains(QStringLiteral("friction 0.61 V")));
    QVERIFY(!bench.page->list().item(1)->icon().isNull()); // a shape besides the word
    bench.page->findChild<SearchField *>()->setText(QStringLiteral("bench 2"));
    QCOMPARE(bench.page->list().count(), 2); // the station is searched, too
    bench.page->findChild<SearchField *>()->setText(QStringLiteral("7B2E"));
    QCOMPARE(bench.page->list().count(), 1);
    bench.page->findChild<SearchField *>()->clear();
    bench.page->setFilter(ReportsPage::Cards);
    QCOMPARE(bench.page->list().count(), 1);
    bench.page->setFilter(ReportsPage::Tunings);
    QCOMPARE(bench.page->list().count(), 1);
}

void TestReportsPage::aUnitThatIsNotHereHasItsCardFromTheJournal()
{
    ReportsPageBench bench;
    bench.serve();
    bench.page->setFilter(ReportsPage::Journal);
    QTRY_VERIFY(bench.page->previewText().contains(QStringLiteral("2103343A7B2E")));
    QVERIFY2(bench.page->previewText().contains(QStringLiteral("drive-base rev C")),
        qPrintable(bench.page->previewText())); // what was done to it
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("card.pdf"));
    QSignalSpy written(&bench.page->order(), &ReportOrder::written);
    bench.page->write(path);
    QTRY_COMPARE(written.size(), 1);
    QVERIFY(written.front().at(1).toBool());
}

void TestReportsPage::aLabelIsAChoice()
{
    ReportsPageBench bench;
    bench.serve();
    bench.page->setFilter(ReportsPage::Journal);
    QTRY_VERIFY(bench.page->previewText().contains(QStringLiteral("2103343A7B2E")));
    const auto whole = bench.page->previewText().size();
    auto *size = bench.page->findChild<QComboBox *>();
    QVERIFY(!size->accessibleName().isEmpty());
    size->setCurrentIndex(1);
    QTRY_VERIFY(bench.page->previewText().size() < whole / 2);
    QVERIFY(bench.page->previewText().contains(QStringLiteral("2103343A7B2E")));
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("label.html"));
    QSignalSpy written(&bench.page->order(), &ReportOrder::written);
    bench.page->write(path);
    QTRY_COMPARE(written.size(), 1);
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QVERIFY(file.readAll().contains("62mm 29mm"));
    bench.workbench.book.matter->pop_back();   // the other one, which was
    bench.page->setFilter(ReportsPage::Cards); // of a unit that was never served
    QTRY_VERIFY(bench.page->list().count() == 1);
    bench.page->write(folder.filePath(QStringLiteral("none.pdf")));
    QTRY_COMPARE(written.size(), 2);
    QVERIFY(!written.back().at(1).toBool());
    QVERIFY(!QFile::exists(folder.filePath(QStringLiteral("none.pdf"))));
}

void TestReportsPage::theJournalThatIsListedIsATable()
{
    ReportsPageBench bench;
    bench.serve();
    bench.page->findChild<SearchField *>()->setText(QStringLiteral("7B2E"));
    bench.page->saveTable(QStringLiteral("journal.csv"));
    QCOMPARE(bench.workbench.visited.exported.size(), 1U);
    QCOMPARE(bench.workbench.visited.exported.front().id, std::string("b"));
    QVERIFY(bench.workbench.lines.back().text.contains(QStringLiteral("journal.csv")));
}

void TestReportsPage::aNoteIsKept()
{
    ReportsPageBench bench;
    bench.serve();
    bench.page->setFilter(ReportsPage::Journal);
    auto *note = noteOf(*bench.page);
    QVERIFY(note->isVisible());
    note->setText(QStringLiteral("red box"));
    Q_EMIT note->editingFinished();
    QCOMPARE(bench.workbench.visited.entries.back().note, std::string("red box"));
    QVERIFY(bench.page->list().item(0)->text().contains(QStringLiteral("red box")));
}

void TestReportsPage::aNoteHasRoomToBeRead()
{
    ReportsPageBench bench;
    bench.serve();
    bench.page->resize(1047, 607); // as it is in the smallest window
    bench.page->setFilter(ReportsPage::Journal);
    QCoreApplication::processEvents();
    const auto *const note = noteOf(*bench.page);
    QVERIFY2(note->width() > note->fontMetrics().horizontalAdvance(note->placeholderText()) + 40,
        qPrintable(QString::number(note->width())));
}

void TestReportsPage::aNoteGoesToTheEntryItWasBegunFor()
{
    ReportsPageBench bench;
    bench.serve();
    bench.page->setFilter(ReportsPage::Journal);
    bench.page->list().setCurrentRow(1); // the older one, "a"
    auto *note = noteOf(*bench.page);
    note->setFocus();
    note->setText(QStringLiteral("red box"));
    service::Visit another = bench.workbench.visited.entries.back();
    another.id = "c";
    another.time += 600.0;
    bench.workbench.visited.entries.push_back(another);
    Q_EMIT bench.workbench.unitEnded(another);
    QCOMPARE(bench.page->list().count(), 3);
    QCOMPARE(bench.page->list().currentRow(), 2);
    QCOMPARE(note->text(), QStringLiteral("red box"));
    Q_EMIT note->editingFinished();
    QCOMPARE(bench.workbench.visited.entries.at(0).note, std::string("red box"));
    QVERIFY(bench.workbench.visited.entries.at(1).note.empty());
    QVERIFY(bench.workbench.visited.entries.at(2).note.empty());
}

void TestReportsPage::aNoteThatWasBegunIsKeptWhenItsEntryIsNotListedAnyMore()
{
    ReportsPageBench bench;
    bench.serve();
    bench.page->setFilter(ReportsPage::Journal);
    bench.page->list().setCurrentRow(1);
    noteOf(*bench.page)->setText(QStringLiteral("red box"));
    bench.page->findChild<SearchField *>()->setText(QStringLiteral("7B2E")); // leaves the other
    QCOMPARE(bench.page->list().count(), 1);
    Q_EMIT noteOf(*bench.page)->editingFinished();
    QCOMPARE(bench.workbench.visited.entries.at(0).note, std::string("red box"));
    QVERIFY(bench.workbench.visited.entries.at(1).note.empty());
}

void TestReportsPage::whatIsWrittenIsWhatWasChosenBeforeAnotherUnitEnded()
{
    ReportsPageBench bench;
    bench.serve();
    bench.page->setFilter(ReportsPage::Journal);
    bench.page->list().setCurrentRow(1);
    service::Visit another = bench.workbench.visited.entries.back();
    another.id = "c";
    another.time += 600.0;
    bench.workbench.visited.entries.push_back(another);
    Q_EMIT bench.workbench.unitEnded(another);
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("card.html"));
    QSignalSpy written(&bench.page->order(), &ReportOrder::written);
    bench.page->write(path);
    QTRY_COMPARE(written.size(), 1);
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray text = file.readAll();
    QVERIFY(text.contains("2103343A79F2"));
    QVERIFY(!text.contains("2103343A7B2E"));
}

void TestReportsPage::whatIsChosenStaysSoWhileUnitsComeAndGetNumbers()
{
    ReportsPageBench bench;
    const auto chosen = [&bench] { return bench.page->list().currentItem()->text(); };
    QTRY_COMPARE(bench.page->list().count(), 2);
    bench.page->list().setCurrentRow(1);
    QVERIFY(chosen().contains(QStringLiteral("Trial #17 of DMC60C #5")));
    DeviceView another = bench.workbench.device(0);
    another.id = {2};
    another.selector = "sim:can/dmc60c:7";
    another.identity.edit().address = 7;
    another.unit = "simulated dmc60c 2103343A0007";
    bench.workbench.shot.devices.insert(bench.workbench.shot.devices.begin(), another);
    bench.workbench.publish();
    QVERIFY(chosen().contains(QStringLiteral("Trial #17 of DMC60C #5"))); // and the book is still read
    QTRY_COMPARE(bench.page->list().count(), 4);
    QVERIFY2(chosen().contains(QStringLiteral("Trial #17 of DMC60C #5")), qPrintable(chosen()));
    bench.page->hide();
    bench.page->show();
    QVERIFY2(chosen().contains(QStringLiteral("Trial #17 of DMC60C #5")), qPrintable(chosen()));
    bench.workbench.device(1).selector = "sim:can/dmc60c:9";
    bench.workbench.device(1).identity.edit().address = 9;
    bench.workbench.publish();
    QTRY_VERIFY2(chosen().contains(QStringLiteral("Trial #17 of DMC60C #9")), qPrintable(chosen()));
}

void TestReportsPage::whoSelectsADeviceSeesItsCard()
{
    ReportsPageBench bench;
    DeviceView another = bench.workbench.device(0);
    another.id = {2};
    another.selector = "sim:can/dmc60c:7";
    another.identity.edit().address = 7;
    another.unit = "simulated dmc60c 2103343A0007";
    bench.workbench.shot.devices.push_back(another);
    bench.workbench.publish();
    QTRY_COMPARE(bench.page->list().count(), 4);
    const auto chosen = [&bench] { return bench.page->list().currentItem()->text(); };
    QVERIFY(chosen().contains(QStringLiteral("Card of DMC60C #5")));
    bench.selection.select({2});
    QVERIFY2(chosen().contains(QStringLiteral("Card of DMC60C #7")), qPrintable(chosen()));
    bench.page->list().setCurrentRow(0); // somebody looks at another
    bench.workbench.publish();
    QVERIFY2(chosen().contains(QStringLiteral("Card of DMC60C #5")), qPrintable(chosen()));
}

void TestReportsPage::thePreviewIsAsLargeAsTheTextAroundIt()
{
    const auto largest = [](double points) {
        ReportsPageBench bench;
        bench.theme.setTheme(darkTheme(points));
        bench.page->hide();
        bench.page->show();
        const auto *text = bench.page->findChild<QTextBrowser *>();
        [&] { QTRY_VERIFY(bench.page->previewText().contains(QStringLiteral("2103343A79F2"))); }();
        int pixels = 0;
        for (QTextBlock block = text->document()->begin(); block.isValid(); block = block.next()) {
            for (const QTextLayout::FormatRange &part : block.textFormats())
                pixels = std::max(pixels, part.format.font().pixelSize());
        }
        return pixels;
    };
    QVERIFY(largest(10.0) > 0);
    QCOMPARE(largest(20.0), 2 * largest(10.0));
}

void TestReportsPage::aCardIsThatOfTheUnitAsItIsNow()
{
    ReportsPageBench bench;
    QTRY_COMPARE(bench.page->list().count(), 2);
    bench.workbench.device(0).identity.edit().firmware = "9.99";
    bench.workbench.publish();
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("card.html"));
    QSignalSpy written(&bench.page->order(), &ReportOrder::written);
    bench.page->write(path);
    QTRY_COMPARE(written.size(), 1);
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QVERIFY(file.readAll().contains("9.99"));
    bench.page->list().setCurrentRow(1);
    bench.page->list().setCurrentRow(0);
    QTRY_VERIFY(bench.page->previewText().contains(QStringLiteral("9.99")));
}

void TestReportsPage::aBookThatCannotBeReadIsToldOnce()
{
    ReportsPageBench bench;
    QTRY_COMPARE(bench.page->list().count(), 2);
    bench.page->hide();
    bench.workbench.lines.clear();
    bench.workbench.shot.devices.push_back(bench.workbench.device(0));
    bench.workbench.device(1).id = {2};
    bench.workbench.device(1).selector = "sim:can/dmc60c:6";
    bench.workbench.book.matter = fail(Fault::LinkLost, say("the database is of a newer version"));
    bench.page->show();
    QTRY_VERIFY(!bench.workbench.lines.empty());
    QVERIFY(bench.workbench.lines.front().text.contains(QStringLiteral("newer version")));
    QCoreApplication::processEvents();
    QCOMPARE(bench.workbench.lines.size(), 1U);
}

MB_WINDOW_TEST(TestReportsPage);
#include "tst_reportspage.moc"
