// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/service/verdictview.h"

#include "widgets/common/clamped.h"
#include "widgets/common/icons.h"
#include "widgets/common/numberformat.h"

#include <QAccessible>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>

namespace mb {
namespace {

using Kind = Verdict::Kind;

constexpr double leastZoom = 0.4;
constexpr double mostZoom = 1.8;
constexpr double smallPrint = 1.5; ///< from it on the picture is so small that the name stands beside the word

/// As large as asked, smaller where the width needs it; letters grow in steps, so it is tried until they fit.
QFont fitted(QFont font, const QString &text, int width)
{
    constexpr double step = 0.96;
    constexpr double least = 8.0;
    while (font.pointSizeF() > least && QFontMetricsF(font).horizontalAdvance(text) > width)
        font.setPointSizeF(font.pointSizeF() * step);
    return font;
}

/// Small print of a picture that is drawn smaller stays as large as elsewhere in the window, as far as there is room for it.
QFont printed(QFont font, double print)
{
    font.setPointSizeF(font.pointSizeF() * print);
    return font;
}

int paintLine(QPainter &painter, const QRect &box, const QFont &font, const QColor &color, const QString &text,
    int alignment = Qt::AlignLeft)
{
    painter.setFont(font);
    painter.setPen(color);
    const QFontMetrics metrics(font);
    painter.drawText(QRect(box.topLeft(), QSize(box.width(), metrics.height())), alignment | Qt::AlignVCenter,
        metrics.elidedText(text, Qt::ElideRight, box.width()));
    return metrics.height();
}

} // namespace

VerdictView::VerdictView(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    setFocusPolicy(Qt::StrongFocus);
    connect(&theme, &ThemeSource::changed, this, qOverload<>(&QWidget::update));
    announce();
}

QString VerdictView::wordOf(Kind kind)
{
    switch (kind) {
    case Kind::Waiting: return tr("READY");
    case Kind::Working: return tr("WORKING");
    case Kind::Passed: return tr("PASS");
    case Kind::Failed: return tr("FAIL");
    case Kind::Refused: return tr("REFUSED");
    case Kind::LeftOut: return tr("LEFT OUT");
    }
    return {};
}

void VerdictView::setVerdict(const Verdict &verdict)
{
    const bool spoken
        = verdict.kind != m_verdict.kind || verdict.unit != m_verdict.unit || verdict.next != m_verdict.next;
    m_verdict = verdict;
    update();
    if (spoken)
        announce();
}

void VerdictView::announce()
{
    setAccessibleName(wordOf(m_verdict.kind) + QLatin1Char(' ') + m_verdict.unit);
    setAccessibleDescription(QStringList{m_verdict.step, m_verdict.cause, m_verdict.remedy, m_verdict.next}
                                 .join(QLatin1Char(' '))
                                 .trimmed());
    QAccessibleEvent event(this, QAccessible::NameChanged);
    QAccessible::updateAccessibility(&event);
}

QSize VerdictView::minimumSizeHint() const
{
    return {m_theme.theme().u(336), m_theme.theme().u(144)};
}

QSize VerdictView::sizeHint() const
{
    return {m_theme.theme().u(840), m_theme.theme().u(360)};
}

QColor VerdictView::colour() const
{
    const Theme &theme = m_theme.theme();
    switch (m_verdict.kind) {
    case Kind::Waiting: return theme.outline;
    case Kind::Working: return theme.accent;
    case Kind::Passed: return theme.ok;
    case Kind::Failed: return theme.danger;
    case Kind::Refused:
    case Kind::LeftOut: return theme.caution;
    }
    return theme.outline;
}

QColor VerdictView::ground() const
{
    const Theme &theme = m_theme.theme();
    switch (m_verdict.kind) {
    case Kind::Waiting: return theme.panel;
    case Kind::Working: return theme.bannerInfo;
    case Kind::Passed: return theme.bannerOk;
    case Kind::Failed: return theme.bannerDanger;
    case Kind::Refused:
    case Kind::LeftOut: return theme.bannerCaution;
    }
    return theme.panel;
}

/// Each verdict has a shape of its own, which is told apart without its colour: tick in a circle, cross in a square, mark in a
/// triangle, an open ring, two chevrons, a bar in a circle.
void VerdictView::paintShape(QPainter &painter, const QRectF &box) const
{
    const double unit = box.width() / 12.0;
    const auto at = [&](double x, double y) { return box.topLeft() + QPointF(x, y) * unit; };
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colour(), unit * 0.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    QPainterPath outline;
    QPainterPath mark;
    switch (m_verdict.kind) {
    case Kind::Passed:
        outline.addEllipse(box);
        mark.moveTo(at(3.2, 6.4));
        mark.lineTo(at(5.2, 8.4));
        mark.lineTo(at(8.8, 4.0));
        break;
    case Kind::Failed:
        outline.addRoundedRect(box, unit, unit);
        mark.moveTo(at(3.5, 3.5));
        mark.lineTo(at(8.5, 8.5));
        mark.moveTo(at(8.5, 3.5));
        mark.lineTo(at(3.5, 8.5));
        break;
    case Kind::Refused:
        outline.addPolygon(QPolygonF({at(6, 0.6), at(12, 11.4), at(0, 11.4), at(6, 0.6)}));
        mark.moveTo(at(6, 4.2));
        mark.lineTo(at(6, 7.4));
        mark.moveTo(at(6, 9.3));
        mark.lineTo(at(6, 9.4));
        break;
    case Kind::Waiting: outline.addEllipse(box); break;
    case Kind::LeftOut:
        outline.addEllipse(box);
        mark.moveTo(at(3.5, 6.0));
        mark.lineTo(at(8.5, 6.0));
        break;
    case Kind::Working:
        for (const double x : {2.0, 6.0}) {
            mark.moveTo(at(x, 2.5));
            mark.lineTo(at(x + 3.5, 6.0));
            mark.lineTo(at(x, 9.5));
        }
        break;
    }
    painter.drawPath(outline);
    painter.setPen(QPen(colour(), unit * 1.1, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(mark);
}

int VerdictView::paintHead(QPainter &painter, const QRect &box, double print) const
{
    const Theme &theme = m_theme.theme();
    const int shape = std::min(theme.u(128), box.height() * 2 / 5);
    const int gap = theme.u(40);
    paintShape(painter, QRectF(box.left(), box.top() + theme.u(10), shape, shape));
    const int right = theme.u(120);
    const QRect words = box.adjusted(shape + gap, 0, -right, 0);
    const QString word = wordOf(m_verdict.kind);
    const QFont large = fitted(theme.font(TextRole::Verdict, font()), word, words.width());
    int height = paintLine(painter, words, large, colour(), word);
    QFont unit = theme.font(TextRole::Raw, font());
    unit.setPointSizeF(theme.bodyPointSize * 3.2);
    const bool isLow = print > smallPrint; // the cause needs the room
    const int past = isLow ? static_cast<int>(QFontMetricsF(large).horizontalAdvance(word)) + gap : 0;
    const QRect beside = words.adjusted(past, isLow ? 0 : height, 0, 0);
    const QFont named = fitted(unit, m_verdict.unit, beside.width());
    if (isLow)
        paintLine(painter,
            QRect(beside.topLeft(), QSize(beside.width(), height))
                .translated(0, (height - QFontMetrics(named).height()) / 2),
            named, theme.text, m_verdict.unit);
    else
        height += paintLine(painter, beside, named, theme.text, m_verdict.unit);
    QFont number = theme.font(TextRole::Title, font());
    number.setPointSizeF(theme.bodyPointSize * 3.0);
    const QRect side(box.right() - right, box.top() + theme.u(36), right, box.height());
    const int below = paintLine(
        painter, side, fitted(number, m_verdict.number, right), theme.text, m_verdict.number, Qt::AlignRight);
    if (m_verdict.seconds > 0.0)
        paintSeconds(painter, side.adjusted(0, below, 0, 0), print);
    return std::max(height, shape + theme.u(20));
}

void VerdictView::paintSeconds(QPainter &painter, const QRect &box, double print) const
{
    const Theme &theme = m_theme.theme();
    const QString seconds = formatNumber(m_verdict.seconds, 1) + QChar(QChar::Nbsp) + QStringLiteral("s");
    const QFont font = fitted(printed(theme.font(TextRole::Large, this->font()), print), seconds, box.width());
    paintLine(painter, box, font, theme.dim, seconds, Qt::AlignRight);
}

int VerdictView::paintFacts(QPainter &painter, const QRect &box, double print) const
{
    const Theme &theme = m_theme.theme();
    const int count = static_cast<int>(m_verdict.facts.size());
    if (count == 0)
        return 0;
    const int width = box.width() / std::max(count, 4);
    const double natural = 2 * QFontMetricsF(theme.font(TextRole::Caption, font())).height()
        + QFontMetricsF(theme.font(TextRole::Large, font())).height();
    print = clamped(box.height() / natural, 1.0, print);
    const QFont caption = printed(theme.font(TextRole::Caption, font()), print);
    const QFont large = printed(theme.font(TextRole::Large, font()), print);
    int height = 0;
    for (int i = 0; i < count; ++i) {
        const Verdict::Fact &fact = m_verdict.facts[static_cast<std::size_t>(i)];
        QRect cell(box.left() + i * width, box.top(), width - theme.u(12), box.height());
        painter.setPen(QPen(theme.line, 1));
        painter.drawLine(cell.left(), cell.top(), cell.left(), cell.top() + static_cast<int>(theme.u(56) * print));
        cell.adjust(theme.u(10), 0, 0, 0);
        int y = paintLine(painter, cell, caption, theme.dim, fact.name);
        y += paintLine(
            painter, cell.adjusted(0, y, 0, 0), fitted(large, fact.value, cell.width()), theme.text, fact.value);
        y += paintLine(painter, cell.adjusted(0, y, 0, 0), caption, theme.dim, fact.note);
        height = std::max(height, y);
    }
    return height + theme.u(12);
}

/// Cause and remedy in full: smaller where there is little room.
void VerdictView::paintCause(QPainter &painter, const QRect &box, double print) const
{
    constexpr double step = 0.94;
    constexpr double least = 0.5;
    const Theme &theme = m_theme.theme();
    const auto paint = [&](double scale, bool isDrawn) {
        int y = 0;
        for (const QString &line : {m_verdict.cause, m_verdict.remedy}) {
            if (line.isEmpty())
                continue;
            QFont words = theme.font(TextRole::Title, font());
            words.setPointSizeF(theme.bodyPointSize * (y == 0 ? 1.8 : 1.4) * scale);
            words.setBold(y == 0);
            const QRect place = box.adjusted(0, y, 0, 0);
            if (isDrawn) {
                painter.setFont(words);
                painter.setPen(y == 0 ? theme.text : theme.dim);
                painter.drawText(place, Qt::TextWordWrap | Qt::TextDontClip, line);
            }
            y += QFontMetrics(words).boundingRect(QRect(0, 0, box.width(), 0), Qt::TextWordWrap, line).height()
                + theme.u(6);
        }
        return y;
    };
    double scale = print;
    while (scale > least && paint(scale, false) > box.height())
        scale *= step;
    paint(scale, true);
}

void VerdictView::paintProgress(QPainter &painter, const QRect &box) const
{
    const Theme &theme = m_theme.theme();
    const int y = paintLine(painter, box, theme.font(TextRole::Large, font()), theme.text, m_verdict.step);
    const QRect bar(box.left(), box.top() + y + theme.u(8), box.width(), theme.u(12));
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme.line);
    painter.drawRoundedRect(bar, theme.u(2), theme.u(2));
    painter.setBrush(theme.accent);
    const int done = static_cast<int>(bar.width() * std::clamp(m_verdict.share, 0.0, 1.0));
    painter.drawRoundedRect(QRect(bar.topLeft(), QSize(done, bar.height())), theme.u(2), theme.u(2));
}

void VerdictView::paintFoot(QPainter &painter, const QRect &box, double print) const
{
    const Theme &theme = m_theme.theme();
    if (m_verdict.next.isEmpty())
        return;
    painter.setPen(QPen(theme.line, 1));
    painter.drawLine(box.left(), box.top(), box.right(), box.top());
    QFont words = theme.font(TextRole::Title, font());
    words.setPointSizeF(theme.bodyPointSize * 2.3);
    const QRect inner = box.adjusted(theme.u(24), theme.u(print > smallPrint ? 4 : 12), -theme.u(24), 0);
    const int y = paintLine(painter, inner, fitted(words, m_verdict.next, inner.width()), theme.text, m_verdict.next);
    paintLine(painter, inner.adjusted(0, y, 0, 0), printed(theme.font(TextRole::Body, font()), print), theme.dim,
        m_verdict.hint);
}

void VerdictView::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Theme &theme = m_theme.theme();
    const double zoom = std::clamp(
        std::min(width() / double(sizeHint().width()), height() / double(sizeHint().height())), leastZoom, mostZoom);
    painter.scale(zoom, zoom); // what has more room is read from farther away
    const double print = std::max(1.0, 1.0 / zoom);
    const QRect whole(0, 0, static_cast<int>(width() / zoom), static_cast<int>(height() / zoom));
    const int frame = theme.u(3);
    painter.setBrush(ground());
    painter.setPen(QPen(hasFocus() ? theme.accent : colour(), frame, Qt::SolidLine));
    painter.drawRoundedRect(whole.adjusted(frame, frame, -frame, -frame), theme.u(4), theme.u(4));
    const int edge = theme.u(36);
    const int foot = m_verdict.next.isEmpty() ? 0 : theme.u(88);
    const int spare = std::max(0, whole.height() - sizeHint().height()); // no empty half: all of it stands lower
    const QRect inner = whole.adjusted(edge, theme.u(16) + spare / 4, -edge, -foot - frame);
    int y = paintHead(painter, inner, print) + theme.u(12) + spare / 4;
    const QRect rest = inner.adjusted(0, y, 0, 0);
    if (m_verdict.kind == Kind::Working)
        paintProgress(painter, rest);
    else if (!m_verdict.cause.isEmpty())
        paintCause(painter, rest, print);
    else
        paintFacts(painter, rest, print);
    paintFoot(painter, QRect(frame, whole.height() - foot, whole.width() - 2 * frame, foot), print);
}

} // namespace mb
