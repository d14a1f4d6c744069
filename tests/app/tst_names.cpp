// SPDX-License-Identifier: GPL-3.0-or-later
// A device has one name in the window's log, whoever speaks of it: engine, pages, lamp.
#include "support/windowtests.h"
#include "widgets/common/devicetext.h"
#include "windowbench.h"

using namespace mb;
using namespace mb::test;

class NamesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aDeviceHasOneNameInTheLog();
};

void NamesTest::aDeviceHasOneNameInTheLog()
{
    WindowBench bench;
    QTRY_VERIFY_WITH_TIMEOUT(bench.isFound() && bench.device(0, "quadquad2drv"), patience);
    bench.select(WindowBench::tuned);
    bench.window().showPage(PageId::Parameters);
    QTRY_VERIFY_WITH_TIMEOUT(bench.isRead(WindowBench::tuned), patience);
    const DeviceView &unit = *bench.device(WindowBench::tuned);
    const ParameterIndex gain = *findParameter(unit.family->parameters, "slot1.p");
    bool written = false;
    bench.engine().send(
        orders::WriteParameters{unit.id, {{gain, 70000}}}, [&written](const Result<void> &) { written = true; });
    QTRY_VERIFY_WITH_TIMEOUT(written, patience);
    bench.arming().arm(bench.device(WindowBench::tuned)->id);
    bench.run();
    QTRY_VERIFY_WITH_TIMEOUT(bench.isOutputOn(), patience);
    bench.arming().stopAll(QStringLiteral("Esc"));
    QTRY_VERIFY_WITH_TIMEOUT(!bench.isOutputOn(), patience);
    bench.arming().arm(bench.device(WindowBench::inBootloader)->id); // which is refused, and said
    QStringList names{QString()};
    for (const LinkView &link : bench.engine().snapshot().links)
        names += QString::fromStdString(link.name);
    for (const DeviceView &device : bench.engine().snapshot().devices)
        names += titleOf(device);
    QStringList heads;
    for (const Notice &notice : bench.engine().notices()) {
        QVERIFY2(names.contains(notice.device), qPrintable(notice.device + QStringLiteral(": ") + notice.text));
        QVERIFY2(!notice.text.contains(QStringLiteral("/dmc60c:")), qPrintable(notice.text));
        heads += notice.device;
    }
    QVERIFY(heads.count(QStringLiteral("DMC60C #5")) >= 3); // found, written, armed …
    QVERIFY(heads.contains(QStringLiteral("DMC60C #9")));
}

MB_WINDOW_TEST(NamesTest);
#include "tst_names.moc"
