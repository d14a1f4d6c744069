// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"
#include "service/recipematter.h"

#include <QString>

#include <memory>
#include <utility>
#include <vector>

namespace mb {

/// What a queue does to every unit: a recipe's file, or an image by itself. GUI thread.
class QueueRecipe {
public:
    QueueRecipe() = default;
    /// Of a queue that others have begun.
    explicit QueueRecipe(std::shared_ptr<const service::RecipeMatter> matter)
        : m_matter(std::move(matter))
    {
    }
    /// With line and mistake where it is none; what was there stays.
    [[nodiscard]] Result<void> openRecipe(const QString &path, std::span<const Family *const> families);
    /// Of the first of these families that it is for, and that takes it over its own link.
    [[nodiscard]] Result<void> openImage(const QString &path, const std::vector<const Family *> &families);

    /// Of the recipe's file; empty for an image by itself, and while nothing is open.
    [[nodiscard]] const QString &path() const { return m_path; }
    /// nullptr: nothing was opened yet.
    [[nodiscard]] const std::shared_ptr<const service::RecipeMatter> &matter() const { return m_matter; }
    /// nullptr without a matter.
    [[nodiscard]] const Family *family() const { return m_matter ? m_matter->recipe.family : nullptr; }
    /// The way in that the recipe names; nullptr: over the link of the unit.
    [[nodiscard]] const UpdateRoute *route() const;
    /// Of its image; nothing: it has none.
    [[nodiscard]] std::optional<ImageSummary> image() const;

private:
    std::shared_ptr<const service::RecipeMatter> m_matter;
    QString m_path;
};

} // namespace mb
