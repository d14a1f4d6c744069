// SPDX-License-Identifier: GPL-3.0-or-later
// The queue of the page Firmware over units with trouble, on the program's own engine.
#include "support/windowtests.h"
#include "unitbench.h"

using namespace mb;
using namespace mb::test;
using service::RowState;

namespace {

constexpr int queuePatience = 120000;

} // namespace

class UnitQueueTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aDuplicateAndWrongHardwareAreRefusedInTheirRowsAndTheRestGoesOn();
};

void UnitQueueTest::aDuplicateAndWrongHardwareAreRefusedInTheirRowsAndTheRestGoesOn()
{
    UnitBench bench("dmc60c",
        {"dmc60c:5,serial=210334000001,firmware=1.23", "dmc60c:6,serial=210334000002,session=0x1111",
            "dmc60c:6,serial=210334000003,session=0x2222", "dmc60c:7,serial=210334000004,product=601",
            "dmc60c:8,serial=210334000005,firmware=1.23"});
    bench.open("sim:can");
    QTRY_COMPARE_WITH_TIMEOUT(bench.found(), std::size_t(5), queuePatience);
    QVERIFY(bench.board().openImage(QStringLiteral(":/firmware/dmc60c-demo.hex")));
    bench.board().model().tickAll(true);
    QTRY_VERIFY_WITH_TIMEOUT(bench.board().canStart(), queuePatience);
    bench.board().start();
    QTRY_COMPARE_WITH_TIMEOUT(bench.in(RowState::Passed).size(), std::size_t(2), queuePatience);
    QTRY_VERIFY_WITH_TIMEOUT(!bench.engine->service().running, queuePatience);
    const auto refused = bench.in(RowState::Refused);
    QCOMPARE(refused.size(), std::size_t(3));
    for (const QueueLine &line : refused) {
        QCOMPARE(line.step, QStringLiteral("refused before start"));
        const bool isOther = line.serial == QLatin1String("210334000004");
        QVERIFY2(line.result.contains(QLatin1String(isOther ? "product 601" : "several units answer as number 6")),
            qPrintable(line.result));
    }
    QStringList served;
    for (const QueueLine &line : bench.in(RowState::Passed))
        served << line.serial;
    QCOMPARE(served, QStringList({QStringLiteral("210334000001"), QStringLiteral("210334000005")}));
}

MB_WINDOW_TEST(UnitQueueTest);
#include "tst_unitqueue.moc"
