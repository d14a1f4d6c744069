// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/parameter.h"

#include <QComboBox>
#include <QLineEdit>

namespace mb {

/// The field in the table: a number at the right, its edge red while it is not legal.
class ValueField : public QLineEdit {
    Q_OBJECT
public:
    ValueField(const Parameter &parameter, QWidget *parent);
    /// The first text stays: what arrives later must not overwrite what is being typed.
    void fillOnce(const QString &text);

private:
    void check();

    const Parameter &m_parameter;
    bool m_filled = false;
};

/// The list in the table, where the device knows a few values only. The data of an item is what parseRaw() takes.
class ChoiceField : public QComboBox {
    Q_OBJECT
public:
    ChoiceField(const Parameter &parameter, QWidget *parent);
    void fillOnce(const QString &text);

private:
    bool m_filled = false;
};

} // namespace mb
