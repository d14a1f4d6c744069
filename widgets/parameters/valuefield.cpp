// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/valuefield.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/labels.h"
#include "widgets/common/numberfield.h"
#include "widgets/parameters/valuetext.h"

namespace mb {

ValueField::ValueField(const Parameter &parameter, QWidget *parent)
    : QLineEdit(parent)
    , m_parameter(parameter)
{
    setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    if (parameter.type != WireType::Boolean && parameter.choices.empty()) { // those are words
        setValidator(new NumberValidator(this));
        new UnderstoodNote(*this, [&parameter](const QString &typed) { return understoodValue(parameter, typed); });
    }
    setToolTip(rangeText(parameter));
    connect(this, &QLineEdit::textChanged, this, &ValueField::check);
}

void ValueField::fillOnce(const QString &text)
{
    if (m_filled)
        return;
    m_filled = true;
    setText(text);
}

void ValueField::check()
{
    const bool legal = text().isEmpty() ? !isModified() : parseValue(m_parameter, text()).raw.has_value();
    setStyleProperty(*this, "state", legal ? QString() : QStringLiteral("error"));
}

ChoiceField::ChoiceField(const Parameter &parameter, QWidget *parent)
    : QComboBox(parent)
{
    for (const Choice &choice : parameter.choices)
        addItem(tableText(choice.label), qt(choice.label));
}

void ChoiceField::fillOnce(const QString &text)
{
    if (m_filled)
        return;
    m_filled = true;
    setCurrentIndex(findData(text));
}

} // namespace mb
