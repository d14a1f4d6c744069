// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/documents.h"

#include "app/application.h"
#include "app/refusal.h"
#include "files/filebytes.h"
#include "recording/loadrecording.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/systemtheme.h"
#include "widgets/plots/picturefile.h"
#include "widgets/plots/qcustomplotkeywords.h"
#include "widgets/plots/recordedtraces.h"
#include "widgets/plots/telemetrysource.h"
#include "widgets/report/reportpdf.h"

#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>

#include <cstdio>

namespace mb {
namespace {

constexpr std::int64_t largestReport = std::int64_t{256} << 20; // bytes
constexpr double pictureScale = 2.0;
constexpr QSize usualSize{1280, 800};

void print(const Options &options, const LoadedRecording &recording, int traces)
{
    const auto [samples, lost, seconds] = totalsOf(recording);
    if (options.json) {
        const QJsonObject object{{QStringLiteral("file"), options.plot}, {QStringLiteral("out"), options.out},
            {QStringLiteral("signals"), traces}, {QStringLiteral("samples"), static_cast<qint64>(samples)},
            {QStringLiteral("lost"), static_cast<qint64>(lost)}, {QStringLiteral("seconds"), seconds},
            {QStringLiteral("complete"), recording.complete}, {QStringLiteral("shortened"), recording.shortened}};
        std::puts(QJsonDocument(object).toJson(QJsonDocument::Compact).constData());
        return;
    }
    std::printf("%s: %d signals, %llu samples, %llu lost, %.3f s%s%s\n", qPrintable(options.out), traces,
        static_cast<unsigned long long>(samples), static_cast<unsigned long long>(lost), seconds,
        recording.complete ? "" : "; the end of the file is missing",
        recording.shortened ? "; the file has more, which is too large for the memory" : "");
}

} // namespace

int plotFile(const Options &options)
{
    const QString suffix = QFileInfo(options.out).suffix().toLower();
    if (suffix != QLatin1String("png") && suffix != QLatin1String("svg") && suffix != QLatin1String("pdf"))
        return refuse({Fault::OutOfRange, say("--out '%1' is no picture", options.out.toStdString()),
                          say("give a name that ends in .png, .svg or .pdf")},
            options.json);
    const auto recording = loadRecording(options.plot.toLocal8Bit().toStdString());
    if (!recording)
        return refuse(
            {Fault::OutOfRange, recording.error().message(),
                say("give an .mcap with messages in JSON or of this program, a .csv, or the output of watch")},
            options.json);
    const double points = 10.0 * options.fontScale.value_or(1.0);
    const ThemeSource theme(themeNamed(options.theme, QApplication::palette(), points));
    QFont font = QApplication::font();
    font.setPointSizeF(points);
    QApplication::setFont(font);
    PlotStack stack(theme);
    const QStringList sides = options.size.split(QLatin1Char('x'));
    const QSize size = sides.size() == 2 ? QSize(sides[0].toInt(), sides[1].toInt()) : usualSize;
    stack.resize(size);
    showRecording(stack, **recording);
    const auto to = plotKey((*recording)->last);
    stack.show();
    stack.refresh(to);
    stack.refresh(to); // the first one has found out how wide the labels are
    // a picture has the size that was asked for, even where the window would want more
    const QByteArray picture = suffix == QLatin1String("png") ? pngOf(stack.plot().picture(size, pictureScale))
                                                              : stack.exporter().contentAs(suffix);
    if (picture.isEmpty())
        return refuse(
            {Fault::OutOfRange, say("%1 cannot be painted", options.out.toStdString()), say("choose a smaller --size")},
            options.json);
    if (const auto saved = saveFile(options.out.toStdString(), picture); !saved)
        return refuse(saved.error(), options.json);
    print(options, **recording, stack.strips().traceCount());
    return 0;
}

int printReport(const Options &options)
{
    const auto html = loadFile(options.report.toLocal8Bit().toStdString(), largestReport);
    if (!html)
        return refuse(html.error(), options.json);
    if (!html->trimmed().toLower().startsWith("<!doctype html"))
        return refuse({Fault::OutOfRange, say("%1 is no report", options.report.toStdString())}, options.json);
    if (!options.out.endsWith(QLatin1String(".pdf"), Qt::CaseInsensitive))
        return refuse({Fault::OutOfRange, say("--out '%1' is no PDF", options.out.toStdString())}, options.json);
    const QByteArray pdf = pdfOf(QString::fromUtf8(*html));
    if (pdf.isEmpty())
        return refuse({Fault::OutOfRange, say("the report cannot be painted"), {}}, options.json);
    if (const auto saved = saveFile(options.out.toLocal8Bit().toStdString(), pdf); !saved)
        return refuse(saved.error(), options.json);
    return 0;
}

} // namespace mb
