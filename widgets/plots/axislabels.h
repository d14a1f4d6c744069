// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/plots/qcustomplotkeywords.h"

namespace mb {

/// Where the words beside the axes of one plot stand: those of y never touch, however low it is. GUI thread; the plot owns it.
class AxisLabels : public QObject {
    Q_OBJECT
public:
    explicit AxisLabels(QCustomPlot &plot);

    /// `atEnd`: the name of x stands behind its numbers, in the margin at the right, and not in a line of its own below them.
    void nameX(const QString &name, bool atEnd);

private:
    void arrange();

    QCustomPlot &m_plot;
    QCPItemText *m_unit = nullptr; ///< of x
    bool m_isUnitAtEnd = false;
};

} // namespace mb
