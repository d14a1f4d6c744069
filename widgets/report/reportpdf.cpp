// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/report/reportpdf.h"

#include "widgets/report/reportdrawings.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QCoreApplication>
#include <QPainter>
#include <QPdfWriter>
#include <QRegularExpression>
#include <QTextDocument>

namespace mb {
namespace {

struct PdfText {
    Q_DECLARE_TR_FUNCTIONS(mb::PdfText)
};

constexpr int resolution = 1200; // of the file; the layout is in px of 96 dpi
constexpr double layoutDpi = 96.0;
constexpr double sideMm = 17.0;
constexpr double topMm = 12.0;
constexpr double pageWidthMm = 210.0;
constexpr double pageHeightMm = 297.0;
constexpr double headRoom = 26.0; // px, of the running head, and of the foot
constexpr int smallText = 10;     // px

double px(double millimetres)
{
    return millimetres / 25.4 * layoutDpi;
}

/// Of the page, in mm; bare: without running head and foot.
struct Sheet {
    QSizeF size{pageWidthMm, pageHeightMm};
    double side = sideMm;
    double top = topMm;
    bool bare = false;

    [[nodiscard]] double room() const { return bare ? 0.0 : headRoom; }
};

Sheet sheetOf(const QString &html)
{
    static const QRegularExpression wish(
        QStringLiteral(R"(@page\s*\{\s*size:\s*([\d.]+)mm\s+([\d.]+)mm;\s*margin:\s*([\d.]+)mm)"));
    const QRegularExpressionMatch found = wish.match(html);
    if (!found.hasMatch())
        return {};
    const double margin = found.captured(3).toDouble();
    return {QSizeF(found.captured(1).toDouble(), found.captured(2).toDouble()), margin, margin, true};
}

QFont smallFont(const QTextDocument &document)
{
    QFont font = document.defaultFont();
    font.setPixelSize(smallText);
    return font;
}

/// Without what is for screens only.
QString printed(QString html)
{
    const int from = html.indexOf(QStringLiteral("<style media=\"screen\">"));
    const QString end = QStringLiteral("</style>");
    return from < 0 ? html : html.remove(from, html.indexOf(end, from) + end.size() - from);
}

/// What every page says: title above, number and a word about simulated units below.
void paintMargins(QPainter &painter, const QTextDocument &document, QSizeF body, int page, int pages, bool simulated)
{
    painter.setFont(smallFont(document));
    painter.setPen(QColor(0x47, 0x52, 0x5E));
    const QRectF head(0.0, 0.0, body.width(), headRoom - 10.0);
    const QRectF foot(0.0, headRoom + body.height() + 10.0, body.width(), headRoom - 10.0);
    painter.drawText(head, Qt::AlignLeft | Qt::AlignTop, document.metaInformation(QTextDocument::DocumentTitle));
    painter.drawText(head, Qt::AlignRight | Qt::AlignTop, QCoreApplication::applicationName());
    painter.drawText(foot, Qt::AlignRight | Qt::AlignBottom, PdfText::tr("page %1 of %2").arg(page + 1).arg(pages));
    if (simulated)
        painter.drawText(foot, Qt::AlignLeft | Qt::AlignBottom, PdfText::tr("DEMO, a simulated unit"));
    painter.drawLine(QPointF(0.0, headRoom - 8.0), QPointF(body.width(), headRoom - 8.0));
}

void paintPages(QPdfWriter &pdf, QTextDocument &document, QSizeF body, bool simulated, const Sheet &sheet)
{
    QPainter painter(&pdf);
    painter.scale(resolution / layoutDpi, resolution / layoutDpi);
    const int pages = document.pageCount();
    for (int page = 0; page < pages; ++page) {
        if (page > 0)
            pdf.newPage();
        if (!sheet.bare)
            paintMargins(painter, document, body, page, pages, simulated);
        painter.save();
        const QRectF view(0.0, page * body.height(), body.width(), body.height());
        painter.translate(0.0, sheet.room() - view.top());
        painter.setClipRect(view);
        QAbstractTextDocumentLayout::PaintContext context;
        context.clip = view;
        context.palette.setColor(QPalette::Text, QColor(0x17, 0x1C, 0x22));
        document.documentLayout()->draw(&painter, context);
        painter.restore();
    }
}

} // namespace

QByteArray pdfOf(const QString &html)
{
    QBuffer content;
    content.open(QIODevice::WriteOnly);
    QPdfWriter pdf(&content);
    pdf.setCreator(QCoreApplication::applicationName());
    pdf.setResolution(resolution);
    const Sheet sheet = sheetOf(html);
    pdf.setPageSize(sheet.bare ? QPageSize(sheet.size, QPageSize::Millimeter) : QPageSize(QPageSize::A4));
    pdf.setPageMargins(QMarginsF(sheet.side, sheet.top, sheet.side, sheet.top), QPageLayout::Millimeter);
    ReportDrawings drawings;
    QTextDocument document;
    document.setUndoRedoEnabled(false);
    document.setUseDesignMetrics(true);
    document.setDocumentMargin(0.0);
    document.documentLayout()->registerHandler(QTextFormat::ImageObject, &drawings);
    document.setHtml(drawings.takeFrom(printed(html)));
    pdf.setTitle(document.metaInformation(QTextDocument::DocumentTitle));
    const QSizeF body(
        px(sheet.size.width() - 2.0 * sheet.side), px(sheet.size.height() - 2.0 * sheet.top) - 2.0 * sheet.room());
    document.setPageSize(body);
    paintPages(pdf, document, body, html.contains(QStringLiteral("<meta name=\"simulated\"")), sheet);
    return content.data();
}

} // namespace mb
