// SPDX-License-Identifier: GPL-3.0-or-later
#include "service/recipematter.h"

#include "files/filebytes.h"
#include "files/qttext.h"
#include "model/family.h"
#include "model/parameterfile.h"
#include "service/reciperead.h"

#include <QCryptographicHash>
#include <QFileInfo>

namespace mb::service {
namespace {

constexpr std::int64_t mostRecipeBytes = 1 << 20;

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

Result<void> readImage(const std::string &path, RecipeMatter &matter, QCryptographicHash &all)
{
    const FirmwareRule &rule = *matter.recipe.firmware;
    MB_TRY(const auto bytes, besideOf(path, rule.file, static_cast<std::int64_t>(FirmwareImage::maxTextSize)));
    auto image
        = FirmwareImage::fromIntelHex(std::string_view(bytes.constData(), static_cast<std::size_t>(bytes.size())));
    if (!image)
        return fail(image.error().about(rule.file));
    if (matter.recipe.family->inspect) {
        const auto summary = matter.recipe.family->inspect(*image);
        if (!summary)
            return fail(summary.error().about(rule.file));
        matter.imageVersion = summary->version;
    }
    matter.image = std::move(*image);
    matter.imageHash = hashOf(bytes);
    all.addData(bytes);
    return {};
}

/// Nothing of one visit switches a unit off and on, and without that its motor may not be driven.
Result<void> checkTested(const Recipe &recipe, const ParameterChange &change)
{
    const Parameter &parameter = recipe.family->parameters[change.index.value];
    const TrialTraits *const trials = recipe.family->trials;
    if (!recipe.test || !trials || parameter.key != trials->never
        || static_cast<double>(change.raw) >= parameter.maximum * parameter.one)
        return {};
    return fail(Fault::OutOfRange,
        say("a unit whose %1 was lowered must lose its power once before its motor may be driven", parameter.key),
        say("leave it out of the file, or the self-test out of the recipe"));
}

/// What makes one unit this very one is never copied to all of them.
Result<void> readParameters(const std::string &path, RecipeMatter &matter, QCryptographicHash &all)
{
    const std::string &file = matter.recipe.parameters->file;
    MB_TRY(const auto bytes, besideOf(path, file, mostRecipeBytes));
    const Family &family = *matter.recipe.family;
    const auto parsed = parseParameterFile(bytes, family);
    if (!parsed)
        return fail(parsed.error().about(file));
    for (const ParameterChange &change : parsed->values) {
        if (auto tested = checkTested(matter.recipe, change); !tested)
            return fail(tested.error().about(file));
        const Parameter &parameter = family.parameters[change.index.value];
        const bool kept = parameter.persistent || !family.capabilities.keepsSettings;
        if (parameter.access != Access::ReadOnly && parameter.nature == Nature::Setting && kept
            && !parameter.belongsToUnit)
            matter.parameters.push_back(change);
    }
    if (matter.parameters.empty())
        return fail(Fault::OutOfRange, say("%1 has no setting that could be written to every unit", file));
    all.addData(bytes);
    return {};
}

/// `text` is the recipe's own; with what its files hold it makes the hash.
Result<RecipeMatter> readFiles(Recipe recipe, const QByteArray &text, const std::string &path)
{
    QCryptographicHash all(QCryptographicHash::Sha256);
    all.addData(text);
    RecipeMatter matter;
    matter.recipe = std::move(recipe);
    if (matter.recipe.firmware)
        MB_TRY_VOID(readImage(path, matter, all));
    if (matter.recipe.parameters) {
        MB_TRY_VOID(readParameters(path, matter, all));
    }
    matter.hash = all.result().toHex().toStdString();
    return matter;
}

} // namespace

Result<RecipeMatter> gatherMatter(Recipe recipe, const std::string &folder)
{
    const QByteArray text = toText(recipe);
    return readFiles(std::move(recipe), text, folder + "/recipe");
}

Result<RecipeMatter> loadRecipe(const std::string &path, std::span<const Family *const> families)
{
    MB_TRY(const auto bytes, loadFile(path, mostRecipeBytes));
    auto recipe = parseRecipe(bytes, families);
    if (!recipe)
        return fail(recipe.error().about(path));
    return readFiles(std::move(*recipe), bytes, path);
}

} // namespace mb::service
