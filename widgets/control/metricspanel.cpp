// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/metricspanel.h"

#include "experiment/metrics.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/numberformat.h"
#include "widgets/common/wraplayout.h"
#include "widgets/control/trialwords.h"

#include <QHeaderView>
#include <QResizeEvent>
#include <QTableWidget>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace mb {
namespace {

enum Column { Name, ValueA, ValueB, Difference, ColumnCount };

/// In the order of the page: what one looks at first.
constexpr std::array<std::string_view, 10> keys{
    "overshoot", "undershoot", "settle", "rise", "sse", "iae", "peak_current", "rms_duty", "saturated", "noise"};

QString textOf(const std::optional<KeptTrial> &kept, std::string_view key, const MetricWord &word, bool withError)
{
    const auto value = kept ? tuning::metricOf(kept->trial.metrics, key) : std::nullopt;
    if (!value)
        return QString(UnknownMark);
    const auto error = tuning::metricOf(kept->trial.errors, key);
    const QString text = formatNumber(*value * word.scale, word.decimals);
    return error && withError ? text + QStringLiteral("±") + formatNumber(*error * word.scale, word.decimals) : text;
}

} // namespace

MetricsPanel::MetricsPanel(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    const Theme &look = theme.theme();
    auto *column = layoutIn<QVBoxLayout>(this, look.u(6), {look.u(8), look.u(6), look.u(6), look.u(6)});
    auto *head = new QHBoxLayout;
    m_repeats = textLabel({}, TextRole::Caption, Tone::Dim, this);
    head->addWidget(new SectionLabel(tr("Metrics"), this));
    head->addStretch(1);
    head->addWidget(m_repeats);
    m_table = new QTableWidget(static_cast<int>(keys.size()), ColumnCount, this);
    m_table->setAccessibleName(tr("Metrics of A and B"));
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setShowGrid(false);
    m_table->setProperty("dense", true);
    m_table->setWordWrap(false);
    m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_table->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff); // the panel scrolls
    m_table->verticalHeader()->hide();
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    m_table->horizontalHeader()->setSectionResizeMode(Name, QHeaderView::Stretch);
    m_table->horizontalHeader()->setMinimumSectionSize(look.u(30));
    m_health = new SectionLabel(tr("Loop health"), this);
    m_chips = new QWidget(this);
    new WrapLayout(m_chips);
    column->addLayout(head);
    column->addWidget(m_table);
    column->addWidget(m_health);
    column->addWidget(m_chips);
    column->addStretch(1);
    connect(&theme, &ThemeSource::changed, this, [this] {
        fit();
        fill();
    });
    fit();
    fill();
}

void MetricsPanel::append(QWidget *below)
{
    auto &column = static_cast<QVBoxLayout &>(*layout());
    column.insertWidget(column.count() - 1, below);
}

void MetricsPanel::fit()
{
    const int row = std::max(m_theme.theme().u(22), fontMetrics().height() + m_theme.theme().u(2));
    m_table->setFont(m_theme.theme().font(TextRole::Caption, font()));
    m_table->verticalHeader()->setDefaultSectionSize(row);
    m_table->setFixedHeight(m_table->horizontalHeader()->sizeHint().height() + m_table->rowCount() * row + 2);
}

void MetricsPanel::setTrials(const KeptTrial *a, const KeptTrial *b, std::optional<double> windup)
{
    m_windup = windup;
    const auto bare = [](const KeptTrial *kept) {
        std::optional<KeptTrial> copy;
        if (!kept)
            return copy;
        copy = *kept;
        copy->trial.signals.clear();
        return copy;
    };
    m_a = bare(a);
    m_b = bare(b);
    fill();
}

void MetricsPanel::fill()
{
    fillRows();
    fillChips();
}

