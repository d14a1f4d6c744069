// SPDX-License-Identifier: GPL-3.0-or-later
// Every page can be reached, read aloud and shown small or with large text; wrong arguments get one line.
#include "support/windowtests.h"
#include "windowbench.h"

#include "app/productionface.h"

#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QHeaderView>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QTabBar>
#include <QToolButton>

#include <set>

using namespace mb;
using namespace mb::test;

class FaceTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void everyControlHasAnAccessibleName();
    void nothingStandsBesideProduction();
    void everyPageIsPainted_data();
    void everyPageIsPainted();
    void badArgumentsGetOneLine_data();
    void badArgumentsGetOneLine();
    void goodArgumentsAreTaken();
};

namespace {

constexpr std::array pages{
    PageId::Overview, PageId::Parameters, PageId::Tune, PageId::Plots, PageId::Firmware, PageId::Bus, PageId::Log};

bool isControl(const QWidget &widget)
{
    if (qobject_cast<const QScrollBar *>(&widget) || qobject_cast<const QHeaderView *>(&widget)
        || widget.inherits("QTableCornerButton") || widget.objectName().startsWith(QStringLiteral("qt_")))
        return false; // Qt's own parts
    for (const QWidget *parent = widget.parentWidget(); parent; parent = parent->parentWidget()) {
        if (qobject_cast<const QComboBox *>(parent) || qobject_cast<const QAbstractSpinBox *>(parent)
            || qobject_cast<const QTabBar *>(parent))
            return false; // speaks through its parent
    }
    return qobject_cast<const QAbstractButton *>(&widget) || qobject_cast<const QLineEdit *>(&widget)
        || qobject_cast<const QComboBox *>(&widget) || qobject_cast<const QAbstractSlider *>(&widget)
        || qobject_cast<const QAbstractSpinBox *>(&widget) || qobject_cast<const QAbstractItemView *>(&widget)
        || qobject_cast<const QTabBar *>(&widget);
}

QString placeOf(const QWidget &widget)
{
    QString place;
    for (const QWidget *at = &widget; at; at = at->parentWidget())
        place.prepend(QLatin1Char('/') + QLatin1String(at->metaObject()->className()));
    return place.mid(place.indexOf(QStringLiteral("Page"))) + QLatin1Char(' ') + widget.toolTip();
}

} // namespace

void FaceTest::everyControlHasAnAccessibleName()
{
    WindowBench bench;
    QTRY_VERIFY_WITH_TIMEOUT(bench.isFound(), patience);
    bench.select(WindowBench::tuned);
    for (const PageId id : pages) {
        bench.window().showPage(id);
        QTRY_VERIFY_WITH_TIMEOUT(bench.window().page(id)->isVisible(), patience);
    }
    QStringList nameless;
    int controls = 0;
    for (QWidget *widget : bench.window().findChildren<QWidget *>()) {
        if (!isControl(*widget))
            continue;
        ++controls;
        const QAccessibleInterface *spoken = QAccessible::queryAccessibleInterface(widget);
        if (!spoken || spoken->text(QAccessible::Name).isEmpty())
            nameless += placeOf(*widget);
    }
    QVERIFY(controls > 60);
    QVERIFY2(nameless.isEmpty(), qPrintable(nameless.join(QLatin1Char('\n'))));
}

void FaceTest::nothingStandsBesideProduction()
{
    WindowBench bench;
    QTRY_VERIFY_WITH_TIMEOUT(bench.isFound(), patience);
    MainWindow &window = bench.window();
    auto *inspector = window.findChild<QDockWidget *>(QStringLiteral("inspectorDock"));
    QVERIFY(inspector->isVisible());
    window.production().show(true);
    window.showPage(PageId::Tune);
    window.showPage(PageId::Overview); // where the inspector belongs, behind the bench
    QVERIFY(!inspector->isVisible());
    QTest::keyClick(&window, Qt::Key_F10);
    QVERIFY(!inspector->isVisible());
    window.production().show(false);
    QVERIFY(inspector->isVisible());
    QTest::keyClick(&window, Qt::Key_F10);
    QVERIFY(!inspector->isVisible());
    window.production().show(true);
    window.production().show(false);
    QVERIFY(!inspector->isVisible()); // as somebody left it
}

