// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plotdecor.h"
#include "widgets/plots/plotframe.h"

#include <numeric>

namespace mb {

StripFace::StripFace(QCPAxisRect &rect, const ThemeSource &theme, const StripDecor &decor)
    : QCPAbstractItem(rect.parentPlot())
    , m_rect(rect)
    , m_theme(theme)
    , m_decor(decor)
{
    setSelectable(false);
    setLayer(QStringLiteral("axes"));
    setClipToAxisRect(false);
}

QFont StripFace::caption() const
{
    return m_theme.theme().font(TextRole::Caption, parentPlot()->font());
}

int StripFace::tagWidth(const Theme &theme, const QFont &body, const QString &widest)
{
    return QFontMetrics(theme.font(TextRole::Caption, body)).horizontalAdvance(widest) + theme.u(16);
}

void StripFace::draw(QCPPainter *painter)
{
    const QRectF box = m_rect.rect();
    painter->setAntialiasing(true);
    const auto *frame = qobject_cast<const PlotFrame *>(parentPlot());
    if (!frame || !frame->stands()) {
        drawHead(*painter, box);
        drawTags(*painter, box);
    }
    drawKeyUnit(*painter, box);
    painter->save();
    painter->setClipRect(box.adjusted(0, -2, 2, 0));
    drawLimits(*painter, box);
    drawNotes(*painter, box);
    drawMarks(*painter, box);
    painter->restore();
    drawTrigger(*painter, box);
}

void StripFace::drawHead(QCPPainter &painter, const QRectF &box) const
{
    const Theme &theme = m_theme.theme();
    const QFont small = caption();
    const QFont bold = theme.font(TextRole::Emphasis, small);
    const double height = theme.u(20);
    const double top = box.top() - height - theme.u(8);
    painter.setFont(small);
    painter.setPen(theme.dim);
    const double left = m_rect.outerRect().left();
    painter.drawText(
        QRectF(left, top, box.left() - left - theme.u(7), height), Qt::AlignRight | Qt::AlignVCenter, m_decor.unit);
    if (!m_decor.secondUnit.isEmpty()) {
        const QRectF corner(box.right() + theme.u(7), top, m_decor.secondRoom + theme.u(40), height);
        painter.drawText(corner, Qt::AlignLeft | Qt::AlignVCenter, m_decor.secondUnit);
    }
    double x = box.left();
    const double end = m_decor.secondUnit.isEmpty() ? m_rect.outerRect().right() : box.right();
    const auto put = [&](const QString &text, const QFont &font, const QColor &color) {
        const QFontMetrics metrics(font);
        const QString shown = metrics.elidedText(text, Qt::ElideRight, static_cast<int>(std::max(0.0, end - x)));
        painter.setFont(font);
        painter.setPen(color);
        painter.drawText(QRectF(x, top, end - x, height), Qt::AlignVCenter, shown);
        x += metrics.horizontalAdvance(shown) + theme.u(16);
    };
    if (!m_decor.title.isEmpty())
        put(m_decor.title, bold, theme.text);
    for (const HeadEntry &entry : m_decor.entries) {
        if (end - x < theme.u(60))
            break;
        paintSwatch(painter, QRectF(x, top, theme.u(24), height), entry.look, theme);
        x += theme.u(30);
        put(entry.name, small, theme.text);
    }
}

void StripFace::drawKeyUnit(QCPPainter &painter, const QRectF &box) const
{
    if (m_decor.keyUnit.isEmpty())
        return;
    const Theme &theme = m_theme.theme();
    const QRectF corner(box.right() + theme.u(18), box.bottom() + theme.u(4), theme.u(40), theme.u(18));
    painter.setFont(caption());
    painter.setPen(theme.dim);
    painter.drawText(corner, Qt::AlignLeft | Qt::AlignVCenter, m_decor.keyUnit);
}

void StripFace::drawLimits(QCPPainter &painter, const QRectF &box) const
{
    const Theme &theme = m_theme.theme();
    const QCPAxis &values = *m_rect.axis(QCPAxis::atLeft);
    const QFontMetrics metrics(caption());
    painter.setFont(caption());
    for (const PlotLimit &limit : m_decor.limits) {
        const double y = std::floor(values.coordToPixel(limit.value)) + 0.5;
        if (y < box.top() || y > box.bottom())
            continue;
        QPen pen(theme.trace(limit.role), 1);
        pen.setCosmetic(true);
        pen.setDashPattern({4, 3});
        painter.setPen(pen);
        painter.drawLine(QLineF(box.left(), y, box.right(), y));
        const bool below = y - metrics.height() < box.top();
        const double top = below ? y + 1 : y - metrics.height() - 1;
        painter.setPen(theme.text);
        painter.drawText(
            QRectF(box.left(), top, box.width() - theme.u(4), metrics.height()), Qt::AlignRight, limit.text);
    }
    for (const PlotBand &band : m_decor.bands) {
        const double y = values.coordToPixel(band.upper) - metrics.height() - theme.u(2);
        painter.setPen(theme.tone(band.tone));
        painter.drawText(QRectF(box.left(), y, box.width() * 0.62, metrics.height()), Qt::AlignRight, band.text);
    }
    for (const PlotSpan &span : m_decor.spans) {
        const double x = m_rect.axis(QCPAxis::atBottom)->coordToPixel(span.from) + theme.u(4);
        painter.setPen(theme.dim);
        painter.drawText(QPointF(x, box.bottom() - theme.u(6)), span.text);
    }
}

void StripFace::drawNotes(QCPPainter &painter, const QRectF &box) const
{
    const Theme &theme = m_theme.theme();
    const QCPAxis &keys = *m_rect.axis(QCPAxis::atBottom);
    const QCPAxis &values = *m_rect.axis(QCPAxis::atLeft);
    std::vector<QRectF> taken;
    for (const GapLabel &gap : gapLabels(m_decor, keys, box, QFontMetrics(caption()), theme))
        taken.push_back(gap.place);
    for (const PlotNote &note : m_decor.notes) {
        const QPointF at(keys.coordToPixel(note.key), values.coordToPixel(note.value));
        if (at.x() < box.left() || at.x() > box.right())
            continue;
        const QFont font = note.strong ? theme.font(TextRole::Emphasis, caption()) : caption();
        QFont small = font;
        small.setPointSizeF(caption().pointSizeF());
        const QFontMetrics metrics(small);
        QRectF text(at + QPointF(theme.u(note.offset.x()), theme.u(note.offset.y())),
            QSizeF(metrics.horizontalAdvance(note.text) + 2, metrics.height()));
        text.moveRight(std::min(text.right(), box.right() - 2));
        text.moveBottom(std::clamp(text.bottom(), box.top() + text.height(), box.bottom()));
        const auto place = freePlace(text, box, taken);
        if (!place)
            continue;
        text = *place;
        taken.push_back(text);
        QPen leader(theme.dim, 1, Qt::DotLine);
        leader.setCosmetic(true);
        painter.setPen(leader);
        painter.drawLine(QLineF(at, QPointF(text.left() - 2, text.center().y())));
        painter.setFont(small);
        painter.setPen(theme.text);
        painter.drawText(text, Qt::AlignVCenter, note.text);
    }
}

void StripFace::drawTags(QCPPainter &painter, const QRectF &box) const
{
    const Theme &theme = m_theme.theme();
    const QFont font = caption();
    const auto place = [this](const ValueTag &tag) {
        return m_rect.axis(tag.second ? QCPAxis::atRight : QCPAxis::atLeft)->coordToPixel(tag.value);
    };
    const double line = QFontMetrics(font).height() + 1;
    std::vector<std::size_t> order(m_decor.tags.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::vector<double> centre;
    for (const ValueTag &tag : m_decor.tags)
        centre.push_back(std::clamp(place(tag), box.top() + line / 2, box.bottom() - line / 2));
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return centre[a] < centre[b]; });
    // Push apart downwards, then back up from the lower edge, so that no two tags overlap.
    for (std::size_t i = 1; i < order.size(); ++i)
        centre[order[i]] = std::max(centre[order[i]], centre[order[i - 1]] + line);
    double floor = box.bottom() - line / 2;
    for (auto it = order.rbegin(); it != order.rend(); ++it) {
        centre[*it] = std::min(centre[*it], floor);
        floor = centre[*it] - line;
    }
    painter.setFont(font);
    for (std::size_t i = 0; i < m_decor.tags.size(); ++i) {
        const ValueTag &tag = m_decor.tags[i];
        const double x = box.right() + m_decor.secondRoom + theme.u(6);
        QPen pen = tracePen(tag.look, theme);
        pen.setWidthF(theme.u(3));
        if (pen.style() != Qt::SolidLine)
            pen.setDashPattern({1.2, 0.8});
        pen.setCapStyle(Qt::FlatCap);
        painter.setPen(pen);
        painter.drawLine(QLineF(x + 1, centre[i] - theme.u(6), x + 1, centre[i] + theme.u(6)));
        painter.setPen(theme.text);
        painter.drawText(QRectF(x + theme.u(7), centre[i] - line / 2, theme.u(200), line), Qt::AlignVCenter, tag.text);
    }
}

} // namespace mb
