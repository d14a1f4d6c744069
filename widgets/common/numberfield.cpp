// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/numberfield.h"

#include <QComboBox>
#include <QPlainTextEdit>
#include <QRegularExpression>
#include <QTextEdit>

namespace mb {
namespace {

bool isNumeric(const QValidator *validator)
{
    return qobject_cast<const NumberValidator *>(validator) || qobject_cast<const QIntValidator *>(validator)
        || qobject_cast<const QDoubleValidator *>(validator);
}

} // namespace

QValidator::State NumberValidator::validate(QString &text, int &) const
{
    static const QRegularExpression shape(
        QStringLiteral("\\A(?:[\\s0-9.,+\\-\u2212%eE]*|\\s*[+\\-\u2212]?0[xX][0-9a-fA-F]*\\s*)\\z"),
        QRegularExpression::UseUnicodePropertiesOption);
    return shape.match(text).hasMatch() ? Acceptable : Invalid;
}

NumberField::NumberField(QWidget *parent)
    : QLineEdit(parent)
{
    setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    setValidator(new NumberValidator(this));
}

NumberField::NumberField(const QString &text, QWidget *parent)
    : NumberField(parent)
{
    setText(text);
}

bool acceptsLetters(const QWidget *widget)
{
    if (const auto *combo = qobject_cast<const QComboBox *>(widget))
        return combo->isEditable() && acceptsLetters(combo->lineEdit());
    if (const auto *field = qobject_cast<const QLineEdit *>(widget))
        return !field->isReadOnly() && !isNumeric(field->validator());
    if (const auto *text = qobject_cast<const QTextEdit *>(widget))
        return !text->isReadOnly();
    if (const auto *text = qobject_cast<const QPlainTextEdit *>(widget))
        return !text->isReadOnly();
    return false;
}

} // namespace mb
