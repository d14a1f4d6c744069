// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/buspage.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/numberformat.h"
#include "widgets/common/searchfield.h"
#include "widgets/common/segmented.h"
#include "widgets/monitor/framedetail.h"
#include "widgets/monitor/framemodel.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QScrollBar>
#include <QShortcut>
#include <QSplitter>
#include <QTableView>
#include <QVBoxLayout>

namespace mb {
namespace {

constexpr std::chrono::milliseconds tickTime{50};

} // namespace

BusPage::BusPage(Workbench &workbench, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_workbench(workbench)
    , m_theme(theme)
    , m_model(new FrameModel(theme, this))
{
    setObjectName(QStringLiteral("busPage"));
    setAccessibleName(tr("Bus"));
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    buildBar(*column);
    buildTable(*column);
    m_tick.setInterval(tickTime);
    connect(&m_tick, &QTimer::timeout, this, &BusPage::tick);
    connect(&workbench, &Workbench::changed, this, &BusPage::followLinks);
}

void BusPage::buildBar(QVBoxLayout &column)
{
    const Theme &theme = m_theme.theme();
    auto *row = new QHBoxLayout;
    row->setContentsMargins(theme.u(12), theme.u(10), theme.u(12), theme.u(10));
    row->setSpacing(theme.u(8));
    m_filter = new SearchField(m_theme, tr("msg:STS* dev:5 -id:0206"), this);
    m_filter->setSymbol(Symbol::Filter);
    m_filter->setAccessibleName(tr("Filter frames"));
    m_filter->setToolTip(tr("All words must hold: msg:STS* dev:5 id:0206 fam:dmc60c dir:tx, a minus turns one round"));
    m_filter->setMinimumWidth(theme.u(260));
    m_direction = new Segmented(tr("Direction"), {tr("All"), tr("rx"), tr("tx")}, this);
    m_links = new Segmented(tr("Link"), this);
    m_state = textLabel({}, TextRole::Body, Tone::Dim, this);
    m_pause = new CommandButton(m_theme, Symbol::Pause, tr("Pause view"), this);
    m_pause->setTextVariants({tr("Pause view"), tr("Go on")});
    m_pause->setKeyHint(QStringLiteral("P"));
    auto *clear = new CommandButton(m_theme, Symbol::Delete, tr("Clear"), this);
    row->addWidget(m_filter);
    row->addWidget(m_direction);
    row->addWidget(m_links);
    row->addStretch();
    row->addWidget(m_state);
    row->addWidget(m_pause);
    row->addWidget(clear);
    column.addLayout(row);
    m_problem = textLabel({}, TextRole::Body, Tone::Danger, this);
    m_problem->setContentsMargins(theme.u(12), 0, theme.u(12), theme.u(6));
    m_problem->hide();
    column.addWidget(m_problem);
    connect(m_filter, &QLineEdit::textChanged, this, &BusPage::applyFilter);
    connect(m_direction, &Segmented::currentChanged, this, &BusPage::applyFilter);
    connect(m_links, &Segmented::currentChanged, this, &BusPage::followLinks);
    connect(m_pause, &QPushButton::clicked, this, [this] { setPaused(!m_paused); });
    connect(clear, &QPushButton::clicked, m_model, &FrameModel::clear);
    auto *pauseKey = new QShortcut(QKeySequence(Qt::Key_P), this);
    pauseKey->setContext(Qt::WidgetWithChildrenShortcut);
    connect(pauseKey, &QShortcut::activated, this, [this] { setPaused(!m_paused); });
}

void BusPage::buildTable(QVBoxLayout &column)
{
    const Theme &theme = m_theme.theme();
    auto *split = new QSplitter(Qt::Horizontal, this);
    m_table = new QTableView(split);
    m_table->setAccessibleName(tr("Frames"));
    m_table->setModel(m_model);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(theme.u(25));
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setShowGrid(false);
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->setWordWrap(false);
    m_table->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    const std::array<int, FrameModel::ColumnCount> widths{86, 68, 40, 96, 140, 44, 440, 190};
    for (int i = 0; i < FrameModel::ColumnCount; ++i)
        m_table->setColumnWidth(i, theme.u(widths[static_cast<std::size_t>(i)]));
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_detail = new FrameDetail(m_theme, split);
    split->addWidget(m_table);
    split->addWidget(m_detail);
    split->setStretchFactor(0, 1);
    split->setSizes({theme.u(900), theme.u(300)});
    column.addWidget(split, 1);
    connect(
        m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this](const QModelIndex &current) {
            if (current.isValid())
                m_detail->show(m_model->row(current.row()));
        });
    // Looking back must not be scrolled away: the view stops following, the log goes on.
    connect(m_table->verticalScrollBar(), &QScrollBar::actionTriggered, this, [this] {
        const QScrollBar *bar = m_table->verticalScrollBar();
        setPaused(bar->sliderPosition() < bar->maximum());
    });
}

void BusPage::setPaused(bool paused)
{
    m_paused = paused;
    m_pause->setText(paused ? tr("Go on") : tr("Pause view"));
    m_pause->setSymbol(paused ? Symbol::Play : Symbol::Pause);
    if (!paused)
        m_table->scrollToBottom();
}

void BusPage::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    followLinks();
    m_tick.start();
}

