// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/firmware/queuerecipe.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/numberformat.h"
#include "widgets/firmware/imagechoice.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>

namespace mb {
namespace {

constexpr int hashShown = 8;

struct RecipeText {
    Q_DECLARE_TR_FUNCTIONS(mb::RecipeText)
};

} // namespace

Result<void> QueueRecipe::openRecipe(const QString &path, std::span<const Family *const> families)
{
    auto loaded = service::loadRecipe(QFile::encodeName(path).toStdString(), families);
    if (!loaded)
        return fail(loaded.error());
    m_matter = std::make_shared<const service::RecipeMatter>(std::move(*loaded));
    return {};
}

Result<void> QueueRecipe::openImage(const QString &path, const std::vector<const Family *> &families)
{
    ImageChoice choice;
    choice.load(path);
    for (const Family *const family : families) {
        choice.check(family);
        if (!family->update || !family->inspect || !family->routes.empty() || (choice.image() && !choice.summary()))
            continue;
        service::Recipe recipe;
        recipe.name = QFileInfo(path).fileName().toStdString();
        recipe.family = family;
        recipe.firmware = service::FirmwareRule{QFileInfo(path).absoluteFilePath().toStdString(), {}};
        auto matter = service::gatherMatter(std::move(recipe), QFileInfo(path).absolutePath().toStdString());
        if (!matter)
            return fail(matter.error());
        m_matter = std::make_shared<const service::RecipeMatter>(std::move(*matter));
        return {};
    }
    return fail(Fault::OutOfRange,
        say("%1 is for no unit that is here and takes firmware over its own link", path.toStdString()),
        say("for the others write a recipe that names the way in"));
}

std::optional<ImageSummary> QueueRecipe::image() const
{
    if (!m_matter || !m_matter->recipe.firmware || !family()->inspect)
        return {};
    const auto summary = family()->inspect(m_matter->image);
    return summary ? std::optional(*summary) : std::nullopt;
}

QString QueueRecipe::name() const
{
    return m_matter ? qt(m_matter->recipe.name) : QString(UnknownMark);
}

QString QueueRecipe::imageText() const
{
    if (!m_matter || !m_matter->recipe.firmware)
        return QString(UnknownMark);
    const QString file = QFileInfo(qt(m_matter->recipe.firmware->file)).fileName();
    return m_matter->imageVersion.empty()
        ? RecipeText::tr("%1 · sha %2").arg(file, qt(m_matter->imageHash).left(hashShown))
        : RecipeText::tr("%1 · version %2 · sha %3")
              .arg(file, qt(m_matter->imageVersion), qt(m_matter->imageHash).left(hashShown));
}

QString QueueRecipe::parameterText() const
{
    if (!m_matter || !m_matter->recipe.parameters)
        return QString(UnknownMark);
    return RecipeText::tr("%1 · %2 values")
        .arg(QFileInfo(qt(m_matter->recipe.parameters->file)).fileName())
        .arg(m_matter->parameters.size());
}

QString QueueRecipe::numberText() const
{
    if (!m_matter || !m_matter->recipe.number)
        return QString(UnknownMark);
    return RecipeText::tr("next free from %1").arg(m_matter->recipe.number->first);
}

} // namespace mb
