// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/stripface.h"

#include "widgets/common/clamped.h"
#include "widgets/plots/plotframe.h"
#include "widgets/plots/plotlabels.h"
#include "widgets/plots/plottickers.h"

#include <algorithm>
#include <cmath>
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
    drawMarks(*painter, box);
    drawWords(*painter);
    painter->restore();
    drawTrigger(*painter, box);
}

void StripFace::drawHead(QCPPainter &painter, const QRectF &box) const
{
    const Theme &theme = m_theme.theme();
    const QFont small = caption();
    const QFont bold = theme.font(TextRole::Emphasis, small);
    const double height = theme.u(headHeight);
    const double top = box.top() - height - m_decor.headGap;
    painter.setFont(small);
    painter.setPen(theme.dim);
    const double left = m_rect.outerRect().left();
    const bool low = m_decor.headGap == 0; // above the number at the top of the axis, which ends beside it
    const QRectF corner(left + (low ? theme.u(4) : 0), top, box.left() - left - theme.u(low ? 4 : 7), height);
    painter.drawText(
        corner, static_cast<int>(low ? Qt::AlignLeft | Qt::AlignTop : Qt::AlignRight | Qt::AlignVCenter), m_decor.unit);
    if (!m_decor.secondUnit.isEmpty()) {
        const QRectF other(box.right() + theme.u(7), top, m_decor.secondAxisWidth + theme.u(40), height);
        painter.drawText(other, Qt::AlignLeft | Qt::AlignVCenter, m_decor.secondUnit);
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
    const auto *ticker = dynamic_cast<const TimeTicker *>(m_rect.axis(QCPAxis::atBottom)->ticker().data());
    if (m_decor.keyUnit.isEmpty() || !ticker || !ticker->showsSeconds())
        return;
    const Theme &theme = m_theme.theme();
    const QRectF corner(box.right() + theme.u(18), box.bottom() + theme.u(4), theme.u(40), theme.u(18));
    painter.setFont(caption());
    painter.setPen(theme.dim);
    painter.drawText(corner, Qt::AlignLeft | Qt::AlignVCenter, m_decor.keyUnit);
}

void StripFace::drawLimits(QCPPainter &painter, const QRectF &box) const
{
    for (const PlotLimit &limit : m_decor.limits) {
        const double y = std::floor(m_rect.axis(QCPAxis::atLeft)->coordToPixel(limit.value)) + 0.5;
        if (y < box.top() || y > box.bottom())
            continue;
        QPen pen(m_theme.theme().trace(limit.role), 1);
        pen.setCosmetic(true);
        pen.setDashPattern({4, 3});
        painter.setPen(pen);
        painter.drawLine(QLineF(box.left(), y, box.right(), y));
    }
}

void StripFace::drawMarks(QCPPainter &painter, const QRectF &box) const
{
    const Theme &theme = m_theme.theme();
    const QCPAxis &keys = *m_rect.axis(QCPAxis::atBottom);
    for (const PlotMark &mark : m_decor.marks) {
        const double x = std::floor(keys.coordToPixel(mark.key)) + 0.5;
        if (x < box.left() || x > box.right())
            continue;
        QPen pen(theme.dim, 1, Qt::DotLine);
        pen.setCosmetic(true);
        painter.setAntialiasing(false);
        painter.setPen(pen);
        painter.drawLine(QLineF(x, box.top(), x, box.bottom()));
    }
    painter.setAntialiasing(true);
}

void StripFace::drawFlag(QCPPainter &painter, const PlotMark &mark, const QRectF &place) const
{
    const Theme &theme = m_theme.theme();
    painter.setPen(QPen(theme.outline, 1));
    painter.setBrush(theme.panel);
    painter.drawRoundedRect(place, theme.u(3), theme.u(3));
    painter.setBrush(Qt::NoBrush);
    painter.setPen(theme.text);
    painter.drawText(place, Qt::AlignCenter, mark.text);
}

void StripFace::drawTrigger(QCPPainter &painter, const QRectF &box) const
{
    if (!m_decor.trigger)
        return;
    const Theme &theme = m_theme.theme();
    const QCPAxis &values = *m_rect.axis(m_decor.trigger->second ? QCPAxis::atRight : QCPAxis::atLeft);
    const double wanted = values.coordToPixel(m_decor.trigger->level);
    const double y = std::floor(clamped(wanted, box.top(), box.bottom())) + 0.5;
    const bool inside = wanted >= box.top() && wanted <= box.bottom();
    QPen pen(theme.accent, 1);
    pen.setCosmetic(true);
    pen.setDashPattern({1, 3});
    painter.setAntialiasing(false);
    painter.setPen(pen);
    if (inside)
        painter.drawLine(QLineF(box.left(), y, box.right(), y));
    painter.setAntialiasing(true);
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme.accent);
    const double size = theme.u(6);
    painter.drawPolygon(QPolygonF({{box.left(), y - size}, {box.left() + size, y}, {box.left(), y + size}}));
}

