// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/deviceprofile.h"

#include "files/filebytes.h"
#include "files/jsonlines.h"
#include "files/qttext.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <cmath>
#include <optional>

namespace mb {
namespace {

constexpr std::int64_t greatestProfile = 1 << 20;
constexpr double exact = 9007199254740992.0; ///< up to here every whole number is a JSON number

std::optional<std::map<std::string, double>> numbers(const QJsonValue &value)
{
    std::map<std::string, double> found;
    if (value.isUndefined())
        return found;
    if (!value.isObject())
        return std::nullopt;
    const QJsonObject object = value.toObject();
    for (auto entry = object.begin(); entry != object.end(); ++entry) {
        if (!entry->isDouble())
            return std::nullopt;
        found.emplace(entry.key().toStdString(), entry->toDouble());
    }
    return found;
}

std::optional<std::map<std::string, std::int64_t>> integers(const QJsonValue &value)
{
    const auto all = numbers(value);
    if (!all)
        return std::nullopt;
    std::map<std::string, std::int64_t> found;
    for (const auto &[key, number] : *all) {
        if (number != std::floor(number) || std::abs(number) > exact)
            return std::nullopt;
        found.emplace(key, static_cast<std::int64_t>(number));
    }
    return found;
}

template <class Number> QJsonObject objectOf(const std::map<std::string, Number> &values)
{
    QJsonObject object;
    for (const auto &[key, value] : values)
        object.insert(qt(key), static_cast<double>(value));
    return object;
}

std::optional<std::map<std::string, std::string>> sentences(const QJsonValue &value)
{
    std::map<std::string, std::string> found;
    const QJsonObject object = value.toObject();
    if (!value.isUndefined() && !value.isObject())
        return std::nullopt;
    for (auto entry = object.begin(); entry != object.end(); ++entry) {
        if (!entry->isString())
            return std::nullopt;
        found.emplace(entry.key().toStdString(), entry->toString().toStdString());
    }
    return found;
}

QJsonObject objectOf(const std::map<std::string, std::string> &values)
{
    QJsonObject object;
    for (const auto &[key, value] : values)
        object.insert(qt(key), qt(value));
    return object;
}

std::optional<std::set<std::string>> texts(const QJsonValue &value)
{
    std::set<std::string> found;
    if (value.isUndefined())
        return found;
    if (!value.isArray())
        return std::nullopt;
    for (const QJsonValue text : value.toArray()) {
        if (!text.isString())
            return std::nullopt;
        found.insert(text.toString().toStdString());
    }
    return found;
}

QJsonArray arrayOf(const std::set<std::string> &values)
{
    QJsonArray array;
    for (const std::string &text : values)
        array.append(qt(text));
    return array;
}

std::optional<DeviceProfile> parse(const QByteArray &bytes)
{
    if (!linesOf(bytes).checkKeys())
        return std::nullopt;
    const QJsonDocument document = QJsonDocument::fromJson(bytes);
    if (!document.isObject())
        return std::nullopt;
    const QJsonObject object = document.object();
    const auto calibration = numbers(object.value(QStringLiteral("calibration")));
    const auto written = integers(object.value(QStringLiteral("written")));
    const auto counters = integers(object.value(QStringLiteral("counters")));
    const auto lost = texts(object.value(QStringLiteral("lost")));
    const auto verdicts = sentences(object.value(QStringLiteral("verdicts")));
    if (!calibration || !written || !counters || !lost || !verdicts)
        return std::nullopt;
    DeviceProfile profile;
    profile.dialect = object.value(QStringLiteral("dialect")).toString().toStdString();
    profile.calibration = *calibration;
    profile.written = *written;
    profile.counters = *counters;
    profile.lost = *lost;
    profile.verdicts = *verdicts;
    return profile;
}

} // namespace

std::string fileNameOf(std::string_view text)
{
    std::string name;
    for (const char c : text) {
        const bool plain
            = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' || c == '_';
        name += plain ? c : '.';
    }
    // Two texts may become one name: which of them it is stands in a hash of the whole.
    std::uint32_t hash = 2166136261U;
    for (const char c : text)
        hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
    return name + '-' + QString::number(hash, 16).toStdString() + ".json";
}

std::string ProfileBook::pathOf(std::string_view key) const
{
    return m_directory + '/' + fileNameOf(key);
}

Result<DeviceProfile> ProfileBook::load(std::string_view key) const
{
    const std::string path = pathOf(key);
    if (!QFile::exists(qt(path)))
        return DeviceProfile();
    const auto bytes = loadFile(path, greatestProfile);
    if (!bytes)
        return fail(bytes.error());
    if (auto profile = parse(*bytes))
        return *profile;
    const QString aside = qt(path) + QStringLiteral(".damaged");
    QFile::remove(aside);
    QFile::rename(qt(path), aside);
    return fail(Fault::OutOfRange, say("%1 is no device profile", path),
        say("it was put aside as %1, and what it kept of the device is unknown again", aside.toStdString()));
}

Result<void> ProfileBook::save(std::string_view key, const DeviceProfile &profile) const
{
    if (!QDir().mkpath(qt(m_directory)))
        return fail(
            Fault::OutOfRange, say("%1 cannot be made", m_directory), say("check the rights of the folder above it"));
    const QJsonObject object{
        {QStringLiteral("device"), qt(key)},
        {QStringLiteral("dialect"), qt(profile.dialect)},
        {QStringLiteral("calibration"), objectOf(profile.calibration)},
        {QStringLiteral("written"), objectOf(profile.written)},
        {QStringLiteral("counters"), objectOf(profile.counters)},
        {QStringLiteral("lost"), arrayOf(profile.lost)},
        {QStringLiteral("verdicts"), objectOf(profile.verdicts)},
    };
    return saveFile(pathOf(key), QJsonDocument(object).toJson());
}

} // namespace mb
