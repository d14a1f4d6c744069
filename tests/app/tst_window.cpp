// SPDX-License-Identifier: GPL-3.0-or-later
// The whole program against simulated controllers: find, edit, plot, update.
#include "windowbench.h"

#include "app/statusbar.h"
#include "support/windowtests.h"
#include "widgets/common/segmented.h"
#include "widgets/common/stateglyph.h"
#include "widgets/connection/devicetree.h"
#include "widgets/connection/overviewpage.h"
#include "widgets/firmware/firmwarepage.h"
#include "widgets/firmware/unitupdate.h"
#include "widgets/monitor/logpage.h"
#include "widgets/parameters/parameterspage.h"
#include "widgets/plots/plotspage.h"

#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTreeView>

using namespace mb;
using namespace mb::test;

class WindowTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void pagesThatNobodyAskedForAreMadeOnceTheWindowIsPainted();
    void theScanFillsTheTree();
    void aTypedGainReachesTheDevice();
    void thePlotShowsSamplesOfTheDevice();
    void anUpdateEndsVerified();
    void anImageThatIsNoneStartsNothing();
    void aPageThatNeedsADeviceSaysSoAndAFileNeedsNone();
    void aTabNamesItsKeyAlsoOnceItCanBeUsed();
    void aDangerStandsUntilItIsRead();
};

void WindowTest::pagesThatNobodyAskedForAreMadeOnceTheWindowIsPainted()
{
    WindowBench bench;
    const auto made = [&bench](auto *page) { return bench.window().findChild<decltype(page)>() != nullptr; };
    QVERIFY(made(static_cast<OverviewPage *>(nullptr)));
    QVERIFY(!made(static_cast<PlotsPage *>(nullptr)));
    QVERIFY(!made(static_cast<FirmwarePage *>(nullptr)));
    bench.window().showPage(PageId::Firmware);
    QVERIFY(made(static_cast<FirmwarePage *>(nullptr)));
    QVERIFY(!made(static_cast<PlotsPage *>(nullptr)));
    QTRY_VERIFY_WITH_TIMEOUT(made(static_cast<PlotsPage *>(nullptr)), patience);
    QTRY_VERIFY_WITH_TIMEOUT(made(static_cast<LogPage *>(nullptr)), patience);
    QCOMPARE(bench.window().findChildren<FirmwarePage *>().size(), 1);
}

void WindowTest::theScanFillsTheTree()
{
    WindowBench bench;
    QTRY_VERIFY_WITH_TIMEOUT(bench.isFound(), patience);
    const QAbstractItemModel &model = *bench.part<DeviceTree>().findChild<QTreeView *>()->model();
    QVERIFY(model.rowCount() >= 1);
    const QModelIndex link = model.index(0, 0);
    QCOMPARE(link.data().toString(), QStringLiteral("sim:can"));
    QTRY_COMPARE_WITH_TIMEOUT(model.rowCount(link), static_cast<int>(WindowBench::benchSize), patience);
    const auto row = [&model, link](int at, int role) { return model.index(at, 0, link).data(role); };
    const QStringList titles{QStringLiteral("Abstract DC #3"), QStringLiteral("Abstract DC #4"),
        QStringLiteral("Abstract DC #5"), QStringLiteral("DMC60C #5"), QStringLiteral("DMC60C #7"),
        QStringLiteral("DMC60C #9")};
    for (int at = 0; at < titles.size(); ++at)
        QCOMPARE(row(at, Qt::DisplayRole).toString(), titles[at]);
    QCOMPARE(row(1, DeviceModel::BadgeRole).toString(), QStringLiteral("L"));
    QTRY_VERIFY_WITH_TIMEOUT(row(3, DeviceModel::LineRole).toString().contains(QStringLiteral("counts/s")), patience);
    QVERIFY(!row(3, DeviceModel::LineRole).toString().contains(QStringLiteral("DMC60C"))); // as its title says
    QCOMPARE(row(3, DeviceModel::GlyphRole).toInt(), static_cast<int>(GlyphState::Online));
    QCOMPARE(row(5, DeviceModel::GlyphRole).toInt(), static_cast<int>(GlyphState::Bootloader));
    QCOMPARE(row(5, DeviceModel::BadgeRole).toString(), QStringLiteral("boot"));
    QVERIFY(row(3, DeviceModel::BadgeRole).toString() != QStringLiteral("boot"));
}