void BusPage::hideEvent(QHideEvent *event)
{
    QWidget::hideEvent(event);
    m_tick.stop();
}

void BusPage::followLinks()
{
    if (!isVisible())
        return;
    const Snapshot &shot = m_workbench.snapshot();
    std::vector<std::string> names;
    for (const LinkView &link : shot.links)
        names.push_back(link.name);
    for (std::size_t i = m_shownLinks.size(); i < names.size(); ++i)
        m_links->addSegment(QString::fromStdString(names[i]));
    for (std::size_t i = 0; i < names.size(); ++i)
        m_links->setText(static_cast<int>(i), QString::fromStdString(names[i]));
    if (names.size() >= m_shownLinks.size())
        m_shownLinks = names;
    m_links->setVisible(names.size() > 1);
    const auto current = static_cast<std::size_t>(std::max(m_links->current(), 0));
    if (current >= shot.links.size())
        return;
    std::vector<const Family *> families;
    for (const DeviceView &device : shot.devices) {
        if (std::find(families.begin(), families.end(), device.family) == families.end())
            families.push_back(device.family);
    }
    m_model->setSource(shot.links[current].traffic, std::move(families), shot.time);
}

void BusPage::applyFilter()
{
    static const std::array directions{QString(), QStringLiteral(" dir:rx"), QStringLiteral(" dir:tx")};
    const FrameFilter filter(
        m_filter->text() + directions[static_cast<std::size_t>(std::max(m_direction->current(), 0))]);
    m_problem->setText(filter.problem());
    m_problem->setVisible(!filter.problem().isEmpty());
    m_model->setFilter(filter);
    if (!m_paused)
        m_table->scrollToBottom();
}

void BusPage::tick()
{
    if (!m_paused && m_model->fetch())
        m_table->scrollToBottom();
    const Instant now = m_workbench.now();
    const Snapshot &shot = m_workbench.snapshot();
    const auto current = static_cast<std::size_t>(std::max(m_links->current(), 0));
    if (current >= shot.links.size() || now - m_rateAt < std::chrono::milliseconds(500))
        return;
    const LinkCounters &counters = shot.links[current].counters;
    const std::uint64_t frames = counters.rx + counters.tx;
    if (m_rateAt != Instant{})
        m_rate = static_cast<double>(frames - std::min(frames, m_rateFrames))
            / std::chrono::duration<double>(now - m_rateAt).count();
    m_rateAt = now;
    m_rateFrames = frames;
    m_state->setText(tr("load %1 %   %2 frames/s   lost %3")
                         .arg(formatNumber(shot.links[current].load * 100, 0), formatNumber(m_rate, 0),
                             formatCount(static_cast<qint64>(counters.lost))));
    const auto shown = m_model->rowCount();
    m_filter->setResult(m_filter->text().isEmpty() ? QString() : tr("%1 shown").arg(formatCount(shown)));
}

} // namespace mb
