// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/wraplayout.h"

#include <QWidget>

#include <algorithm>
#include <numeric>

namespace mb {

WrapLayout::WrapLayout(QWidget *parent)
    : QLayout(parent)
{
    setSpacing(8);
}

WrapLayout::~WrapLayout()
{
    for (QLayoutItem *item : m_items)
        delete item;
}

int WrapLayout::gap() const
{
    return std::max(0, spacing());
}

void WrapLayout::prepend(QWidget *widget)
{
    addWidget(widget);
    std::rotate(m_items.begin(), m_items.end() - 1, m_items.end());
    m_spring += m_spring < 0 ? 0 : 1;
}

/// That of its line counts; the rest of what one is stretched by is found when it is placed.
QSize WrapLayout::sizeOf(QLayoutItem &item) const
{
    const bool stretched = m_stretched && item.widget() == m_stretched;
    return {stretched ? item.minimumSize().width() : item.sizeHint().width(), item.sizeHint().height()};
}

QLayoutItem *WrapLayout::itemAt(int index) const
{
    return index >= 0 && index < count() ? m_items[static_cast<std::size_t>(index)] : nullptr;
}

QLayoutItem *WrapLayout::takeAt(int index)
{
    QLayoutItem *item = itemAt(index);
    if (item)
        m_items.erase(m_items.begin() + index);
    m_spring -= item && index < m_spring ? 1 : 0;
    return item;
}

std::vector<WrapLayout::Line> WrapLayout::linesFor(int width) const
{
    std::vector<Line> lines(1);
    for (int i = 0; i < count(); ++i) {
        QLayoutItem &item = *m_items[static_cast<std::size_t>(i)];
        if (item.isEmpty())
            continue;
        const QSize hint = sizeOf(item);
        Line *line = &lines.back();
        if (!line->items.empty() && line->width + gap() + hint.width() > width) {
            lines.emplace_back();
            line = &lines.back();
        }
        line->width += hint.width() + (line->items.empty() ? 0 : gap());
        line->height = std::max(line->height, hint.height());
        line->items.push_back(i);
    }
    return lines;
}

void WrapLayout::placeLine(const Line &line, const QRect &room, bool sprung) const
{
    int x = room.left();
    int spare = std::max(0, room.width() - line.width);
    bool given = !sprung;
    for (const int i : line.items) {
        if (!given && i >= m_spring) {
            x += spare;
            given = true;
        }
        QLayoutItem &item = *m_items[static_cast<std::size_t>(i)];
        QSize size = sizeOf(item).boundedTo({room.width(), QWIDGETSIZE_MAX});
        if (m_stretched && item.widget() == m_stretched) {
            const int most = std::max(size.width(), item.maximumSize().width());
            size.setWidth(std::min(size.width() + spare, most));
            spare -= size.width() - sizeOf(item).width();
        }
        item.setGeometry(QRect(QPoint(x, room.top() + (line.height - size.height()) / 2), size));
        x += size.width() + gap();
    }
}

void WrapLayout::setGeometry(const QRect &rect)
{
    QLayout::setGeometry(rect);
    QRect room = rect.marginsRemoved(contentsMargins());
    const auto lines = linesFor(room.width());
    for (const Line &line : lines) {
        placeLine(line, room, m_spring >= 0 && lines.size() == 1);
        room.setTop(room.top() + line.height + lineGap());
    }
}

int WrapLayout::heightForWidth(int width) const
{
    const QMargins margins = contentsMargins();
    const auto lines = linesFor(width - margins.left() - margins.right());
    const int heights
        = std::accumulate(lines.begin(), lines.end(), 0, [](int sum, const Line &line) { return sum + line.height; });
    return heights + (static_cast<int>(lines.size()) - 1) * lineGap() + margins.top() + margins.bottom();
}

QSize WrapLayout::sizeHint() const
{
    const auto lines = linesFor(QWIDGETSIZE_MAX);
    const QMargins margins = contentsMargins();
    return {lines.front().width + margins.left() + margins.right(),
        lines.front().height + margins.top() + margins.bottom()};
}

QSize WrapLayout::minimumSize() const
{
    QSize size;
    for (const QLayoutItem *item : m_items)
        size = size.expandedTo(item->minimumSize());
    const QMargins margins = contentsMargins();
    return size + QSize(margins.left() + margins.right(), margins.top() + margins.bottom());
}

} // namespace mb
