// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/report/reportdrawings.h"

#include <QPainter>
#include <QSvgRenderer>
#include <QTextBlock>
#include <QTextDocument>
#include <QTextFormat>
#include <QTextFrame>

#include <algorithm>

namespace mb {
namespace {

constexpr auto drawingScheme = "svg:";

} // namespace

ReportDrawings::ReportDrawings(QObject *parent, double scale)
    : QObject(parent)
    , m_scale(scale)
{
}

ReportDrawings::~ReportDrawings() = default;

QString ReportDrawings::takeFrom(QString html)
{
    const QString begin = QStringLiteral("<svg ");
    const QString end = QStringLiteral("</svg>");
    for (int from = html.indexOf(begin); from >= 0; from = html.indexOf(begin, from)) {
        const int length = html.indexOf(end, from) + end.size() - from;
        if (length < end.size())
            break;
        m_drawings.push_back(std::make_unique<QSvgRenderer>(html.mid(from, length).toUtf8()));
        const auto number = static_cast<int>(m_drawings.size()) - 1;
        const QString image = QStringLiteral("<img src=\"%1%2\">").arg(QLatin1String(drawingScheme)).arg(number);
        html.replace(from, length, image);
        from += image.size();
    }
    return html;
}

QSizeF ReportDrawings::intrinsicSize(QTextDocument *document, int position, const QTextFormat &format)
{
    const QSvgRenderer *const drawing = find(format);
    if (!drawing)
        return {};
    const QSizeF own = QSizeF(drawing->defaultSize()) * m_scale;
    const QTextBlockFormat block = document->findBlock(position).blockFormat();
    double room = document->textWidth() - block.leftMargin() - block.rightMargin();
    for (const QTextFrame *frame = document->frameAt(position); frame; frame = frame->parentFrame()) {
        const QTextFrameFormat around = frame->frameFormat();
        room -= around.leftMargin() + around.rightMargin() + 2 * (around.padding() + around.border());
    }
    return document->textWidth() > 0 && room < own.width() ? own * (std::max(room, 1.0) / own.width()) : own;
}

void ReportDrawings::drawObject(QPainter *painter, const QRectF &rect, QTextDocument *, int, const QTextFormat &format)
{
    if (QSvgRenderer *const drawing = find(format))
        drawing->render(painter, rect);
}

QSvgRenderer *ReportDrawings::find(const QTextFormat &format) const
{
    const QString name = format.toImageFormat().name();
    if (!name.startsWith(QLatin1String(drawingScheme)))
        return nullptr;
    const auto index = static_cast<std::size_t>(name.mid(static_cast<int>(qstrlen(drawingScheme))).toInt());
    return index < m_drawings.size() ? m_drawings[index].get() : nullptr;
}

} // namespace mb