void WindowTest::aTypedGainReachesTheDevice()
{
    WindowBench bench;
    QTRY_VERIFY_WITH_TIMEOUT(bench.isFound(), patience);
    bench.select(WindowBench::tuned);
    auto &page = bench.page<ParametersPage>(PageId::Parameters);
    QTRY_VERIFY_WITH_TIMEOUT(bench.isRead(WindowBench::tuned), patience);
    QTRY_VERIFY_WITH_TIMEOUT(page.model().edits(), patience);
    const auto gain = findParameter(page.model().family()->parameters, "slot1.p").value();
    page.view().setFocus();
    page.view().goTo(gain);
    QTest::keyClick(&page.view(), Qt::Key_Return);
    auto *field = page.view().viewport()->findChild<QLineEdit *>();
    QVERIFY(field);
    QTest::keyClicks(field, QStringLiteral("2.75"));
    QTest::keyClick(field, Qt::Key_Return);
    QCOMPARE(page.model().edits()->count(), 1);
    const std::int64_t wanted = static_cast<std::int64_t>(2.75 * 65536);
    QVERIFY(bench.parameter(WindowBench::tuned, "slot1.p").raw != wanted);
    page.write();
    QTRY_VERIFY_WITH_TIMEOUT(bench.parameter(WindowBench::tuned, "slot1.p").raw == wanted, patience);
    QTRY_COMPARE_WITH_TIMEOUT(page.model().edits()->count(), 0, patience);

    const DeviceId id = bench.device(WindowBench::tuned)->id; // what the program knows is not asked again
    const std::uint64_t revision = bench.device(WindowBench::tuned)->parameterRevision;
    bench.engine().post([id](EngineCore &core) {
        core.session().find(id)->parameters().forgetAll();
        core.send(orders::ReadParameters{id});
    });
    QTRY_VERIFY_WITH_TIMEOUT(bench.device(WindowBench::tuned)->parameterRevision > revision, patience);
    QTRY_VERIFY_WITH_TIMEOUT(bench.isRead(WindowBench::tuned), patience);
    QVERIFY(bench.parameter(WindowBench::tuned, "slot1.p").raw == wanted);
}

void WindowTest::thePlotShowsSamplesOfTheDevice()
{
    WindowBench bench;
    QTRY_VERIFY_WITH_TIMEOUT(bench.isFound(), patience);
    bench.select(WindowBench::tuned);
    auto &page = bench.page<PlotsPage>(PageId::Plots);
    QTRY_VERIFY_WITH_TIMEOUT(page.traceCount() == 4, patience);
    const auto samples = [&bench] { return bench.device(WindowBench::tuned)->telemetry->size({}); };
    QTRY_VERIFY_WITH_TIMEOUT(samples() > 100, patience);
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("seen.csv"));
    const auto drawn = [&page, &path] {
        QFile file(path);
        return page.stack().exporter().exportTo(path) && file.open(QIODevice::ReadOnly) ? file.readAll().count('\n')
                                                                                        : 0;
    };
    QTRY_VERIFY_WITH_TIMEOUT(drawn() > 50, patience);
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QByteArray head = file.readLine();
    while (head.startsWith('#'))
        head = file.readLine();
    QVERIFY2(head.startsWith("time_s,") && head.count(',') == 4, head.constData());
    for (const DeviceView &device : bench.engine().snapshot().devices)
        QCOMPARE(device.telemetry->lost({}), 0U);
}

void WindowTest::anUpdateEndsVerified()
{
    WindowBench bench;
    bench.beginUpdate();
    auto &page = bench.page<FirmwarePage>(PageId::Firmware);
    const auto report = [&bench]() -> const UpdateReport * {
        const OperationView *update = bench.engine().snapshot().operation(bench.device(WindowBench::inBootloader)->id);
        return update && update->update ? &*update->update : nullptr;
    };
    QTRY_VERIFY_WITH_TIMEOUT(report(), 2 * patience);
    QVERIFY(report()->outcome == UpdateOutcome::Done);
    QVERIFY(report()->verified);
    const auto says = [&page](const QString &start) {
        const auto labels = page.findChildren<QLabel *>();
        return std::any_of(labels.begin(), labels.end(), [&](const QLabel *l) { return l->text().startsWith(start); });
    };
    QTRY_VERIFY_WITH_TIMEOUT(says(QStringLiteral("Verified: ")), patience);
    const auto *progress = page.findChild<UnitUpdate *>()->findChild<QProgressBar *>();
    QCOMPARE(progress->value(), progress->maximum());
    QCOMPARE(progress->maximum(), 31);
    const auto now = [&bench] { return bench.device(WindowBench::inBootloader)->identity; };
    QTRY_VERIFY_WITH_TIMEOUT(now()->state == DeviceState::Online, patience);
    QCOMPARE(QString::fromStdString(now()->firmware), QStringLiteral("1.25"));
}

