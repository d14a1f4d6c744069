// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/curvemarks.h"

#include "widgets/common/clamped.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace mb {
namespace {

constexpr double bandShare = 0.16; ///< of its colour
constexpr double plateShare = 0.8; ///< of what is behind words, that is covered
constexpr int mostMoves = 12;      ///< of words that make room for each other

/// Where words of this size stand beside a point.
QRectF besidePoint(const QPointF &at, const QSizeF &size, Qt::Alignment side, double gap)
{
    const double x = side & Qt::AlignLeft ? at.x() - gap - size.width()
        : side & Qt::AlignHCenter         ? at.x() - size.width() / 2
                                          : at.x() + gap;
    const double y = side & Qt::AlignTop ? at.y() - gap - size.height()
        : side & Qt::AlignVCenter        ? at.y() - size.height() / 2
                                         : at.y() + gap;
    return {QPointF(x, y), size};
}

QRectF inside(QRectF box, const QRectF &room)
{
    box.moveLeft(std::max(std::min(box.left(), room.right() - box.width()), room.left()));
    box.moveTop(std::max(std::min(box.top(), room.bottom() - box.height()), room.top()));
    return box;
}

bool isFree(const QRectF &box, const std::vector<QRectF> &taken)
{
    return std::ranges::none_of(taken, [&box](const QRectF &other) { return other.intersects(box); });
}

/// The nearest place above or below that no other words have; nothing where there is none.
std::optional<QRectF> clearOf(const QRectF &box, const std::vector<QRectF> &taken, const QRectF &room)
{
    for (int i = 0; i < mostMoves; ++i) {
        for (const int way : {1, -1}) {
            const QRectF moved = inside(box.translated(0, way * i * box.height() / 2), room);
            if (isFree(moved, taken))
                return moved;
        }
    }
    return {};
}

} // namespace

CurveMarks::CurveMarks(QCustomPlot &plot, const ThemeSource &theme)
    : QObject(&plot)
    , m_plot(plot)
    , m_theme(theme)
{
    connect(&plot, &QCustomPlot::afterLayout, this, &CurveMarks::arrange);
}

void CurveMarks::set(std::vector<CurveMark> marks, const QFont &body)
{
    for (QCPAbstractItem *item : m_items)
        m_plot.removeItem(item);
    m_items.clear();
    m_words.clear();
    m_body = body;
    m_marks = std::move(marks);
    for (const CurveMark &mark : m_marks)
        add(mark);
}

void CurveMarks::add(const CurveMark &mark)
{
    const Theme &look = m_theme.theme();
    switch (mark.kind) {
    case CurveMark::Kind::Band:
    case CurveMark::Kind::Beyond: {
        auto *const box = new QCPItemRect(&m_plot);
        m_items.push_back(box);
        const bool band = mark.kind == CurveMark::Kind::Band;
        box->topLeft->setTypeX(band ? QCPItemPosition::ptAxisRectRatio : QCPItemPosition::ptPlotCoords);
        box->topLeft->setTypeY(band ? QCPItemPosition::ptPlotCoords : QCPItemPosition::ptAxisRectRatio);
        box->bottomRight->setTypeX(QCPItemPosition::ptAxisRectRatio);
        box->bottomRight->setTypeY(band ? QCPItemPosition::ptPlotCoords : QCPItemPosition::ptAxisRectRatio);
        box->topLeft->setCoords(band ? 0.0 : mark.x, band ? mark.to : 0.0);
        box->bottomRight->setCoords(1.0, band ? mark.y : 1.0);
        QColor fill = look.tone(mark.tone);
        fill.setAlphaF(bandShare);
        box->setPen(Qt::NoPen);
        box->setBrush(band ? QBrush(fill) : QBrush(look.line, Qt::BDiagPattern));
        box->setLayer(QStringLiteral("grid"));
        if (!band)
            addLine({CurveMark::Kind::Upright, mark.x}, QPen(look.outline, 1));
        return;
    }
    case CurveMark::Kind::Upright: return addLine(mark, QPen(look.accent, 1, Qt::DotLine));
    case CurveMark::Kind::Level: return addLine(mark, QPen(look.dim, 1, Qt::DashLine));
    case CurveMark::Kind::Span: return addLine(mark, QPen(look.accent, look.u(3)));
    case CurveMark::Kind::Ring: {
        auto *const ring = new QCPItemTracer(&m_plot);
        m_items.push_back(ring);
        ring->setStyle(QCPItemTracer::tsCircle);
        ring->position->setCoords(mark.x, mark.y);
        ring->setSize(look.u(8));
        ring->setPen(QPen(look.accent, 2));
        ring->setBrush(look.canvas);
        return;
    }
    case CurveMark::Kind::Words: return addWords(mark);
    }
}

void CurveMarks::addLine(const CurveMark &mark, const QPen &pen)
{
    auto *const line = new QCPItemLine(&m_plot);
    m_items.push_back(line);
    line->setPen(pen);
    const bool upright = mark.kind == CurveMark::Kind::Upright;
    const bool level = mark.kind == CurveMark::Kind::Level;
    for (QCPItemPosition *end : {line->start, line->end}) {
        end->setTypeX(level ? QCPItemPosition::ptAxisRectRatio : QCPItemPosition::ptPlotCoords);
        end->setTypeY(upright ? QCPItemPosition::ptAxisRectRatio : QCPItemPosition::ptPlotCoords);
    }
    line->start->setCoords(level ? 0.0 : mark.x, upright ? 0.0 : mark.y);
    line->end->setCoords(level ? 1.0 : mark.x, upright ? 1.0 : level ? mark.y : mark.to);
}

void CurveMarks::addWords(const CurveMark &mark)
{
    const Theme &look = m_theme.theme();
    auto *const words = new QCPItemText(&m_plot);
    m_items.push_back(words);
    QFont font = look.font(TextRole::Caption, m_body);
    font.setBold(mark.strong);
    QColor plate = look.canvas;
    plate.setAlphaF(plateShare);
    words->setText(mark.text);
    words->setFont(font);
    words->setColor(look.tone(mark.tone));
    words->setBrush(plate);
    words->setTextAlignment(mark.side & Qt::AlignLeft ? Qt::AlignRight : Qt::AlignLeft);
    words->setPositionAlignment(Qt::AlignLeft | Qt::AlignTop);
    words->position->setType(QCPItemPosition::ptAbsolute);
    m_words.emplace_back(mark, words);
}

/// Words stand where there is room for them: nothing is cut at an edge, and none covers another; those for which none is left are not shown.
void CurveMarks::arrange()
{
    const QRectF room = m_plot.axisRect()->rect();
    std::vector<QRectF> taken;
    for (const auto &[mark, words] : m_words) {
        const QPointF at(
            m_plot.xAxis->coordToPixel(mark.x), clamped(m_plot.yAxis->coordToPixel(mark.y), room.top(), room.bottom()));
        words->setVisible(std::isfinite(at.x()) && at.x() >= room.left() - 1 && at.x() <= room.right() + 1);
        if (!words->visible())
            continue;
        const QSizeF size = QFontMetrics(words->font()).boundingRect({}, Qt::AlignLeft, mark.text).size();
        const QRectF wished = inside(besidePoint(at, size, mark.side, m_theme.theme().u(6)), room);
        const std::optional<QRectF> place = clearOf(wished, taken, room);
        words->setVisible(place.has_value());
        if (!place)
            continue;
        taken.push_back(*place);
        words->position->setCoords(place->topLeft());
    }
}

} // namespace mb
