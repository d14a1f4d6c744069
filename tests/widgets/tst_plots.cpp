// SPDX-License-Identifier: GPL-3.0-or-later
#include "spike.h"
#include "support/utf8.h"
#include "support/windowtests.h"
#include "widgets/plots/fixedtrace.h"
#include "widgets/plots/plotstack.h"

#include <QPaintEvent>
#include <QPdfWriter>
#include <QSignalSpy>
#include <QSvgRenderer>
#include <QTemporaryDir>
#include <QTest>
#include <QWheelEvent>
#include <cmath>

using namespace mb;
using test::flatWithSpike;

namespace {

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

std::unique_ptr<PlotStack> shownStack(const ThemeSource &theme)
{
    auto stack = std::make_unique<PlotStack>(theme);
    stack->resize(600, 300);
    stack->show();
    return stack;
}

/// A flat trace with one high sample, or none.
std::unique_ptr<PlotStack> spikeStack(const ThemeSource &theme, int spikeAt)
{
    auto stack = shownStack(theme);
    stack->strips().addTrace({s("v"), s("rpm"), TraceRole::Velocity, 0, TraceDash::Automatic, TraceMarker::None},
        std::make_shared<FixedTrace>(flatWithSpike(200'000, spikeAt, 1000.0)));
    stack->view().setRange(0, 1);
    stack->strips().setValueRange(0, std::pair(-100.0, 1100.0));
    stack->refresh(0);
    return stack;
}

/// Goes on for ever, between −1 and 1.
class Wave : public TraceSource {
public:
    void columns(double from, double to, int, std::vector<PlotPoint> &points) const override
    {
        points.clear();
        for (double key = std::floor(from * 10); key < to * 10 + 1; ++key)
            points.push_back({key / 10, std::sin(key / 4)});
    }
    std::optional<double> latest() const override { return 0.5; }
    QString foot() const override { return s("10 Hz"); }
};

/// Counts what was painted in part only.
class PartialPaints : public QObject {
public:
    explicit PartialPaints(QWidget &widget) { widget.installEventFilter(this); }
    bool eventFilter(QObject *watched, QEvent *event) override
    {
        if (event->type() == QEvent::Paint)
            count += static_cast<QPaintEvent *>(event)->region() != static_cast<QWidget *>(watched)->rect() ? 1 : 0;
        return false;
    }
    int count = 0;
};

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
    void aPenDrawsTheSpikeToo();
    void whatIsKeptOfThePictureIsWhatWouldBeDrawn();
    void nothingIsFetchedWhileHidden();
    void liveFollowsThePresentByWholeColumns();
    void pausedStaysWhereItIs();
    void aGapAtThePresentEndsNow();
    void clearingLeavesAUsablePlot();
    void cursorsReadTheTrace();
    void keysZoomPauseAndFit();
    void aBoxZoomsTimeAndValuesWhileLive();
    void theWheelZoomsAndMovesWhileLive();
    void arrowsMoveACursorByAPixel();
    void aHeldEventStandsStillWhileLive();
    void anAlignedTraceStaysOnTheScreen();
    void aNoteIsDrawnThroughAllStrips();
    void theNumbersOfTheSelectionAreExact();
    void exportsReadableFiles();
    void anUnknownSuffixOrFolderFails();
    void tableHasOneColumnPerTraceARowForEverySampleAndNanInGaps();
    void summarySpeaksOfEveryTrace();

private:
    [[nodiscard]] QColor velocityColor() const { return m_theme.theme().trace(TraceRole::Velocity); }

    ThemeSource m_theme{darkTheme()};
};

void PlotsTest::aSpikeBetweenTwoPixelsIsDrawn()
{
    // One of 200 000 samples is high: 1/400 of a pixel column.
    const auto pixels = [this](int spikeAt) {
        return pixelsNear(spikeStack(m_theme, spikeAt)->plot().picture({600, 300}, 1.0), velocityColor());
    };
    const int withSpike = pixels(123'457);
    const int withoutSpike = pixels(-1);
    QVERIFY2(withSpike > withoutSpike + 100, qPrintable(QStringLiteral("%1 %2").arg(withSpike).arg(withoutSpike)));
}

void PlotsTest::aPenDrawsTheSpikeToo() // as for SVG and PDF
{
    const auto pixels = [this](int spikeAt) {
        return pixelsNear(spikeStack(m_theme, spikeAt)->plot().toPixmap().toImage(), velocityColor());
    };
    const int withSpike = pixels(123'457);
    const int withoutSpike = pixels(-1);
    QVERIFY2(withSpike > withoutSpike + 100, qPrintable(QStringLiteral("%1 %2").arg(withSpike).arg(withoutSpike)));
}

void PlotsTest::whatIsKeptOfThePictureIsWhatWouldBeDrawn()
{
    const auto stack = shownStack(m_theme);
    for (int strip = 0; strip < 2; ++strip) {
        stack->strips().addTrace({s("velocity"), s("rpm"), TraceRole::Velocity, strip}, std::make_shared<Wave>());
        stack->strips().addTrace({s("set-point"), s("rpm"), TraceRole::Setpoint, strip}, std::make_shared<Wave>());
    }
    stack->strips().setWatermark(s("DEMO"));
    stack->strips().annotate<PlotLimit>(0, {{0.4, s("limit"), TraceRole::Current}});
    stack->strips().setMarks({{107, s("load pulse")}});
    stack->view().setWindow(10);
    QVERIFY(QTest::qWaitForWindowExposed(stack.get()));
    stack->refresh(100);
    PartialPaints partial(stack->plot());
    for (int i = 1; i <= 40; ++i) {
        stack->refresh(100 + i * 0.317);
        const QImage shown = stack->plot().grab().toImage();
        stack->plot().render();
        QCOMPARE(shown, stack->plot().grab().toImage());
    }
    QVERIFY2(partial.count > 10, "every refresh has drawn everything: nothing was tried");
}

void PlotsTest::nothingIsFetchedWhileHidden()
{
    PlotStack stack(m_theme);
    stack.resize(600, 300);
    const auto source = std::make_shared<Counting>();
    stack.strips().addTrace({s("v"), s("rpm"), TraceRole::Velocity, 0}, source);
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
    stack->strips().addTrace({s("v"), s("rpm"), TraceRole::Velocity, 0}, source);
    stack->view().setWindow(60);
    stack->refresh(100);
    QCoreApplication::processEvents();
    stack->refresh(100);
    QVERIFY(stack->view().range().second >= 100 && stack->view().range().second < 100.5);
    QCOMPARE(stack->view().range().second - stack->view().range().first, 60.0);
    const int asked = source->asked;
    stack->refresh(stack->view().range().second - 1e-6); // less than a pixel later
    QCOMPARE(source->asked, asked);
    stack->refresh(102);
    QCOMPARE(source->asked, asked + 1);
}

void PlotsTest::pausedStaysWhereItIs()
{
    const auto stack = shownStack(m_theme);
    const auto source = std::make_shared<Counting>();
    stack->strips().addTrace({s("v"), s("rpm"), TraceRole::Velocity, 0}, source);
    QSignalSpy live(&stack->view(), &PlotView::liveChanged);
    stack->view().setRange(3, 5);
    QCOMPARE(live.count(), 1);
    stack->refresh(100);
    const int asked = source->asked;
    stack->refresh(200);
    QCOMPARE(source->asked, asked);
    QCOMPARE(stack->view().range(), std::make_pair(3.0, 5.0));
}

void PlotsTest::aGapAtThePresentEndsNow()
{
    const auto stack = shownStack(m_theme);
    std::vector<PlotPoint> points{{0, 1}, {1, 2}, PlotPoint::gap(1.0)};
    stack->strips().addTrace({s("v"), s("rpm"), TraceRole::Velocity, 0}, std::make_shared<FixedTrace>(points));
    stack->view().setWindow(10);
    stack->refresh(5);
    const QImage image = stack->plot().picture({600, 300}, 1.0);
    QVERIFY(stack->readings().summary().contains(s("1 gap")));
    QVERIFY(pixelsNear(image, m_theme.theme().caution) > 5);
}

void PlotsTest::clearingLeavesAUsablePlot()
{
    const auto stack = shownStack(m_theme);
    for (int round = 0; round < 3; ++round) {
        const int first
            = stack->strips().addTrace({s("v"), s("rpm"), TraceRole::Velocity, 0}, std::make_shared<Counting>());
        stack->strips().addTrace({s("c"), s("A"), TraceRole::Current, 2}, std::make_shared<Counting>());
        stack->strips().setSource(first, std::make_shared<Counting>());
        stack->refresh(10 + round);
        QCOMPARE(stack->strips().traceCount(), 2);
        stack->strips().removeTrace(first);
        QCOMPARE(stack->strips().traceCount(), 1);
        stack->strips().clear();
        QCOMPARE(stack->strips().traceCount(), 0);
        stack->refresh(10.5 + round);
    }
    QCOMPARE(stack->plot().axisRectCount(), 0);
}

void PlotsTest::cursorsReadTheTrace()
{
    const auto stack = shownStack(m_theme);
    const int trace = stack->strips().addTrace({s("v"), s("rpm"), TraceRole::Velocity, 0},
        std::make_shared<FixedTrace>(std::vector<PlotPoint>{{0, 0}, {3, 30}}));
    stack->view().setRange(0, 3);
    stack->refresh(0);
    QSignalSpy changed(stack.get(), &PlotStack::cursorsChanged);
    stack->setCursorsShown(true);
    QCOMPARE(changed.count(), 1);
    const auto [a, b] = stack->cursorKeys();
    QCOMPARE(stack->readings().valueAt(trace, a), 10.0);
    QCOMPARE(stack->readings().valueAt(trace, b), 20.0);
}

void PlotsTest::keysZoomPauseAndFit()
{
    const auto stack = shownStack(m_theme);
    stack->strips().addTrace({s("v"), s("rpm"), TraceRole::Velocity, 0},
        std::make_shared<FixedTrace>(std::vector<PlotPoint>{{0, 0}, {3, 30}}));
    stack->refresh(50);
    const double window = stack->view().window();
    QTest::keyClick(stack.get(), Qt::Key_Plus);
    QVERIFY(stack->view().window() < window);
    QVERIFY(stack->view().isLive());
    QTest::keyClick(stack.get(), Qt::Key_P);
    QVERIFY(!stack->view().isLive());
    QTest::keyClick(stack.get(), Qt::Key_0);
    QCOMPARE(stack->view().range(), std::make_pair(0.0, 3.0));
    QTest::keyClick(stack.get(), Qt::Key_L);
    QVERIFY(stack->cursorsShown());
    QTest::keyClick(stack.get(), Qt::Key_End);
    QVERIFY(stack->view().isLive());
}

void PlotsTest::aBoxZoomsTimeAndValuesWhileLive()
{
    const auto stack = shownStack(m_theme);
    stack->strips().addTrace({s("v"), s("rpm"), TraceRole::Velocity, 0}, std::make_shared<Counting>());
    stack->view().setWindow(10);
    stack->refresh(100);
    QVERIFY(stack->view().isLive());
    QCustomPlot &plot = stack->plot();
    const QRect area = plot.axisRect(0)->rect();
    const auto [from, to] = stack->view().range();
    const QPoint corner(area.left() + area.width() / 4, area.top() + area.height() / 4);
    const QPoint other(area.left() + area.width() / 2, area.top() + area.height() / 2);
    const double upper = plot.axisRect(0)->axis(QCPAxis::atLeft)->pixelToCoord(corner.y());
    QTest::mousePress(&plot, Qt::LeftButton, Qt::ShiftModifier, corner);
    QTest::mouseRelease(&plot, Qt::LeftButton, Qt::ShiftModifier, other);
    stack->refresh(101);
    QVERIFY(!stack->view().isLive());
    QVERIFY(std::abs(stack->view().range().first - (from + (to - from) / 4)) < 0.1);
    QVERIFY(std::abs(stack->view().range().second - (from + to) / 2) < 0.1);
    QVERIFY(std::abs(plot.axisRect(0)->axis(QCPAxis::atLeft)->range().upper - upper) < 0.05);
    QTest::keyClick(stack.get(), Qt::Key_End); // back, with the axis following the data again
    stack->refresh(102);
    QVERIFY(stack->view().isLive());
}

void PlotsTest::theWheelZoomsAndMovesWhileLive()
{
    const auto stack = shownStack(m_theme);
    stack->strips().addTrace({s("v"), s("rpm"), TraceRole::Velocity, 0}, std::make_shared<Counting>());
    stack->view().setWindow(10);
    stack->refresh(100);
    QCustomPlot &plot = stack->plot();
    const QPoint middle = plot.axisRect(0)->rect().center();
    const auto turn = [&](int angle, Qt::KeyboardModifiers modifiers) {
        QWheelEvent event(middle, plot.mapToGlobal(middle), QPoint(), QPoint(0, angle), Qt::NoButton, modifiers,
            Qt::NoScrollPhase, false);
        QApplication::sendEvent(&plot, &event);
    };
    turn(120, Qt::NoModifier);
    QVERIFY(stack->view().window() < 10.0 && stack->view().isLive());
    const QCPRange before = plot.axisRect(0)->axis(QCPAxis::atLeft)->range();
    turn(120, Qt::ControlModifier);
    stack->refresh(101);
    QVERIFY(plot.axisRect(0)->axis(QCPAxis::atLeft)->range().size() < before.size());
    QVERIFY(stack->view().isLive());
    const double from = stack->view().range().first;
    turn(120, Qt::ShiftModifier); // back in time
    QVERIFY(!stack->view().isLive() && stack->view().range().first < from);
}

void PlotsTest::arrowsMoveACursorByAPixel()
{
    const auto stack = shownStack(m_theme);
    stack->strips().addTrace({s("v"), s("rpm"), TraceRole::Velocity, 0}, std::make_shared<Counting>());
    stack->view().setRange(0, 3);
    stack->refresh(0);
    stack->setCursorsShown(true);
    const auto [a, b] = stack->cursorKeys();
    QTest::keyClick(stack.get(), Qt::Key_Right);
    const double pixel = stack->cursorKeys().second - b;
    QVERIFY(pixel > 0.0 && pixel < 0.05);
    QTest::keyClick(stack.get(), Qt::Key_C);
    QTest::keyClick(stack.get(), Qt::Key_Left, Qt::ControlModifier);
    QVERIFY(std::abs(stack->cursorKeys().first - (a - 10 * pixel)) < 1e-9);
    QCOMPARE(stack->view().range(), std::make_pair(0.0, 3.0));
}

void PlotsTest::aHeldEventStandsStillWhileLive()
{
    const auto stack = shownStack(m_theme);
    stack->strips().addTrace({s("v"), s("rpm"), TraceRole::Velocity, 0}, std::make_shared<Counting>());
    stack->view().setWindow(10);
    stack->refresh(100);
    stack->view().hold(95.0, 0.2);
    stack->refresh(101);
    QVERIFY(stack->view().isLive());
    QVERIFY(std::abs(stack->view().range().first - 93.0) < 0.05);
    stack->refresh(120);
    QVERIFY(std::abs(stack->view().range().second - 103.0) < 0.05);
    stack->view().hold({}, 0.2);
    stack->refresh(121);
    QVERIFY(stack->view().range().second >= 121);
}

void PlotsTest::anAlignedTraceStaysOnTheScreen()
{
    const auto stack = shownStack(m_theme);
    TraceStyle style{s("ref"), s("rpm"), TraceRole::Velocity, 0};
    style.aligned = true;
    const int id
        = stack->strips().addTrace(style, std::make_shared<FixedTrace>(std::vector<PlotPoint>{{0, 0}, {10, 100}}));
    stack->view().setWindow(10);
    for (const double now : {50.0, 77.0}) {
        stack->refresh(now);
        QVERIFY(std::abs(stack->readings().valueAt(id, stack->view().range().first + 5.0) - 50.0) < 1e-6);
    }
    stack->view().hold(60.0, 0.5);
    stack->refresh(78);
    QVERIFY(std::abs(stack->readings().valueAt(id, 62.0) - 20.0) < 1e-6); // from the event on
}

void PlotsTest::aNoteIsDrawnThroughAllStrips()
{
    const auto stack = shownStack(m_theme);
    stack->strips().addTrace(
        {s("v"), s("rpm"), TraceRole::Velocity, 0}, std::make_shared<FixedTrace>(std::vector<PlotPoint>{}));
    stack->view().setRange(0, 1);
    stack->refresh(0);
    const QImage before = stack->plot().picture({600, 300}, 1.0);
    stack->strips().setMarks({{0.5, s("load pulse")}});
    stack->refresh(0);
    QVERIFY(stack->plot().picture({600, 300}, 1.0) != before);
}

void PlotsTest::theNumbersOfTheSelectionAreExact()
{
    const auto stack = shownStack(m_theme);
    stack->strips().addTrace({s("v"), s("rpm"), TraceRole::Velocity, 0},
        std::make_shared<FixedTrace>(std::vector<PlotPoint>{{0, 0}, {4, 40}}));
    stack->view().setRange(0, 4);
    stack->refresh(0);
    stack->setCursorsShown(true);
    stack->setCursorKeys(1.0, 3.0);
    const QString numbers = stack->readings().numbers();
    QVERIFY2(numbers.contains(s("time\ts\t1.000000\t3.000000\t2\t")), qPrintable(numbers));
    QVERIFY2(numbers.contains(s("v\trpm\t10\t30\t20")), qPrintable(numbers));
}

void PlotsTest::exportsReadableFiles()
{
    const QTemporaryDir folder;
    const auto stack = shownStack(m_theme);
    stack->strips().addTrace(
        {s("v"), s("rpm"), TraceRole::Velocity, 0}, std::make_shared<FixedTrace>(flatWithSpike(1000, 500, 10)));
    stack->strips().setWatermark(s("DEMO"));
    stack->view().setRange(0, 1);
    stack->refresh(0);
    QSignalSpy exported(&stack->exporter(), &PlotExport::exported);
    for (const char *kind : {"png", "svg", "pdf", "csv"})
        QVERIFY2(stack->exporter().exportTo(folder.filePath(s("plot.") + s(kind))), kind);
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
    QSignalSpy failed(&stack->exporter(), &PlotExport::exportFailed);
    QVERIFY(!stack->exporter().exportTo(folder.filePath(s("plot.xyz"))));
    QVERIFY(!stack->exporter().exportTo(folder.filePath(s("missing/plot.csv"))));
    QCOMPARE(failed.count(), 2);
    QVERIFY2(failed.at(0).first().toString().contains(s(".pdf")), qPrintable(failed.at(0).first().toString()));
    QVERIFY2(
        failed.at(1).first().toString().contains(s("no such folder")), qPrintable(failed.at(1).first().toString()));
}

void PlotsTest::tableHasOneColumnPerTraceARowForEverySampleAndNanInGaps()
{
    const QTemporaryDir folder;
    const auto stack = shownStack(m_theme);
    stack->strips().addTrace({s("speed, left"), s("rpm"), TraceRole::Velocity, 0},
        std::make_shared<FixedTrace>(
            std::vector<PlotPoint>{{0, 1.5}, {1, -2}, PlotPoint::gap(2), {2, 3}, {3, 4}, {3, 5}}));
    stack->strips().addTrace(
        {s("current"), s("A"), TraceRole::Current, 1}, std::make_shared<FixedTrace>(std::vector<PlotPoint>{{1, 7}}));
    stack->view().setRange(0, 3);
    const QString path = folder.filePath(s("plot.csv"));
    QVERIFY(stack->exporter().exportTo(path));
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QStringList lines = QString::fromUtf8(file.readAll()).trimmed().split(QLatin1Char('\n'));
    QCOMPARE(lines,
        QStringList({s("time_s,\"speed, left (rpm)\",current (A)"), s("0.000000,1.5,"), s("1.000000,-2,7"),
            s("2.000000,nan,"), s("2.000000,3,"), s("3.000000,4,"), s("3.000000,5,")}));
}

void PlotsTest::summarySpeaksOfEveryTrace()
{
    const auto stack = shownStack(m_theme);
    QCOMPARE(stack->readings().summary(), s("No traces"));
    stack->strips().addTrace({s("velocity"), s("rpm"), TraceRole::Velocity, 0},
        std::make_shared<FixedTrace>(std::vector<PlotPoint>{{0, 0}, {1, 1500}}));
    stack->strips().addTrace(
        {s("current"), s("A"), TraceRole::Current, 1}, std::make_shared<FixedTrace>(std::vector<PlotPoint>{}));
    stack->view().setRange(0, 1);
    stack->refresh(0);
    QVERIFY(stack->readings().summary().contains(s("velocity")) && stack->readings().summary().contains(s("rpm")));
    QVERIFY(stack->readings().summary().contains(s("current no data")));
}

MB_WINDOW_TEST(PlotsTest);
#include "tst_plots.moc"