void WindowTest::anImageThatIsNoneStartsNothing()
{
    WindowBench bench;
    QTRY_VERIFY_WITH_TIMEOUT(bench.isFound(), patience);
    bench.select(WindowBench::inBootloader);
    auto &page = bench.page<FirmwarePage>(PageId::Firmware);
    for (const QString &path : {QStringLiteral(":/style.qss"), QStringLiteral("/"), QStringLiteral("/no/such/file")}) {
        page.loadImage(path);
        QVERIFY(!page.canStart());
        page.startUpdate();
    }
    page.loadImage(QStringLiteral(":/firmware/dmc60c-demo.hex"));
    QVERIFY(page.canStart());
    page.loadImage(QStringLiteral(":/style.qss"));
    QVERIFY2(!page.canStart(), "the image before must not be written in place of the bad one");
    const auto before = bench.engine().snapshot().time;
    QTRY_VERIFY_WITH_TIMEOUT(bench.engine().snapshot().time > before + std::chrono::milliseconds(200), patience);
    QVERIFY(!bench.engine().snapshot().operation(bench.device(WindowBench::inBootloader)->id));
}

void WindowTest::aPageThatNeedsADeviceSaysSoAndAFileNeedsNone()
{
    WindowBench bench;
    MainWindow &window = bench.window();
    QTRY_VERIFY_WITH_TIMEOUT(bench.isFound(), patience);
    window.showPage(PageId::Tune);
    for (const LinkView &link : bench.engine().snapshot().links)
        bench.engine().send(orders::CloseLink{link.address});
    QTRY_VERIFY_WITH_TIMEOUT(bench.engine().snapshot().devices.empty(), patience);
    QTRY_COMPARE_WITH_TIMEOUT(window.shownPage(), PageId::Overview, patience);
    QTest::keyClick(&window, Qt::Key_3, Qt::ControlModifier);
    QCOMPARE(window.shownPage(), PageId::Overview);
    QVERIFY(bench.engine().notices().back().text.contains(QStringLiteral("needs a device")));
    QTest::keyClick(&window, Qt::Key_2, Qt::ControlModifier);
    QSignalSpy changed(&bench.engine(), &Workbench::changed);
    QVERIFY(changed.wait(patience));
    QCOMPARE(window.shownPage(), PageId::Parameters);
    QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("unit.json")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(R"({"family":"dmc60c","parameters":{"slot1.p":{"value":2}}})");
    file.close();
    auto &page = bench.page<ParametersPage>(PageId::Parameters);
    page.openFile(file.fileName());
    QVERIFY(changed.wait(patience));
    QVERIFY(page.view().isVisible());
    QCOMPARE(countParameters(page.model()).changed, 1);
}

void WindowTest::aTabNamesItsKeyAlsoOnceItCanBeUsed()
{
    WindowBench bench;
    const PageTabs &tabs = bench.part<PageTabs>();
    QTRY_VERIFY_WITH_TIMEOUT(bench.isFound(), patience);
    QVERIFY2(tabs.tabToolTip(2).contains(QStringLiteral("Ctrl+3")), qPrintable(tabs.tabToolTip(2)));
}

void WindowTest::aDangerStandsUntilItIsRead()
{
    WindowBench bench;
    QTRY_VERIFY_WITH_TIMEOUT(bench.isFound(), patience);
    const auto says = [&bench](const char *words) {
        const auto labels = bench.part<StatusBar>().findChildren<QLabel *>();
        return std::any_of(labels.begin(), labels.end(),
            [words](const QLabel *label) { return label->text().contains(QLatin1String(words)); });
    };
    for (const bool byLog : {false, true}) {
        bench.engine().report(Severity::Danger, {}, QStringLiteral("the limits were not kept"));
        bench.engine().report(Severity::Info, {}, QStringLiteral("found something"));
        QVERIFY(says("found something"));
        bench.part<StatusBar>().findChild<QTimer *>(QStringLiteral("messageTime"))->start(0);
        QTRY_VERIFY_WITH_TIMEOUT(says("were not kept"), patience);
        if (byLog)
            bench.window().showPage(PageId::Log);
        else
            QTest::mouseClick(&bench.part<StatusBar>(), Qt::LeftButton);
        QVERIFY(!says("were not kept"));
        bench.engine().report(Severity::Info, {}, QStringLiteral("found something"));
        QVERIFY(says("found something"));
    }
    bench.engine().report(Severity::Danger, {}, QStringLiteral("the limits were not kept")); // on the page Log
    bench.window().showPage(PageId::Overview);
    QVERIFY(!says("were not kept"));
}

MB_WINDOW_TEST(WindowTest);
#include "tst_window.moc"