void StripFace::drawWords(QCPPainter &painter) const
{
    const Theme &theme = m_theme.theme();
    const auto write = [&painter](const QRectF &place, const QString &text, const QColor &color) {
        painter.setPen(color);
        painter.drawText(place, Qt::AlignCenter, text);
    };
    QColor behind = theme.canvas; // what must cross a curve is still read
    behind.setAlphaF(0.8);
    const std::vector<StripWord> words = stripWords(m_decor, m_rect, caption(), theme);
    for (const StripWord &word : words) { // below all of them
        if (word.kind == StripWord::Kind::Note)
            drawLeader(painter, m_decor.notes[word.index], word.place);
    }
    for (const StripWord &word : words) {
        painter.setFont(caption());
        if (!m_decor.curves.empty() && word.kind != StripWord::Kind::Mark)
            painter.fillRect(word.place, behind);
        switch (word.kind) {
        case StripWord::Kind::Mark: drawFlag(painter, m_decor.marks[word.index], word.place); break;
        case StripWord::Kind::Limit: write(word.place, m_decor.limits[word.index].text, theme.text); break;
        case StripWord::Kind::Trigger: write(word.place, m_decor.trigger->text, theme.accent); break;
        case StripWord::Kind::Note: drawNote(painter, m_decor.notes[word.index], word.place); break;
        case StripWord::Kind::Band:
            write(word.place, m_decor.bands[word.index].text, theme.tone(m_decor.bands[word.index].tone));
            break;
        case StripWord::Kind::Span: write(word.place, m_decor.spans[word.index].text, theme.dim); break;
        }
    }
}

void StripFace::drawLeader(QCPPainter &painter, const PlotNote &note, const QRectF &place) const
{
    const QPointF at(
        m_rect.axis(QCPAxis::atBottom)->coordToPixel(note.key), m_rect.axis(QCPAxis::atLeft)->coordToPixel(note.value));
    QPen leader(m_theme.theme().dim, 1, Qt::DotLine);
    leader.setCosmetic(true);
    painter.setPen(leader);
    const double end = at.x() > place.right() ? place.right() + 2 : std::max(at.x(), place.left() - 2);
    const double top = at.y() < place.top() ? place.top() : at.y() > place.bottom() ? place.bottom() : at.y();
    const bool over = end > place.left() - 2 && end < place.right() + 2; // straight above or below the point
    painter.drawLine(QLineF(at, QPointF(end, over ? top : place.center().y())));
}

void StripFace::drawNote(QCPPainter &painter, const PlotNote &note, const QRectF &place) const
{
    const Theme &theme = m_theme.theme();
    QFont font = note.strong ? theme.font(TextRole::Emphasis, caption()) : caption();
    font.setPointSizeF(caption().pointSizeF());
    painter.setFont(font);
    painter.setPen(theme.text);
    painter.drawText(place, Qt::AlignVCenter, note.text);
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
        centre.push_back(clamped(place(tag), box.top() + line / 2, box.bottom() - line / 2));
    std::ranges::sort(order, [&](std::size_t a, std::size_t b) { return centre[a] < centre[b]; });
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
        const double x = box.right() + m_decor.secondAxisWidth + theme.u(6);
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
