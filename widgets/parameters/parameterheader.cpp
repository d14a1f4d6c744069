// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/parameterheader.h"

#include "widgets/parameters/parameterdelegate.h"

#include <QPainter>

namespace mb {

ParameterHeader::ParameterHeader(const ThemeSource &theme, const ParameterDelegate &delegate, QWidget *parent)
    : QHeaderView(Qt::Horizontal, parent)
    , m_theme(theme)
    , m_delegate(delegate)
{
    setAccessibleName(tr("Columns"));
}

QSize ParameterHeader::sizeHint() const
{
    return {QHeaderView::sizeHint().width(), m_theme.theme().u(26)};
}

void ParameterHeader::paintSection(QPainter *painter, const QRect &rect, int logicalIndex) const
{
    const Theme &theme = m_theme.theme();
    painter->fillRect(rect, theme.window);
    painter->fillRect(rect.left(), rect.bottom(), rect.width(), 1, theme.line);
    const int left = logicalIndex == ParameterModel::Label ? m_delegate.labelIndent() : m_delegate.padding();
    const QRect text = rect.adjusted(left, 0, -m_delegate.padding(), 0);
    const auto alignment = model()->headerData(logicalIndex, Qt::Horizontal, Qt::TextAlignmentRole).toInt();
    const QString title = model()->headerData(logicalIndex, Qt::Horizontal).toString();
    painter->setFont(theme.font(TextRole::Caption, font()));
    painter->setPen(theme.dim);
    painter->drawText(text, alignment, painter->fontMetrics().elidedText(title, Qt::ElideRight, text.width()));
}

} // namespace mb
