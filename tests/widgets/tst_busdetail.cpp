// SPDX-License-Identifier: GPL-3.0-or-later
// Which frame the detail of the Bus page shows.
#include "buspagebench.h"
#include "support/windowtests.h"
#include "widgets/monitor/framedetail.h"
#include "widgets/monitor/framemodel.h"

#include <QLabel>

using namespace mb;
using namespace mb::test;

class BusDetailTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void theDetailShowsNoFrameThatNobodyChose();
};

void BusDetailTest::theDetailShowsNoFrameThatNobodyChose()
{
    BusBench bench;
    bench.traffic.add(controlOf5);
    bench.traffic.add(generalOf7);
    bench.publish();
    auto *table = bench.named<TrafficView>("Frames");
    table->selectRow(0);
    const auto detail = [&bench] {
        QStringList words;
        for (const QLabel *label : bench.page->findChild<FrameDetail *>()->findChildren<QLabel *>())
            words << label->text();
        return words.join(QLatin1Char('|'));
    };
    const QString before = detail();
    const QString copied = bench.page->selectedText();
    QVERIFY2(copied.contains(QStringLiteral("02060005#")), qPrintable(copied));
    for (std::size_t i = 0; i <= FrameModel::keptRows; ++i) {
        bench.traffic.add(generalOf5);
        if (i % 10'000 == 0)
            bench.page->tick();
    }
    bench.page->tick();
    QCOMPARE(bench.page->model().rowCount(), static_cast<int>(FrameModel::keptRows));
    QVERIFY(bench.page->model().skipped() == 0);
    QCOMPARE(detail(), before); // its row is gone
    bench.page->bar().setFilterText(QStringLiteral("device:7"));
    QCOMPARE(detail(), before);
    QCOMPARE(bench.page->selectedText(), copied);
    LinkView another = canLink(std::make_shared<TrafficLog>());
    another.address = another.name = "sim:other";
    bench.workbench.shot.links.push_back(another);
    bench.page->showLink(another.address);
    QVERIFY2(detail().contains(QStringLiteral("No frame selected")), qPrintable(detail()));
    QCOMPARE(bench.page->selectedText(), QString());
}

MB_WINDOW_TEST(BusDetailTest);
#include "tst_busdetail.moc"
