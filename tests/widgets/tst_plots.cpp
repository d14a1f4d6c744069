// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plotstack.h"

#include <QPdfWriter>
#include <QSignalSpy>
#include <QSvgRenderer>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

using namespace mb;

namespace {

QString s(const char *text)
{
    return QString::fromUtf8(text);
}

/// Counts how often it is asked.
class Counting : public TraceSource {
public:
    void columns(double from, double to, int pixels, std::vector<PlotPoint> &points) const override
    {
        ++asked;
        lastPixels = pixels;
        points = {{from, 1.0}, {to, 2.0}};
    }
    std::optional<double> latest() const override { return 2.0; }
    QString foot() const override { return s("100 Hz, 0 of 6400 lost"); }
    mutable int asked = 0;
    mutable int lastPixels = 0;
};

std::vector<PlotPoint> flatWithSpike(int count, int spikeAt, double spike)
{
    std::vector<PlotPoint> points;
    for (int i = 0; i < count; ++i)
        points.push_back({i * 1.0 / count, i == spikeAt ? spike : 0.0});
    return points;
}

std::unique_ptr<PlotStack> shownStack(const ThemeSource &theme)
{
    auto stack = std::make_unique<PlotStack>(theme);
    stack->resize(600, 300);
    stack->show();
    return stack;
}

int pixelsNear(const QImage &image, const QColor &color)
{
    int found = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const QColor c = image.pixelColor(x, y);
            const int distance = std::abs(c.red() - color.red()) + std::abs(c.green() - color.green())
                + std::abs(c.blue() - color.blue());
            found += distance < 40 ? 1 : 0;
        }
    }
    return found;
}

} // namespace

class PlotsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aSpikeBetweenTwoPixelsIsDrawn();
    void nothingIsFetchedWhileHidden();
    void liveFollowsThePresentByWholeColumns();
    void pausedStaysWhereItIs();
    void aGapAtThePresentEndsNow();
    void clearingLeavesAUsablePlot();
    void cursorsReadTheTrace();
    void keysZoomPauseAndFit();
    void exportsReadableFiles();
    void anUnknownSuffixOrFolderFails();
    void tableHasOneColumnPerTraceAndBlanksInGaps();
    void summarySpeaksOfEveryTrace();

private:
    ThemeSource m_theme{darkTheme()};
};

