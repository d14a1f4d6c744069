// SPDX-License-Identifier: GPL-3.0-or-later
// What production shows beside its verdict: what must hold before a unit, what comes next, how many are in the journal.
#include "model/registry.h"
#include "support/fakeworkbench.h"
#include "support/utf8.h"
#include "support/windowtests.h"
#include "widgets/service/counttiles.h"
#include "widgets/service/journalcard.h"
#include "widgets/service/productionpage.h"
#include "widgets/service/unitchecks.h"
#include "widgets/service/verdictof.h"

#include <QApplication>
#include <QCheckBox>
#include <QTest>

using namespace mb;
using namespace mb::test;

namespace {

service::QueueRow sightRow(std::uint32_t id, service::RowState state, const char *serial)
{
    service::QueueRow row;
    row.id = id;
    row.state = state;
    row.visit.serial = serial;
    row.visit.time = 1000.0 + id;
    row.visit.seconds = 21.6;
    row.visit.from = "1.23";
    row.visit.to = "1.25";
    row.visit.parameters = 55;
    return row;
}

struct SightBench {
    FakeWorkbench workbench;
    ThemeSource theme{darkTheme()};
    std::unique_ptr<ProductionPage> page;

    SightBench()
    {
        LinkView link;
        link.address = "sim:can";
        link.name = "sim:can";
        link.state = LinkState::Open;
        workbench.shot.links.push_back(link);
        page = std::make_unique<ProductionPage>(workbench, families(), theme, nullptr);
        page->setSound(false);
        page->resize(1280, 748);
        page->show();
        QApplication::setActiveWindow(page.get());
    }
    void show(std::vector<service::QueueRow> rows, bool running = true) { workbench.serve(std::move(rows), running); }
};

} // namespace

class TestProductionSight : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void atTwiceTheFontKeysAndCountsStayInSight();
    void whatMustHoldBeforeAUnitIsShown();
    void whatComesNextIsSaidWithTheVerdict();
};

void TestProductionSight::atTwiceTheFontKeysAndCountsStayInSight()
{
    SightBench bench;
    auto &page = *bench.page;
    page.resize(1280, 490); // what a window of 1080 lines leaves, in units of twice the font
    QCoreApplication::processEvents();
    for (const QWidget *part :
        {static_cast<QWidget *>(page.findChild<CountTiles *>()),
            static_cast<QWidget *>(page.findChild<QCheckBox *>(s("sound"))), static_cast<QWidget *>(&page.verdict())}) {
        QVERIFY(part->isVisible());
        QVERIFY(page.rect().contains(QRect(part->mapTo(&page, QPoint()), part->size())));
    }
    QVERIFY(page.verdict().height() >= page.verdict().minimumSizeHint().height());
}

void TestProductionSight::whatMustHoldBeforeAUnitIsShown()
{
    SightBench bench;
    const auto &checks = *bench.page->findChild<UnitChecks *>();
    QVERIFY(checks.isVisible());
    QVERIFY2(checks.text().contains(s("sim:can is open")), qPrintable(checks.text()));
    QVERIFY(checks.text().contains(s("no unit answers yet")));
    QVERIFY(checks.text().contains(s("no motor turns")));
    DeviceView turning;
    turning.family = families().front();
    turning.link = "sim:can";
    turning.liveness.heard = true;
    turning.identity.edit().address = 5;
    turning.mayTurn = true;
    bench.workbench.shot.devices.push_back(turning);
    bench.workbench.publish();
    QVERIFY2(checks.text().contains(s("#5 may turn")), qPrintable(checks.text()));
    bench.workbench.shot.links.front().state = LinkState::Lost;
    bench.workbench.publish();
    QVERIFY2(checks.text().contains(s("no link is open")), qPrintable(checks.text()));
}

void TestProductionSight::whatComesNextIsSaidWithTheVerdict()
{
    SightBench bench;
    auto passed = sightRow(1, service::RowState::Passed, "A1");
    bench.show({passed});
    QCOMPARE(bench.page->verdict().verdict().next, s("Unplug, connect next"));
    QCOMPARE(bench.page->verdict().verdict().facts.front().note, s("it answers with it"));
    passed.visit.from = "1.25";
    bench.show({passed}, false);
    QVERIFY(!bench.page->verdict().verdict().hint.isEmpty());
    QCOMPARE(bench.page->verdict().verdict().facts.front().note, s("was there already"));
    passed.visit.unproved = true;
    bench.show({passed}, false);
    QCOMPARE(bench.page->verdict().verdict().facts.front().note, s("written, not proved"));
    bench.workbench.served.counts.passed = 3;
    bench.show({passed}, false);
    QVERIFY2(bench.page->findChild<JournalCard *>()->text().contains(s("3 units")),
        qPrintable(bench.page->findChild<JournalCard *>()->text()));
}

MB_WINDOW_TEST(TestProductionSight);
#include "tst_productionsight.moc"
