// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"
#include "widgets/control/setpointentries.h"

#include <QWidget>

class QGridLayout;
class QLineEdit;

namespace mb {

/// Velocity and acceleration of a profile that the device makes from what the command says.
class ProfileFields : public QWidget {
    Q_OBJECT
public:
    explicit ProfileFields(const ThemeSource &theme, QWidget *parent);

    void show(const SetPointEntries &entries);
    void read(SetPointEntries &entries) const;
    /// Of this mode: one that goes to a velocity has no other.
    void setMode(Mode mode);
    /// Why the device would not take it; empty: it would.
    [[nodiscard]] QString fault(const Capabilities &can) const;

Q_SIGNALS:
    void changed();

private:
    QLineEdit *field(const Theme &theme, const QString &name, const QString &unit, const QString &help);

    QGridLayout *m_grid = nullptr;
    QLineEdit *m_velocity = nullptr;
    QLineEdit *m_acceleration = nullptr;
};

} // namespace mb
