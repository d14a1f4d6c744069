// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include <QWidget>

#include <optional>

class QComboBox;
class QLabel;
class QLineEdit;

namespace mb {

/// The limits of the hand: how far a set-point may go, and how fast it gets there.
class SetPointRange : public QWidget {
    Q_OBJECT
public:
    explicit SetPointRange(const ThemeSource &theme, QWidget *parent);

    void showLimit(const QString &number);
    void setUnit(const QString &unit);
    /// No more than this can be entered, as it is shown.
    void setMost(std::optional<double> most) { m_most = most; }
    /// Place in slewTimes; less than 0 is the usual one.
    [[nodiscard]] int slew() const;
    void setSlew(int place);
    /// The device makes the way by itself: how fast is not asked here.
    void setSlewShown(bool shown);

Q_SIGNALS:
    /// A legal one was typed, as it is shown.
    void limitTyped(double shown);
    void limitFinished();
    void slewChosen();

private:
    void fillSlew();
    void read(const QString &text);

    std::optional<double> m_most;
    QLineEdit *m_limit = nullptr;
    QLabel *m_unit = nullptr;
    QLabel *m_moves = nullptr;
    QComboBox *m_slew = nullptr;
};

} // namespace mb
