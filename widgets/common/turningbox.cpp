// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/turningbox.h"

#include <QWidget>

#include <algorithm>

namespace mb {
namespace {

/// Answers as another layout's item does, and leaves it where it lies.
class Mirror : public QLayoutItem {
public:
    explicit Mirror(const QLayoutItem &item)
        : QLayoutItem(item.alignment())
        , m_item(item)
    {
    }
    [[nodiscard]] QSize sizeHint() const override { return m_item.sizeHint(); }
    [[nodiscard]] QSize minimumSize() const override { return m_item.minimumSize(); }
    [[nodiscard]] QSize maximumSize() const override { return m_item.maximumSize(); }
    [[nodiscard]] Qt::Orientations expandingDirections() const override { return m_item.expandingDirections(); }
    [[nodiscard]] bool isEmpty() const override { return m_item.isEmpty(); }
    [[nodiscard]] bool hasHeightForWidth() const override { return m_item.hasHeightForWidth(); }
    [[nodiscard]] int heightForWidth(int width) const override { return m_item.heightForWidth(width); }
    [[nodiscard]] QRect geometry() const override { return m_item.geometry(); }
    void setGeometry(const QRect & /*rect*/) override { }

private:
    const QLayoutItem &m_item;
};

} // namespace

TurningBox::TurningBox(const ThemeSource &theme, int besideFrom, QWidget *parent)
    : QBoxLayout(LeftToRight, parent)
    , m_theme(theme)
    , m_besideFrom(besideFrom)
{
    setContentsMargins(0, 0, 0, 0);
}

QSize TurningBox::minimumSize() const
{
    int width = 0;
    for (int i = 0; i < count(); ++i)
        width = std::max(width, itemAt(i)->minimumSize().width());
    const QMargins margins = contentsMargins();
    return {width + margins.left() + margins.right(), QBoxLayout::minimumSize().height()};
}

QBoxLayout::Direction TurningBox::directionFor(int width) const
{
    return width < m_theme.theme().u(m_besideFrom) ? TopToBottom : LeftToRight;
}

int TurningBox::heightForWidth(int width) const
{
    QBoxLayout asked(directionFor(width));
    asked.setContentsMargins(contentsMargins());
    asked.setSpacing(spacing());
    for (int i = 0; i < count(); ++i) {
        asked.addItem(new Mirror(*itemAt(i)));
        asked.setStretch(i, stretch(i));
    }
    return asked.hasHeightForWidth() ? asked.heightForWidth(width) : asked.sizeHint().height();
}

void TurningBox::setGeometry(const QRect &rect)
{
    setDirection(directionFor(rect.width()));
    QBoxLayout::setGeometry(rect);
}

} // namespace mb