void MetricsPanel::fillRows()
{
    const auto head = [](const QString &letter, const std::optional<KeptTrial> &kept) {
        return kept ? QStringLiteral("%1 #%2").arg(letter).arg(kept->number) : letter;
    };
    m_table->setHorizontalHeaderLabels(
        {tr("metric"), head(QStringLiteral("A"), m_a), head(QStringLiteral("B"), m_b), tr("Δ B − A", "difference")});
    for (int column = ValueA; column < ColumnCount; ++column)
        m_table->horizontalHeaderItem(column)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    const auto fillAll = [this](Detail detail) {
        for (std::size_t i = 0; i < keys.size(); ++i)
            fillRow(static_cast<int>(i), keys[i], detail);
        return tableWidth();
    };
    const int least = fillAll(Detail::WordsOnly);
    const QMargins around = layout()->contentsMargins();
    const int room = width() - around.left() - around.right(); // the table follows later
    const bool whole = fillAll(Detail::All) <= room;
    if (!whole && fillAll(Detail::WithoutError) > room)
        fillAll(Detail::WordsOnly);
    for (int column = ValueA; column < ColumnCount; ++column)
        m_table->setColumnWidth(column, widthOf(column));
    const int repeats = m_b ? m_b->trial.repeat : 1;
    m_repeats->setText(
        repeats > 1 ? (whole ? tr("± from %1 repeats") : tr("means of %1 repeats")).arg(repeats) : QString());
    if (std::exchange(m_least, least + around.left() + around.right() + m_theme.theme().u(20)) != m_least)
        Q_EMIT leastWidthChanged();
}

/// What the texts of a column need.
int MetricsPanel::widthOf(int column) const
{
    const QFontMetrics caption(m_theme.theme().font(TextRole::Caption, font()));
    int width = caption.horizontalAdvance(m_table->horizontalHeaderItem(column)->text());
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const QTableWidgetItem &item = *m_table->item(row, column);
        width = std::max(width, QFontMetrics(item.font()).horizontalAdvance(item.text()));
    }
    return width + m_theme.theme().u(8) + 8; // what the sheet leaves around a text, and the style inside it
}

int MetricsPanel::tableWidth() const
{
    return widthOf(Name) + widthOf(ValueA) + widthOf(ValueB) + widthOf(Difference) + 2 * m_table->frameWidth();
}

void MetricsPanel::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    if (event->size().width() != event->oldSize().width())
        fillRows(); // and no chip is deleted: a change of style, which resizes, walks through all widgets
}

void MetricsPanel::fillRow(int row, std::string_view key, Detail detail)
{
    const MetricWord word = metricWord(key);
    setCell(row, Name, QStringLiteral("%1, %2").arg(word.name, word.unit), Tone::Text, false);
    setCell(row, ValueA, textOf(m_a, key, word, false), Tone::Text, false);
    setCell(row, ValueB, textOf(m_b, key, word, detail == Detail::All), Tone::Text, true);
    const auto [difference, tone] = differenceOf(key, detail);
    setCell(row, Difference, difference, tone, false);
    for (int column = Name; column < ColumnCount; ++column)
        m_table->item(row, column)->setToolTip(m_table->item(row, column)->text());
    m_table->item(row, ValueA)->setToolTip(textOf(m_a, key, word, true));
    m_table->item(row, ValueB)->setToolTip(textOf(m_b, key, word, true));
    m_table->item(row, Difference)->setToolTip(differenceOf(key, Detail::All).first);
}

