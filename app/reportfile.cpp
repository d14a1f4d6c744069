// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/reportfile.h"

#include "app/application.h"
#include "app/refusal.h"
#include "files/filebytes.h"
#include "widgets/report/reportpdf.h"

namespace mb {
namespace {

constexpr std::int64_t largestReport = std::int64_t{256} << 20; // bytes

} // namespace

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
