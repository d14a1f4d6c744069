// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"
#include "widgets/plots/qcustomplotkeywords.h"

namespace mb {

/// The line under all strips: what time means at the left, rate and loss at the right.
class PlotFoot : public QCPLayoutElement {
    Q_OBJECT
public:
    PlotFoot(QCustomPlot &plot, const ThemeSource &theme);
    void setTexts(const QString &left, const QString &right, bool loss);
    QString left() const { return m_left; }
    QString right() const { return m_right; }
    QSize minimumOuterSizeHint() const override;
    QSize maximumOuterSizeHint() const override;

protected:
    void draw(QCPPainter *painter) override;

private:
    const ThemeSource &m_theme;
    QString m_left;
    QString m_right;
    bool m_loss = false;
};

} // namespace mb
