// SPDX-License-Identifier: GPL-3.0-or-later
// Small screens: whatever gives way, the lamp and STOP do not.
#include "support/windowtests.h"
#include "widgets/connection/devicetree.h"
#include "windowbench.h"

#include <QAbstractScrollArea>
#include <QDir>
#include <QScreen>
#include <QTemporaryDir>
#include <QToolButton>

using namespace mb;
using namespace mb::test;

class SizeTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void lampAndStopAreWholeOnSmallScreens_data();
    void lampAndStopAreWholeOnSmallScreens();
    void theLeastWindowKeepsThemAndGivesTheDevicesBack();
    void besideLargeTextTheDevicesComeOverThePage();
    void aWindowThatDoesNotFitWithItsFrameTakesTheScreen();
};

namespace {

constexpr std::array allPages{
    PageId::Overview, PageId::Parameters, PageId::Tune, PageId::Plots, PageId::Firmware, PageId::Bus, PageId::Log};

QByteArray sized(QSize size)
{
    return QByteArray::number(size.width()) + 'x' + QByteArray::number(size.height());
}

void verifyWhole(const QWidget &safe, const MainWindow &window)
{
    const QRect place(safe.mapTo(&window, QPoint()), safe.size());
    QVERIFY(safe.isVisible());
    QVERIFY2(window.rect().contains(place),
        QByteArray(safe.metaObject()->className()) + " ends at " + QByteArray::number(place.right()));
    QVERIFY(safe.width() >= safe.minimumSizeHint().width() && safe.height() >= safe.minimumSizeHint().height());
}

/// For looking at it, where MOTORBENCH_PICTURES names a folder.
void keepPictureOfPage(MainWindow &window, const QByteArray &row, PageId id)
{
    const QString folder = qEnvironmentVariable("MOTORBENCH_PICTURES");
    if (folder.isEmpty() || id != PageId::Tune)
        return;
    const QString name = QString::fromLatin1(row).remove(QLatin1Char(',')).replace(QLatin1Char(' '), QLatin1Char('-'));
    window.grab().save(QDir(folder).filePath(name + QStringLiteral(".png")));
}

} // namespace

void SizeTest::lampAndStopAreWholeOnSmallScreens_data()
{
    QTest::addColumn<QSize>("size");
    QTest::addColumn<double>("pixels"); // of the device, for one of the window's
    QTest::addColumn<double>("fontScale");
    for (const QSize screen : {QSize(1366, 768), QSize(1280, 800), QSize(1024, 600)}) {
        for (const int dpi : {96, 144, 192}) {
            const double scale = dpi / 96.0;
            const QByteArray name = sized(screen) + " at " + QByteArray::number(dpi) + " dpi, ";
            QTest::newRow(name + "scaled by the screen") << QSize(screen / scale) << scale << 1.0;
            QTest::newRow(name + "scaled by the font") << screen << 1.0 << scale;
        }
    }
}

void SizeTest::lampAndStopAreWholeOnSmallScreens()
{
    QFETCH(QSize, size);
    QFETCH(double, pixels);
    QFETCH(double, fontScale);
    WindowBench bench(fontScale);
    MainWindow &window = bench.window();
    QTRY_VERIFY_WITH_TIMEOUT(bench.isFound(), patience);
    bench.select(WindowBench::tuned);
    bench.arming().arm(bench.device(WindowBench::tuned)->id);
    bench.arming().stopAll(QStringLiteral("Esc"));
    window.resize(size);
    for (const PageId id : allPages) {
        window.showPage(id);
        QCoreApplication::processEvents();
        const QSize least = window.minimumSizeHint().expandedTo(window.minimumSize());
        QVERIFY2(least.width() <= size.width() && least.height() <= size.height(),
            sized(least) + " are needed on page " + QByteArray::number(static_cast<int>(id)));
        QCOMPARE(window.size(), size);
        keepPictureOfPage(window, QTest::currentDataTag(), id);
        verifyWhole(bench.part<Lamp>(), window);
        verifyWhole(bench.part<StopButton>(), window);
        QVERIFY(bench.part<StopButton>().width() * pixels >= 160.0);
        QVERIFY(!bench.part<Lamp>().geometry().intersects(bench.part<StopButton>().geometry()));
    }
    window.showPage(PageId::Tune);
    bench.part<Lamp>().setStatus({LampState::MayTurn, QStringLiteral("#7: cut its power"), {}, false});
    QCoreApplication::processEvents();
    keepPictureOfPage(window, QByteArray("may turn, ") + QTest::currentDataTag(), PageId::Tune);
    verifyWhole(bench.part<Lamp>(), window);
}

void SizeTest::theLeastWindowKeepsThemAndGivesTheDevicesBack()
{
    WindowBench bench;
    MainWindow &window = bench.window();
    QTRY_VERIFY_WITH_TIMEOUT(bench.isFound(), patience);
    const auto &tree = bench.part<DeviceTree>();
    const int before = tree.width();
    window.resize(1, 1);
    QCoreApplication::processEvents();
    verifyWhole(bench.part<Lamp>(), window);
    verifyWhole(bench.part<StopButton>(), window);
    window.resize(1280, 800);
    QCoreApplication::processEvents();
    QCOMPARE(tree.width(), before);
}

void SizeTest::besideLargeTextTheDevicesComeOverThePage()
{
    WindowBench bench(2.0);
    MainWindow &window = bench.window();
    QTRY_VERIFY_WITH_TIMEOUT(bench.isFound(), patience);
    const auto &tree = bench.part<DeviceTree>();
    const QWidget &pages = *window.centralWidget();
    QVERIFY(!tree.isVisible());
    QCOMPARE(pages.width(), window.width());
    auto *show = window.findChild<QToolButton *>(QStringLiteral("showDevices"));
    QVERIFY(show->isVisible());
    for (const bool byKey : {true, false}) {
        byKey ? QTest::keyClick(&window, Qt::Key_F9) : show->click();
        QVERIFY(tree.isVisible());
        QVERIFY(tree.isAncestorOf(QApplication::focusWidget()));
        QCOMPARE(pages.width(), window.width());
        QTest::mouseClick(window.page(PageId::Overview), Qt::LeftButton);
        QVERIFY(!tree.isVisible());
    }
    window.resize(2560, 1600);
    QCoreApplication::processEvents();
    QVERIFY(tree.isVisible());
    QVERIFY(pages.width() < window.width());
    QVERIFY(!show->isVisible());
}

void SizeTest::aWindowThatDoesNotFitWithItsFrameTakesTheScreen()
{
    const QTemporaryDir config; // no window was kept
    qputenv("XDG_CONFIG_HOME", config.path().toUtf8());
    Application application(*qApp, Options());
    const MainWindow &window = application.window();
    const QSize room = window.screen()->availableSize();
    QVERIFY(room.width() < 1440); // of the platform that draws nowhere
    QVERIFY(window.isMaximized());
    QVERIFY(window.normalGeometry().width() <= room.width() && window.normalGeometry().height() < room.height());
}

MB_WINDOW_TEST(SizeTest);
#include "tst_size.moc"
