// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/parameterspage.h"

#include "widgets/common/banner.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/emptystate.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/pagekeys.h"
#include "widgets/common/searchfield.h"
#include "widgets/common/segmented.h"
#include "widgets/common/wraplayout.h"
#include "widgets/parameters/changespanel.h"
#include "widgets/parameters/parameterfiles.h"
#include "widgets/parameters/parameterfoot.h"
#include "widgets/parameters/readstatus.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSplitter>
#include <QStackedWidget>
#include <QVBoxLayout>

namespace mb {
namespace {

constexpr int panelWidth = 288;
constexpr int besideFrom = 900; ///< narrower than this the panel goes below the table

} // namespace

ParametersPage::ParametersPage(
    Workbench &workbench, Selection &selection, const ThemeSource &theme, BannerStack &banners, QWidget *parent)
    : QWidget(parent)
    , m_workbench(workbench)
    , m_desk(EditDesk::of(workbench))
    , m_selection(selection)
    , m_theme(theme)
    , m_banners(banners)
    , m_model(new ParameterModel(this))
{
    setObjectName(QStringLiteral("parametersPage"));
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    m_stack = new QStackedWidget(this);
    column->addWidget(m_stack, 1);
    buildEmpty();
    m_stack->addWidget(buildTable());
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

void ParametersPage::buildEmpty()
{
    m_empty = new EmptyState(m_theme, Symbol::Chip, {}, {}, m_stack);
    m_openFile = m_empty->addAction(Symbol::Document, tr("Open a parameter file…"));
    m_stack->addWidget(m_empty);
    connect(m_openFile, &QPushButton::clicked, this,
        [this] { askForFile(*this, tr("Open a parameter file"), [this](const QString &path) { openFile(path); }); });
    connect(&m_banners, &BannerStack::actionTriggered, this, &ParametersPage::act);
}

QWidget *ParametersPage::buildHead()
{
    const Theme &t = m_theme.theme();
    auto *head = new QWidget(this);
    auto *row = new WrapLayout(head);
    row->setContentsMargins(t.u(12), t.u(8), t.u(12), t.u(4));
    m_status = new ReadStatus(m_theme, head);
    m_undo = new IconButton(m_theme, Symbol::Undo, tr("Undo the last edit or write"), head);
    m_undo->setKeyHint(tr("Ctrl+Z"));
    m_redo = new IconButton(m_theme, Symbol::Redo, tr("Redo the edit or write"), head);
    m_redo->setKeyHint(tr("Ctrl+Y"));
    m_read = new CommandButton(m_theme, Symbol::Refresh, tr("Read all"), head);
    m_read->setKeyHint(QStringLiteral("F5"));
    m_import = new CommandButton(m_theme, Symbol::Import, tr("Import…"), head);
    m_export = new CommandButton(m_theme, Symbol::Export, tr("Export…"), head);
    m_snapshot = new CommandButton(m_theme, Symbol::Camera, tr("Snapshot"), head);
    m_snapshot->setKeyHint(tr("Ctrl+Shift+S"));
    m_showHistory = new CommandButton(m_theme, Symbol::Clock, tr("History"), head);
    m_showHistory->setKeyHint(tr("Ctrl+H"));
    m_showHistory->setCheckable(true);
    row->addWidget(m_status);
    row->addSpring();
    for (QWidget *widget :
        std::initializer_list<QWidget *>{m_undo, m_redo, m_read, m_import, m_export, m_snapshot, m_showHistory})
        row->addWidget(widget);
    connect(m_undo, &QToolButton::clicked, this, [this] { undo(false); });
    connect(m_redo, &QToolButton::clicked, this, [this] { undo(true); });
    connect(m_read, &QPushButton::clicked, this, &ParametersPage::readAll);
    connect(m_import, &QPushButton::clicked, this,
        [this] { askForFile(*this, tr("Import parameters"), [this](const QString &path) { importFrom(path); }); });
    connect(m_export, &QPushButton::clicked, this, [this] {
        if (const DeviceView *shown = device())
            askWhereToSave(*this, tr("Export parameters"),
                QStringLiteral("%1-%2.json").arg(qt(shown->family->key)).arg(shown->identity.address),
                [this](const QString &path) { exportTo(path); });
    });
    return head;
}

QWidget *ParametersPage::buildTools()
{
    const Theme &t = m_theme.theme();
    auto *tools = new QWidget(this);
    auto *row = new WrapLayout(tools);
    row->setContentsMargins(t.u(12), t.u(4), t.u(12), t.u(8));
    m_search = new SearchField(m_theme, tr("Search parameters"), tools);
    m_search->setKeyHint(tr("Ctrl+F"));
    m_search->setFixedWidth(t.u(232));
    m_segments = new Segmented(tr("Which parameters"), {tr("All"), tr("Changed"), tr("Edited"), tr("Errors")}, tools);
    auto *comparison = new QWidget(tools);
    auto *pair = new QHBoxLayout(comparison);
    pair->setContentsMargins(0, 0, 0, 0);
    auto *with = new QLabel(tr("Compare with"), comparison);
    setTextRole(*with, TextRole::Caption);
    setTone(*with, Tone::Dim);
    m_compare = new QComboBox(comparison);
    m_compare->setAccessibleName(tr("Compare with"));
    m_compare->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    with->setBuddy(m_compare);
    row->addWidget(m_search);
    row->addWidget(m_segments);
    buildAxes(*tools);
    row->addWidget(m_axes);
    row->addWidget(m_copy);
    row->addSpring();
    pair->addWidget(with);
    pair->addWidget(m_compare);
    row->addWidget(comparison);
    connect(m_search, &QLineEdit::textChanged, this, &ParametersPage::setFilter);
    connect(m_search, &QLineEdit::returnPressed, this, [this] { m_view->setFocus(); });
    connect(m_segments, &Segmented::currentChanged, this, &ParametersPage::setFilter);
    connect(m_compare, qOverload<int>(&QComboBox::activated), this, &ParametersPage::comparisonChosen);
    return tools;
}

QWidget *ParametersPage::buildTable()
{
    auto *content = new QWidget(this);
    auto *column = new QVBoxLayout(content);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(buildHead());
    m_tools = buildTools();
    column->addWidget(m_tools);
    column->addWidget(separatorLine(Qt::Horizontal, content));
    m_splitter = new QSplitter(Qt::Horizontal, content);
    m_splitter->setChildrenCollapsible(false);
    m_splitter->setHandleWidth(1);
    auto *left = new QWidget(m_splitter);
    auto *rows = new QVBoxLayout(left);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(0);
    m_view = new ParameterView(m_theme, *m_model, left);
    m_foot = new ParameterFoot(m_theme, left);
    rows->addWidget(m_view, 1);
    rows->addWidget(m_foot);
    m_panel = new ChangesPanel(m_theme, m_workbench, *m_model, m_ledger, m_splitter);
    m_splitter->setStretchFactor(0, 1);
    m_splitter->setStretchFactor(1, 0);
    m_panel->setMinimumWidth(m_theme.theme().u(panelWidth));
    column->addWidget(m_splitter, 1);
    buildHistory(*content, *column);
    connect(m_view, &ParameterView::retryRequested, this, &ParametersPage::readAll);
    connect(m_view, &ParameterView::currentParameterChanged, this, &ParametersPage::refreshTexts);
    connect(m_panel, &ChangesPanel::writeRequested, this, &ParametersPage::write);
    connect(m_panel, &ChangesPanel::storeRequested, this, &ParametersPage::store);
    connect(m_panel, &ChangesPanel::discardRequested, this, [this] { m_model->edits()->discard(); });
    connect(m_panel, &ChangesPanel::parameterActivated, this, [this](ParameterIndex index) {
        m_view->goTo(index);
        m_view->setFocus();
    });
    return content;
}

void ParametersPage::buildKeys()
{
    auto *keys = new PageKeys(*this);
    keys->add({Qt::Key_F5}, tr("reads all parameters"), [this] { readAll(); });
    keys->add({QKeySequence(QStringLiteral("Ctrl+F"))}, tr("searches"), [this] {
        m_search->setFocus(Qt::ShortcutFocusReason);
        m_search->selectAll();
    });
    keys->add({QKeySequence(QStringLiteral("Ctrl+S"))}, tr("writes what is staged"), [this] { write(); });
    keys->add({QKeySequence(QStringLiteral("Ctrl+Z"))}, tr("undoes the last edit, or else the last write to the unit"),
        [this] { undo(false); });
    keys->add({QKeySequence(QStringLiteral("Ctrl+Y")), QKeySequence(QStringLiteral("Ctrl+Shift+Z"))},
        tr("makes it again"), [this] { undo(true); });
    keys->add({QKeySequence(QStringLiteral("Ctrl+Shift+S"))}, tr("takes a snapshot"), [this] { takeSnapshot(); });
    keys->add({QKeySequence(QStringLiteral("Ctrl+H"))}, tr("shows the history of the unit, or its values"),
        [this] { showHistory(!m_showHistory->isChecked()); });
}

void ParametersPage::setFilter()
{
    ParameterFilter filter;
    filter.segment = static_cast<ParameterFilter::Segment>(m_segments->current());
    filter.words = m_search->text();
    filter.axis = filterAxis();
    m_view->setFilter(filter);
    refreshTexts();
}

void ParametersPage::undo(bool redo)
{
    if (!m_model->edits())
        return;
    m_view->commitField();
    QUndoStack &stack = m_model->edits()->undoStack();
    if (redo ? stack.canRedo() : stack.canUndo() && !stack.isClean())
        redo ? stack.redo() : stack.undo();
    else
        undoWrite(redo);
}

void ParametersPage::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    m_shown = {};
    follow();
}

void ParametersPage::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    const bool beside = width() >= m_theme.theme().u(besideFrom);
    m_splitter->setOrientation(beside ? Qt::Horizontal : Qt::Vertical);
    m_splitter->setStretchFactor(0, beside ? 1 : 3);
    m_splitter->setStretchFactor(1, beside ? 0 : 1);
    m_panel->setCompact(!beside);
    m_foot->setCompact(!beside);
    m_search->setFixedWidth(m_theme.theme().u(beside ? 232 : 170));
}

} // namespace mb
