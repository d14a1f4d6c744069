// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include <QBoxLayout>

namespace mb {

/// Parts side by side, or one below the other where they have no room for that. How high it gets in a width is known before it is laid out in it,
/// so that nothing lies over anything in the first picture, and asking for it changes nothing: a layout that turns when it is asked
/// is laid out anew without end. It never holds its widget wider than its widest part.
class TurningBox : public QBoxLayout {
    Q_OBJECT
public:
    /// `besideFrom`: units of the theme; narrower than this, its margins included, it turns.
    TurningBox(const ThemeSource &theme, int besideFrom, QWidget *parent);
    [[nodiscard]] bool isTurned() const { return direction() == TopToBottom; }
    [[nodiscard]] QSize minimumSize() const override;
    [[nodiscard]] bool hasHeightForWidth() const override { return true; }
    [[nodiscard]] int heightForWidth(int width) const override;
    void setGeometry(const QRect &rect) override;

private:
    [[nodiscard]] Direction directionFor(int width) const;

    const ThemeSource &m_theme;
    int m_besideFrom;
};

} // namespace mb
