// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/connection/overviewpage.h"

#include "widgets/common/card.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/linkload.h"
#include "widgets/common/losses.h"
#include "widgets/common/numberformat.h"
#include "widgets/common/sparkline.h"
#include "widgets/common/valuelabel.h"
#include "widgets/connection/devicecard.h"
#include "widgets/connection/doctorcard.h"
#include "widgets/connection/startpage.h"

#include <QCoreApplication>
#include <QScrollArea>
#include <QScrollBar>
#include <QStackedWidget>

#include <algorithm>
#include <utility>

#include <cmath>

namespace mb {
namespace {

constexpr int mostColumns = 6;
constexpr int leastLinkCard = 220; ///< units
constexpr int leastDeviceCard = 280;

} // namespace

OverviewPage::OverviewPage(Workbench &workbench, Selection &selection, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_workbench(workbench)
    , m_selection(selection)
    , m_theme(theme)
{
    setObjectName(QStringLiteral("overviewPage"));
    setAccessibleName(tr("Overview"));
    auto *column = layoutIn<QVBoxLayout>(this);
    m_states = new QStackedWidget(this);
    column->addWidget(m_states);
    buildCards();
    buildEmpty();
    connect(&workbench, &Workbench::changed, this, &OverviewPage::follow);
    connect(&selection, &Selection::changed, this, &OverviewPage::follow);
    connect(&selection, &Selection::kept, this, &OverviewPage::goToChosen); // not what the program chose
}

void OverviewPage::buildCards()
{
    const Theme &theme = m_theme.theme();
    auto *scroll = new QScrollArea(m_states);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_canvas = new QWidget(scroll);
    auto *column = layoutIn<QVBoxLayout>(m_canvas, theme.u(8), {theme.u(12), theme.u(12), theme.u(12), theme.u(12)});
    m_linkGrid = new QGridLayout;
    m_linkGrid->setSpacing(theme.u(8));
    m_deviceGrid = new QGridLayout;
    m_deviceGrid->setSpacing(theme.u(8));
    m_ailing = new DoctorCard(m_workbench, m_theme, false, m_canvas);
    column->addLayout(m_linkGrid);
    column->addLayout(m_deviceGrid);
    column->addWidget(m_ailing); // comes and goes below what may be under the mouse; the notice says it first
    column->addStretch(1);       // cards are as low as they can be: more of them are in sight
    scroll->setWidget(m_canvas);
    m_states->addWidget(scroll);
}

void OverviewPage::addOffer(QWidget *offer)
{
    static_cast<QVBoxLayout *>(m_canvas->layout())->insertWidget(0, offer);
}

void OverviewPage::buildEmpty()
{
    auto *scroll = new QScrollArea(m_states);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_start = new StartPage(m_workbench, m_theme, scroll);
    scroll->setWidget(m_start);
    m_states->addWidget(scroll);
    connect(m_start, &StartPage::benchWanted, this, &OverviewPage::simulateRequested);
    connect(m_start, &StartPage::addLinkRequested, this, &OverviewPage::addLinkRequested);
    connect(m_start, &StartPage::openRecordingRequested, this, &OverviewPage::openRecordingRequested);
}

void OverviewPage::follow()
{
    const Snapshot &shot = m_workbench.snapshot();
    m_loads.keep(shot);
    if (!isVisible())
        return;
    m_states->setCurrentIndex(shot.links.empty() ? 1 : 0);
    if (shot.links.empty()) {
        m_start->follow();
        return;
    }
    m_ailing->follow();
    followLinks(shot);
    followDevices(shot);
}

OverviewPage::LinkCard OverviewPage::makeLinkCard(const LinkView &link)
{
    LinkCard made;
    made.card = new Card(m_theme, QString::fromStdString(link.name), m_canvas);
    made.card->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
    made.line = new Sparkline(m_theme, TraceRole::Neutral, made.card);
    made.line->setCapacity(static_cast<int>(LinkLoads::points));
    made.line->setFixedSize(m_theme.theme().u(44), m_theme.theme().u(20));
    made.line->setToolTip(tr("Load of the last minute"));
    made.card->addHeadWidget(made.line);
    auto *row = new QHBoxLayout;
    row->setSpacing(m_theme.theme().u(12));
    const auto add = [&](const QString &caption, const QString &unit) {
        auto *label = new ValueLabel(m_theme, ValueLabel::Look::Card, caption, unit, made.card);
        label->setWidest(QStringLiteral("88"));
        row->addWidget(label);
        return label;
    };
    made.load = add(tr("load"), QStringLiteral("%"));
    made.errors = add(tr("errors"), {});
    made.lost = add(tr("lost"), {});
    made.unknown = add(tr("unknown"), {});
    made.unknown->setToolTip(tr("Frames received that no controller family knows: somebody else's traffic"));
    made.roundTrip = add(tr("round trip"), QStringLiteral("ms"));
    row->addStretch();
    made.card->body().addLayout(row);
    return made;
}

void OverviewPage::followLinks(const Snapshot &shot)
{
    for (auto entry = m_links.begin(); entry != m_links.end();) {
        if (shot.link(entry->first)) {
            ++entry;
            continue;
        }
        delete entry->second.card;
        entry = m_links.erase(entry);
        m_columns = 0;
    }
    for (const LinkView &link : shot.links) {
        auto entry = m_links.find(link.address);
        if (entry == m_links.end()) {
            entry = m_links.emplace(link.address, makeLinkCard(link)).first;
            m_columns = 0;
        }
        LinkCard &card = entry->second;
        card.line->setValues(m_loads.of(link.address));
        card.card->setTitle(QString::fromStdString(link.name),
            link.state == LinkState::Open ? bitrateText(link) : messageText(link.reason));
        const std::optional<Tone> ailing
            = link.diagnosis.isHealthy() ? std::nullopt : std::optional<Tone>(Tone::Caution);
        card.card->setEdge(link.state == LinkState::Open ? ailing : std::optional<Tone>(Tone::Danger));
        card.unknown->setValue(formatCount(static_cast<qint64>(link.unknown)));
        card.unknown->setVisible(link.kind == LinkKind::Can);
        if (const double load = loadOf(link); std::isnan(load))
            card.load->clear();
        else
            card.load->setValue(formatNumber(load * 100, 0));
        card.roundTrip->setVisible(link.kind == LinkKind::Serial);
        if (link.roundTrip)
            card.roundTrip->setValue(
                formatNumber(std::chrono::duration<double, std::milli>(*link.roundTrip).count(), 1));
        else
            card.roundTrip->clear();
        card.errors->setValue(formatCount(static_cast<qint64>(link.counters.errors)));
        card.errors->setTone(link.counters.errors > 0 ? Tone::Caution : Tone::Text);
        const auto lost = static_cast<qint64>(samplesOn(shot, link.address).lost);
        card.lost->setValue(formatCount(lost));
        card.lost->setTone(lost > 0 ? Tone::Caution : Tone::Text);
    }
}

void OverviewPage::followDevices(const Snapshot &shot)
{
    for (auto entry = m_cards.begin(); entry != m_cards.end();) {
        if (shot.device(entry->first)) {
            ++entry;
            continue;
        }
        delete entry->second;
        entry = m_cards.erase(entry);
        m_columns = 0;
    }
    for (const DeviceView &device : shot.devices) {
        auto entry = m_cards.find(device.id);
        if (entry == m_cards.end()) {
            auto *card = new DeviceCard(m_theme, m_canvas);
            const DeviceId id = device.id;
            connect(card, &Card::activated, this, [this, id] { m_selection.select(id); });
            connect(card, &DeviceCard::axisActivated, this, [this, id](int axis) { m_selection.select(id, axis); });
            connect(card, &DeviceCard::updateRequested, this, [this, id] {
                m_selection.select(id);
                Q_EMIT updateRequested();
            });
            entry = m_cards.emplace(id, card).first;
            m_columns = 0;
        }
        entry->second->show(device, m_workbench.presentOf(device.link), device.id == m_selection.device());
    }
    followOrder(shot);
    arrange();
}

void OverviewPage::goToChosen()
{
    const auto chosen = m_cards.find(m_selection.device());
    if (chosen != m_cards.end())
        static_cast<QScrollArea *>(m_states->widget(0))->ensureWidgetVisible(chosen->second, 0, m_theme.theme().u(12));
}

/// That of the tree; as long as the mouse is over them a new one comes last and moves none.
void OverviewPage::followOrder(const Snapshot &shot)
{
    std::vector<DeviceId> order;
    if (m_canvas->underMouse()) {
        order = m_order;
        std::erase_if(order, [this](DeviceId id) { return m_cards.count(id) == 0; });
    }
    for (const LinkView &link : shot.links) {
        for (const DeviceView &device : shot.devices) {
            if (device.link == link.address && std::ranges::find(order, device.id) == order.end())
                order.push_back(device.id);
        }
    }
    if (std::exchange(m_order, order) != order)
        m_columns = 0;
}

/// As many cards of this width, or wider, as stand beside each other.
int OverviewPage::fittingColumns(int widest) const
{
    const Theme &theme = m_theme.theme();
    const auto *scroll = static_cast<QScrollArea *>(m_states->widget(0));
    const int room = width() - 2 * theme.u(12) - scroll->verticalScrollBar()->sizeHint().width();
    return std::clamp((room + theme.u(8)) / (widest + theme.u(8)), 1, mostColumns);
}

/// None of them is cut.
void OverviewPage::arrange()
{
    const Theme &theme = m_theme.theme();
    int widestLink = theme.u(leastLinkCard);
    int widest = theme.u(leastDeviceCard);
    for (const auto &[address, card] : m_links)
        widestLink = std::max(widestLink, card.card->minimumSizeHint().width());
    for (const auto &[id, card] : m_cards)
        widest = std::max(widest, card->minimumSizeHint().width() / card->columns());
    const int columns = fittingColumns(widest);
    const int links = std::max(columns, std::min(fittingColumns(widestLink), static_cast<int>(m_links.size())));
    if (columns == m_columns && links == m_linkColumns)
        return;
    m_columns = columns;
    m_linkColumns = links;
    int place = 0;
    for (const auto &[address, card] : m_links) {
        m_linkGrid->addWidget(card.card, place / links, place % links);
        card.card->setVisible(true);
        ++place;
    }
    place = 0;
    for (const DeviceId id : m_order) {
        DeviceCard &card = *m_cards.at(id);
        const int span = std::min(card.columns(), columns);
        if (place % columns + span > columns)
            place += columns - place % columns;
        m_deviceGrid->addWidget(&card, place / columns, place % columns, 1, span);
        card.setVisible(true); // a layout does it later only
        place += span;
    }
    for (int i = 0; i < mostColumns; ++i) {
        m_linkGrid->setColumnStretch(i, i < links ? 1 : 0);
        m_deviceGrid->setColumnStretch(i, i < columns ? 1 : 0);
    }
    QEvent request(QEvent::LayoutRequest); // now: the first picture would show cards that are squeezed into the page
    m_canvas->layout()->activate();
    QCoreApplication::sendEvent(m_states->widget(0), &request); // the area that scrolls them
}

} // namespace mb
