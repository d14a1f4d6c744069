// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/windowtests.h"
#include "tunebench.h"
#include "widgets/report/reportorder.h"
#include "widgets/report/reportpdf.h"

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace mb;
using namespace mb::test;

namespace {

/// A trial of the drive of the bench, with curves.
KeptTrial stepped(const DeviceView &view)
{
    KeptTrial kept;
    kept.number = 3;
    tuning::Trial &trial = kept.trial;
    trial.number = 3;
    trial.device = view.selector;
    trial.unit = view.unit;
    trial.simulated = true;
    trial.stimulus = *tuning::Stimulus::make(tuning::Profile::Step, 0.0, 1000.0, {}, 0.02);
    trial.holds = {{0.0, 1.0}};
    trial.gains = {{"slot0.p", 0.5}};
    trial.reason = tuning::EndReason::Done;
    tuning::Trace trace;
    for (int i = -10; i < 200; ++i)
        trace.add(0.005 * i, i < 0 ? 0.0 : 1000.0);
    trial.signals = {{"velocity", "counts/s", trace}};
    return kept;
}

struct ReportBench {
    FakeWorkbench workbench;
    Recording recording{workbench.time};
    QWidget page;
    ReportOrder order{workbench, page};
    QTemporaryDir folder;

    ReportBench()
    {
        workbench.shot.devices.push_back(tunableDrive(recording.telemetry()));
        ReportUnit unit;
        unit.unit = "simulated tag dmc60c left arm"; // as the notebook knows it
        unit.trials = {stepped(view())};
        unit.history = unit.trials;
        workbench.book.matter = std::vector<ReportUnit>{unit};
    }
    [[nodiscard]] const DeviceView &view() const { return workbench.shot.devices.front(); }
    bool write(const QString &path)
    {
        QSignalSpy written(&order, &ReportOrder::written);
        order.write(view(), {{3}, {}, false}, path);
        if (written.isEmpty() && !written.wait(5000))
            return false;
        return written.last().at(1).toBool();
    }
    static QByteArray contentOf(const QString &path)
    {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
};

} // namespace

class TestReportPdf : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aPdfHasPagesWithWordsAndLinesAndNoPixels();
    void aNewPageBeginsWhereTheTextSaysSo();
    void aTextThatNamesItsPageGetsPagesOfThatSize();
    void thePageWritesWhatItShowsAsHtmlAndAsPdf();
    void whatCannotBeWrittenIsSaidAndLeavesNothing();
    void aNotebookThatCannotBeReadIsSaidSo();
};

void TestReportPdf::aPdfHasPagesWithWordsAndLinesAndNoPixels()
{
    ReportBench bench;
    const QString html = bench.folder.filePath(QStringLiteral("a.html"));
    QVERIFY(bench.write(html));
    const QByteArray pdf = pdfOf(QString::fromUtf8(ReportBench::contentOf(html)));
    QVERIFY(pdf.startsWith("%PDF-"));
    QVERIFY(pdf.contains("/Subtype /Type0") || pdf.contains("/Type /Font"));
    QVERIFY2(!pdf.contains("/Subtype /Image"), "the plots are lines");
    QVERIFY(pdf.size() > 5000);
}

void TestReportPdf::aNewPageBeginsWhereTheTextSaysSo()
{
    const QString page = QStringLiteral("<p style=\"page-break-before: always\">x</p>");
    const auto pages = [](const QString &html) { return pdfOf(html).count("/Type /Page\n"); };
    QCOMPARE(pages(QStringLiteral("<html><body><p>one</p>%1%1</body></html>").arg(page)), 3);
}

void TestReportPdf::aTextThatNamesItsPageGetsPagesOfThatSize()
{
    Report report;
    for (const char *const serial : {"2103343A7B2E", "2103343A7B2F"}) {
        service::Visit visit;
        visit.serial = serial;
        visit.to = "1.25";
        visit.outcome = service::Outcome::Passed;
        ReportUnit unit;
        unit.identity.family = "dmc60c";
        unit.identity.address = 63;
        unit.simulated = true;
        unit.visits.push_back(visit);
        report.units.push_back(std::move(unit));
    }
    const auto sizeOf = [](const QByteArray &pdf) {
        static const QRegularExpression box(QStringLiteral("/MediaBox \\[0 0 ([0-9.]+) ([0-9.]+)\\]"));
        const auto match = box.match(QString::fromLatin1(pdf.constData(), pdf.size()));
        return QSizeF(match.captured(1).toDouble(), match.captured(2).toDouble()) / 72.0 * 25.4; // mm
    };
    const QByteArray labels = pdfOf(labelHtmlOf(report));
    QCOMPARE(labels.count("/Type /Page\n"), 2);
    QVERIFY2(std::abs(sizeOf(labels).width() - 62.0) < 0.5, qPrintable(QString::number(sizeOf(labels).width())));
    QVERIFY2(std::abs(sizeOf(labels).height() - 29.0) < 0.5, qPrintable(QString::number(sizeOf(labels).height())));
    const QByteArray cards = pdfOf(cardHtmlOf(report));
    QCOMPARE(cards.count("/Type /Page\n"), 2);
    QVERIFY(std::abs(sizeOf(cards).width() - 210.0) < 0.5);
    QVERIFY(std::abs(sizeOf(cards).height() - 297.0) < 0.5);
}

void TestReportPdf::thePageWritesWhatItShowsAsHtmlAndAsPdf()
{
    ReportBench bench;
    const QString html = bench.folder.filePath(QStringLiteral("a.html"));
    QVERIFY(bench.write(html));
    QCOMPARE(bench.workbench.book.wishes.back().trials, std::vector<std::int64_t>{3});
    QCOMPARE(bench.workbench.book.wishes.back().unit, bench.view().unit);
    const QString text = QString::fromUtf8(ReportBench::contentOf(html));
    QVERIFY(text.contains(QStringLiteral("Trial 3")));
    QVERIFY(text.contains(QStringLiteral("left arm")));
    QVERIFY2(text.contains(QStringLiteral("<h2>Parameters")), "of the unit as it is now");
    const QString pdf = bench.folder.filePath(QStringLiteral("a.pdf"));
    QVERIFY(bench.write(pdf));
    QVERIFY(ReportBench::contentOf(pdf).startsWith("%PDF-"));
    QVERIFY(bench.workbench.notices().back().text.contains(pdf));
}

void TestReportPdf::whatCannotBeWrittenIsSaidAndLeavesNothing()
{
    ReportBench bench;
    QVERIFY(!bench.write(QStringLiteral("/nonexistent/a.pdf")));
    QVERIFY(bench.workbench.notices().back().text.contains(QStringLiteral("/nonexistent/a.pdf")));
    QVERIFY(!bench.write(bench.folder.filePath(QStringLiteral("a.doc"))));
    QVERIFY(QDir(bench.folder.path()).entryList(QDir::Files | QDir::Hidden).isEmpty());
}

void TestReportPdf::aNotebookThatCannotBeReadIsSaidSo()
{
    ReportBench bench;
    bench.workbench.book.matter = fail(Fault::OutOfRange, say("the notebook is damaged"));
    QVERIFY(!bench.write(bench.folder.filePath(QStringLiteral("a.pdf"))));
    QVERIFY(bench.workbench.notices().back().text.contains(QStringLiteral("the notebook is damaged")));
}

MB_WINDOW_TEST(TestReportPdf);
#include "tst_reportpdf.moc"
