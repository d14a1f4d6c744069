// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/service/unitlist.h"

#include "widgets/common/clocktext.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/numberformat.h"
#include "widgets/common/stateglyph.h"
#include "widgets/service/verdictof.h"

#include <QPainter>
#include <QStyledItemDelegate>

namespace mb {
namespace {

enum RowRole { Glyph = Qt::UserRole + 1, Unit, Number, Word, Line, Seconds, Time };

GlyphState glyphOf(service::RowState state)
{
    switch (state) {
    case service::RowState::Passed: return GlyphState::Done;
    case service::RowState::Failed: return GlyphState::Fault;
    case service::RowState::Refused: return GlyphState::Warning;
    case service::RowState::Running: return GlyphState::Busy;
    case service::RowState::Skipped: return GlyphState::Volatile;
    case service::RowState::Waiting: break;
    }
    return GlyphState::Waiting;
}

/// Draws a text into the left or right of what is left of a row, and takes its width from there.
void take(QPainter &painter, QRect &room, const QFont &font, const QColor &color, const QString &text, bool fromRight,
    int gap)
{
    painter.setFont(font);
    painter.setPen(color);
    const QString shown = QFontMetrics(font).elidedText(text, Qt::ElideRight, room.width());
    const int side = fromRight ? Qt::AlignRight : Qt::AlignLeft;
    QRect taken;
    painter.drawText(room, side | Qt::AlignVCenter, shown, &taken);
    const int width = shown.isEmpty() ? 0 : taken.width() + gap;
    fromRight ? room.setRight(room.right() - width) : room.setLeft(room.left() + width);
}

} // namespace

class UnitList::Row : public QStyledItemDelegate {
public:
    Row(const ThemeSource &theme, QObject *parent)
        : QStyledItemDelegate(parent)
        , m_theme(theme)
    {
    }
    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem &option, const QModelIndex &) const override
    {
        return {0, 2 * QFontMetrics(option.font).height() + m_theme.theme().u(8)};
    }
    void paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const override;

private:
    const ThemeSource &m_theme;
};

/// Two lines: who and how it went; and why, seconds, time.
void UnitList::Row::paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    const Theme &theme = m_theme.theme();
    painter->save();
    painter->setPen(theme.line);
    painter->drawLine(option.rect.bottomLeft(), option.rect.bottomRight());
    const auto state = static_cast<GlyphState>(index.data(Glyph).toInt());
    const QColor color = glyphColor(state, theme);
    QRect row = option.rect.adjusted(theme.u(12), theme.u(3), -theme.u(12), -theme.u(4));
    const int side = theme.u(14);
    paintGlyph(*painter, QRectF(row.left(), row.center().y() - side / 2.0, side, side), state, color);
    row.setLeft(row.left() + side + theme.u(10));
    const int gap = theme.u(10);
    const QFont body = theme.font(TextRole::Body, option.font);
    const QFont caption = theme.font(TextRole::Caption, option.font);
    QRect top(row.left(), row.top(), row.width(), row.height() / 2);
    QRect below(row.left(), top.bottom() + 1, row.width(), row.height() - top.height());
    take(*painter, top, theme.font(TextRole::Raw, option.font), theme.text, index.data(Unit).toString(), false, gap);
    take(*painter, top, theme.font(TextRole::Emphasis, option.font), theme.text, index.data(Number).toString(), false,
        gap);
    take(*painter, top, theme.font(TextRole::Emphasis, option.font), color, index.data(Word).toString(), true, gap);
    take(*painter, below, caption, theme.dim, index.data(Time).toString(), true, gap);
    take(*painter, below, body, theme.text, index.data(Seconds).toString(), true, gap);
    take(*painter, below, caption, theme.dim, index.data(Line).toString(), false, gap);
    painter->restore();
}

UnitList::UnitList(const ThemeSource &theme, QWidget *parent)
    : QListWidget(parent)
    , m_theme(theme)
{
    setAccessibleName(tr("Last ten units, newest first"));
    setFocusPolicy(Qt::NoFocus);
    setSelectionMode(QAbstractItemView::NoSelection);
    setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setItemDelegate(new Row(theme, this));
    connect(&theme, &ThemeSource::changed, viewport(), qOverload<>(&QWidget::update));
}

void UnitList::follow(const ServiceView &view)
{
    clear();
    for (int i = static_cast<int>(view.rows.size()) - 1; i >= 0 && this->count() < shown; --i) {
        const service::QueueRow &row = view.rows[static_cast<std::size_t>(i)];
        if (row.state == service::RowState::Skipped && row.visit.id.empty()) // nothing was done to it
            continue;
        const QString number = row.visit.number ? QStringLiteral("#%1").arg(*row.visit.number) : QString();
        auto *item = new QListWidgetItem(
            QStringList{nameOf(row), number, wordOf(row), lineOf(row)}.join(QLatin1Char(' ')).simplified(), this);
        item->setData(Glyph, static_cast<int>(glyphOf(row.state)));
        item->setData(Unit, nameOf(row));
        item->setData(Number, number);
        item->setData(Word, wordOf(row));
        item->setData(Line, lineOf(row));
        if (row.visit.seconds > 0.0)
            item->setData(Seconds, formatValue(row.visit.seconds, 1, QStringLiteral("s")));
        if (row.visit.time > 0.0)
            item->setData(Time, clockText(momentOf(row.visit.time), ClockPart::Minutes));
        item->setToolTip(lineOf(row));
    }
}

} // namespace mb
