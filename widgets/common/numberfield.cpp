// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/numberfield.h"

#include "widgets/common/labels.h"
#include "widgets/common/numberformat.h"

#include <QComboBox>
#include <QEvent>
#include <QPlainTextEdit>
#include <QRegularExpression>
#include <QTextEdit>
#include <QToolTip>

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

UnderstoodNote::UnderstoodNote(QLineEdit &field, std::function<QString(const QString &)> read)
    : QLabel(&field)
    , m_field(field)
    , m_read(std::move(read))
{
    setObjectName(QStringLiteral("understood"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setTextRole(*this, TextRole::Caption);
    mb::setTone(*this, Tone::Dim);
    hide();
    field.installEventFilter(this);
    connect(&field, &QLineEdit::textChanged, this, &UnderstoodNote::follow);
}

bool UnderstoodNote::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::Resize)
        follow();
    return QLabel::eventFilter(watched, event);
}

void UnderstoodNote::follow()
{
    const QString words = m_read(m_field.text());
    setText(words);
    m_field.setAccessibleDescription(words);
    ensurePolished();
    const int edge = m_field.fontMetrics().averageCharWidth();
    const int typed = m_field.fontMetrics().horizontalAdvance(m_field.text());
    const bool fits = 4 * edge + sizeHint().width() + typed < m_field.width();
    setGeometry(edge, 0, sizeHint().width(), m_field.height());
    setVisible(fits && !words.isEmpty());
    const bool below = !fits && !words.isEmpty() && m_field.hasFocus();
    if (below)
        QToolTip::showText(m_field.mapToGlobal(QPoint(0, m_field.height() / 2)), words, &m_field);
    else if (m_field.hasFocus())
        QToolTip::hideText();
}

NumberField::NumberField(QWidget *parent)
    : QLineEdit(parent)
{
    setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    setValidator(new NumberValidator(this));
    new UnderstoodNote(*this, understoodText);
    connect(this, &QLineEdit::editingFinished, this, [this] {
        if (const QString plain = asWritten(text()); plain != text())
            setText(plain);
    });
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
