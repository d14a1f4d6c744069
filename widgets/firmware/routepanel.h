// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include "model/family.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QLineEdit;

namespace mb {

/// The way in for an update of a family that is not updated over its own link: programmer, kind of microcontroller, and
/// whether what the unit has stored is erased. Hidden for the others.
class RoutePanel : public QWidget {
    Q_OBJECT
public:
    explicit RoutePanel(const ThemeSource &theme, QWidget *parent = nullptr);
    /// nullptr: no device.
    void show(const Family *family);
    [[nodiscard]] UpdateOptions options() const;

private:
    const Family *m_family = nullptr;
    QLineEdit *m_via = nullptr;
    QComboBox *m_target = nullptr;
    QCheckBox *m_erase = nullptr;
};

} // namespace mb
