// SPDX-License-Identifier: GPL-3.0-or-later
#include "plotbench.h"
#include "support/windowtests.h"
#include "widgets/common/paintbudget.h"

#include <QTimer>

using namespace mb;
using namespace mb::test;

/// Makes every drawing of a plot expensive, and counts those that came sooner after the one before than that had taken.
class SlowPainting : public QObject {
public:
    explicit SlowPainting(QWidget &plot) { plot.installEventFilter(this); }
    int paintings = 0;
    int early = 0;

protected:
    bool eventFilter(QObject *, QEvent *event) override
    {
        if (event->type() != QEvent::Paint)
            return false;
        const auto begun = PaintBudget::Clock::now();
        early += m_others.isDue(begun) ? 0 : 1;
        ++paintings;
        auto now = begun;
        while (now < begun + 25ms)
            now = PaintBudget::Clock::now();
        m_others.spend(begun, now);
        return false;
    }

private:
    PaintBudget m_others;
};

class PaintBudgetTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aDrawingIsFollowedByAsMuchTimeForOthers();
    void whatIsPartOfADrawingIsNotPaidTwice();
    void anExpensivePlotLeavesHalfOfTheThreadToOthers();
};

void PaintBudgetTest::aDrawingIsFollowedByAsMuchTimeForOthers()
{
    const PaintBudget::Clock::time_point begun(100s);
    PaintBudget budget;
    QVERIFY(budget.isDue(begun));
    budget.spend(begun, begun + 12ms);
    QVERIFY(!budget.isDue(begun + 23ms));
    QCOMPARE(budget.wait(begun + 14ms).count(), PaintBudget::Clock::duration(10ms).count());
    QVERIFY(budget.isDue(begun + 24ms));
    QCOMPARE(budget.wait(begun + 30ms).count(), PaintBudget::Clock::duration::zero().count());
}

void PaintBudgetTest::whatIsPartOfADrawingIsNotPaidTwice()
{
    const PaintBudget::Clock::time_point begun(100s);
    PaintBudget budget;
    budget.spend(begun + 2ms, begun + 8ms); // the part ends first
    budget.spend(begun, begun + 10ms);
    QVERIFY(!budget.isDue(begun + 19ms));
    QVERIFY(budget.isDue(begun + 20ms));
}

void PaintBudgetTest::anExpensivePlotLeavesHalfOfTheThreadToOthers()
{
    PlotBench bench;
    bench.pass(0.1, 1000.0);
    auto *plot = bench.stack().findChild<PlotFrame *>();
    QVERIFY(plot);
    SlowPainting painting(*plot);
    QTimer data; // something new for every tick
    QObject::connect(&data, &QTimer::timeout, [&] {
        bench.recording.run(0.02, 1000.0);
        bench.workbench.time = bench.recording.now();
    });
    data.start(5);
    QTRY_VERIFY_WITH_TIMEOUT(painting.paintings >= 20, 60'000);
    QCOMPARE(painting.early, 0);
}

MB_WINDOW_TEST(PaintBudgetTest);
#include "tst_paintbudget.moc"
