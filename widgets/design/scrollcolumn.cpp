// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/design/scrollcolumn.h"

#include "widgets/common/layoutin.h"

#include <QVariant>

namespace mb {
namespace {

void settle(QWidget &widget)
{
    for (QWidget *child : widget.findChildren<QWidget *>(QString(), Qt::FindDirectChildrenOnly))
        settle(*child);
    if (QLayout *const layout = widget.layout())
        layout->activate();
}

} // namespace

ScrollColumn::ScrollColumn(const Theme &theme, QWidget *parent)
    : QScrollArea(parent)
{
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFocusPolicy(Qt::NoFocus);
    m_content = new QWidget(this);
    m_content->setProperty("transparent", true);
    m_rows = layoutIn<QVBoxLayout>(m_content, theme.u(6), {theme.u(12), theme.u(6), theme.u(12), theme.u(6)});
    m_rows->setSizeConstraint(QLayout::SetMinimumSize);
    setWidget(m_content);
}

bool ScrollColumn::isInSight(std::initializer_list<QWidget *> parts) const
{
    const QMargins margins = m_rows->contentsMargins();
    const int width = viewport()->width() - margins.left() - margins.right();
    int height = margins.top() + margins.bottom() + static_cast<int>(parts.size() - 1) * m_rows->spacing();
    for (QWidget *part : parts) {
        settle(*part);
        if (!part->isHidden())
            height += part->hasHeightForWidth() ? part->heightForWidth(width) : part->sizeHint().height();
    }
    return height <= viewport()->height();
}

} // namespace mb