void PlotsTest::aSpikeBetweenTwoPixelsIsDrawn()
{
    // One of 200 000 samples is high: 1/400 of a pixel column.
    const auto stack = shownStack(m_theme);
    stack->addTrace({s("v"), s("rpm"), TraceRole::Velocity, 0, TraceDash::Automatic, TraceMarker::None},
        std::make_shared<FixedTrace>(flatWithSpike(200'000, 123'457, 1000.0)));
    stack->setRange(0, 1);
    stack->setValueRange(0, std::pair(-100.0, 1100.0));
    stack->refresh(0);
    const int withSpike = pixelsNear(stack->plot().toPixmap().toImage(), m_theme.theme().trace(TraceRole::Velocity));
    const auto flat = shownStack(m_theme);
    flat->addTrace({s("v"), s("rpm"), TraceRole::Velocity, 0, TraceDash::Automatic, TraceMarker::None},
        std::make_shared<FixedTrace>(flatWithSpike(200'000, -1, 0.0)));
    flat->setRange(0, 1);
    flat->setValueRange(0, std::pair(-100.0, 1100.0));
    flat->refresh(0);
    const int withoutSpike = pixelsNear(flat->plot().toPixmap().toImage(), m_theme.theme().trace(TraceRole::Velocity));
    QVERIFY2(withSpike > withoutSpike + 100, qPrintable(QStringLiteral("%1 %2").arg(withSpike).arg(withoutSpike)));
}

void PlotsTest::nothingIsFetchedWhileHidden()
{
    PlotStack stack(m_theme);
    stack.resize(600, 300);
    const auto source = std::make_shared<Counting>();
    stack.addTrace({s("v"), s("rpm"), TraceRole::Velocity, 0}, source);
    for (int i = 0; i < 10; ++i)
        stack.refresh(i);
    QCoreApplication::processEvents();
    QCOMPARE(source->asked, 0);
    stack.show();
    stack.refresh(11);
    QVERIFY(source->asked > 0);
    QVERIFY(source->lastPixels > 100);
}

void PlotsTest::liveFollowsThePresentByWholeColumns()
{
    const auto stack = shownStack(m_theme);
    const auto source = std::make_shared<Counting>();
    stack->addTrace({s("v"), s("rpm"), TraceRole::Velocity, 0}, source);
    stack->setWindow(60);
    stack->refresh(100);
    QCoreApplication::processEvents();
    stack->refresh(100);
    QVERIFY(stack->range().second >= 100 && stack->range().second < 100.5);
    QCOMPARE(stack->range().second - stack->range().first, 60.0);
    const int asked = source->asked;
    stack->refresh(stack->range().second - 1e-6); // less than a pixel later
    QCOMPARE(source->asked, asked);
    stack->refresh(102);
    QCOMPARE(source->asked, asked + 1);
}

void PlotsTest::pausedStaysWhereItIs()
{
    const auto stack = shownStack(m_theme);
    const auto source = std::make_shared<Counting>();
    stack->addTrace({s("v"), s("rpm"), TraceRole::Velocity, 0}, source);
    QSignalSpy live(stack.get(), &PlotStack::liveChanged);
    stack->setRange(3, 5);
    QCOMPARE(live.count(), 1);
    stack->refresh(100);
    const int asked = source->asked;
    stack->refresh(200);
    QCOMPARE(source->asked, asked);
    QCOMPARE(stack->range(), std::make_pair(3.0, 5.0));
}

void PlotsTest::aGapAtThePresentEndsNow()
{
    const auto stack = shownStack(m_theme);
    std::vector<PlotPoint> points{{0, 1}, {1, 2}, PlotPoint::gap(1.0)};
    stack->addTrace({s("v"), s("rpm"), TraceRole::Velocity, 0}, std::make_shared<FixedTrace>(points));
    stack->setWindow(10);
    stack->refresh(5);
    const QImage image = stack->plot().toPixmap().toImage();
    QVERIFY(stack->summary().contains(s("1 gap")));
    QVERIFY(pixelsNear(image, m_theme.theme().caution) > 5);
}

void PlotsTest::clearingLeavesAUsablePlot()
{
    const auto stack = shownStack(m_theme);
    for (int round = 0; round < 3; ++round) {
        const int first = stack->addTrace({s("v"), s("rpm"), TraceRole::Velocity, 0}, std::make_shared<Counting>());
        stack->addTrace({s("c"), s("A"), TraceRole::Current, 2}, std::make_shared<Counting>());
        stack->setSource(first, std::make_shared<Counting>());
        stack->refresh(10 + round);
        QCOMPARE(stack->traceCount(), 2);
        stack->removeTrace(first);
        QCOMPARE(stack->traceCount(), 1);
        stack->clear();
        QCOMPARE(stack->traceCount(), 0);
        stack->refresh(10.5 + round);
    }
    QCOMPARE(stack->plot().axisRectCount(), 0);
}

void PlotsTest::cursorsReadTheTrace()
{
    const auto stack = shownStack(m_theme);
    const int trace = stack->addTrace({s("v"), s("rpm"), TraceRole::Velocity, 0},
        std::make_shared<FixedTrace>(std::vector<PlotPoint>{{0, 0}, {3, 30}}));
    stack->setRange(0, 3);
    stack->refresh(0);
    QSignalSpy changed(stack.get(), &PlotStack::cursorsChanged);
    stack->setCursorsShown(true);
    QCOMPARE(changed.count(), 1);
    const auto [a, b] = stack->cursorKeys();
    QCOMPARE(stack->valueAt(trace, a), 10.0);
    QCOMPARE(stack->valueAt(trace, b), 20.0);
}

void PlotsTest::keysZoomPauseAndFit()
{
    const auto stack = shownStack(m_theme);
    stack->addTrace({s("v"), s("rpm"), TraceRole::Velocity, 0},
        std::make_shared<FixedTrace>(std::vector<PlotPoint>{{0, 0}, {3, 30}}));
    stack->refresh(50);
    const double window = stack->window();
    QTest::keyClick(stack.get(), Qt::Key_Plus);
    QVERIFY(stack->window() < window);
    QVERIFY(stack->isLive());
    QTest::keyClick(stack.get(), Qt::Key_P);
    QVERIFY(!stack->isLive());
    QTest::keyClick(stack.get(), Qt::Key_0);
    QCOMPARE(stack->range(), std::make_pair(0.0, 3.0));
    QTest::keyClick(stack.get(), Qt::Key_L);
    QVERIFY(stack->cursorsShown());
    QTest::keyClick(stack.get(), Qt::Key_End);
    QVERIFY(stack->isLive());
}

void PlotsTest::exportsReadableFiles()
{
    const QTemporaryDir folder;
    const auto stack = shownStack(m_theme);
    stack->addTrace(
        {s("v"), s("rpm"), TraceRole::Velocity, 0}, std::make_shared<FixedTrace>(flatWithSpike(1000, 500, 10)));
    stack->setWatermark(s("DEMO"));
    stack->setRange(0, 1);
    stack->refresh(0);
    QSignalSpy exported(stack.get(), &PlotStack::exported);
    for (const char *kind : {"png", "svg", "pdf", "csv"})
        QVERIFY2(stack->exportTo(folder.filePath(s("plot.") + s(kind))), kind);
    QCOMPARE(exported.count(), 4);
    const QImage picture(folder.filePath(s("plot.png")));
    QVERIFY(picture.width() > 1000 && pixelsNear(picture, m_theme.theme().trace(TraceRole::Velocity)) > 100);
    QSvgRenderer svg(folder.filePath(s("plot.svg")));
    QVERIFY(svg.isValid());
    QFile pdf(folder.filePath(s("plot.pdf")));
    QVERIFY(pdf.open(QIODevice::ReadOnly));
    const QByteArray bytes = pdf.readAll();
    QVERIFY(bytes.startsWith("%PDF-") && bytes.contains("%%EOF"));
}

void PlotsTest::anUnknownSuffixOrFolderFails()
{
    const QTemporaryDir folder;
    const auto stack = shownStack(m_theme);
    QSignalSpy failed(stack.get(), &PlotStack::exportFailed);
    QVERIFY(!stack->exportTo(folder.filePath(s("plot.xyz"))));
    QVERIFY(!stack->exportTo(folder.filePath(s("missing/plot.csv"))));
    QCOMPARE(failed.count(), 2);
}

void PlotsTest::tableHasOneColumnPerTraceAndBlanksInGaps()
{
    const QTemporaryDir folder;
    const auto stack = shownStack(m_theme);
    stack->addTrace({s("speed, left"), s("rpm"), TraceRole::Velocity, 0},
        std::make_shared<FixedTrace>(std::vector<PlotPoint>{{0, 1.5}, {1, -2}, PlotPoint::gap(2), {3, 4}}));
    stack->addTrace(
        {s("current"), s("A"), TraceRole::Current, 1}, std::make_shared<FixedTrace>(std::vector<PlotPoint>{{1, 7}}));
    stack->setRange(0, 3);
    const QString path = folder.filePath(s("plot.csv"));
    QVERIFY(stack->exportTo(path));
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QStringList lines = QString::fromUtf8(file.readAll()).trimmed().split(QLatin1Char('\n'));
    QCOMPARE(lines,
        QStringList({s("time_s,\"speed, left (rpm)\",current (A)"), s("0.000000,1.5,"), s("1.000000,-2,7"),
            s("2.000000,,"), s("3.000000,4,")}));
}

void PlotsTest::summarySpeaksOfEveryTrace()
{
    const auto stack = shownStack(m_theme);
    QCOMPARE(stack->summary(), s("No traces"));
    stack->addTrace({s("velocity"), s("rpm"), TraceRole::Velocity, 0},
        std::make_shared<FixedTrace>(std::vector<PlotPoint>{{0, 0}, {1, 1500}}));
    stack->addTrace(
        {s("current"), s("A"), TraceRole::Current, 1}, std::make_shared<FixedTrace>(std::vector<PlotPoint>{}));
    stack->setRange(0, 1);
    stack->refresh(0);
    QVERIFY(stack->summary().contains(s("velocity")) && stack->summary().contains(s("rpm")));
    QVERIFY(stack->summary().contains(s("current no data")));
}

QTEST_MAIN(PlotsTest)
#include "tst_plots.moc"
