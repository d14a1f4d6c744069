// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/messagejson.h"

#include "files/qttext.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <cmath>

namespace mb {
namespace {

const QLatin1String literalKey("say");
const QLatin1String argumentsKey("of");
const QLatin1String wholeKey("whole"); ///< QJsonValue knows no integers
const QLatin1String numberKey("number");
const QLatin1String decimalsKey("decimals");
const QLatin1String unitKey("unit");

QJsonValue argumentToJson(const MessageArgument &argument)
{
    struct Writing {
        QJsonValue operator()(std::int64_t number) const
        {
            return QJsonObject{{wholeKey, QString::number(static_cast<qlonglong>(number))}};
        }
        QJsonValue operator()(const MessageNumber &number) const
        {
            const QJsonValue value = std::isfinite(number.value) ? QJsonValue(number.value) : QJsonValue();
            return QJsonObject{{numberKey, value}, {decimalsKey, number.decimals}, {unitKey, qt(number.unit)}};
        }
        QJsonValue operator()(const std::string &text) const { return qt(text); }
        QJsonValue operator()(const Message &message) const { return toJson(message); }
    };
    return std::visit(Writing{}, argument.value);
}

MessageArgument argumentFrom(const QJsonValue &value)
{
    const QJsonObject object = value.toObject();
    if (object.contains(wholeKey))
        return static_cast<std::int64_t>(object.value(wholeKey).toString().toLongLong());
    if (object.contains(numberKey))
        return MessageNumber{object.value(numberKey).toDouble(std::nan("")), object.value(decimalsKey).toInt(-1),
            object.value(unitKey).toString().toStdString()};
    if (object.contains(literalKey))
        return messageFrom(value);
    return value.toString().toStdString();
}

} // namespace

QJsonValue toJson(const Message &message)
{
    if (message.empty() || message.isVerbatim())
        return qt(message.english());
    QJsonArray arguments;
    for (const MessageArgument &argument : message.arguments())
        arguments.append(argumentToJson(argument));
    return QJsonObject{{literalKey, qt(message.literal())}, {argumentsKey, arguments}};
}

Message messageFrom(const QJsonValue &value)
{
    const QJsonObject object = value.toObject();
    if (!object.contains(literalKey))
        return Message::verbatim(value.toString().toStdString());
    std::vector<MessageArgument> arguments;
    for (const QJsonValue argument : object.value(argumentsKey).toArray())
        arguments.push_back(argumentFrom(argument));
    return Message::composed(object.value(literalKey).toString().toStdString(), std::move(arguments));
}

QString savedText(const Message &message)
{
    const QJsonValue value = toJson(message);
    return value.isString() ? value.toString()
                            : QString::fromUtf8(QJsonDocument(value.toObject()).toJson(QJsonDocument::Compact));
}

Message messageFrom(const std::string &saved)
{
    const QJsonDocument document = QJsonDocument::fromJson(QByteArray::fromStdString(saved));
    const bool composed = document.isObject() && document.object().contains(literalKey);
    return composed ? messageFrom(QJsonValue(document.object())) : Message::verbatim(saved);
}

} // namespace mb