void FaceTest::everyPageIsPainted_data()
{
    QTest::addColumn<double>("fontScale");
    QTest::newRow("normal text") << 1.0;
    QTest::newRow("text of twice the size") << 2.0;
}

void FaceTest::everyPageIsPainted()
{
    QFETCH(double, fontScale);
    WindowBench bench(fontScale);
    QTRY_VERIFY_WITH_TIMEOUT(bench.isFound(), patience);
    bench.select(WindowBench::tuned);
    std::vector<QImage> pictures;
    for (const PageId id : pages) {
        bench.window().showPage(id);
        const QImage picture = bench.window().grab().toImage();
        QCOMPARE(picture.size(), QSize(1280, 800));
        std::set<QRgb> colours;
        for (int y = 0; y < picture.height(); y += 3) {
            for (int x = 0; x < picture.width(); x += 3)
                colours.insert(picture.pixel(x, y));
        }
        QVERIFY2(colours.size() > 8, qPrintable(QStringLiteral("page %1").arg(static_cast<int>(id))));
        for (const QImage &other : pictures)
            QVERIFY(other != picture);
        pictures.push_back(picture);
    }
    for (const QWidget *safe :
        {static_cast<QWidget *>(&bench.part<Lamp>()), static_cast<QWidget *>(&bench.part<StopButton>())}) {
        QVERIFY(safe->isVisible());
        const QRect place(safe->mapTo(&bench.window(), QPoint()), safe->size());
        QVERIFY(bench.window().rect().contains(place));
        QVERIFY2(safe->width() >= safe->minimumSizeHint().width(), qPrintable(placeOf(*safe)));
    }
}

void FaceTest::badArgumentsGetOneLine_data()
{
    QTest::addColumn<QStringList>("arguments");
    const auto row = [](const QStringList &arguments) {
        QTest::newRow(qPrintable(arguments.join(QLatin1Char(' ')))) << arguments;
    };
    for (const char *text : {"--nonsense", "file.json", "--theme pink", "--theme", "--font-scale big", "--font-scale 0",
             "--font-scale nan", "--font-scale -1", "--font-scale 1e9", "--size 1280", "--size 0x0", "--size 1280x",
             "--size 1280x800x2", "--size axb", "--size 99999999x800", "--link nonsense", "--link foo:bar",
             "--link sim:nowhere", "--link socketcan:", "--link sim:can?loss", "--language xx"})
        row(QString::fromLatin1(text).split(QLatin1Char(' ')));
    row({QStringLiteral("--tour"), QString()});
}

void FaceTest::badArgumentsGetOneLine()
{
    QFETCH(QStringList, arguments);
    const auto options = Options::parse(QStringList(QStringLiteral("motorbench")) + arguments);
    QVERIFY(!options);
    QVERIFY(options.error().fault == Fault::OutOfRange || options.error().fault == Fault::Usage);
    const QString line = QString::fromStdString(options.error().text());
    QVERIFY(!line.isEmpty());
    QVERIFY2(!line.contains(QLatin1Char('\n')), qPrintable(line));
}

void FaceTest::goodArgumentsAreTaken()
{
    const auto options = Options::parse(
        {QStringLiteral("motorbench"), QStringLiteral("--demo"), QStringLiteral("--theme"), QStringLiteral("light"),
            QStringLiteral("--size"), QStringLiteral("1024x640"), QStringLiteral("--font-scale"), QStringLiteral("1.5"),
            QStringLiteral("--language"), QStringLiteral("de"), QStringLiteral("--link"),
            QStringLiteral("socketcan:can0"), QStringLiteral("--link"), QStringLiteral("sim:can?loss=0.1")});
    QVERIFY(options);
    QVERIFY(options->demo);
    QCOMPARE(options->theme, QStringLiteral("light"));
    QCOMPARE(options->fontScale, 1.5);
    QCOMPARE(options->links.size(), 2);
}

MB_WINDOW_TEST(FaceTest);
#include "tst_face.moc"
