// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/buspage.h"

#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/pagekeys.h"
#include "widgets/common/replaybar.h"
#include "widgets/monitor/busbar.h"
#include "widgets/monitor/busloadview.h"
#include "widgets/monitor/framedetail.h"
#include "widgets/monitor/framemodel.h"
#include "widgets/monitor/idmodel.h"
#include "widgets/monitor/recordstrip.h"
#include "widgets/monitor/sendpanel.h"
#include "widgets/monitor/trafficview.h"

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QScrollArea>
#include <QScrollBar>
#include <QShortcut>
#include <QSplitter>
#include <QVBoxLayout>

namespace mb {
namespace {

constexpr std::chrono::milliseconds refreshTime{50};

} // namespace

BusPage::BusPage(Workbench &workbench, Arming &arming, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_workbench(workbench)
    , m_theme(theme)
    , m_model(new FrameModel(theme, this))
    , m_ids(new IdModel(theme, this))
    , m_bar(new BusBar(theme, this))
    , m_send(new SendPanel(workbench, arming, theme, this))
    , m_record(new RecordStrip(workbench, theme, this))
    , m_replay(new ReplayBar(workbench, theme, this))
{
    setObjectName(QStringLiteral("busPage"));
    setAccessibleName(tr("Bus"));
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    buildTables();
    buildSide();
    buildKeys();
    m_send->hide();
    auto *panel = new QVBoxLayout;
    panel->setContentsMargins(theme.theme().u(12), 0, theme.theme().u(12), 0);
    panel->setSpacing(0);
    panel->addWidget(m_send);
    m_bar->addButton(m_record->button());
    for (QWidget *part : std::initializer_list<QWidget *>{m_bar, m_record, m_replay})
        column->addWidget(part);
    column->addLayout(panel);
    column->addWidget(separatorLine(Qt::Horizontal, this));
    column->addWidget(m_outer, 1);
    m_tick.setInterval(refreshTime);
    connect(&m_tick, &QTimer::timeout, this, &BusPage::tick);
    connect(&workbench, &Workbench::changed, this, &BusPage::followLinks);
    connect(&theme, &ThemeSource::changed, this, [this] {
        if (const LinkView *shown = link())
            showState(*shown); // whose words carry their colours with them
    });
}

void BusPage::buildTables()
{
    m_outer = new QSplitter(Qt::Horizontal, this);
    auto *stack = new QSplitter(Qt::Vertical, m_outer);
    m_lower = new QSplitter(Qt::Horizontal, stack);
    m_table = new TrafficView(m_theme, tr("Frames"), {88, 66, 54, 88, 132, 42, 240, 208}, FrameModel::Decoded, stack);
    m_table->setSpare(FrameModel::Data);
    m_table->setModel(m_model);
    m_table->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_idTable = new TrafficView(
        m_theme, tr("Identifiers"), {88, 50, 122, 42, 64, 72, 84, 208, 118, 100}, IdModel::Value, m_lower);
    m_idTable->setSpare(IdModel::Data);
    m_idTable->setSharing(IdModel::Spark);
    m_idTable->setModel(m_ids);
    m_idTable->setSelectionMode(QAbstractItemView::SingleSelection);
    m_idTable->setContextMenuPolicy(Qt::CustomContextMenu);
    m_idTable->horizontalHeader()->setSortIndicator(IdModel::Id, Qt::AscendingOrder);
    m_idTable->setSortingEnabled(true);
    stack->addWidget(m_table);
    stack->addWidget(m_lower);
    stack->setStretchFactor(0, 3);
    stack->setStretchFactor(1, 2);
    stack->setChildrenCollapsible(true);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this, &BusPage::showSelected);
    connect(m_idTable, &QWidget::customContextMenuRequested, this, &BusPage::chooseField);
    connect(m_model, &FrameModel::olderFound, this, [this] {
        if (!m_paused)
            toEnd();
    });
    // Looking back must not be scrolled away: the view stops following, the log goes on.
    connect(m_table->verticalScrollBar(), &QScrollBar::actionTriggered, this, [this] {
        const QScrollBar *bar = m_table->verticalScrollBar();
        setPaused(bar->sliderPosition() < bar->maximum());
    });
}

void BusPage::buildSide()
{
    // At large fonts it is higher than the room that is left.
    auto *scroll = new QScrollArea(m_outer);
    m_side = scroll;
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto *content = new QWidget(scroll);
    setStyleProperty(*content, "surface", QStringLiteral("window"));
    content->setAttribute(Qt::WA_StyledBackground);
    scroll->setWidget(content);
    buildSideContent(*content);
    scroll->setMinimumWidth(content->minimumSizeHint().width() + scroll->verticalScrollBar()->sizeHint().width());
    m_outer->addWidget(m_side);
    m_outer->setStretchFactor(0, 1);
    m_outer->setStretchFactor(1, 0);
}

void BusPage::buildSideContent(QWidget &content)
{
    const Theme &theme = m_theme.theme();
    auto *column = new QVBoxLayout(&content);
    column->setContentsMargins(0, 0, 0, theme.u(8));
    column->setSpacing(theme.u(4));
    m_detail = new FrameDetail(m_theme, &content);
    m_load = new BusLoadView(m_theme, &content);
    m_loadCaption = textLabel({}, TextRole::Caption, Tone::Dim, &content);
    m_facts = textLabel({}, TextRole::Caption, Tone::Dim, &content);
    m_facts->setWordWrap(true);
    auto *head = new QHBoxLayout;
    head->setContentsMargins(theme.u(12), 0, theme.u(12), 0);
    head->addWidget(new SectionLabel(tr("Bus load, %"), &content));
    head->addStretch();
    head->addWidget(m_loadCaption);
    auto *foot = new QVBoxLayout;
    foot->setContentsMargins(theme.u(12), 0, theme.u(12), 0);
    foot->addWidget(m_load);
    foot->addWidget(m_facts);
    column->addWidget(m_detail, 1);
    column->addWidget(separatorLine(Qt::Horizontal, &content));
    column->addLayout(head);
    column->addLayout(foot);
    connect(
        m_detail, &FrameDetail::copyRequested, this, [this] { QApplication::clipboard()->setText(selectedText()); });
    connect(m_detail, &FrameDetail::sendRequested, this, [this](const CanFrame &frame) {
        m_bar->setSendShown(true);
        m_send->setFrame(frame);
    });
}

void BusPage::buildKeys()
{
    auto *keys = new PageKeys(*this);
    keys->add({Qt::Key_P}, tr("pauses the list, and goes on"), [this] { setPaused(!m_paused); });
    keys->add({QKeySequence::Find}, tr("goes to the filter"), [this] { m_bar->focusFilter(); });
    keys->add({Qt::Key_F3}, tr("finds the next one"), [this] { find(true); });
    keys->add({QKeySequence(QStringLiteral("Shift+F3"))}, tr("finds the one before"), [this] { find(false); });
    auto *copy = new QShortcut(QKeySequence::Copy, m_table);
    copy->setContext(Qt::WidgetShortcut);
    connect(copy, &QShortcut::activated, this, [this] { QApplication::clipboard()->setText(selectedText()); });
    connect(m_bar, &BusBar::linkChanged, this, &BusPage::followLinks);
    connect(m_bar, &BusBar::filterChanged, this, &BusPage::applyFilter);
    connect(m_bar, &BusBar::findRequested, this, &BusPage::find);
    connect(m_bar, &BusBar::pauseRequested, this, [this] { setPaused(!m_paused); });
    connect(m_bar, &BusBar::clearRequested, m_model, &FrameModel::clear);
    connect(m_bar, &BusBar::clearRequested, m_detail, &FrameDetail::clear);
    connect(m_bar, &BusBar::exportRequested, this, &BusPage::askWhereTo);
    connect(m_bar, &BusBar::sendToggled, m_send, &QWidget::setVisible);
}

void BusPage::setPaused(bool paused)
{
    m_paused = paused;
    m_model->setFrozen(paused);
    m_bar->setPaused(paused);
    if (!paused)
        toEnd();
}

void BusPage::toEnd()
{
    m_table->scrollToBottom();
}

void BusPage::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    followLinks();
    m_model->rejoin();
    tick();
    m_tick.start();
}

void BusPage::hideEvent(QHideEvent *event)
{
    QWidget::hideEvent(event);
    m_tick.stop();
}

void BusPage::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    arrange();
}

void BusPage::arrange()
{
    // Where there is room the detail stands right, full height; otherwise beside the identifiers.
    const Theme &theme = m_theme.theme();
    QSplitter *home = width() >= theme.u(1150) ? m_outer : m_lower;
    if (m_side->parentWidget() == home)
        return;
    home->addWidget(m_side);
    home->setStretchFactor(0, 1);
    home->setStretchFactor(1, 0);
    const int side = theme.u(width() >= theme.u(1500) ? 360 : 300);
    home->setSizes({width() - side, side});
}

} // namespace mb
