// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/buspage.h"

#include "model/registry.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/emptystate.h"
#include "widgets/common/filechoice.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/linkload.h"
#include "widgets/common/numberformat.h"
#include "widgets/common/pagekeys.h"
#include "widgets/common/replaybar.h"
#include "widgets/monitor/busbar.h"
#include "widgets/monitor/busside.h"
#include "widgets/monitor/bustables.h"
#include "widgets/monitor/framedetail.h"
#include "widgets/monitor/frameexport.h"
#include "widgets/monitor/framemodel.h"
#include "widgets/monitor/frametext.h"
#include "widgets/monitor/idmodel.h"
#include "widgets/monitor/recordstrip.h"
#include "widgets/monitor/sendpanel.h"

#include <QApplication>
#include <QClipboard>
#include <QStackedWidget>

#include <algorithm>

namespace mb {
namespace {

constexpr std::chrono::milliseconds refreshTime{50};
constexpr int losslessBelow = 560; ///< units
constexpr Duration idsTime = std::chrono::milliseconds(200);

QString shownName(const std::string &address)
{
    const auto parsed = LinkAddress::parse(address);
    return qt(parsed ? parsed->shortName() : address);
}

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
    buildContent();
    buildKeys();
    buildColumn();
    m_tick.setInterval(refreshTime);
    connect(&m_tick, &QTimer::timeout, this, &BusPage::tick);
    connect(&workbench, &Workbench::changed, this, &BusPage::followLinks);
    connect(&theme, &ThemeSource::changed, this, [this] {
        if (const LinkView *shown = link())
            showState(*shown); // whose words carry their colours with them
    });
}

int BusPage::heightForWidth(int width) const
{
    return layout()->minimumHeightForWidth(width);
}

void BusPage::buildColumn()
{
    const Theme &theme = m_theme.theme();
    auto *column = layoutIn<QVBoxLayout>(this, 0);
    m_send->hide();
    auto *panel = new QVBoxLayout;
    panel->setContentsMargins(theme.u(12), 0, theme.u(12), 0);
    panel->setSpacing(0);
    panel->addWidget(m_send);
    m_bar->addButton(m_record->button());
    for (QWidget *part : std::initializer_list<QWidget *>{m_bar, m_record, m_replay})
        column->addWidget(part);
    column->addLayout(panel);
    column->addWidget(separatorLine(Qt::Horizontal, this));
    column->addWidget(m_lists, 1);
}

void BusPage::buildContent()
{
    m_lists = new QStackedWidget(this);
    m_lists->addWidget(new EmptyState(m_theme, Symbol::Plug, tr("No link yet"),
        tr("Open a link, or the simulated bench from the menu; what passes on it appears here."), m_lists));
    m_outer = new QSplitter(Qt::Horizontal, m_lists);
    m_lists->addWidget(m_outer);
    m_tables = new BusTables(m_theme, *m_model, *m_ids, m_outer);
    m_side = new BusSide(m_theme, m_outer);
    m_outer->addWidget(m_side);
    m_outer->setStretchFactor(0, 1);
    m_outer->setStretchFactor(1, 0);
    const auto copy = [this] {
        if (const QString text = selectedText(); !text.isEmpty())
            QApplication::clipboard()->setText(text);
    };
    connect(m_tables, &BusTables::currentChanged, this, &BusPage::showSelected);
    connect(m_tables, &BusTables::copyRequested, this, copy);
    // Looking back must not be scrolled away: the view stops following, the log goes on.
    connect(m_tables, &BusTables::scrolled, this, &BusPage::setPaused);
    connect(m_model, &FrameModel::olderFound, this, [this] {
        if (!m_paused)
            m_tables->toEnd();
    });
    connect(&m_side->detail(), &FrameDetail::copyRequested, this, copy);
    connect(&m_side->detail(), &FrameDetail::sendRequested, this, [this](const CanFrame &frame) {
        m_bar->setSendShown(true);
        m_send->setFrame(frame);
    });
}

void BusPage::buildKeys()
{
    auto *keys = new PageKeys(*this);
    keys->add({Qt::Key_P}, tr("pauses the list, and goes on"), [this] { setPaused(!m_paused); });
    keys->add({Qt::Key_R}, tr("records, or ends the recording"), [this] { m_record->toggle(); });
    keys->add({QKeySequence::Find}, tr("goes to the filter"), [this] { m_bar->focusFilter(); });
    keys->add({Qt::Key_F3}, tr("finds the next one"), [this] { find(true); });
    keys->add({QKeySequence(QStringLiteral("Shift+F3"))}, tr("finds the one before"), [this] { find(false); });
    connect(m_bar, &BusBar::linkChosen, this, &BusPage::chooseLink);
    connect(m_bar, &BusBar::filterChanged, this, &BusPage::applyFilter);
    connect(m_bar, &BusBar::findRequested, this, &BusPage::find);
    connect(m_bar, &BusBar::pauseRequested, this, [this] { setPaused(!m_paused); });
    connect(m_bar, &BusBar::clearRequested, m_model, &FrameModel::clear);
    connect(m_model, &FrameModel::modelReset, this, [this] {
        if (m_model->kept().empty()) // cleared, or another link
            m_side->detail().clear();
    });
    connect(m_bar, &BusBar::exportRequested, this, &BusPage::askWhereTo);
    connect(m_bar, &BusBar::sendToggled, m_send, &QWidget::setVisible);
}

void BusPage::setPaused(bool paused)
{
    m_paused = paused;
    m_model->setFrozen(paused);
    m_bar->setPaused(paused);
    if (!paused)
        m_tables->toEnd();
}

void BusPage::followLinks()
{
    const Snapshot &shot = m_workbench.snapshot();
    if (m_side->loads().keep(shot) && link() && isVisible())
        m_side->showLoads(m_address);
    if (!isVisible())
        return;
    if (m_address.empty() && !shot.links.empty())
        m_address = shot.links.front().address;
    nameLinks();
    const LinkView *shown = link();
    m_lists->setCurrentIndex(!shot.links.empty() || m_model->rowCount() > 0 ? 1 : 0);
    m_bar->setSendable(shown != nullptr);
    m_send->setLink(shown ? m_address : std::string());
    m_record->setLink(m_address);
    m_replay->setLink(m_address);
    if (!shown) // what a link that is closed left stays
        return m_bar->setState(m_address.empty() ? QString() : tr("%1 is not open").arg(shownName(m_address)));
    m_source = {shown->name, shown->simulated, m_workbench.wallClock(shown->address)};
    const FrameDecoder decoder = decoderFor(families(), m_workbench.snapshot(), shown->address);
    m_model->setDecoder(decoder);
    m_ids->setDecoder(decoder);
    m_model->setSource(shown->traffic, shown->kind);
    m_tables->setIdentifiersShown(shown->kind == LinkKind::Can);
    m_ids->setSource(shown->traffic);
}

/// The one that is looked at is named last where it is not open.
void BusPage::nameLinks()
{
    QStringList names;
    m_offered.clear();
    for (const LinkView &link : m_workbench.snapshot().links) {
        names += qt(link.name);
        m_offered.push_back(link.address);
    }
    if (!m_address.empty() && !link()) {
        names += shownName(m_address);
        m_offered.push_back(m_address);
    }
    const auto current = std::ranges::find(m_offered, m_address);
    m_bar->setLinks(names, current == m_offered.end() ? -1 : static_cast<int>(current - m_offered.begin()));
}

void BusPage::chooseLink(int place)
{
    showLink(m_offered.at(static_cast<std::size_t>(place)));
}

void BusPage::showLink(const std::string &address)
{
    m_address = address;
    followLinks();
}

void BusPage::applyFilter(const FrameFilter &filter, const FrameFilter &search)
{
    m_model->setFilter(filter);
    m_model->setSearch(search);
    m_ids->setFilter(search.isEmpty() ? filter : FrameFilter::both(filter, search));
    if (!m_paused)
        m_tables->toEnd();
}

void BusPage::find(bool forward)
{
    const auto current = m_tables->current();
    const int from = current ? *current + (forward ? 1 : -1) : forward ? 0 : m_model->rowCount() - 1;
    const int found = m_model->findFrom(from, forward);
    if (found < 0)
        return;
    setPaused(true);
    m_tables->goTo(found);
}

void BusPage::tick()
{
    if (m_model->fetch() && !m_paused)
        m_tables->toEnd();
    const LinkView *shown = link();
    const Instant now = m_workbench.now();
    if (!shown || now - m_idsAt < idsTime)
        return;
    m_idsAt = now;
    m_ids->refresh(m_workbench.presentOf(shown->address));
    showState(*shown);
}

void BusPage::showState(const LinkView &link)
{
    const auto bold = [](const QString &text, const QColor &color) {
        return QStringLiteral("<b style='color:%1'>%2</b>").arg(color.name(), text);
    };
    const Theme &theme = m_theme.theme();
    const auto count = [](std::uint64_t number) { return formatCount(static_cast<qint64>(number)); };
    const QString rates
        = link.kind == LinkKind::Can ? tr("load %1 &nbsp; frames/s %2") : tr("load %1 &nbsp; bytes/s %2");
    QString state = rates.arg(bold(formatValue(loadOf(link) * 100.0, 0, QStringLiteral("%")), theme.text),
        bold(formatNumber(m_rate.of(link, m_workbench.now()), 0), theme.text));
    const bool narrow = width() < theme.u(losslessBelow); // then what is 0 is not said
    if (!narrow || link.counters.lost + link.counters.errors > 0)
        state += QStringLiteral(" &nbsp; ")
            + tr("dropped %1 &nbsp; errors %2")
                  .arg(bold(count(link.counters.lost), link.counters.lost > 0 ? theme.caution : theme.ok),
                      bold(count(link.counters.errors), link.counters.errors > 0 ? theme.danger : theme.ok));
    if (m_model->skipped() > 0)
        state += QStringLiteral(" &nbsp; ") + tr("not kept %1").arg(bold(count(m_model->skipped()), theme.caution));
    m_bar->setState(state);
    m_bar->setResult(
        tr("%1 of %2 shown")
            .arg(formatCount(m_model->rowCount()), formatCount(static_cast<qint64>(m_model->kept().size()))));
    m_side->showFacts(link, *m_ids);
}

/// What was chosen stays when its row goes.
void BusPage::showSelected()
{
    const auto current = m_tables->current();
    if (!current)
        return;
    const FrameRow &row = m_model->row(*current);
    m_side->detail().show(row, m_model->meaning(row), m_model->decoder(), m_model->origin());
}

WallClock BusPage::exportClock() const
{
    return m_source.simulated ? WallClock{-m_model->origin().time_since_epoch(), {}} : m_source.clock;
}

QString BusPage::selectedText() const
{
    std::string text;
    const WallClock clock = exportClock();
    const auto add = [&](const TrafficRecord &record) { text += trafficLine(record, m_source.name, clock) + '\n'; };
    for (const int row : m_tables->selected())
        add(m_model->row(row).record);
    if (const auto &shown = m_side->detail().record(); text.empty() && shown)
        add(*shown);
    return QString::fromStdString(text);
}

void BusPage::askWhereTo(bool all)
{
    askWhereToSave(*this, all ? tr("Export all frames") : tr("Export the frames that are shown"),
        tr("candump log (*.log)"), {}, [this, all](const QString &path) { exportTo(path, all); });
}

void BusPage::exportTo(const QString &path, bool all)
{
    const auto &kept = m_model->kept();
    const int count = all ? static_cast<int>(kept.size()) : m_model->rowCount();
    const auto at = [&](int i) -> const TrafficRecord & {
        return all ? kept[static_cast<std::size_t>(i)].record : m_model->row(i).record;
    };
    const QString name = qt(m_source.name);
    const auto written = exportTraffic(path, count, at, m_source.name, exportClock());
    if (!written)
        m_workbench.report(Severity::Danger, name, errorText(written.error()));
    else
        m_workbench.report(Severity::Info, name, tr("%1 frames written to %2").arg(formatCount(count), path));
}

void BusPage::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    followLinks();
    m_model->rejoin();
    tick();
    m_tick.start();
}

void BusPage::arrange()
{
    // Where there is room the detail stands right, full height; otherwise beside the identifiers.
    const Theme &theme = m_theme.theme();
    QSplitter *home = width() >= theme.u(1150) ? m_outer : &m_tables->lower();
    if (m_side->parentWidget() == home)
        return;
    home->addWidget(m_side);
    home->setStretchFactor(0, 1);
    home->setStretchFactor(1, 0);
    const int side = theme.u(width() >= theme.u(1500) ? 360 : 300);
    home->setSizes({width() - side, side});
}

} // namespace mb
