// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineEdit>
#include <QValidator>

namespace mb {

/// Lets only what numbers are written with into a field: digits, signs, "," and ".", an exponent, "%", and "0x…". What stands
/// there is always acceptable: whether it is a legal number is said beside the field, not by a key that does nothing.
class NumberValidator : public QValidator {
    Q_OBJECT
public:
    using QValidator::QValidator;
    State validate(QString &text, int &position) const override;
};

/// A field for one number, at the right. The stop key Space works while it has the focus: no word is ever typed here.
class NumberField : public QLineEdit {
    Q_OBJECT
public:
    explicit NumberField(QWidget *parent = nullptr);
    NumberField(const QString &text, QWidget *parent);
};

/// Whether words can be typed into this widget, so that Space belongs to it. False for numbers, and for what is read only.
[[nodiscard]] bool acceptsLetters(const QWidget *widget);

} // namespace mb
