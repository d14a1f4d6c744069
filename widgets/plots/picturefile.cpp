// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/picturefile.h"

#include "files/filebytes.h"
#include "widgets/plots/qcustomplotkeywords.h"

#include <QApplication>
#include <QBuffer>
#include <QPdfWriter>
#include <QSvgGenerator>

namespace mb {
namespace {

bool paintOn(QPaintDevice &device, const PaintedPicture &drawing)
{
    QCPPainter painter(&device);
    if (!painter.isActive())
        return false;
    painter.setMode(QCPPainter::pmVectorized);
    drawing.paint(painter);
    return painter.end();
}

bool paintSvg(QIODevice &content, const PaintedPicture &drawing)
{
    QSvgGenerator svg;
    svg.setOutputDevice(&content);
    svg.setSize(drawing.size);
    svg.setViewBox(QRect(QPoint(), drawing.size));
    svg.setTitle(drawing.title);
    svg.setDescription(drawing.description);
    return paintOn(svg, drawing);
}

bool paintPdf(QIODevice &content, const PaintedPicture &drawing)
{
    QPdfWriter pdf(&content);
    pdf.setCreator(QApplication::applicationName());
    pdf.setTitle(drawing.title);
    pdf.setResolution(72); // one unit of the plot is one point of the page
    pdf.setPageSize(QPageSize(QSizeF(drawing.size), QPageSize::Point));
    pdf.setPageMargins({});
    return paintOn(pdf, drawing);
}

} // namespace

QByteArray pngOf(const QImage &picture)
{
    QBuffer content;
    content.open(QIODevice::WriteOnly);
    return picture.save(&content, "PNG") ? content.data() : QByteArray();
}

Result<void> savePlot(const QString &path, const QByteArray &content)
{
    if (content.isEmpty())
        return fail(Fault::OutOfRange, say("%1 has a name that ends in no kind of picture", path.toStdString()),
            say("end it in .png, .svg or .pdf"));
    return saveFile(path.toStdString(), content);
}

QByteArray drawingAs(const QString &kind, const PaintedPicture &drawing)
{
    QBuffer content;
    content.open(QIODevice::WriteOnly);
    const bool painted = kind == QLatin1String("svg") ? paintSvg(content, drawing)
        : kind == QLatin1String("pdf")                ? paintPdf(content, drawing)
                                                      : false;
    return painted ? content.data() : QByteArray();
}

} // namespace mb
