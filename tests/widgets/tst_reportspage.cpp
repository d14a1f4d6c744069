// SPDX-License-Identifier: GPL-3.0-or-later
// What can be handed out about the units that are here: listed, searched, looked at, written.
#include "support/windowtests.h"
#include "tunebench.h"
#include "tuning/verdict.h"
#include "widgets/report/reportorder.h"
#include "widgets/report/reportspage.h"

#include <QFile>
#include <QLineEdit>
#include <QListWidget>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace mb;
using namespace mb::test;

namespace {

struct ReportBench {
    FakeWorkbench workbench;
    ThemeSource theme{darkTheme()};
    std::unique_ptr<ReportsPage> page;

    ReportBench()
    {
        workbench.shot.devices.push_back(tunableDrive(std::make_shared<Telemetry>(dmc60c().channels), 1, 5));
        workbench.device(0).selector = "sim:can/dmc60c:5";
        workbench.device(0).link = "sim:can";
        workbench.device(0).identity.serial = "2103343A79F2";
        ReportUnit unit;
        unit.family = &dmc60c();
        unit.identity = workbench.device(0).identity;
        unit.selector = workbench.device(0).selector;
        unit.simulated = true;
        unit.unit = tuning::unitOf(unit.identity, unit.selector, true);
        KeptTrial trial;
        trial.number = 17;
        trial.time = 1'718'100'000.0;
        trial.note = "before the new gearbox";
        unit.history.push_back(trial);
        workbench.book.matter = std::vector<ReportUnit>{unit};
        page = std::make_unique<ReportsPage>(workbench, theme, nullptr);
        page->resize(1208, 700);
        page->show();
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
};

void TestReportsPage::unitsAndTheirTrialsAreListed()
{
    ReportBench bench;
    QTRY_COMPARE(bench.page->list().count(), 2);
    QVERIFY(bench.page->list().item(0)->text().contains(QStringLiteral("2103343A79F2")));
    QVERIFY(bench.page->list().item(1)->text().contains(QStringLiteral("#17")));
}

void TestReportsPage::theSearchLeavesWhatItNames()
{
    ReportBench bench;
    QTRY_COMPARE(bench.page->list().count(), 2);
    bench.page->findChild<QLineEdit *>()->setText(QStringLiteral("GEARBOX"));
    QCOMPARE(bench.page->list().count(), 1);
    QVERIFY(bench.page->list().item(0)->text().contains(QStringLiteral("#17")));
}

void TestReportsPage::whatIsChosenIsLookedAt()
{
    ReportBench bench;
    QTRY_VERIFY2(bench.page->previewText().contains(QStringLiteral("2103343A79F2")),
        qPrintable(bench.page->previewText().left(400)));
}

void TestReportsPage::itIsWrittenAsItIsLookedAt()
{
    ReportBench bench;
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
    ReportsPage page(workbench, theme, nullptr);
    page.show();
    QCOMPARE(page.list().count(), 0);
    QVERIFY(!page.list().isVisible());
}

MB_WINDOW_TEST(TestReportsPage);
#include "tst_reportspage.moc"
