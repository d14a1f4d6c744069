// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/scanbook.h"

#include "files/filebytes.h"
#include "files/jsonfields.h"
#include "files/jsonlines.h"
#include "files/qttext.h"
#include "model/deviceprofile.h"

#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>

#include <optional>

namespace mb {

template <>
const JsonFields<Identity> jsonFields<Identity>{{"family", &Identity::family}, {"address", &Identity::address},
    {"dialect", &Identity::dialect}, {"descriptors", &Identity::descriptors}};

namespace {

constexpr std::int64_t greatestBook = 1 << 20;
constexpr int greatestAddress = 1 << 16;

std::optional<Identity> identityIn(const QJsonValue &value)
{
    Identity identity;
    identity.address = -1;
    fromJson(value, identity);
    const bool isOne = !identity.family.empty() && identity.address >= 0 && identity.address <= greatestAddress;
    return isOne ? std::optional(identity) : std::nullopt;
}

std::optional<std::vector<Identity>> parse(const QByteArray &bytes, std::string_view link)
{
    if (!linesOf(bytes).checkKeys())
        return std::nullopt;
    const QJsonObject object = QJsonDocument::fromJson(bytes).object();
    const QJsonValue rows = object.value(QStringLiteral("devices"));
    if (object.value(QStringLiteral("link")).toString() != qt(link) || !rows.isArray())
        return std::nullopt;
    std::vector<Identity> all;
    for (const QJsonValue row : rows.toArray()) {
        auto identity = identityIn(row);
        if (!identity)
            return std::nullopt;
        all.push_back(std::move(*identity));
    }
    return all;
}

} // namespace

std::string ScanBook::pathOf(std::string_view link) const
{
    return m_directory + '/' + fileNameOf(link);
}

Result<std::vector<Identity>> ScanBook::load(std::string_view link) const
{
    const std::string path = pathOf(link);
    if (!QFile::exists(qt(path)))
        return std::vector<Identity>();
    MB_TRY(const auto bytes, loadFile(path, greatestBook));
    if (auto all = parse(bytes, link))
        return std::move(*all);
    return fail(Fault::OutOfRange,
        say("%1 is no list of devices and is ignored: the next scan takes its full time and writes it anew", path));
}

Result<void> ScanBook::save(std::string_view link, const std::vector<Identity> &seen) const
{
    if (!QDir().mkpath(qt(m_directory)))
        return fail(
            Fault::OutOfRange, say("%1 cannot be made", m_directory), say("check the rights of the folder above it"));
    const QJsonObject object{{QStringLiteral("link"), qt(link)}, {QStringLiteral("devices"), toJson(seen)}};
    return saveFile(pathOf(link), QJsonDocument(object).toJson());
}

} // namespace mb
