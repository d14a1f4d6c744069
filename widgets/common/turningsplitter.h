// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include <QSplitter>

namespace mb {

/// Parts side by side, or one below the other where they have no room for that: it never holds its page wider than its widest part.
class TurningSplitter : public QSplitter {
    Q_OBJECT
public:
    /// `besideFrom`: units of the theme; narrower than this it turns.
    TurningSplitter(const ThemeSource &theme, int besideFrom, QWidget *parent);
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    const ThemeSource &m_theme;
    int m_besideFrom;
};

} // namespace mb
