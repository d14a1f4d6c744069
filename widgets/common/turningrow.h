// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include <QWidget>

class QBoxLayout;

namespace mb {

/// Parts side by side, or one below the other where they have no room for that; like TurningSplitter, with nothing to drag between them.
class TurningRow : public QWidget {
    Q_OBJECT
public:
    /// `besideFrom`: units of the theme; narrower than this it turns.
    TurningRow(const ThemeSource &theme, int besideFrom, QWidget *parent);
    /// That of one part below the other, however they stand.
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    [[nodiscard]] QBoxLayout &parts() const { return *m_parts; }
    [[nodiscard]] bool isTurned() const;
    void resizeEvent(QResizeEvent *event) override;

private:
    const ThemeSource &m_theme;
    int m_besideFrom;
    QBoxLayout *m_parts;
};

} // namespace mb
