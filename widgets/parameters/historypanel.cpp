// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/historypanel.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/guarded.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/segmented.h"
#include "widgets/common/turningsplitter.h"
#include "widgets/common/wraplayout.h"
#include "widgets/parameters/differencetable.h"
#include "widgets/parameters/stagededits.h"
#include "widgets/parameters/timelinedelegate.h"

#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QLabel>
#include <QPainter>

#include <algorithm>
#include <utility>

namespace mb {
namespace {

constexpr int narrowHistory = 900;
constexpr int historyBesideFrom = 600; ///< units
constexpr int timelineWidth = 280;
constexpr int stateLetters = 18;
constexpr int fewLetters = 10;

} // namespace

HistoryPanel::HistoryPanel(Workbench &workbench, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_workbench(workbench)
    , m_theme(theme)
{
    setObjectName(QStringLiteral("historyPanel"));
    auto *column = layoutIn<QVBoxLayout>(this, 0);
    column->addWidget(buildBar());
    column->addWidget(separatorLine(Qt::Horizontal, this));
    auto *splitter = new TurningSplitter(theme, historyBesideFrom, this);
    splitter->setHandleWidth(1);
    splitter->addWidget(buildTimeline());
    m_table = new DifferenceTable(theme, splitter);
    splitter->setStretchFactor(1, 1);
    splitter->setSizes({theme.theme().u(timelineWidth), theme.theme().u(720)});
    column->addWidget(splitter, 1);
    column->addWidget(separatorLine(Qt::Horizontal, this));
    column->addWidget(buildFoot());
    connect(m_line, &TimelineList::chosen, this, &HistoryPanel::choose);
    connect(m_table, &QTableWidget::itemChanged, this, &HistoryPanel::count);
    connect(&theme, &ThemeSource::changed, this, [this] { // lines and symbols have colours of their own
        drawBadges();
        if (m_states.family())
            rebuild();
    });
}

QWidget *HistoryPanel::buildTimeline()
{
    const Theme &t = m_theme.theme();
    auto *side = new QWidget(this);
    auto *column = layoutIn<QVBoxLayout>(side, 0);
    auto *head = new QWidget(side);
    auto *words = layoutIn<QHBoxLayout>(head, t.u(8), {t.u(8), 0, t.u(8), 0});
    words->addWidget(new SectionLabel(tr("Timeline"), head));
    words->addStretch(1);
    words->addWidget(textLabel(tr("differences from A"), TextRole::Caption, Tone::Dim, head));
    head->setFixedHeight(t.u(26));
    m_line = new TimelineList(m_theme, side);
    auto *hint = new ElidedLabel(tr("Click sets B, Shift+click sets A."), side);
    setTextRole(*hint, TextRole::Caption);
    setTone(*hint, Tone::Dim);
    hint->setContentsMargins(t.u(8), t.u(4), t.u(8), t.u(4));
    column->addWidget(head);
    column->addWidget(separatorLine(Qt::Horizontal, side));
    column->addWidget(m_line, 1);
    column->addWidget(separatorLine(Qt::Horizontal, side));
    column->addWidget(hint);
    return side;
}

/// A letter in a filled box stands before each choice, as beside its state.
void HistoryPanel::drawBadges()
{
    const Theme &t = m_theme.theme();
    for (const auto &[label, letter] : {std::pair(m_badgeA, 'A'), std::pair(m_badgeB, 'B')}) {
        const int side = t.u(18);
        QPixmap picture(QSize(side, side) * devicePixelRatioF());
        picture.setDevicePixelRatio(devicePixelRatioF());
        picture.fill(Qt::transparent);
        QPainter painter(&picture);
        paintStateBadge(painter, {0, 0, side, side}, QLatin1Char(letter), t, font());
        label->setPixmap(picture);
    }
}

QWidget *HistoryPanel::buildBar()
{
    const Theme &t = m_theme.theme();
    auto *bar = new QWidget(this);
    auto *row = layoutIn<WrapLayout>(bar, t.u(8), {t.u(12), t.u(4), t.u(12), t.u(8)});
    const auto chooser = [&](QLabel *&badge, const QString &name) {
        auto *both = new QWidget(bar);
        auto *parts = layoutIn<QHBoxLayout>(both, t.u(8));
        badge = new QLabel(both);
        parts->addWidget(badge);
        auto *box = new QComboBox(both);
        box->setAccessibleName(name);
        box->setMinimumContentsLength(stateLetters);
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        parts->addWidget(box);
        row->addWidget(both);
        return box;
    };
    m_a = chooser(m_badgeA, tr("State A"));
    auto *swap = new IconButton(m_theme, Symbol::Swap, tr("Exchange A and B"), bar);
    row->addWidget(swap);
    m_b = chooser(m_badgeB, tr("State B"));
    drawBadges();
    connect(swap, &QToolButton::clicked, this, [this] {
        const int a = m_a->currentIndex();
        choose(m_b->currentIndex(), true);
        choose(a, false);
    });
    m_which = new Segmented(tr("Which parameters"), {tr("Only differences"), tr("All")}, bar);
    row->addSpring();
    row->addWidget(m_which);
    connect(m_a, qOverload<int>(&QComboBox::activated), this, [this](int place) { choose(place, true); });
    connect(m_b, qOverload<int>(&QComboBox::activated), this, [this](int place) { choose(place, false); });
    connect(m_which, &Segmented::currentChanged, this, &HistoryPanel::compareChosen);
    return bar;
}

QWidget *HistoryPanel::buildFoot()
{
    const Theme &t = m_theme.theme();
    auto *foot = new QWidget(this);
    auto *row = layoutIn<QHBoxLayout>(foot, -1, {t.u(12), t.u(8), t.u(12), t.u(8)});
    m_ticked = textLabel({}, TextRole::Body, Tone::Dim, foot);
    m_restore = new CommandButton(m_theme, Symbol::Undo, tr("Restore what is ticked"), foot);
    auto *copy = new CommandButton(m_theme, Symbol::Copy, tr("Copy as text"), foot);
    row->addWidget(m_ticked, 1);
    row->addWidget(copy);
    row->addWidget(m_restore);
    connect(copy, &QPushButton::clicked, this, [this] { QGuiApplication::clipboard()->setText(m_table->asText()); });
    connect(m_restore, &QPushButton::clicked, this, [this] {
        if (!mayWrite())
            return;
        m_chose = true; // the snapshot that is taken before is the contrary
        Q_EMIT restoreRequested();
    });
    return foot;
}

HistoryPanel::Ready HistoryPanel::readyOf(const DeviceView &device) const
{
    if (!device.liveness.heard || !device.busy.empty())
        return Ready::No;
    const auto waits = [&device](const UnconfirmedView &view) { return view.device == device.id; };
    return std::ranges::any_of(m_workbench.snapshot().unconfirmed, waits) ? Ready::Decide : Ready::Yes;
}

void HistoryPanel::showDevice(const DeviceView &device)
{
    const std::string &unit = device.unit;
    if (unit.empty())
        return;
    const Ready ready = readyOf(device);
    if (unit == m_unit && device.parameterRevision == m_revision && ready == m_ready)
        return;
    const bool isOther = unit != m_unit || m_states.family() != device.family;
    m_ready = ready;
    m_unit = unit;
    m_revision = device.parameterRevision;
    m_entries = device.parameters;
    if (isOther) {
        m_states.begin(*device.family);
        m_chose = false;
        m_chosenA = UnitStates::present;
        m_chosenB = UnitStates::defaults;
    }
    m_states.setPresent(
        settings::sideOf(ParameterSource{*device.family, device.identity, device.selector, *device.parameters}));
    rebuild();
    reload();
}

void HistoryPanel::reload()
{
    if (!m_states.family())
        return;
    m_workbench.settings().list(m_unit, guarded(this, [this, unit = m_unit](const Result<SettingsTimeline> &timeline) {
        if (m_unit == unit && timeline)
            take(*timeline);
    }));
}

void HistoryPanel::take(const SettingsTimeline &timeline)
{
    m_states.setTimeline(timeline);
    rebuild();
    for (const std::int64_t number : m_states.missing())
        m_workbench.settings().fetch(
            number, guarded(this, [this, unit = m_unit](const Result<settings::ParameterSnapshot> &snapshot) {
                if (!snapshot || snapshot->unit != unit || m_unit != unit)
                    return;
                m_states.addFile(*snapshot);
                rebuild();
            }));
}

/// States that are known by now, in the choices and on the time line.
void HistoryPanel::rebuild()
{
    m_states.rebuild();
    if (!m_chose)
        m_chosenB = m_states.newestUnlike();
    for (QComboBox *box : {m_a, m_b}) {
        const QSignalBlocker quiet(box);
        box->clear();
        for (const UnitState &state : m_states.all())
            box->addItem(state.time.isEmpty() ? state.title : state.title + QLatin1Char(' ') + state.time,
                static_cast<qint64>(state.number));
        const int place = box->findData(static_cast<qint64>(box == m_a ? m_chosenA : m_chosenB));
        box->setCurrentIndex(place >= 0 ? place : box == m_a ? 0 : box->count() - 1);
    }
    m_line->show(*m_states.family(), m_states.all(), m_states.timeline());
    compareChosen();
}

void HistoryPanel::choose(int state, bool asA)
{
    m_chose = true;
    (asA ? m_chosenA : m_chosenB) = m_states.at(state).number;
    (asA ? m_a : m_b)->setCurrentIndex(state);
    compareChosen();
}

void HistoryPanel::compareChosen()
{
    if (!m_states.family())
        return;
    const QSignalBlocker quiet(m_table);
    m_line->mark(m_a->currentIndex(), m_b->currentIndex());
    const Compared now{m_unit, m_states.at(m_a->currentIndex()).number, m_states.at(m_b->currentIndex()).number};
    if (std::exchange(m_compared, now) != now)
        m_table->forgetTicks(now.b != UnitStates::defaults); // nobody loses all gains by one click
    const auto counts = m_table->show(*m_states.family(), m_states.at(m_a->currentIndex()).side,
        m_states.at(m_b->currentIndex()).side, m_which->current() == 1);
    m_which->setText(0, tr("Only differences %1").arg(counts.differences));
    m_which->setText(1, tr("All %1").arg(counts.all));
    count();
}

/// What the device has now is A: values of B can be written to it.
bool HistoryPanel::isLive() const
{
    return m_states.family() && m_states.at(m_a->currentIndex()).kind == UnitState::Kind::Now;
}

std::vector<ParameterChange> HistoryPanel::ticked() const
{
    const std::vector<ParameterChange> changes = m_table->ticked();
    StagedEdits order(*m_states.family());
    order.setEntries(m_entries);
    order.stageAll(changes, {});
    for (const ParameterChange &change : changes)
        order.confirm(change.index);
    return order.toWrite();
}

void HistoryPanel::count()
{
    const auto chosen = m_states.family() ? ticked().size() : 0;
    m_ticked->setText(isLive() ? tr("%1 ticked; a snapshot of what is there is taken first.").arg(chosen)
                               : tr("Choose what the device has now as A to write values of B."));
    m_restore->setText(m_ready == Ready::Decide ? tr("Keep or revert first") : tr("Restore %1").arg(chosen));
    m_restore->setEnabled(mayWrite());
}

void HistoryPanel::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    m_table->setNarrow(width() < m_theme.theme().u(narrowHistory));
    const bool narrow = width() < m_theme.theme().u(historyBesideFrom);
    for (QComboBox *box : {m_a, m_b})
        box->setMinimumContentsLength(narrow ? fewLetters : stateLetters); // what is cut is said in the list
    m_which->setFolded(narrow);
}

} // namespace mb
