// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/firmware/queueside.h"

#include "widgets/common/devicetext.h"
#include "widgets/firmware/pagemap.h"
#include "widgets/firmware/queuelines.h"
#include "widgets/firmware/queuerecipe.h"
#include "widgets/firmware/stepspanel.h"
#include "widgets/firmware/unitsteps.h"
#include "widgets/service/verdictof.h"

#include <utility>

namespace mb {

using service::RowState;

QueueSide::QueueSide(const ThemeSource &theme, QWidget *parent)
    : UpdateSide(theme, parent)
{
    add(m_unit = new UnitSteps(theme, this));
}

void QueueSide::noteWhatTurns(const QueueRecipe &recipe)
{
    const auto test = recipe.matter() ? recipe.matter()->recipe.test : std::nullopt;
    setNotes(test
            ? tr("The self-test turns the motor: %1. Hold Arm in the header once the queue runs.").arg(motionOf(*test))
            : QString());
}

void QueueSide::setRecipe(const QueueRecipe &recipe)
{
    if (std::exchange(m_matter, recipe.matter()) == recipe.matter())
        return;
    const auto image = recipe.image();
    const UpdateRoute *const route = recipe.route();
    setGuided(route && !route->steps.empty());
    steps().setSteps(route ? route->steps : std::span<const GuidedStep>());
    map().setParts(image ? image->parts : std::vector<int>{}, image ? image->criticalPart : std::nullopt);
}

void QueueSide::showUnit(const service::QueueRow *row, const QueueLine *line, const QueueRecipe &recipe)
{
    setRecipe(recipe);
    if (m_unit->row() != (row ? row->id : 0))
        map().setStates({}); // of another unit
    const QString title = line ? line->title : QString();
    m_unit->show(row, title, recipe.matter() ? &recipe.matter()->recipe : nullptr);
    map().setStates(row ? row->parts : std::map<int, PartState>());
    followHands(row);
    const bool running = row && row->state == RowState::Running;
    const bool waits = line && line->glyph == GlyphState::Waiting; // of one that runs: for Arm
    const Safety safety = !running ? Safety::Nothing
        : mayUnplug(*row)          ? Safety::MayCut
        : !row->mayInterrupt       ? Safety::MustNotCut
        : waits                    ? Safety::WaitsToTurn
                                   : Safety::Turns;
    const QString link = line && !line->link.isEmpty() ? QStringLiteral(" · ") + line->link : QString();
    const bool isWhole = row && row->state == RowState::Passed;
    showSafety(safety, running || isWhole ? title + link : QString(),
        recipe.family() ? updateWords(*recipe.family()) : UpdateWords());
}

/// The steps by hand, where the recipe names a way in that needs them.
void QueueSide::followHands(const service::QueueRow *row)
{
    if (!row || row->parts.empty())
        return steps().follow(nullptr);
    OperationStatus status;
    status.parts = row->parts;
    status.state = row->state == RowState::Running ? OperationStatus::State::Running
        : row->state == RowState::Passed           ? OperationStatus::State::Done
                                                   : OperationStatus::State::Failed;
    steps().follow(&status);
}

} // namespace mb