std::pair<QString, Tone> MetricsPanel::differenceOf(std::string_view key, Detail detail) const
{
    const MetricWord word = metricWord(key);
    const auto a = m_a ? tuning::metricOf(m_a->trial.metrics, key) : std::nullopt;
    const auto b = m_b ? tuning::metricOf(m_b->trial.metrics, key) : std::nullopt;
    if (!a || !b)
        return {QString(), Tone::Dim};
    const bool wordsOnly = detail == Detail::WordsOnly;
    const double before = a.value_or(0.0);
    const double after = b.value_or(0.0);
    const double change = (after - before) * word.scale;
    const QString changed = formatDifference(change, word.decimals);
    if (m_a->trial.has(tuning::flag::aborted) || m_b->trial.has(tuning::flag::aborted)) // no judgement of a part of one
        return {wordsOnly ? QString() : changed, Tone::Dim};
    const QString number = wordsOnly ? QString() : changed + QLatin1Char(' ');
    const bool isSigned = key == "sse"; // what counts is how far it is from the set-point
    const double difference = isSigned ? (std::abs(after) - std::abs(before)) * word.scale : change;
    const auto errorOf = [&](const KeptTrial &kept) { return tuning::metricOf(kept.trial.errors, key).value_or(0.0); };
    const double error = (errorOf(*m_a) + errorOf(*m_b)) * word.scale;
    if (std::abs(difference) < word.same)
        return {tr("%1= same").arg(number), Tone::Dim};
    if (std::abs(difference) < error) // 511 and 808 are not the same to anyone who is not told why
        return {tr("%1= same ±%2").arg(number, formatNumber(error, word.decimals)), Tone::Dim};
    if (difference < 0.0)
        return {QStringLiteral("%1▼ %2").arg(number, word.less), Tone::Ok};
    return {QStringLiteral("%1▲ %2").arg(number, word.more), Tone::Caution};
}

void MetricsPanel::setCell(int row, int column, const QString &text, Tone tone, bool strong)
{
    QTableWidgetItem *item = m_table->item(row, column);
    if (!item) {
        item = new QTableWidgetItem;
        m_table->setItem(row, column, item);
    }
    item->setText(text);
    item->setForeground(m_theme.theme().tone(tone));
    QFont face = m_table->font();
    face.setBold(strong);
    item->setFont(face);
    item->setTextAlignment(static_cast<int>((column == Name ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter));
}

void MetricsPanel::addChip(const QString &text, Tone tone, const QString &tip)
{
    QLabel *const chip = badge(text, tone, m_chips);
    chip->setToolTip(tip);
    chip->setAccessibleName(tip);
    m_chips->layout()->addWidget(chip);
    chip->show();
    m_chipTexts << text;
}

void MetricsPanel::fillChips()
{
    m_chipTexts.clear();
    while (QLayoutItem *item = m_chips->layout()->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    m_health->setVisible(m_b.has_value());
    m_chips->setVisible(m_b.has_value());
    if (!m_b)
        return;
    const tuning::Trial &trial = m_b->trial;
    const auto of = [&trial](std::string_view flag) { return trial.has(flag) ? Tone::Caution : Tone::Dim; };
    if (trial.metrics.saturated)
        addChip(tr("SAT %1 %").arg(formatNumber(*trial.metrics.saturated * 100.0, 0)), of(tuning::flag::saturated),
            tr("Share of the hold in which the duty was at its limit"));
    addChip(tr("ILIM"), of(tuning::flag::currentLimit), tr("The current was at its limit"));
    addChip(tr("RAMP"), of(tuning::flag::rampLimit), tr("The drive's own ramp was on"));
    addChip(tr("LIMIT SW"), of(tuning::flag::limitSwitch), tr("A limit switch was met"));
    addChip(m_windup ? tr("WINDUP %1").arg(formatDuration(*m_windup)) : tr("WINDUP"),
        m_windup ? Tone::Caution : Tone::Dim,
        tr("The duty was at its limit while I went on; that is paid back as overshoot"));
    addChip(tr("QUANT"), of(tuning::flag::lowResolution), tr("The step has few counts of the encoder"));
    addChip(tr("LOST %1").arg(trial.lost), trial.lost > 0 ? Tone::Caution : Tone::Ok, tr("Samples that are missing"));
    if (trial.simulated)
        addChip(tr("SIMULATED"), Tone::Accent, tr("Made on a simulated controller, and marked so for ever"));
}

} // namespace mb
