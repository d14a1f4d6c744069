// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/historypanel.h"

#include "settings/unit.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/segmented.h"
#include "widgets/parameters/stagededits.h"
#include "widgets/parameters/valuetext.h"

#include <QComboBox>
#include <QDateTime>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QPointer>
#include <QSplitter>
#include <QStyle>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace mb {
namespace {

enum Column { NameColumn, KeyColumn, AColumn, BColumn, UnitColumn, NoteColumn, Columns };

constexpr std::size_t mostFetched = 60; ///< newest snapshots that are compared by themselves
constexpr std::int64_t presentState = 0;
constexpr std::int64_t defaultState = -1;
constexpr int narrowHistory = 900;

QString stateValue(const Parameter &parameter, const ParameterStore::Entry &entry)
{
    return entry.raw ? valueText(parameter, *entry.raw) : QStringLiteral("–");
}

} // namespace

HistoryPanel::HistoryPanel(Workbench &workbench, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_workbench(workbench)
    , m_theme(theme)
{
    setObjectName(QStringLiteral("historyPanel"));
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(buildBar());
    column->addWidget(separatorLine(Qt::Horizontal, this));
    m_splitter = new QSplitter(Qt::Horizontal, this);
    m_splitter->setChildrenCollapsible(false);
    m_splitter->setHandleWidth(1);
    m_line = new TimelineList(theme, m_splitter);
    m_table = new QTableWidget(0, Columns, m_splitter);
    m_table->setAccessibleName(tr("Differences"));
    m_table->setHorizontalHeaderLabels({tr("parameter"), tr("key"), tr("A"), tr("B"), tr("unit"), tr("note")});
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(NameColumn, QHeaderView::Interactive); // fitNames()
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->verticalHeader()->hide();
    m_table->setShowGrid(false);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_splitter->setStretchFactor(1, 1);
    m_splitter->setSizes({theme.theme().u(260), theme.theme().u(720)});
    column->addWidget(m_splitter, 1);
    column->addWidget(separatorLine(Qt::Horizontal, this));
    column->addWidget(buildFoot());
    connect(m_line, &TimelineList::chosen, this, &HistoryPanel::choose);
    connect(m_table, &QTableWidget::itemChanged, this, &HistoryPanel::count);
}

QWidget *HistoryPanel::buildBar()
{
    const Theme &t = m_theme.theme();
    auto *bar = new QWidget(this);
    auto *row = new QHBoxLayout(bar);
    row->setContentsMargins(t.u(12), t.u(4), t.u(12), t.u(8));
    row->setSpacing(t.u(8));
    const auto chooser = [&](const QString &letter, const QString &name) {
        row->addWidget(textLabel(letter, TextRole::Emphasis, Tone::Accent, bar));
        auto *box = new QComboBox(bar);
        box->setAccessibleName(name);
        box->setMinimumContentsLength(18);
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        row->addWidget(box);
        return box;
    };
    m_a = chooser(QStringLiteral("A"), tr("State A"));
    m_b = chooser(QStringLiteral("B"), tr("State B"));
    m_which = new Segmented(tr("Which parameters"), {tr("Only differences"), tr("All")}, bar);
    row->addStretch(1);
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
    auto *row = new QHBoxLayout(foot);
    row->setContentsMargins(t.u(12), t.u(8), t.u(12), t.u(8));
    m_ticked = textLabel({}, TextRole::Body, Tone::Dim, foot);
    m_restore = new CommandButton(m_theme, Symbol::Undo, tr("Restore what is ticked"), foot);
    row->addWidget(m_ticked, 1);
    row->addWidget(m_restore);
    connect(m_restore, &QPushButton::clicked, this, [this] {
        if (mayWrite())
            Q_EMIT restoreRequested(m_b->currentText());
    });
    return foot;
}

void HistoryPanel::showDevice(const DeviceView &device)
{
    const auto link = LinkAddress::parse(device.link);
    if (!link)
        return;
    const std::string unit = settings::unitOf(device.identity, *link).key;
    const bool online = device.liveness.heard && device.busy.empty();
    if (unit == m_unit && device.parameterRevision == m_revision && online == m_online)
        return;
    const bool isOther = unit != m_unit;
    m_online = online;
    m_unit = unit;
    m_revision = device.parameterRevision;
    m_family = device.family;
    m_entries = device.parameters;
    m_now = settings::sideOf(ParameterSource{*device.family, device.identity, device.selector, device.parameters});
    if (isOther) {
        m_chose = false;
        m_chosenA = presentState;
        m_chosenB = defaultState;
        m_files.clear();
        m_timeline = {};
    }
    rebuild();
    reload();
}

void HistoryPanel::reload()
{
    m_workbench.settings().list(
        m_unit, [panel = QPointer<HistoryPanel>(this), unit = m_unit](const Result<SettingsTimeline> &timeline) {
            if (panel && panel->m_unit == unit && timeline)
                panel->take(*timeline);
        });
}

void HistoryPanel::take(const SettingsTimeline &timeline)
{
    m_timeline = timeline;
    const auto &all = m_timeline.snapshots;
    rebuild();
    for (std::size_t i = all.size() > mostFetched ? all.size() - mostFetched : 0; i < all.size(); ++i) {
        if (m_files.contains(all[i].number))
            continue;
        m_workbench.settings().fetch(all[i].number,
            [panel = QPointer<HistoryPanel>(this), unit = m_unit](const Result<settings::ParameterSnapshot> &snapshot) {
                if (panel && snapshot && snapshot->unit == unit && panel->m_unit == unit)
                    panel->takeFile(*snapshot);
            });
    }
}

void HistoryPanel::takeFile(const settings::ParameterSnapshot &snapshot)
{
    if (auto side = settings::sideOf(QByteArray::fromStdString(snapshot.file), *m_family))
        m_files.insert_or_assign(snapshot.number, std::move(*side));
    rebuild();
}

/// What is worth a look when nobody has chosen yet.
std::int64_t HistoryPanel::newestUnlike(const settings::Side &side) const
{
    const auto found = std::find_if(m_states.begin(), m_states.end(), [&side](const UnitState &state) {
        return state.kind == UnitState::Kind::Snapshot && !settings::compare(side, state.side).empty();
    });
    return found == m_states.end() ? defaultState : found->number;
}

/// States that are known by now: those whose files have come, the present one and the data sheet's.
void HistoryPanel::rebuild()
{
    m_states.clear();
    m_states.push_back({UnitState::Kind::Now, presentState, tr("Device, now"), {}, m_now});
    for (auto snapshot = m_timeline.snapshots.rbegin(); snapshot != m_timeline.snapshots.rend(); ++snapshot) {
        const auto file = m_files.find(snapshot->number);
        if (file == m_files.end())
            continue;
        const QDateTime time = QDateTime::fromMSecsSinceEpoch(std::llround(snapshot->time * 1e3));
        m_states.push_back({UnitState::Kind::Snapshot, snapshot->number, tableText(snapshot->name),
            locale().toString(time.time(), QStringLiteral("HH:mm:ss")), file->second});
    }
    m_states.push_back(
        {UnitState::Kind::Defaults, defaultState, tr("factory defaults"), {}, settings::defaultsOf(*m_family)});
    if (!m_chose)
        m_chosenB = newestUnlike(m_now);
    for (QComboBox *box : {m_a, m_b}) {
        const QSignalBlocker quiet(box);
        box->clear();
        for (const UnitState &state : m_states)
            box->addItem(state.time.isEmpty() ? state.title : state.title + QLatin1Char(' ') + state.time,
                static_cast<qint64>(state.number));
        const int place = box->findData(static_cast<qint64>(box == m_a ? m_chosenA : m_chosenB));
        box->setCurrentIndex(place >= 0 ? place : box == m_a ? 0 : box->count() - 1);
    }
    m_line->show(*m_family, m_states, m_timeline);
    compareChosen();
}

void HistoryPanel::choose(int state, bool asA)
{
    m_chose = true;
    (asA ? m_chosenA : m_chosenB) = stateAt(state).number;
    (asA ? m_a : m_b)->setCurrentIndex(state);
    compareChosen();
}

void HistoryPanel::compareChosen()
{
    if (!m_family)
        return;
    const QSignalBlocker quiet(m_table);
    m_line->mark(m_a->currentIndex(), m_b->currentIndex());
    const settings::Side &a = stateAt(m_a->currentIndex()).side;
    const settings::Side &b = stateAt(m_b->currentIndex()).side;
    const auto differences = settings::compare(a, b);
    m_table->setRowCount(0);
    int all = 0;
    auto next = differences.begin();
    for (std::uint16_t i = 0; i < m_family->parameters.size(); ++i) {
        const bool differs = next != differences.end() && next->index.value == i;
        const bool spoken = a.entries[i] && b.entries[i] && settings::isSetting(m_family->parameters[i]);
        all += spoken ? 1 : 0;
        if (differs)
            addRow(*next++, true);
        else if (spoken && m_which->current() == 1)
            addRow({{i}, *a.entries[i], *b.entries[i]}, false);
    }
    m_which->setText(0, tr("Only differences %1").arg(differences.size()));
    m_which->setText(1, tr("All %1").arg(all));
    fitNames();
    count();
}

/// The contents' own width forgets the box before the name, which the style sheet draws.
void HistoryPanel::fitNames()
{
    m_table->resizeColumnToContents(NameColumn);
    const QStyle &look = *m_table->style();
    const int box = look.pixelMetric(QStyle::PM_IndicatorWidth, nullptr, m_table)
        + look.pixelMetric(QStyle::PM_CheckBoxLabelSpacing, nullptr, m_table);
    QHeaderView &header = *m_table->horizontalHeader();
    header.resizeSection(NameColumn, header.sectionSize(NameColumn) + box);
}

void HistoryPanel::addRow(const settings::SideDifference &difference, bool differs)
{
    const Parameter &parameter = m_family->parameters[difference.index.value];
    const int row = m_table->rowCount();
    m_table->insertRow(row);
    const bool writable = differs && difference.b.raw && isLegal(parameter, difference.b.raw.value_or(0));
    QString note;
    if (parameter.belongsToUnit)
        note = tr("belongs to one unit, copied only if you tick it");
    else if (difference.a.state == ParameterState::Assumed || difference.b.state == ParameterState::Assumed)
        note = tr("assumed: it cannot be read");
    const QStringList texts{tableText(parameter.label), qt(parameter.key), stateValue(parameter, difference.a),
        stateValue(parameter, difference.b), tableText(parameter.unit), note};
    for (int column = 0; column < Columns; ++column) {
        auto *item = new QTableWidgetItem(texts.at(column));
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
        if (column == AColumn || column == BColumn)
            item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        if (column == BColumn && differs) {
            QFont bold = m_table->font();
            bold.setBold(true);
            item->setFont(bold);
        }
        if (column == NameColumn && writable) {
            item->setFlags(item->flags() | Qt::ItemIsUserCheckable);
            item->setCheckState(parameter.belongsToUnit ? Qt::Unchecked : Qt::Checked);
        }
        if (column == NameColumn && parameter.belongsToUnit) {
            item->setIcon(symbolIcon(Symbol::Lock, m_theme.theme(), Tone::Dim));
        }
        item->setData(Qt::UserRole, difference.index.value);
        if (difference.b.raw)
            item->setData(Qt::UserRole + 1, static_cast<qint64>(*difference.b.raw));
        m_table->setItem(row, column, item);
    }
}

bool HistoryPanel::mayWrite() const
{
    return m_online && m_family && stateAt(m_a->currentIndex()).kind == UnitState::Kind::Now && !ticked().empty();
}

std::vector<ParameterChange> HistoryPanel::ticked() const
{
    std::vector<ParameterChange> changes;
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const QTableWidgetItem *item = m_table->item(row, NameColumn);
        if (item->flags().testFlag(Qt::ItemIsUserCheckable) && item->checkState() == Qt::Checked)
            changes.push_back({{static_cast<std::uint16_t>(item->data(Qt::UserRole).toUInt())},
                item->data(Qt::UserRole + 1).toLongLong()});
    }
    StagedEdits order(*m_family);
    order.setEntries(m_entries);
    order.stageAll(changes, {});
    for (const ParameterChange &change : changes)
        order.confirm(change.index);
    return order.toWrite();
}

void HistoryPanel::count()
{
    const auto chosen = m_family ? ticked().size() : 0;
    const bool live = m_family && stateAt(m_a->currentIndex()).kind == UnitState::Kind::Now;
    m_ticked->setText(live ? tr("%1 ticked; a snapshot of what is there is taken first.").arg(chosen)
                           : tr("Choose what the device has now as A to write values of B."));
    m_restore->setText(tr("Restore %1").arg(chosen));
    m_restore->setEnabled(mayWrite());
}

void HistoryPanel::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    const bool isNarrow = width() < m_theme.theme().u(narrowHistory);
    m_table->setColumnHidden(KeyColumn, isNarrow);
}

} // namespace mb
