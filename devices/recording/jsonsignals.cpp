// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/jsonsignals.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace mb {
namespace {

constexpr int longestJsonList = 64;
constexpr int deepestJson = 16;

using Tell = std::function<void(const std::string &, double)>;

void walkJson(const QJsonValue &value, const std::string &way, int depth, const Tell &tell)
{
    if (value.isDouble())
        return tell(way, value.toDouble());
    if (value.isBool())
        return tell(way, value.toBool() ? 1.0 : 0.0);
    if (depth == deepestJson)
        return;
    if (value.isObject()) {
        const QJsonObject object = value.toObject();
        for (auto part = object.begin(); part != object.end(); ++part)
            walkJson(part.value(), way + '/' + part.key().toStdString(), depth + 1, tell);
    } else if (value.isArray()) {
        const QJsonArray list = value.toArray();
        for (int i = 0; i < std::min(list.size(), longestJsonList); ++i)
            walkJson(list[i], way + '/' + std::to_string(i), depth + 1, tell);
    }
}

} // namespace

bool eachNumber(std::span<const unsigned char> json, const Tell &tell)
{
    const QJsonDocument document = QJsonDocument::fromJson(
        QByteArray::fromRawData(reinterpret_cast<const char *>(json.data()), static_cast<int>(json.size())));
    if (document.isNull())
        return false;
    walkJson(document.isArray() ? QJsonValue(document.array()) : QJsonValue(document.object()), {}, 0, tell);
    return true;
}

} // namespace mb
