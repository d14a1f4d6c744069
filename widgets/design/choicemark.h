// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include <QWidget>

namespace mb {

/// The ring of one choice of several, filled where it is the chosen one. Has no words and takes no focus: what it marks does.
class ChoiceMark : public QWidget {
    Q_OBJECT
public:
    ChoiceMark(const ThemeSource &theme, QWidget *parent);
    void setChosen(bool chosen);
    [[nodiscard]] bool isChosen() const { return m_chosen; }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    const ThemeSource &m_theme;
    bool m_chosen = false;
};

} // namespace mb
