// SPDX-License-Identifier: GPL-3.0-or-later
// Nothing that may be under the mouse moves because the program has something to say.
#include "support/windowtests.h"
#include "widgets/common/noticestrip.h"
#include "widgets/common/segmented.h"
#include "widgets/connection/devicetree.h"
#include "widgets/start/guidestrip.h"
#include "windowbench.h"

#include <QTemporaryDir>

using namespace mb;
using namespace mb::test;

namespace {

/// Until what is seen of a page has kept its size for some pictures of the engine: values that come in may still bring or take a
/// scroll bar.
void waitUntilItRests(WindowBench &bench, PageId id)
{
    constexpr int still = 15;
    const QWidget &seen = *bench.window().page(id)->parentWidget();
    QSize size;
    int pictures = 0;
    const QObject here; // ends the connection, also where the wait fails
    QObject::connect(&bench.engine(), &Workbench::changed, &here, [&] {
        pictures = seen.size() == size ? pictures + 1 : 0;
        size = seen.size();
    });
    QTRY_VERIFY_WITH_TIMEOUT(pictures >= still, patience);
}

/// Counts what is laid out anew anywhere in the program.
class Layouts : public QObject {
public:
    Layouts() { qApp->installEventFilter(this); }
    int count = 0;

protected:
    bool eventFilter(QObject * /*watched*/, QEvent *event) override
    {
        count += event->type() == QEvent::LayoutRequest ? 1 : 0;
        return false;
    }
};

} // namespace

class StillTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void noticesMoveNothing_data();
    void noticesMoveNothing();
    void openingTheSimulatedBenchMovesNoFrame();
    void aPageWithNothingNewIsNotLaidOutAnew_data();
    void aPageWithNothingNewIsNotLaidOutAnew();
};

void StillTest::noticesMoveNothing_data()
{
    QTest::addColumn<double>("fontScale");
    QTest::newRow("normal text") << 1.0;
    QTest::newRow("text of twice the size") << 2.0;
}

void StillTest::noticesMoveNothing()
{
    QFETCH(double, fontScale);
    WindowBench bench(fontScale);
    QTRY_VERIFY_WITH_TIMEOUT(bench.isFound(), patience);
    bench.select(WindowBench::tuned);
    auto &banners = bench.part<NoticeStrip>().banners();
    const QString words = QStringLiteral("words that go on and on ").repeated(30);
    for (const PageId id : {PageId::Overview, PageId::Parameters, PageId::Plots, PageId::Firmware, PageId::Bus}) {
        bench.window().showPage(id);
        QTRY_VERIFY_WITH_TIMEOUT(id != PageId::Parameters || bench.isRead(WindowBench::tuned), patience);
        const auto *page = bench.window().page(id);
        waitUntilItRests(bench, id);
        const QPoint corner = page->mapTo(&bench.window(), QPoint());
        const QPoint tabs = bench.part<PageTabs>().mapTo(&bench.window(), QPoint());
        const QPoint tree = bench.part<DeviceTree>().mapTo(&bench.window(), QPoint());
        const QSize size = page->parentWidget()->size(); // what is seen of it
        for (int round = 0; round < 2; ++round) {
            for (const char *key : {"a", "b", "c"}) {
                if (round == 0)
                    banners.post(QLatin1String(key), BannerKind::Danger, words, words, QStringLiteral("Do it"));
                else
                    banners.clear(QLatin1String(key));
                QCoreApplication::processEvents();
                QCOMPARE(page->mapTo(&bench.window(), QPoint()), corner);
                QCOMPARE(page->parentWidget()->size(), size);
                QCOMPARE(bench.part<PageTabs>().mapTo(&bench.window(), QPoint()), tabs);
                QCOMPARE(bench.part<DeviceTree>().mapTo(&bench.window(), QPoint()), tree);
            }
        }
    }
}

void StillTest::openingTheSimulatedBenchMovesNoFrame()
{
    Options options;
    options.size = QStringLiteral("1280x800");
    options.language = QStringLiteral("en");
    Application application(*qApp, options);
    MainWindow &window = application.window();
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    QCoreApplication::processEvents();
    QVERIFY(window.findChild<DemoStripe *>()->isEmpty());
    const auto frames = [&window] {
        QCoreApplication::processEvents();
        QString places;
        for (const QWidget *part : std::initializer_list<const QWidget *>{
                 window.findChild<PageTabs *>(), window.findChild<DeviceTree *>(), window.page(PageId::Overview)}) {
            const QPoint at = part->mapTo(&window, QPoint());
            places += QStringLiteral("%1 %2, ").arg(at.x()).arg(at.y());
        }
        return places;
    };
    const QString before = frames();
    LinkAddress address;
    address.scheme = "sim";
    application.engine().send(orders::OpenLink{address});
    QTRY_VERIFY_WITH_TIMEOUT(!window.findChild<DemoStripe *>()->isEmpty(), patience);
    QCOMPARE(frames(), before);
}

void StillTest::aPageWithNothingNewIsNotLaidOutAnew_data()
{
    QTest::addColumn<QSize>("size");
    QTest::addColumn<double>("fontScale");
    QTest::newRow("normal text") << QSize(1280, 800) << 1.0;
    QTest::newRow("larger text") << QSize(1440, 900) << 1.2;
}

/// Motors at rest: what a picture of the engine brings is a few figures of other widths.
void StillTest::aPageWithNothingNewIsNotLaidOutAnew()
{
    QFETCH(QSize, size);
    QFETCH(double, fontScale);
    const QTemporaryDir config; // of a newcomer
    qputenv("XDG_CONFIG_HOME", config.path().toUtf8());
    WindowBench bench(fontScale);
    QTRY_VERIFY_WITH_TIMEOUT(bench.isFound(), patience);
    bench.window().resize(size);
    int pictures = 0;
    connect(&bench.engine(), &Workbench::changed, this, [&pictures] { ++pictures; });
    const auto look = [&](PageId id) {
        waitUntilItRests(bench, id);
        Layouts layouts;
        pictures = 0;
        QTRY_VERIFY_WITH_TIMEOUT(pictures >= 10, patience);
        const int each = layouts.count / pictures;
        qInfo("page %d: %d layouts a picture", static_cast<int>(id), each);
        QVERIFY2(each < 40, qPrintable(QString::number(each)));
    };
    QVERIFY(bench.window().findChild<GuideStrip *>(QStringLiteral("guideOffer"))->isVisible());
    look(PageId::Overview);
    bench.select(WindowBench::tuned);
    for (int page = 0; page <= static_cast<int>(PageId::Reports) && !QTest::currentTestFailed(); ++page) {
        const auto id = static_cast<PageId>(page);
        bench.window().showPage(id);
        QTRY_VERIFY_WITH_TIMEOUT(id != PageId::Parameters || bench.isRead(WindowBench::tuned), patience);
        look(id);
    }
}

MB_WINDOW_TEST(StillTest);
#include "tst_still.moc"
