// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/tunegains.h"

#include "experiment/kepttrial.h"
#include "model/loopparameters.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/guarded.h"
#include "widgets/control/gainspanel.h"
#include "widgets/control/gainswriterow.h"
#include "widgets/control/gainunits.h"
#include "widgets/control/tunecolumn.h"
#include "widgets/parameters/axisparameters.h"

#include <QUndoStack>

#include <algorithm>

namespace mb {
namespace {

/// What is the same in every slot and on every axis.
std::string_view nameOf(std::string_view key)
{
    return key.substr(key.rfind('.') + 1);
}

} // namespace

TuneGains::TuneGains(Workbench &workbench, Arming &arming, TuneChoices &choices, TuneColumn &column)
    : m_workbench(workbench)
    , m_arming(arming)
    , m_choices(choices)
    , m_column(column)
{
}

/// What runs on the device: nullptr where it is free.
const OperationView *TuneGains::operation(const DeviceView &view) const
{
    const OperationView *const last = m_workbench.snapshot().operation(view.id);
    return last && last->status.state == OperationStatus::State::Running ? last : nullptr;
}

void TuneGains::follow(const DeviceView &view)
{
    const TuneChoice &chosen = *m_choices.current();
    const bool reading = operation(view) != nullptr;
    const Shown shown{view.id, view.parameterRevision, reading, m_choices.editRevision(), chosen.mode,
        chosen.editedSlot, chosen.units.countsPerRevolution, m_choices.axis()};
    if (std::exchange(m_shown, shown) == shown)
        return;
    GainsPanel &panel = m_column.gainsPanel();
    panel.choose(*view.family, *chosen.edits, chosen.mode, chosen.editedSlot, m_choices.axis());
    panel.refresh(view, reading);
}

void TuneGains::showWriteRow(const DeviceView &view)
{
    const GainsPanel &panel = m_column.gainsPanel();
    GainsWriteRow::State row;
    row.staged = panel.stagedNames();
    if (view.family->capabilities.gainSlots > 1)
        row.slot = m_choices.current()->editedSlot;
    row.free = view.liveness.heard && view.busy.empty() && !m_writing && !operation(view);
    row.fault = panel.hasFault();
    row.leap = !panel.unconfirmed().isEmpty();
    m_column.writeRow().show(row);
}

std::optional<PageStatus> TuneGains::obstacle(const DeviceView &view) const
{
    const GainsPanel &panel = m_column.gainsPanel();
    if (panel.hasFault())
        return PageStatus{GlyphState::OutOfRange, tr("A gain is out of range"), tr("Correct or revert it first.")};
    if (const QString leap = panel.unconfirmed(); !leap.isEmpty())
        return PageStatus{GlyphState::Warning, tr("Look at a gain again"), leap};
    if (m_writing)
        return PageStatus{GlyphState::Busy, tr("Writing gains"), {}};
    const bool known = std::any_of(
        view.parameters->begin(), view.parameters->end(), [](const auto &entry) { return entry.raw.has_value(); });
    if (const OperationView *const reading = operation(view); reading && !known)
        return PageStatus{
            GlyphState::Busy, tr("Reading gains"), tr("%1 of %2").arg(reading->status.done).arg(reading->status.total)};
    return std::nullopt;
}

void TuneGains::write(std::function<void()> next)
{
    const TuneMotor motor = m_choices.shown();
    const std::vector<ParameterChange> changes = m_column.gainsPanel().toWrite();
    m_writing = true;
    m_workbench.send(orders::WriteParameters{motor.device, changes},
        guarded(this,
            [this, motor, changes, next = std::move(next), number = m_arming.armingNumber()](
                const Result<void> &result) {
                written(motor, changes, result);
                if (result && next && m_choices.shown() == motor && m_arming.isArmed(motor.device)
                    && m_arming.armingNumber() == number)
                    next();
            }));
}

void TuneGains::written(const TuneMotor &motor, const std::vector<ParameterChange> &changes, const Result<void> &result)
{
    m_writing = false;
    const TuneChoice *const chosen = m_choices.find(motor);
    if (result && chosen)
        chosen->edits->settle(changes);
    Q_EMIT changed();
    if (!result)
        m_workbench.report(Severity::Danger, {}, tr("gains not written: %1").arg(errorText(result.error())));
}

void TuneGains::undo(bool again)
{
    const TuneChoice *const chosen = m_choices.current();
    const DeviceView *const view = m_choices.device();
    if (!chosen || !chosen->edits || !view)
        return;
    QUndoStack &stack = chosen->edits->undoStack();
    if (again ? stack.canRedo() : chosen->edits->canUndo()) {
        again ? stack.redo() : stack.undo();
        return;
    }
    if (!view->liveness.heard)
        return;
    m_workbench.send(
        orders::UndoWrite{view->id, again}, guarded(this, [this, name = titleOf(*view)](const Result<void> &result) {
            if (!result)
                m_workbench.report(Severity::Danger, name, errorText(result.error()));
        }));
}

/// By what they are called, whatever slot they were of.
template <class Values> void TuneGains::stage(const Values &values, const QString &title)
{
    const DeviceView *const view = m_choices.device();
    const TuneChoice *const chosen = m_choices.current();
    if (!view || !chosen)
        return;
    const GainSet set = gainSet(*view->family, chosen->mode, chosen->editedSlot, m_choices.axis());
    std::vector<ParameterIndex> rows = set.gains;
    rows.insert(rows.end(), set.bounds.begin(), set.bounds.end());
    std::vector<ParameterChange> changes;
    for (const ParameterIndex index : rows) {
        const Parameter &row = view->family->parameters[index.value];
        for (const auto &[key, value] : values) {
            const std::optional<double> number = value;
            if (!number || nameOf(row.key) != nameOf(key))
                continue;
            if (const auto raw = toRaw(row, *number))
                changes.push_back({index, *raw});
        }
    }
    chosen->edits->stageAll(changes, title);
}

void TuneGains::stageTrial(const KeptTrial &kept)
{
    const DeviceView *const view = m_choices.device();
    auto gains = kept.trial.gains;
    const LoopGains *const loop = view ? loopOf(*view->family, kept.trial.mode) : nullptr;
    const auto own
        = loop ? loopParameters(*view->family, *loop, kept.trial.axis, kept.trial.slot) : std::vector<ParameterIndex>();
    std::erase_if(gains, [&view, &own](const auto &gain) { // of another slot or loop, though called the same
        const auto index = view ? findParameter(view->family->parameters, gain.first) : std::nullopt;
        return !index || std::ranges::find(own, *index) == own.end();
    });
    stage(gains, tr("Gains of trial #%1").arg(kept.number));
}

void TuneGains::stageAdvice(const std::vector<std::pair<std::string, double>> &values)
{
    stage(values, tr("What the adviser proposes"));
}

void TuneGains::stageAxis(int from)
{
    const DeviceView *const view = m_choices.device();
    const TuneChoice *const chosen = m_choices.current();
    if (!view || !chosen)
        return;
    const int axis = m_choices.axis();
    const GainSet rows = gainSet(*view->family, chosen->mode, chosen->editedSlot, axis);
    const auto isShown = [&rows](ParameterIndex index) {
        return std::ranges::find(rows.gains, index) != rows.gains.end()
            || std::ranges::find(rows.bounds, index) != rows.bounds.end();
    };
    std::vector<ParameterChange> changes = gainsOfAxis(*view->family, *chosen->edits, from, axis);
    std::erase_if(changes, [&](const ParameterChange &change) { return !isShown(change.index); });
    if (changes.empty()) {
        m_workbench.report(Severity::Caution, titleOf(*view),
            tr("nothing copied: no gain of axis %1 is known for this mode; write it first").arg(from));
        return;
    }
    chosen->edits->stageAll(changes, tr("Gains and limits of axis %1").arg(from));
}

} // namespace mb
