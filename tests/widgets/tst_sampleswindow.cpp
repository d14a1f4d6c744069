// SPDX-License-Identifier: GPL-3.0-or-later
#include "plotbench.h"
#include "recording/exportcsv.h"
#include "support/windowtests.h"
#include "widgets/plots/sampleswindow.h"

#include <QFileDialog>
#include <QLabel>
#include <QMenu>

using namespace mb;
using namespace mb::test;

namespace {

constexpr int samples = 2000; ///< of each of two channels, 1 ms apart

/// A recording with a loss in the middle, in a window of its own.
struct SamplesBench {
    QTemporaryDir folder;
    std::unique_ptr<ThemeSource> theme = std::make_unique<ThemeSource>(darkTheme());
    std::unique_ptr<SamplesWindow> window;

    SamplesBench()
    {
        const auto telemetry = std::make_shared<Telemetry>(dmc60c().channels);
        const Instant begin{1000s};
        for (int i = 0; i < samples; ++i) {
            if (i == samples / 2)
                telemetry->lost(channel("velocity"), 7);
            telemetry->append({channel("velocity"), begin + i * 1ms, i * 1.0});
            telemetry->append({channel("current"), begin + i * 1ms, i * 0.001});
        }
        telemetry->commit();
        ExportPlan plan;
        for (const char *key : {"velocity", "current"})
            plan.channels.push_back({telemetry, channel(key), "sim:can/dmc60c:5", "dmc60c", key,
                key[0] == 'v' ? "counts/s" : "A", {}, false});
        plan.from = begin;
        plan.to = begin + samples * 1ms;
        if (!exportCsv(plan, folder.filePath(s("in.csv")).toStdString(), {}))
            qFatal("no recording");
        window = std::make_unique<SamplesWindow>(folder.filePath(s("in.csv")), *theme, nullptr);
        window->setAttribute(Qt::WA_DeleteOnClose, false);
        window->show();
    }
    [[nodiscard]] PlotStack &stack() const { return window->stack(); }
    void exportTable(const QString &path) const
    {
        QMenu menu;
        stack().fillMenu(menu);
        const auto actions = menu.actions();
        const auto csv = std::find_if(
            actions.begin(), actions.end(), [](const QAction *a) { return a->text() == s("Export CSV…"); });
        if (csv == actions.end())
            qFatal("no table is offered");
        (*csv)->trigger();
        auto *dialog = window->findChild<QFileDialog *>();
        Q_EMIT dialog->fileSelected(path);
        dialog->close();
    }
};

} // namespace

class TestSamplesWindow : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void itsTableHasEverySampleAndEveryGap();
    void fittingShowsAllOfIt();
    void aRecordingHasNoPresentToFollow();
    void whatIsWrongWithTheFileStandsAfterAnExport();
};

void TestSamplesWindow::whatIsWrongWithTheFileStandsAfterAnExport()
{
    const SamplesBench bench;
    QTRY_VERIFY(bench.window->isLoaded());
    const auto says = [&bench](const QString &words) {
        const auto labels = bench.window->findChildren<QLabel *>();
        return std::any_of(labels.begin(), labels.end(),
            [&words](const QLabel *label) { return label->isVisible() && label->text().contains(words); });
    };
    QVERIFY(says(s("7 lost")));
    bench.exportTable(bench.folder.filePath(s("out.csv")));
    QTRY_VERIFY(says(s("Written: ")));
    QVERIFY(says(s("7 lost")));
    bench.exportTable(bench.folder.filePath(s("none/out.csv")));
    QTRY_VERIFY(!says(s("Written: ")));
    QVERIFY(says(s("7 lost")));
}

void TestSamplesWindow::itsTableHasEverySampleAndEveryGap()
{
    const SamplesBench bench;
    QTRY_VERIFY(bench.window->isLoaded());
    const QString path = bench.folder.filePath(s("out.csv"));
    bench.exportTable(path);
    QTRY_VERIFY(QFile::exists(path));
    const auto loaded = loadRecording(path.toStdString());
    QVERIFY(loaded);
    const Telemetry &out = *(*loaded)->telemetry;
    QCOMPARE((*loaded)->table.size(), std::size_t{2});
    for (const std::uint16_t each : {std::uint16_t{0}, std::uint16_t{1}})
        QCOMPARE(out.size({each}), std::size_t{samples});
    QCOMPARE(out.gaps({0}, Instant::min(), Instant::max()).size(), std::size_t{1});
    QCOMPARE(QString::fromUtf8((*loaded)->table[0].unit.data()), s("counts/s"));
}

void TestSamplesWindow::fittingShowsAllOfIt()
{
    const SamplesBench bench;
    QTRY_VERIFY(bench.window->isLoaded());
    const auto whole = bench.stack().view().range();
    bench.stack().view().setRange(whole.first + 0.5, whole.first + 0.6);
    QTest::keyClick(bench.window.get(), Qt::Key_0);
    QCOMPARE(bench.stack().view().range(), whole);
}

void TestSamplesWindow::aRecordingHasNoPresentToFollow()
{
    const SamplesBench bench;
    QTRY_VERIFY(bench.window->isLoaded());
    const auto whole = bench.stack().view().range();
    bench.stack().view().setRange(whole.first + 0.5, whole.first + 0.6);
    bench.stack().view().setLive(true); // as End and a double click do
    QVERIFY(!bench.stack().view().isLive());
    QCOMPARE(bench.stack().view().range(), whole);
}

MB_WINDOW_TEST(TestSamplesWindow);
#include "tst_sampleswindow.moc"
