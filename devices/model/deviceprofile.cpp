// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/deviceprofile.h"

#include "files/filebytes.h"
#include "files/jsonfields.h"
#include "files/jsonlines.h"
#include "files/qttext.h"
#include "model/axis.h"

#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>

#include <optional>

namespace mb {

QJsonValue toJson(const DirectionVerdict &verdict)
{
    return qt(toString(verdict));
}

bool fromJson(const QJsonValue &json, DirectionVerdict &verdict)
{
    verdict = DirectionVerdict::Foreign;
    for (const auto each : {DirectionVerdict::Agrees, DirectionVerdict::Reversed, DirectionVerdict::NoMotion}) {
        if (json.toString() == qt(toString(each)))
            verdict = each;
    }
    return json.isString();
}

template <>
const JsonFields<DeviceProfile> jsonFields<DeviceProfile>{{"dialect", &DeviceProfile::dialect},
    {"calibration", &DeviceProfile::calibration}, {"written", &DeviceProfile::written},
    {"counters", &DeviceProfile::counters}, {"lost", &DeviceProfile::lost}, {"verdicts", &DeviceProfile::verdicts}};

namespace {

constexpr std::int64_t greatestProfile = 1 << 20;
constexpr QLatin1String deviceField("device"); ///< for people who look into the file

/// What `whole` has that `understood` has not; in both, objects are compared by their members.
QJsonObject beyond(QJsonObject whole, const QJsonObject &understood)
{
    for (const QString &key : understood.keys()) {
        const QJsonObject rest = beyond(whole.value(key).toObject(), understood.value(key).toObject());
        if (rest.isEmpty())
            whole.remove(key);
        else
            whole.insert(key, rest);
    }
    return whole;
}

/// Both; of what both have, that of `upper`.
QJsonObject joined(QJsonObject lower, const QJsonObject &upper)
{
    for (auto field = upper.begin(); field != upper.end(); ++field) {
        const bool isObject = field.value().isObject();
        lower.insert(field.key(),
            isObject ? QJsonValue(joined(lower.value(field.key()).toObject(), field.value().toObject()))
                     : field.value());
    }
    return lower;
}

std::optional<DeviceProfile> parse(const QByteArray &bytes)
{
    if (!linesOf(bytes).checkKeys())
        return std::nullopt;
    const QJsonDocument document = QJsonDocument::fromJson(bytes);
    if (!document.isObject())
        return std::nullopt;
    DeviceProfile profile;
    if (!fromJson(document.object(), profile))
        return std::nullopt;
    std::erase_if(profile.verdicts, [](const auto &row) { return row.second == DirectionVerdict::Foreign; });
    QJsonObject understood = toJson(profile);
    understood.insert(deviceField, QString());
    if (const QJsonObject rest = beyond(document.object(), understood); !rest.isEmpty())
        profile.foreign = QJsonDocument(rest).toJson(QJsonDocument::Compact).toStdString();
    return profile;
}

} // namespace

std::string_view toString(DirectionVerdict verdict)
{
    switch (verdict) {
    case DirectionVerdict::Foreign: break;
    case DirectionVerdict::Agrees: return "agrees";
    case DirectionVerdict::Reversed: return "reversed";
    case DirectionVerdict::NoMotion: return "no motion";
    }
    return "";
}

std::string directionKey(int axis)
{
    return axisKey(axis, "direction");
}

std::string fileNameOf(std::string_view text, std::string_view ending)
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
    return (name + '-' + QString::number(hash, 16).toStdString()).append(ending);
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
    MB_TRY(const auto bytes, loadFile(path, greatestProfile));
    if (auto profile = parse(bytes))
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
    QJsonObject object
        = joined(QJsonDocument::fromJson(QByteArray::fromStdString(profile.foreign)).object(), toJson(profile));
    object.insert(deviceField, qt(key));
    return saveFile(pathOf(key), QJsonDocument(object).toJson());
}

} // namespace mb
