// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/tabletext.h"

#include "files/qttext.h"
#include "widgets/common/numberformat.h"

#include <QCoreApplication>

#include <optional>

namespace mb {

QString tableText(std::string_view english)
{
    return english.empty() ? QString() : QCoreApplication::translate("table", std::string(english).c_str());
}

namespace {

/// Without a decimal sign of its own: as numbers are shown.
QString wordsOf(const Message &message, std::optional<QChar> decimal);

QString quantityOf(const MessageNumber &quantity, std::optional<QChar> decimal)
{
    const QString digits = qt(textOf({quantity.value, quantity.decimals}));
    const QString unit = quantity.unit.empty() ? QString() : QLatin1Char(' ') + qt(quantity.unit);
    return (decimal ? QString(digits).replace(QLatin1Char('.'), *decimal) : formatWritten(digits)) + unit;
}

QString argumentText(const MessageArgument &argument, std::optional<QChar> decimal)
{
    struct Wording {
        std::optional<QChar> decimal;
        QString operator()(std::int64_t number) const { return QString::number(number); }
        QString operator()(const MessageNumber &number) const { return quantityOf(number, decimal); }
        QString operator()(const std::string &text) const { return qt(text); }
        QString operator()(const Message &message) const { return wordsOf(message, decimal); }
    };
    return std::visit(Wording{decimal}, argument.value);
}

QString wordsOf(const Message &message, std::optional<QChar> decimal)
{
    if (message.empty() || message.isVerbatim())
        return qt(message.english());
    const std::string literal(message.literal());
    const QString phrase = QCoreApplication::translate("table", literal.c_str());
    const auto arguments = message.arguments();
    QString text;
    for (int i = 0; i < phrase.size(); ++i) {
        const int which = phrase[i] == QLatin1Char('%') && i + 1 < phrase.size() ? phrase[i + 1].digitValue() : 0;
        const bool stands = which >= 1 && static_cast<std::size_t>(which) <= arguments.size();
        text += stands ? argumentText(arguments[static_cast<std::size_t>(which) - 1], decimal) : QString(phrase[i]);
        i += stands ? 1 : 0;
    }
    return text;
}

} // namespace

QString messageText(const Message &message)
{
    return wordsOf(message, {});
}

QString messageText(const Message &message, QChar decimal)
{
    return wordsOf(message, decimal);
}

QString quantityText(const MessageNumber &quantity)
{
    return quantityOf(quantity, std::nullopt);
}

} // namespace mb
