// SPDX-License-Identifier: GPL-3.0-or-later
// What the page shows: snapshots, edits, what is compared.
#include "widgets/common/devicetext.h"
#include "widgets/common/emptystate.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/searchfield.h"
#include "widgets/common/segmented.h"
#include "widgets/parameters/axisparameters.h"
#include "widgets/parameters/changespanel.h"
#include "widgets/parameters/historypanel.h"
#include "widgets/parameters/parameterfiles.h"
#include "widgets/parameters/parameterfoot.h"
#include "widgets/parameters/parameterspage.h"
#include "widgets/parameters/readstatus.h"

#include <QComboBox>
#include <QDateTime>
#include <QStackedWidget>

#include <algorithm>

namespace mb {
namespace {

enum Comparison { WithDefaults, AsFound, WithFile, ChooseFile, WithAxis }; // and the axis on top of it

bool isUnderWay(const OperationView *operation)
{
    return operation && operation->status.state == OperationStatus::State::Running;
}

} // namespace

const DeviceView *ParametersPage::device() const
{
    return m_workbench.snapshot().device(m_selection.device());
}

void ParametersPage::follow()
{
    m_ledger.observe(m_workbench.snapshot(), m_workbench.now());
    followEdits();
    if (!isVisible())
        return;
    choose();
}

void ParametersPage::followEdits()
{
    for (const DeviceView &device : m_workbench.snapshot().devices) {
        const auto [seen, isNew] = m_revisions.try_emplace(device.id, 0);
        if (device.parameters.size() != device.family->parameters.size()
            || (!isNew && seen->second == device.parameterRevision))
            continue;
        seen->second = device.parameterRevision;
        (void)editsOf(device);
        rememberAsFound(device);
    }
}

void ParametersPage::rememberAsFound(const DeviceView &device)
{
    const bool complete = std::all_of(device.parameters.begin(), device.parameters.end(),
        [](const auto &entry) { return entry.raw && entry.state != ParameterState::Failed; });
    if (!complete || m_asFound.contains(device.id))
        return;
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(
        m_workbench.now().time_since_epoch() + m_workbench.unixOffset());
    ParameterReference found{
        tr("as found %1").arg(QDateTime::fromSecsSinceEpoch(seconds.count()).toString(QStringLiteral("HH:mm"))), {}};
    for (const auto &entry : device.parameters)
        found.raws.push_back(entry.raw);
    m_asFound.emplace(device.id, std::move(found));
    if (m_model->edits() == &editsOf(device))
        fillComparisons();
}

void ParametersPage::choose()
{
    const DeviceView *shown = device();
    const bool hasParameters
        = shown && shown->identity.state != DeviceState::Bootloader && !shown->family->parameters.empty();
    if (hasParameters)
        showDevice(*shown);
    else if (shown || !m_fileEdits)
        showEmpty();
}

void ParametersPage::showDevice(const DeviceView &device)
{
    StagedEdits &edits = editsOf(device);
    m_boardOnly = m_boardOnly && m_selection.axis() == 0;
    m_stack->setCurrentIndex(1);
    const OperationView *operation = m_workbench.snapshot().operation(device.id);
    Shown now{device.id, device.parameterRevision, device.liveness.heard, device.identity.state, {}, {}, 0, {},
        m_boardOnly ? -1 : m_selection.axis()};
    if (operation) {
        now.operation = operation->id;
        now.operationState = operation->status.state;
        now.done = operation->status.done;
        now.step = operation->status.step;
    }
    const bool same = now == m_shown && m_model->edits() == &edits;
    const bool sameRows = m_model->edits() == &edits && now.axis == m_shown.axis && now.device == m_shown.device;
    m_shown = now;
    if (m_history->isVisible())
        m_history->showDevice(device);
    readOnce(device);
    if (same)
        return;
    if (m_model->edits() != &edits) {
        m_view->commitField();
        m_model->show(device.family, &edits, true);
        m_fileEdits.reset();
        m_fileReference.reset();
        m_panel->show();
        m_comparedAxis = 0;
    } else {
        m_model->refresh();
    }
    if (!sameRows) {
        followAxes(*device.family);
        fillComparisons();
        setFilter();
    }
    refresh();
}

void ParametersPage::showEmpty()
{
    showHistory(false);
    if (m_model->edits()) {
        m_view->commitField();
        m_model->show(nullptr, nullptr, false);
    }
    m_stack->setCurrentIndex(0);
    const DeviceView *shown = device();
    m_openFile->setVisible(!shown);
    if (!shown)
        m_empty->setText(tr("Select a device"),
            tr("Its parameters appear here. A parameter file can be looked at and compared without a device."));
    else if (shown->identity.state == DeviceState::Bootloader)
        m_empty->setText(tr("No parameters in the bootloader"),
            tr("%1 has no application running. Write firmware to it, then its parameters can be read.")
                .arg(titleOf(*shown)));
    else
        m_empty->setText(tr("No parameters"), tr("%1 has none.").arg(titleOf(*shown)));
}

void ParametersPage::readOnce(const DeviceView &device)
{
    const bool unknown = std::all_of(device.parameters.begin(), device.parameters.end(),
        [](const auto &entry) { return entry.state == ParameterState::Unknown; });
    const bool ready = device.identity.state == DeviceState::Online && device.liveness.heard && device.busy.empty()
        && device.family->capabilities.readback;
    if (!unknown || !ready || isUnderWay(m_workbench.snapshot().operation(device.id))
        || !m_asked.insert(device.id).second)
        return;
    m_workbench.send(orders::ReadParameters{device.id});
}

void ParametersPage::refresh()
{
    if (!isVisible())
        return;
    const DeviceView *shown = m_fileEdits ? nullptr : device();
    m_panel->refresh(shown, shown ? m_workbench.snapshot().operation(shown->id) : nullptr);
    refreshTexts();
}

void ParametersPage::refreshTexts()
{
    StagedEdits *edits = m_model->edits();
    if (!edits)
        return;
    const ParameterCounts counts = countParameters(*m_model, m_fileEdits ? std::nullopt : filterAxis());
    m_segments->setText(ParameterFilter::All, tr("All %1").arg(counts.all));
    m_segments->setText(ParameterFilter::Changed, tr("Changed %1").arg(counts.changed));
    m_segments->setText(ParameterFilter::Edited, tr("Edited %1").arg(counts.edited + counts.illegal));
    m_segments->setText(ParameterFilter::Errors, tr("Errors %1").arg(counts.illegal + counts.unread));
    m_search->setResult(
        m_search->text().isEmpty() ? QString() : tr("%1 of %2").arg(m_view->shownRows()).arg(counts.all));
    m_foot->showCounts(counts);
    const auto current = m_view->currentParameter();
    m_foot->showParameter(current ? &m_model->parameter(*current) : nullptr);
    const DeviceView *shown = m_fileEdits ? nullptr : device();
    const OperationView *operation = shown ? m_workbench.snapshot().operation(shown->id) : nullptr;
    if (shown)
        m_status->showDevice(*shown, operation, countParameters(*m_model));
    else
        m_status->showFile(m_fileName, qt(m_model->family()->title));
    const bool free = shown && shown->liveness.heard && !isUnderWay(operation);
    m_undo->setEnabled(free || edits->undoStack().canUndo());
    m_redo->setEnabled(free || edits->undoStack().canRedo());
    m_read->setEnabled(free);
    m_snapshot->setEnabled(free);
    m_showHistory->setEnabled(shown != nullptr);
    m_import->setEnabled(shown != nullptr);
    m_export->setEnabled(shown
        && std::any_of(shown->parameters.begin(), shown->parameters.end(),
            [](const auto &entry) { return entry.raw.has_value(); }));
}

void ParametersPage::fillComparisons()
{
    m_compare->clear();
    m_compare->addItem(tr("defaults"), WithDefaults);
    const auto found = m_fileEdits ? m_asFound.end() : m_asFound.find(m_selection.device());
    if (found != m_asFound.end())
        m_compare->addItem(found->second.title, AsFound);
    if (m_fileReference)
        m_compare->addItem(m_fileReference->title, WithFile);
    const Family *family = m_model->family();
    for (int axis = 1; family && m_selection.axis() > 0 && axis <= family->capabilities.axes; ++axis) {
        if (axis != m_selection.axis())
            m_compare->addItem(tr("axis %1").arg(axis), WithAxis + axis);
    }
    m_compare->addItem(tr("a file…"), ChooseFile);
    const int shown = m_compare->findText(m_model->reference().title);
    m_compare->setCurrentIndex(std::max(0, shown));
}

void ParametersPage::comparisonChosen(int row)
{
    if (!m_model->family())
        return;
    const int chosen = m_compare->itemData(row).toInt();
    m_comparedAxis = std::max(0, chosen - WithAxis);
    switch (chosen) {
    case WithDefaults: m_model->setReference(defaultsOf(*m_model->family())); break;
    case AsFound: m_model->setReference(m_asFound.at(m_selection.device())); break;
    case WithFile: m_model->setReference(*m_fileReference); break;
    case ChooseFile:
        askForFile(*this, tr("Compare with a parameter file"), [this](const QString &path) { compareWith(path); });
        break;
    default: m_model->setReference(axisReference(*m_model->family(), *m_model->edits(), m_comparedAxis)); break;
    }
    fillComparisons();
}

} // namespace mb
