// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QValidator>

#include <functional>

namespace mb {

/// Lets only what numbers are written with into a field: digits, signs, "," and ".", an exponent, "%", and "0x…". What stands
/// there is always acceptable: whether it is a legal number is said beside the field, not by a key that does nothing.
class NumberValidator : public QValidator {
    Q_OBJECT
public:
    using QValidator::QValidator;
    State validate(QString &text, int &position) const override;
};

/// What is understood of a field's text, small at its left end: "= 1.5" where "1,5" was typed, before anything is written. In a
/// field too narrow for both it stands below while one types. It is read aloud as the field's description.
class UnderstoodNote : public QLabel {
    Q_OBJECT
public:
    /// `read` has the words for a text; empty for none.
    UnderstoodNote(QLineEdit &field, std::function<QString(const QString &)> read);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void follow();

    QLineEdit &m_field;
    std::function<QString(const QString &)> m_read;
};

/// A field for one number, at the right, with comma or dot; what was understood of a comma is shown, and stands there once the
/// field is left. The stop key Space works while it has the focus: no word is ever typed here.
class NumberField : public QLineEdit {
    Q_OBJECT
public:
    explicit NumberField(QWidget *parent = nullptr);
    NumberField(const QString &text, QWidget *parent);
};

/// Whether words can be typed into this widget, so that Space belongs to it. False for numbers, and for what is read only.
[[nodiscard]] bool acceptsLetters(const QWidget *widget);

} // namespace mb
