// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include <QHeaderView>

namespace mb {

class ParameterDelegate;

/// Head of the table, its texts above those of the cells.
class ParameterHeader : public QHeaderView {
    Q_OBJECT
public:
    ParameterHeader(const ThemeSource &theme, const ParameterDelegate &delegate, QWidget *parent);
    QSize sizeHint() const override;

protected:
    void paintSection(QPainter *painter, const QRect &rect, int logicalIndex) const override;

private:
    const ThemeSource &m_theme;
    const ParameterDelegate &m_delegate;
};

} // namespace mb
