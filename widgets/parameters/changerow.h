// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/parameters/parametermodel.h"

#include <QWidget>

class QCheckBox;
class QLabel;

namespace mb {

/// One staged change in the panel: whether it goes along, its key, its place in the order, old → new.
class ChangeRow : public QWidget {
    Q_OBJECT
public:
    ChangeRow(const ThemeSource &theme, QWidget *parent);
    /// `place` counts from 1; 0 when it must be mended first.
    void show(const ParameterModel &model, ParameterIndex index, int place);
    [[nodiscard]] ParameterIndex parameter() const { return m_index; }

Q_SIGNALS:
    void includedChanged(mb::ParameterIndex index, bool included);
    void activated(mb::ParameterIndex index);

protected:
    void mouseReleaseEvent(QMouseEvent *event) override;
    void paintEvent(QPaintEvent *event) override;

private:
    const ThemeSource &m_theme;
    ParameterIndex m_index;
    QCheckBox *m_check = nullptr;
    QLabel *m_key = nullptr;
    QLabel *m_values = nullptr;
    QLabel *m_place = nullptr;
    QLabel *m_look = nullptr;
    QLabel *m_fix = nullptr;
};

/// "40 → <b>35</b>" as rich text.
[[nodiscard]] QString transitionText(const QString &from, const QString &to);

} // namespace mb
