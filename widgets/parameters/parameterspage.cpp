// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/parameterspage.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/emptystate.h"
#include "widgets/common/filechoice.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/leastheight.h"
#include "widgets/common/pagekeys.h"
#include "widgets/parameters/editdesk.h"
#include "widgets/parameters/historypanel.h"
#include "widgets/parameters/parametercommands.h"
#include "widgets/parameters/parameterfiles.h"
#include "widgets/parameters/parameterhead.h"
#include "widgets/parameters/parametersheet.h"
#include "widgets/parameters/parametertools.h"
#include "widgets/parameters/readstatus.h"

#include <QStackedWidget>

namespace mb {
namespace {

constexpr int besideFrom = 900; ///< narrower than this the panel goes below the table
constexpr int lowBelow = 400;   ///< lower than this the orders share a line with the search

QVBoxLayout *plainColumn(QWidget *widget)
{
    auto *column = layoutIn<QVBoxLayout>(widget, 0);
    return column;
}

/// It answers, and no job of it is under way.
bool isFree(const DeviceView *device, const Snapshot &shot)
{
    return device && device->liveness.heard && !isUnderWay(shot.operation(device->id));
}

} // namespace

ParametersPage::ParametersPage(
    Workbench &workbench, Selection &selection, const ThemeSource &theme, BannerStack &banners, QWidget *parent)
    : QWidget(parent)
    , m_workbench(workbench)
    , m_desk(EditDesk::of(workbench))
    , m_selection(selection)
    , m_theme(theme)
    , m_model(new ParameterModel(this))
    , m_commands(new ParameterCommands(workbench, banners, this))
{
    setObjectName(QStringLiteral("parametersPage"));
    m_stack = new QStackedWidget(this);
    plainColumn(this)->addWidget(m_stack, 1);
    buildEmpty();
    m_stack->addWidget(buildTable(banners));
    connectHead();
    connectSheet();
    buildKeys();
    connect(&workbench, &Workbench::changed, this, &ParametersPage::follow);
    connect(&selection, &Selection::changed, this, &ParametersPage::follow);
    connect(m_model, &ParameterModel::standingChanged, this, &ParametersPage::refresh);
    connect(&theme, &ThemeSource::changed, this, &ParametersPage::refresh);
    follow();
}

ParametersPage::~ParametersPage()
{
    m_model->show(nullptr, nullptr, false);
}

ParameterView &ParametersPage::view()
{
    return m_sheet->view();
}

void ParametersPage::ask(const QString &title, void (ParametersPage::*then)(const QString &))
{
    askForFile(*this, title, parameterFilters(), {}, [this, then](const QString &path) { (this->*then)(path); });
}

void ParametersPage::buildEmpty()
{
    m_empty = new EmptyState(m_theme, Symbol::Chip, {}, {}, m_stack);
    m_openFile = m_empty->addAction(Symbol::Document, tr("Open a parameter file…"));
    m_stack->addWidget(m_empty);
    connect(m_openFile, &QPushButton::clicked, this,
        [this] { ask(tr("Open a parameter file"), &ParametersPage::openFile); });
}

QWidget *ParametersPage::buildTable(BannerStack &banners)
{
    auto *content = new LeastHeight(this);
    m_head = new ParameterHead(m_theme, content);
    m_tools = new ParameterTools(m_theme, m_workbench, m_selection, *m_model, content);
    m_sheet = new ParameterSheet(m_theme, m_workbench, *m_model, content);
    m_exchange = new FileExchange(m_workbench, banners, m_sheet->view());
    m_history = new HistoryPanel(m_workbench, m_theme, content);
    m_history->hide();
    m_column = plainColumn(content);
    m_column->addWidget(m_head);
    m_column->addWidget(m_tools);
    m_column->addWidget(separatorLine(Qt::Horizontal, content));
    m_column->addWidget(m_sheet, 1);
    m_column->addWidget(m_history, 1);
    connect(m_tools, &ParameterTools::filterChanged, this, &ParametersPage::setFilter);
    connect(m_tools, &ParameterTools::searchEnded, &m_sheet->view(), qOverload<>(&QWidget::setFocus));
    connect(&m_tools->axes(), &AxisChoice::changed, this, &ParametersPage::follow);
    connect(&m_tools->comparison(), &ComparisonBox::fileRequested, this,
        [this] { ask(tr("Compare with a parameter file"), &ParametersPage::compareWith); });
    connect(m_commands, &ParameterCommands::written, this, &ParametersPage::refresh);
    connect(m_commands, &ParameterCommands::kept, m_history, &HistoryPanel::reload);
    connect(m_history, &HistoryPanel::restoreRequested, this, [this] {
        if (const DeviceView *shown = device())
            m_commands->restore(shown->id, m_history->ticked());
    });
    return content;
}

void ParametersPage::connectHead()
{
    connect(m_head, &ParameterHead::undoRequested, this, &ParametersPage::undo);
    connect(m_head, &ParameterHead::readRequested, this, &ParametersPage::readAll);
    connect(m_head, &ParameterHead::snapshotRequested, this, &ParametersPage::takeSnapshot);
    connect(m_head, &ParameterHead::historyToggled, this, &ParametersPage::showHistory);
    connect(m_head, &ParameterHead::menuFilled, this, [this](QMenu *menu) { m_tools->comparison().addTo(*menu); });
    connect(m_head, &ParameterHead::importRequested, this,
        [this] { ask(tr("Import parameters"), &ParametersPage::importFrom); });
    connect(m_head, &ParameterHead::exportRequested, this, [this] {
        if (const DeviceView *shown = device())
            askWhereToSave(*this, tr("Export parameters"), parameterFilters(),
                QStringLiteral("%1-%2.json").arg(qt(shown->family->key)).arg(shown->identity->address),
                [this](const QString &path) { exportTo(path); });
    });
}

void ParametersPage::connectSheet()
{
    connect(&view(), &ParameterView::retryRequested, this, &ParametersPage::readAll);
    connect(&view(), &ParameterView::currentParameterChanged, this, &ParametersPage::refreshTexts);
    ChangesPanel &changes = m_sheet->changes();
    connect(&changes, &ChangesPanel::writeRequested, this, &ParametersPage::write);
    connect(&changes, &ChangesPanel::storeRequested, this, &ParametersPage::store);
    connect(&changes, &ChangesPanel::discardRequested, this, [this] { m_model->edits()->discard(); });
    connect(&changes, &ChangesPanel::parameterActivated, this, [this](ParameterIndex index) {
        view().goTo(index);
        view().setFocus();
    });
}

void ParametersPage::buildKeys()
{
    auto *keys = new PageKeys(*this);
    keys->add({Qt::Key_F5}, tr("reads all parameters"), [this] { readAll(); });
    keys->add({QKeySequence(QStringLiteral("Ctrl+F"))}, tr("searches"), [this] { m_tools->search(); });
    keys->add({QKeySequence(QStringLiteral("Ctrl+Shift+W"))}, tr("writes what is staged"), [this] { write(); });
    keys->add({QKeySequence(QStringLiteral("Ctrl+Z"))}, tr("undoes the last edit, or else the last write to the unit"),
        [this] { undo(false); });
    keys->add({QKeySequence(QStringLiteral("Ctrl+Y")), QKeySequence(QStringLiteral("Ctrl+Shift+Z"))},
        tr("redoes the last edit or write"), [this] { undo(true); });
    keys->add({QKeySequence(QStringLiteral("Ctrl+H"))}, tr("shows the history of the unit, or its values"),
        [this] { showHistory(!m_head->isHistoryChosen()); });
}

void ParametersPage::follow()
{
    for (const DeviceView &device : m_workbench.snapshot().devices) {
        if (device.parameters->size() != device.family->parameters.size())
            continue;
        (void)m_desk.editsOf(device);
        m_tools->comparison().remember(device);
    }
    if (isVisible())
        choose();
}

void ParametersPage::choose()
{
    const DeviceView *shown = device();
    const bool hasParameters
        = shown && shown->identity->state != DeviceState::Bootloader && !shown->family->parameters.empty();
    if (hasParameters)
        showDevice(*shown);
    else if (shown || !m_file)
        showEmpty();
}

void ParametersPage::showDevice(const DeviceView &device)
{
    StagedEdits &edits = m_desk.editsOf(device);
    m_stack->setCurrentIndex(1);
    const OperationView *operation = m_workbench.snapshot().operation(device.id);
    Shown now{device.id, device.parameterRevision, device.liveness.heard, device.identity->state, {}, {}, 0, {},
        m_tools->axes().chosen()};
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
    m_desk.readOnce(device);
    if (same)
        return;
    if (m_model->edits() != &edits) {
        view().commitField();
        m_model->show(device.family, &edits, true);
        m_file.reset();
        m_tools->comparison().forgetFile();
        m_sheet->setWritable(true);
    } else {
        m_model->refresh();
    }
    if (!sameRows) {
        m_tools->axes().follow(*device.family);
        m_tools->comparison().forgetAxis();
        m_tools->comparison().refresh();
        setFilter();
    }
    refresh();
}

void ParametersPage::showEmpty()
{
    showHistory(false);
    if (m_model->edits()) {
        view().commitField();
        m_model->show(nullptr, nullptr, false);
        m_file.reset();
    }
    m_stack->setCurrentIndex(0);
    const DeviceView *shown = device();
    m_openFile->setVisible(!shown);
    if (!shown)
        m_empty->setText(tr("Select a device"),
            tr("Its parameters appear here. A parameter file can be looked at and compared without a device."));
    else if (shown->identity->state == DeviceState::Bootloader)
        m_empty->setText(tr("No parameters in the bootloader"),
            tr("%1 has no application running. Write firmware to it, then its parameters can be read.")
                .arg(titleOf(*shown)));
    else
        m_empty->setText(tr("No parameters"), tr("%1 has none.").arg(titleOf(*shown)));
}

void ParametersPage::refresh()
{
    if (!isVisible())
        return;
    const DeviceView *shown = m_file ? nullptr : device();
    m_sheet->changes().refresh(shown, shown ? m_workbench.snapshot().operation(shown->id) : nullptr);
    refreshTexts();
}

void ParametersPage::refreshTexts()
{
    StagedEdits *edits = m_model->edits();
    if (!edits)
        return;
    const ParameterCounts counts = countParameters(*m_model, m_file ? std::nullopt : m_tools->axes().chosen());
    m_tools->showCounts(counts, view().shownRows());
    m_sheet->foot().showCounts(counts);
    const auto current = view().currentParameter();
    m_sheet->foot().showParameter(current ? &m_model->parameter(*current) : nullptr);
    if (const DeviceView *shown = m_file ? nullptr : device()) {
        const OperationView *const operation = m_workbench.snapshot().operation(shown->id);
        const ParameterCounts known = countParameters(*m_model);
        m_head->showDevice(*shown, operation, known, edits->undoStack());
        m_sheet->foot().status().showDevice(*shown, operation, known);
    } else {
        const QString family = qt(m_model->family()->title);
        m_head->showFile(m_file ? m_file->name : QString(), family, edits->undoStack());
        m_sheet->foot().status().showFile(m_file ? m_file->name : QString(), family);
    }
}

void ParametersPage::setFilter()
{
    view().setFilter(m_tools->filter());
    refreshTexts();
}

void ParametersPage::undo(bool redo)
{
    if (!m_model->edits())
        return;
    view().commitField();
    QUndoStack &stack = m_model->edits()->undoStack();
    const DeviceView *shown = device();
    if (redo ? stack.canRedo() : m_model->edits()->canUndo())
        redo ? stack.redo() : stack.undo();
    else if (shown && !m_file && shown->liveness.heard)
        m_commands->undoWrite(shown->id, redo);
}

void ParametersPage::readAll()
{
    const DeviceView *shown = device();
    if (isFree(shown, m_workbench.snapshot()) && m_model->edits() && !m_file)
        m_commands->read(shown->id);
}

void ParametersPage::write()
{
    if (!m_model->edits() || m_file)
        return;
    view().commitField();
    refresh();
    if (!m_sheet->changes().mayWrite())
        return;
    m_exchange->endImport();
    m_commands->write(m_selection.device(), m_model->edits()->toWrite());
}

void ParametersPage::store()
{
    const DeviceView *shown = device();
    if (isFree(shown, m_workbench.snapshot()) && !inRam(*shown->parameters).empty())
        m_commands->store(shown->id);
}

void ParametersPage::takeSnapshot()
{
    const DeviceView *shown = device();
    if (isFree(shown, m_workbench.snapshot()))
        m_commands->takeSnapshot(shown->id);
}

void ParametersPage::showHistory(bool on)
{
    view().commitField();
    const DeviceView *shown = device();
    const bool may = on && shown && !m_file;
    if (may)
        m_history->showDevice(*shown);
    m_head->chooseHistory(may);
    m_history->setVisible(may);
    m_tools->setVisible(!may);
    m_sheet->setVisible(!may);
    fit();
}

void ParametersPage::importFrom(const QString &path)
{
    const DeviceView *shown = device();
    if (shown && m_model->edits() && !m_file && m_exchange->importInto(*shown, path))
        m_tools->chooseEdited();
}

void ParametersPage::exportTo(const QString &path)
{
    if (const DeviceView *shown = device())
        m_exchange->exportOf(*shown, path);
}

void ParametersPage::compareWith(const QString &path)
{
    const Family *family = m_model->family();
    if (!family)
        return;
    const QString owner = m_file ? m_file->name : device() ? titleOf(*device()) : QString();
    if (auto reference = m_exchange->referenceOf(path, *family, owner))
        m_tools->comparison().compareWith(std::move(*reference));
    else
        m_tools->comparison().refresh();
}

void ParametersPage::openFile(const QString &path)
{
    auto opened = m_exchange->open(path);
    if (!opened)
        return;
    m_model->show(opened->family, opened->edits.get(), false);
    m_file = std::move(opened);
    m_tools->comparison().forgetFile();
    m_sheet->setWritable(false);
    m_stack->setCurrentIndex(1);
    m_tools->comparison().refresh();
    setFilter();
}

void ParametersPage::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    m_shown = {};
    follow();
}

/// Where the orders do not fit in a line with their words they are symbols, and in a low window those that are used most stand in one line
/// with the search: the values are what the page is for.
void ParametersPage::fit()
{
    const Theme &t = m_theme.theme();
    const bool words = m_head->wordsWidth() <= width();
    const bool low = height() < t.u(lowBelow) && !m_tools->isHidden();
    m_head->setRoom(words ? HeadRoom::Words : low ? HeadRoom::Menu : HeadRoom::Symbols);
    const bool leads = !words && low;
    if (!leads)
        m_column->insertWidget(0, m_head);
    m_tools->setLead(leads ? m_head : nullptr);
    m_sheet->setCompact(width() < t.u(besideFrom));
    m_sheet->foot().status().setVisible(leads);
}

} // namespace mb
