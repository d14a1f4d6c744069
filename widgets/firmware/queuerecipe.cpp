// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/firmware/queuerecipe.h"

#include "widgets/firmware/imagechoice.h"

#include <QFile>
#include <QFileInfo>

namespace mb {

Result<void> QueueRecipe::openRecipe(const QString &path, std::span<const Family *const> families)
{
    MB_TRY(auto loaded, service::loadRecipe(QFile::encodeName(path).toStdString(), families));
    m_matter = std::make_shared<const service::RecipeMatter>(std::move(loaded));
    m_path = path;
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
        MB_TRY(auto matter, service::gatherMatter(std::move(recipe), QFileInfo(path).absolutePath().toStdString()));
        m_matter = std::make_shared<const service::RecipeMatter>(std::move(matter));
        m_path.clear();
        return {};
    }
    return fail(Fault::OutOfRange,
        say("%1 is for no unit that is here and takes firmware over its own link", path.toStdString()),
        say("for the others write a recipe that names the way in"));
}

const UpdateRoute *QueueRecipe::route() const
{
    if (!m_matter || !m_matter->recipe.firmware)
        return nullptr;
    const std::string_view via = m_matter->recipe.firmware->via;
    for (const UpdateRoute &route : family()->routes) {
        if (via.substr(0, via.find(':')) == route.scheme)
            return &route;
    }
    return nullptr;
}

std::optional<ImageSummary> QueueRecipe::image() const
{
    if (!m_matter || !m_matter->recipe.firmware || !family()->inspect)
        return {};
    const auto summary = family()->inspect(m_matter->image);
    return summary ? std::optional(*summary) : std::nullopt;
}

} // namespace mb
