// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"
#include "widgets/parameters/parametermodel.h"

#include <QWidget>

class QLabel;
class QPushButton;

namespace mb {

/// Below an illegal edit: what is wrong, what is legal, and one click that mends it.
class FaultLine : public QWidget {
    Q_OBJECT
public:
    FaultLine(const ThemeSource &theme, ParameterModel &model, ParameterIndex index, QWidget *parent);
    /// The edit changed.
    void refresh();
    int heightForWidth(int width) const override;

Q_SIGNALS:
    /// A button mended the value: the field that shows the illegal one must not bring it back.
    void mended();

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    void useNearest();
    void revert();

    const ThemeSource &m_theme;
    ParameterModel &m_model;
    ParameterIndex m_index;
    QLabel *m_fault = nullptr;
    QLabel *m_remedy = nullptr;
    QPushButton *m_nearest = nullptr;
    bool m_looking = false; ///< a leap that asks for one more look, not a fault
    QPushButton *m_revert = nullptr;
};

} // namespace mb
