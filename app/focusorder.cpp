// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/focusorder.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLayout>
#include <QMainWindow>
#include <QPlainTextEdit>
#include <QScrollArea>
#include <QTextEdit>

#include <algorithm>
#include <set>

namespace mb {
namespace {

/// A widget or a layout in its parent, where it stands.
struct Part {
    QRect place;
    QWidget *widget = nullptr;
    QLayout *layout = nullptr;
};
using Parts = std::vector<Part>;
using Found = std::vector<QWidget *>;

constexpr int slack = 3; ///< px that neighbours may overlap and still be apart

int begin(const QRect &place, Qt::Orientation along)
{
    return along == Qt::Vertical ? place.top() : place.left();
}

int end(const QRect &place, Qt::Orientation along)
{
    return along == Qt::Vertical ? place.bottom() : place.right();
}

/// Groups that no line across this direction would cut.
std::vector<Parts> cut(Parts parts, Qt::Orientation along)
{
    std::ranges::stable_sort(
        parts, [along](const Part &a, const Part &b) { return begin(a.place, along) < begin(b.place, along); });
    std::vector<Parts> groups;
    int reached = 0;
    for (const Part &part : parts) {
        if (groups.empty() || begin(part.place, along) > reached - slack)
            groups.emplace_back();
        reached = groups.back().empty() ? end(part.place, along) : std::max(reached, end(part.place, along));
        groups.back().push_back(part);
    }
    return groups;
}

void collect(const QWidget &widget, Found &found);

void collect(const Part &part, Found &found);

/// Rows first, then what stands side by side in them; what overlaps both ways by its corner.
void collect(Parts parts, Found &found)
{
    for (const Qt::Orientation along : {Qt::Vertical, Qt::Horizontal}) {
        std::vector<Parts> groups = cut(parts, along);
        if (groups.size() < 2)
            continue;
        for (Parts &group : groups)
            collect(std::move(group), found);
        return;
    }
    std::ranges::stable_sort(parts, [](const Part &a, const Part &b) {
        return std::pair(a.place.top(), a.place.left()) < std::pair(b.place.top(), b.place.left());
    });
    for (const Part &part : parts)
        collect(part, found);
}

Parts partsOf(const QLayout &layout)
{
    Parts parts;
    for (int i = 0; i < layout.count(); ++i) {
        QLayoutItem *item = layout.itemAt(i);
        if (item && !item->isEmpty() && (item->widget() || item->layout()))
            parts.push_back({item->geometry(), item->widget(), item->layout()});
    }
    return parts;
}

/// All widgets that a layout places, whatever layouts there are in it.
void gather(const QLayout &layout, std::set<const QWidget *> &placed)
{
    for (int i = 0; i < layout.count(); ++i) {
        QLayoutItem *item = layout.itemAt(i);
        if (item && item->widget())
            placed.insert(item->widget());
        else if (item && item->layout())
            gather(*item->layout(), placed);
    }
}

void collect(const Part &part, Found &found)
{
    if (part.layout)
        collect(partsOf(*part.layout), found);
    else
        collect(*part.widget, found);
}

void collect(const QWidget &widget, Found &found)
{
    if (!widget.isWindow() && (!widget.isVisible() || !widget.isEnabled()))
        return;
    if (!widget.isWindow() && (widget.focusPolicy() & Qt::TabFocus) != 0 && !widget.focusProxy())
        found.push_back(const_cast<QWidget *>(&widget));
    Parts parts;
    std::set<const QWidget *> placed;
    const bool main = qobject_cast<const QMainWindow *>(&widget); // whose layout does not tell its parts
    if (const QLayout *layout = main ? nullptr : widget.layout()) {
        parts = partsOf(*layout);
        gather(*layout, placed);
    }
    for (QObject *child : widget.children()) {
        auto *one = qobject_cast<QWidget *>(child);
        if (one && !one->isWindow() && placed.find(one) == placed.end())
            parts.push_back({one->geometry(), one, nullptr});
    }
    collect(std::move(parts), found);
}

} // namespace

std::vector<QWidget *> readingOrder(const QWidget &window)
{
    Found found;
    collect(window, found);
    return found;
}

/// Some editors take Tab for themselves. Tables would too, from cell to cell and round again: there are the arrows for that.
bool FocusOrder::takesTab(const QWidget &widget)
{
    if (const auto *text = qobject_cast<const QTextEdit *>(&widget))
        return !text->tabChangesFocus() && !text->isReadOnly();
    const auto *plain = qobject_cast<const QPlainTextEdit *>(&widget);
    return plain && !plain->tabChangesFocus() && !plain->isReadOnly();
}

void FocusOrder::go(QWidget &from, bool forwards)
{
    const std::vector<QWidget *> order = readingOrder(*from.window());
    if (order.empty())
        return;
    auto at = order.end(); // a cell that is edited stands for its table
    for (QWidget *one = &from; one && at == order.end() && !one->isWindow(); one = one->parentWidget())
        at = std::ranges::find(order, one);
    const auto count = static_cast<std::ptrdiff_t>(order.size());
    const std::ptrdiff_t place = at == order.end() ? (forwards ? -1 : 0) : at - order.begin();
    QWidget *next = order[static_cast<std::size_t>((place + (forwards ? 1 : count - 1) + count) % count)];
    next->setFocus(forwards ? Qt::TabFocusReason : Qt::BacktabFocusReason);
    for (QWidget *around = next->parentWidget(); around; around = around->parentWidget()) {
        auto *area = qobject_cast<QScrollArea *>(around);
        if (area && area->widget() && area->widget()->isAncestorOf(next))
            area->ensureWidgetVisible(next);
    }
}

bool FocusOrder::eventFilter(QObject *watched, QEvent *event)
{
    QWidget *focus = QApplication::focusWidget();
    if (event->type() != QEvent::KeyPress || !focus || watched != focus)
        return false;
    const auto &key = static_cast<const QKeyEvent &>(*event);
    const bool tab = key.key() == Qt::Key_Tab || key.key() == Qt::Key_Backtab;
    if (!tab || (key.modifiers() & (Qt::ControlModifier | Qt::AltModifier)) != 0 || takesTab(*focus))
        return false;
    go(*focus, key.key() == Qt::Key_Tab && (key.modifiers() & Qt::ShiftModifier) == 0);
    return true;
}

} // namespace mb
