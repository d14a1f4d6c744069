// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/steptable.h"

#include "model/axis.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/numberformat.h"
#include "widgets/control/gainunits.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QTableWidget>

#include <algorithm>

namespace mb {
namespace {

enum Column { Number, Step, GainP, GainI, GainD, GainF, Over, Settle, Rise, Steady, Peak, Note, ColumnCount };

constexpr double percent = 100.0;
constexpr double milliseconds = 1000.0;

QString percentText(std::optional<double> fraction)
{
    return fraction ? formatNumber(*fraction * percent, 1) : QString(UnknownMark);
}

QString millisecondText(std::optional<double> seconds)
{
    return seconds ? formatNumber(*seconds * milliseconds) : QString(UnknownMark);
}

} // namespace

StepTable::StepTable(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(buildHead());
    m_table = new QTableWidget(0, ColumnCount, this);
    column->addWidget(m_table);
    configure();
    connect(m_table, &QTableWidget::itemSelectionChanged, this, &StepTable::updateButtons);
    connect(m_table, &QTableWidget::itemActivated, m_show, &QPushButton::click);
    connect(m_show, &QPushButton::clicked, this, [this] {
        if (const StepRecord *record = current())
            Q_EMIT showRequested(*record);
    });
    connect(m_use, &QPushButton::clicked, this, [this] {
        if (const StepRecord *record = current())
            Q_EMIT useRequested(*record);
    });
    connect(&theme, &ThemeSource::changed, this, [this] {
        fitHeight();
        fill();
    });
    fill();
}

QHBoxLayout *StepTable::buildHead()
{
    const Theme &theme = m_theme.theme();
    auto *head = new QHBoxLayout;
    head->setContentsMargins(theme.u(12), theme.u(4), theme.u(12), theme.u(4));
    head->setSpacing(theme.u(8));
    m_count = textLabel({}, TextRole::Caption, Tone::Dim, this);
    m_show = new CommandButton(m_theme, tr("Show in plot"), this);
    m_use = new CommandButton(m_theme, Symbol::Undo, tr("Use these gains"), this);
    m_use->setToolTip(tr("Stages the gains of the step that is selected; nothing is written yet."));
    head->addWidget(new SectionLabel(tr("Steps"), this));
    head->addWidget(m_count, 1);
    head->addWidget(m_show);
    head->addWidget(m_use);
    return head;
}

void StepTable::configure()
{
    m_table->setAccessibleName(tr("Steps of this session"));
    m_table->setHorizontalHeaderLabels({tr("step"), tr("set-point"), tr("P"), tr("I"), tr("D"), tr("F"), tr("over %"),
        tr("settle"), tr("rise"), tr("error %"), tr("peak A"), tr("note")});
    m_table->horizontalHeaderItem(Over)->setToolTip(tr("Overshoot in per cent of the step"));
    m_table->horizontalHeaderItem(Settle)->setToolTip(
        tr("Milliseconds until it stays within 2 %, or within the noise"));
    m_table->horizontalHeaderItem(Rise)->setToolTip(tr("Milliseconds from 10 to 90 %"));
    m_table->horizontalHeaderItem(Steady)->setToolTip(tr("What is missing to the set-point in the end"));
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setShowGrid(false);
    m_table->setWordWrap(false);
    m_table->verticalHeader()->hide();
    QHeaderView &head = *m_table->horizontalHeader();
    head.setSectionResizeMode(QHeaderView::ResizeToContents);
    head.setSectionResizeMode(Note, QHeaderView::Stretch);
    for (int column = GainP; column <= Peak; ++column)
        m_table->horizontalHeaderItem(column)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_empty = textLabel(tr("Every run appears here with its gains and what became of it."), TextRole::Body, Tone::Faint,
        m_table->viewport());
    auto *middle = new QVBoxLayout(m_table->viewport());
    middle->addWidget(m_empty, 0, Qt::AlignCenter);
    fitHeight();
}

void StepTable::setRows(int rows)
{
    m_rows = rows;
    fitHeight();
}

void StepTable::fitHeight()
{
    const int row = std::max(m_theme.theme().u(26), fontMetrics().height() + m_theme.theme().u(6));
    m_table->verticalHeader()->setDefaultSectionSize(row);
    m_table->setFixedHeight(m_table->horizontalHeader()->sizeHint().height() + m_rows * row + m_theme.theme().u(4));
}

void StepTable::setUnits(const DisplayUnits &units)
{
    if (units == m_units)
        return;
    m_units = units;
    fill();
}

void StepTable::setRecords(const Family *family, const std::vector<StepRecord> &records)
{
    m_family = family;
    m_records.assign(records.rbegin(), records.rend());
    fill();
}

void StepTable::fill()
{
    const StepRecord *chosen = current();
    const int keep = chosen ? chosen->number : 0;
    const QSignalBlocker quiet(m_table);
    m_table->setRowCount(static_cast<int>(m_records.size()));
    for (int row = 0; row < m_table->rowCount(); ++row) {
        fillRow(row, m_records[static_cast<std::size_t>(row)]);
        if (m_records[static_cast<std::size_t>(row)].number == keep)
            m_table->selectRow(row);
    }
    for (std::size_t i = 0; i < 4; ++i) { // a gain that nobody uses needs no column
        const bool used = std::any_of(m_records.begin(), m_records.end(),
            [i](const StepRecord &record) { return record.gains[i].value_or(0) != 0; });
        m_table->setColumnHidden(GainP + static_cast<int>(i), !used && i >= 2);
    }
    m_empty->setVisible(m_records.empty());
    m_count->setText(
        m_records.empty() ? QString() : tr("%1 this session, every run is kept").arg(m_records.front().number));
    updateButtons();
}

void StepTable::setCell(int row, int column, const QString &text, Tone tone)
{
    QTableWidgetItem *item = m_table->item(row, column);
    if (!item) {
        item = new QTableWidgetItem;
        m_table->setItem(row, column, item);
    }
    item->setText(text);
    item->setForeground(m_theme.theme().tone(tone));
    const bool number = column >= GainP && column <= Peak;
    const Qt::Alignment alignment = (number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter;
    item->setTextAlignment(static_cast<int>(alignment));
}

QStringList StepTable::notesOf(const StepRecord &record)
{
    const StepMetrics &metrics = record.metrics;
    QStringList notes;
    if (!record.finished)
        notes << tr("running");
    else if (metrics.unsteady)
        notes << tr("does not settle");
    else if (!metrics.moved)
        notes << tr("did not move");
    if (record.cut)
        notes << tr("cut short");
    if (record.lost > 0)
        notes << tr("%1 lost").arg(formatCount(static_cast<qint64>(record.lost)));
    if (record.ramp > 0.0)
        notes << tr("ramp %1").arg(formatDuration(record.ramp));
    if (metrics.moved && metrics.band > 0.021)
        notes << tr("band ±%1 %").arg(formatNumber(metrics.band * percent, 1));
    return notes;
}

void StepTable::fillRow(int row, const StepRecord &record)
{
    const ShownUnit unit = shownUnit(record.mode, m_units);
    const int decimals = unit.decimals > 1 ? 1 : 0;
    const StepMetrics &metrics = record.metrics;
    setCell(row, Number, QStringLiteral("#%1").arg(record.number), record.finished ? Tone::Text : Tone::Accent);
    setCell(row, Step,
        QStringLiteral("%1 → %2").arg(
            formatNumber(record.from * unit.scale, decimals), formatNumber(record.to * unit.scale, decimals)));
    m_table->item(row, Step)->setToolTip(unit.text);
    const GainSet set = m_family ? gainSet(*m_family, record.mode, record.slot, record.axis) : GainSet{};
    for (std::size_t i = 0; i < record.gains.size(); ++i) {
        const bool known = i < set.gains.size() && record.gains[i];
        const double number
            = known ? static_cast<double>(*record.gains[i]) / m_family->parameters[set.gains[i].value].one : 0.0;
        setCell(row, GainP + static_cast<int>(i),
            !known              ? QString(UnknownMark)
                : number == 0.0 ? QStringLiteral("0")
                                : formatSignificant(number, 4),
            number == 0.0 ? Tone::Dim : Tone::Text);
    }
    setCell(row, Over, percentText(metrics.overshoot));
    setCell(row, Settle, millisecondText(metrics.settle));
    setCell(row, Rise, millisecondText(metrics.rise));
    setCell(row, Steady, percentText(metrics.steadyError));
    const bool measured = m_family && findChannel(m_family->channels, axisKey(record.axis, "current"));
    setCell(row, Peak, record.finished && measured ? formatNumber(record.peakCurrent, 1) : QString(UnknownMark));
    const QStringList notes = notesOf(record);
    const bool bad = record.cut || record.lost > 0 || (record.finished && !metrics.moved);
    setCell(row, Note, notes.join(QStringLiteral(", ")), bad ? Tone::Caution : Tone::Dim);
    m_table->item(row, Note)->setToolTip(notes.join(QStringLiteral(", ")));
}

const StepRecord *StepTable::current() const
{
    const auto rows = m_table->selectionModel() ? m_table->selectionModel()->selectedRows() : QModelIndexList{};
    if (rows.isEmpty() || rows.first().row() >= static_cast<int>(m_records.size()))
        return nullptr;
    return &m_records[static_cast<std::size_t>(rows.first().row())];
}

void StepTable::updateButtons()
{
    const StepRecord *record = current();
    m_show->setEnabled(record);
    m_use->setEnabled(record
        && std::any_of(record->gains.begin(), record->gains.end(), [](const auto &raw) { return raw.has_value(); }));
}

} // namespace mb
