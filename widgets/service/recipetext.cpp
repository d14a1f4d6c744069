// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/service/recipetext.h"

#include "service/figuretext.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/numberformat.h"

#include <QCoreApplication>
#include <QFileInfo>

namespace mb {
namespace {

constexpr int hashShown = 8;

struct RecipeText {
    Q_DECLARE_TR_FUNCTIONS(mb::RecipeText)
};

} // namespace

QString recipeName(const service::RecipeMatter *matter)
{
    return matter ? qt(matter->recipe.name) : QString(UnknownMark);
}

QString imageText(const service::RecipeMatter *matter)
{
    if (!matter || !matter->recipe.firmware)
        return QString(UnknownMark);
    const QString file = QFileInfo(qt(matter->recipe.firmware->file)).fileName();
    return matter->imageVersion.empty()
        ? RecipeText::tr("%1 · sha %2").arg(file, qt(matter->imageHash).left(hashShown))
        : RecipeText::tr("%1 · version %2 · sha %3")
              .arg(file, qt(matter->imageVersion), qt(matter->imageHash).left(hashShown));
}

QString parameterText(const service::RecipeMatter *matter)
{
    if (!matter || !matter->recipe.parameters)
        return QString(UnknownMark);
    return RecipeText::tr("%1 · %2 values")
        .arg(QFileInfo(qt(matter->recipe.parameters->file)).fileName())
        .arg(matter->parameters.size());
}

QString numberText(const service::RecipeMatter *matter)
{
    if (!matter || !matter->recipe.number)
        return QString(UnknownMark);
    return RecipeText::tr("next free from %1").arg(matter->recipe.number->first);
}

QString testText(const service::RecipeMatter *matter)
{
    if (!matter || !matter->recipe.test)
        return QString(UnknownMark);
    QStringList words{modeText(matter->recipe.test->loop)};
    for (const service::Acceptance &acceptance : matter->recipe.test->accept)
        words << messageText(service::figureName(acceptance.key));
    return words.join(QStringLiteral(", "));
}

} // namespace mb
