// SPDX-License-Identifier: GPL-3.0-or-later
#include "service/recipe.h"

#include "files/filebytes.h"
#include "files/qttext.h"
#include "model/family.h"
#include "model/parameterfile.h"
#include "service/reciperead.h"
#include "tuning/metrics.h"

#include <QCryptographicHash>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <array>

namespace mb::service {
namespace {

constexpr std::array motorKeys{figure::resistance, figure::friction, figure::gain, figure::encoder};
constexpr std::int64_t mostRecipeBytes = 1 << 20;

QJsonObject limitsOf(const Envelope &limits)
{
    QJsonObject object;
    for (const EnvelopeBound &bound : envelopeBounds) {
        if (const auto value = limits.*bound.value)
            object.insert(QLatin1String(bound.key), *value);
    }
    return object;
}

QJsonObject acceptOf(const std::vector<Acceptance> &accept)
{
    QJsonObject object;
    for (const Acceptance &one : accept) {
        QJsonValue value(one.high);
        if (one.key == figure::encoder)
            value = true;
        else if (one.low)
            value = QJsonArray{*one.low, one.high};
        object.insert(qt(one.key), value);
    }
    return object;
}

QJsonObject testOf(const SelfTest &test)
{
    QJsonObject object{{QStringLiteral("loop"), qt(toString(test.loop))}, {QStringLiteral("to"), test.to},
        {QStringLiteral("repeat"), test.repeat}, {QStringLiteral("axis"), test.axis},
        {QStringLiteral("slot"), test.slot}, {QStringLiteral("limits"), limitsOf(test.limits)},
        {QStringLiteral("accept"), acceptOf(test.accept)}};
    if (test.from)
        object.insert(QStringLiteral("from"), *test.from);
    if (test.seconds)
        object.insert(QStringLiteral("time"), *test.seconds);
    return object;
}

std::string hashOf(const QByteArray &bytes)
{
    return QCryptographicHash::hash(bytes, QCryptographicHash::Sha256).toHex().toStdString();
}

Result<QByteArray> besideOf(const std::string &recipe, const std::string &file, std::int64_t most)
{
    const QString folder = QFileInfo(qt(recipe)).absolutePath();
    const QString path = QFileInfo(qt(file)).isAbsolute() ? qt(file) : folder + QLatin1Char('/') + qt(file);
    auto bytes = loadFile(path.toStdString(), most);
    if (!bytes)
        return fail(bytes.error().about(recipe));
    return bytes;
}

Result<void> readImage(const std::string &path, RecipeMatter &matter)
{
    const FirmwareRule &rule = *matter.recipe.firmware;
    const auto bytes = besideOf(path, rule.file, static_cast<std::int64_t>(FirmwareImage::maxTextSize));
    if (!bytes)
        return fail(bytes.error());
    auto image
        = FirmwareImage::fromIntelHex(std::string_view(bytes->constData(), static_cast<std::size_t>(bytes->size())));
    if (!image)
        return fail(image.error().about(rule.file));
    if (matter.recipe.family->inspect) {
        const auto summary = matter.recipe.family->inspect(*image);
        if (!summary)
            return fail(summary.error().about(rule.file));
        matter.imageVersion = summary->version;
    }
    matter.image = std::move(*image);
    matter.imageHash = hashOf(*bytes);
    return {};
}

/// What makes one unit this very one is never copied to all of them.
Result<void> readParameters(const std::string &path, RecipeMatter &matter)
{
    const std::string &file = matter.recipe.parameters->file;
    const auto bytes = besideOf(path, file, mostRecipeBytes);
    if (!bytes)
        return fail(bytes.error());
    const Family &family = *matter.recipe.family;
    const auto parsed = parseParameterFile(*bytes, family);
    if (!parsed)
        return fail(parsed.error().about(file));
    for (const ParameterChange &change : parsed->values) {
        const Parameter &parameter = family.parameters[change.index.value];
        const bool kept = parameter.persistent || !family.capabilities.keepsSettings;
        if (parameter.access != Access::ReadOnly && parameter.nature == Nature::Setting && kept
            && !parameter.belongsToUnit)
            matter.parameters.push_back(change);
    }
    if (matter.parameters.empty())
        return fail(Fault::OutOfRange, say("%1 has no setting that could be written to every unit", file));
    return {};
}

Result<RecipeMatter> readFiles(RecipeMatter matter, const std::string &path)
{
    if (matter.recipe.firmware) {
        if (auto read = readImage(path, matter); !read)
            return fail(read.error());
    }
    if (matter.recipe.parameters) {
        if (auto read = readParameters(path, matter); !read)
            return fail(read.error());
    }
    return matter;
}

} // namespace

bool isFigure(std::string_view key)
{
    return std::find(motorKeys.begin(), motorKeys.end(), key) != motorKeys.end();
}

Result<Recipe> parseRecipe(const QByteArray &text, std::span<const Family *const> families)
{
    return readRecipe(text, families);
}

QByteArray toText(const Recipe &recipe)
{
    QJsonObject object{{QStringLiteral("recipe"), 1}, {QStringLiteral("name"), qt(recipe.name)},
        {QStringLiteral("family"), qt(recipe.family->key)}};
    if (recipe.firmware) {
        QJsonObject firmware{{QStringLiteral("file"), qt(recipe.firmware->file)}};
        if (!recipe.firmware->via.empty())
            firmware.insert(QStringLiteral("via"), qt(recipe.firmware->via));
        object.insert(QStringLiteral("firmware"), firmware);
    }
    if (recipe.parameters)
        object.insert(QStringLiteral("parameters"),
            QJsonObject{{QStringLiteral("file"), qt(recipe.parameters->file)},
                {QStringLiteral("store"), recipe.parameters->store}});
    if (recipe.number)
        object.insert(QStringLiteral("number"), QJsonObject{{QStringLiteral("first"), recipe.number->first}});
    if (recipe.test)
        object.insert(QStringLiteral("test"), testOf(*recipe.test));
    return QJsonDocument(object).toJson(QJsonDocument::Indented);
}

Result<RecipeMatter> gatherMatter(Recipe recipe, const std::string &folder)
{
    RecipeMatter matter;
    matter.hash = hashOf(toText(recipe));
    matter.recipe = std::move(recipe);
    return readFiles(std::move(matter), folder + "/recipe");
}

Result<RecipeMatter> loadRecipe(const std::string &path, std::span<const Family *const> families)
{
    const auto bytes = loadFile(path, mostRecipeBytes);
    if (!bytes)
        return fail(bytes.error());
    auto recipe = parseRecipe(*bytes, families);
    if (!recipe)
        return fail(recipe.error().about(path));
    RecipeMatter matter;
    matter.recipe = std::move(*recipe);
    matter.hash = hashOf(*bytes);
    return readFiles(std::move(matter), path);
}

} // namespace mb::service
