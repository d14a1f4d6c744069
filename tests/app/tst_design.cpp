// SPDX-License-Identifier: GPL-3.0-or-later
// From a unit that overshoots to proven gains by one key, with the real window, engine and simulated controllers.
#include "support/windowtests.h"
#include "widgets/design/designpage.h"
#include "widgets/design/proposalcard.h"
#include "windowbench.h"

#include <QDir>

using namespace mb;
using namespace mb::test;

class DesignTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void oneKeyTamesTheUnitThatOvershoots();
};

namespace {

constexpr int lively = 7;
constexpr int tuningTime = 90000; ///< ms

} // namespace

void DesignTest::oneKeyTamesTheUnitThatOvershoots()
{
    WindowBench bench;
    QTRY_VERIFY_WITH_TIMEOUT(bench.isFound() && bench.device(lively)->liveness.heard, patience);
    bench.select(lively);
    auto &page = bench.page<DesignPage>(PageId::Design);
    QVERIFY(!page.report());
    QTest::keyClick(&page, Qt::Key_F6);
    QVERIFY2(!bench.arming().isMoving(), "nothing moves before it is armed");
    bench.arming().arm(bench.device(lively)->id);
    QTest::keyClick(&page, Qt::Key_F6);
    QTRY_VERIFY_WITH_TIMEOUT(bench.arming().isOnTrial(), patience);
    QTRY_VERIFY_WITH_TIMEOUT(page.report(), tuningTime);
    const QString folder = qEnvironmentVariable("MOTORBENCH_PICTURES");
    QTRY_VERIFY(!bench.part<ProposalCard>().visibleRegion().isEmpty());
    if (!folder.isEmpty()) {
        bench.window().resize(1440, 900);
        QCoreApplication::processEvents();
        bench.window().grab().save(QDir(folder).filePath(QStringLiteral("design.png")));
    }
    QVERIFY2(page.report()->result == tuning::TuneResult::Kept, page.report()->evidence.english().c_str());
    const double overshoot = page.report()->measured.overshoot.value_or(1.0);
    QVERIFY2(overshoot <= 0.05, qPrintable(QString::number(overshoot)));
    QCOMPARE(page.report()->proposals.size(), std::size_t(3));
    QVERIFY2(bench.arming().isArmed(bench.device(lively)->id), "armed as before");
    QVERIFY(!bench.isOutputOn());
}

MB_WINDOW_TEST(DesignTest);
#include "tst_design.moc"
