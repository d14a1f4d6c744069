// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/trialtraits.h"
#include "widgets/common/theme.h"
#include "widgets/plots/displayunits.h"

#include <QWidget>

#include <array>

class QLabel;
class QLineEdit;
class QPushButton;

namespace mb {

/// Travel, speed, current and duty that no experiment may leave: what a person has entered, and beside it what holds now.
class EnvelopePanel : public QWidget {
    Q_OBJECT
public:
    explicit EnvelopePanel(const ThemeSource &theme, QWidget *parent = nullptr);

    void setUnits(const DisplayUnits &units);
    /// What was entered for this unit. Without a signal.
    void setEntered(const Envelope &entered);
    [[nodiscard]] const Envelope &entered() const { return m_entered; }
    /// What bounds the next experiment; `missing` must be entered before it.
    void setInForce(const Envelope &inForce, const QString &missing);
    void setOpen(bool open);

Q_SIGNALS:
    void changed();

private:
    struct Row {
        QLineEdit *field = nullptr;
        QLabel *inForce = nullptr;
        ShownUnit unit;
    };
    void read();
    void write();
    void say();

    const ThemeSource &m_theme;
    Envelope m_entered;
    Envelope m_inForce;
    QString m_missing;
    std::array<Row, 4> m_rows;
    QPushButton *m_head = nullptr;
    QLabel *m_words = nullptr;
    QWidget *m_box = nullptr;
};

} // namespace mb
