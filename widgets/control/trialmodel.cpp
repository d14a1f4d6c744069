// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/trialmodel.h"

#include "widgets/common/clocktext.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/icons.h"
#include "widgets/common/numberformat.h"
#include "widgets/common/stateglyph.h"
#include "widgets/control/gainunits.h"
#include "widgets/control/trialwords.h"

#include <QDateTime>
#include <QFont>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <set>

namespace mb {
namespace {

constexpr std::array<Role, 4> shownGains{
    Role::Proportional, Role::Integral, Role::Derivative, Role::FeedForward}; ///< of the columns from GainP on

QString orNone(const QString &text)
{
    return text.isEmpty() ? QString(UnknownMark) : text;
}

QString percentText(std::optional<double> fraction)
{
    return fraction ? formatNumber(*fraction * 100.0, 1) : QString();
}

QString milliseconds(std::optional<double> seconds)
{
    return seconds ? formatNumber(*seconds * 1e3) : QString();
}

bool passes(const KeptTrial &kept, TrialModel::Filter filter)
{
    return filter == TrialModel::Filter::All
        || (filter == TrialModel::Filter::Starred ? kept.star : TrialModel::isClean(kept.trial));
}

QVariant toneOf(const KeptTrial &kept, int column, const Theme &theme)
{
    if (column == TrialModel::Flags)
        return theme.tone(kept.trial.has(tuning::flag::aborted) ? Tone::Danger : Tone::Caution);
    if (column == TrialModel::Use)
        return theme.accent;
    if (column == TrialModel::Time || column == TrialModel::Note)
        return theme.tone(Tone::Dim);
    return {};
}

/// A shape beside the words, never colour alone.
QVariant flagIcon(const KeptTrial &kept, const Theme &theme)
{
    if (kept.trial.flags.empty())
        return {};
    const bool stopped = kept.trial.has(tuning::flag::aborted);
    return glyphIcon(stopped ? GlyphState::Fault : GlyphState::Warning, theme);
}

} // namespace

TrialModel::TrialModel(const ThemeSource &theme, QObject *parent)
    : QAbstractTableModel(parent)
    , m_theme(theme)
{
}

void TrialModel::setFamily(const Family *family)
{
    m_gainRows = {};
    for (std::size_t i = 0; family && i < shownGains.size(); ++i) {
        for (const Parameter &parameter : family->parameters) {
            if (parameter.role == shownGains.at(i))
                m_gainRows.at(i).push_back(&parameter);
        }
    }
}

std::optional<TrialModel::TriedGain> TrialModel::gainOf(const tuning::Trial &trial, int column) const
{
    const auto &rows = m_gainRows.at(static_cast<std::size_t>(column - GainP));
    for (const auto &[key, value] : trial.gains) {
        const auto row = std::ranges::find(rows, key, &Parameter::key);
        if (row != rows.end()) // those of its own loop come first
            return value ? std::optional(TriedGain{*row, *value}) : std::nullopt;
    }
    return std::nullopt;
}

bool TrialModel::usesGain(int column) const
{
    return std::ranges::any_of(m_trials, [this, column](const KeptTrial &kept) {
        const auto gain = gainOf(kept.trial, column);
        return gain && gain->value != 0.0;
    });
}

QString TrialModel::useText()
{
    return tr("Use");
}

bool TrialModel::isClean(const tuning::Trial &trial)
{
    return trial.reason == tuning::EndReason::Done && trial.metrics.settle && !trial.has(tuning::flag::lostSamples)
        && !trial.has(tuning::flag::saturated) && !trial.has(tuning::flag::currentLimit);
}

int TrialModel::countOf(Filter filter) const
{
    return static_cast<int>(
        std::ranges::count_if(m_trials, [filter](const KeptTrial &kept) { return passes(kept, filter); }));
}

void TrialModel::setTrials(std::vector<KeptTrial> trials)
{
    if (m_rows.empty() || trials.empty()) {
        m_trials = std::move(trials);
        return arrange();
    }
    const std::vector<std::size_t> rows = arranged(trials);
    removeAllBut(trials, rows);
    std::map<std::int64_t, std::string> notes; // of what is listed
    for (int row = 0; row < rowCount(); ++row)
        notes[at(row)->number] = at(row)->note;
    std::vector<std::size_t> stay;
    std::ranges::copy_if(
        rows, std::back_inserter(stay), [&](std::size_t i) { return notes.count(trials[i].number) > 0; });
    move(std::move(trials), std::move(stay));
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const int row = static_cast<int>(i);
        if (i < m_rows.size() && m_rows[i] == rows[i])
            continue;
        beginInsertRows({}, row, row);
        m_rows.insert(m_rows.begin() + row, rows[i]);
        endInsertRows();
    }
    Q_EMIT dataChanged(index(0, Star), index(rowCount() - 1, Star));
    for (int row = 0; row < rowCount(); ++row) {
        if (const auto note = notes.find(at(row)->number); note != notes.end() && note->second != at(row)->note)
            Q_EMIT dataChanged(index(row, Note), index(row, Note));
    }
}

void TrialModel::removeAllBut(const std::vector<KeptTrial> &trials, const std::vector<std::size_t> &rows)
{
    std::set<std::int64_t> stay;
    for (const std::size_t i : rows)
        stay.insert(trials[i].number);
    for (int row = rowCount() - 1; row >= 0; --row) {
        if (stay.count(at(row)->number) > 0)
            continue;
        beginRemoveRows({}, row, row);
        m_rows.erase(m_rows.begin() + row);
        endRemoveRows();
    }
}

/// What is listed already, in the order of `rows`.
void TrialModel::move(std::vector<KeptTrial> trials, std::vector<std::size_t> rows)
{
    Q_EMIT layoutAboutToBeChanged({}, VerticalSortHint);
    const QModelIndexList before = persistentIndexList();
    std::vector<std::int64_t> numbers;
    for (const QModelIndex &index : before)
        numbers.push_back(at(index.row())->number);
    m_trials = std::move(trials);
    m_rows = std::move(rows);
    QModelIndexList after;
    for (int i = 0; i < before.size(); ++i)
        after << index(rowOf(numbers[static_cast<std::size_t>(i)]), before[i].column());
    changePersistentIndexList(before, after);
    Q_EMIT layoutChanged({}, VerticalSortHint);
}

void TrialModel::setUnits(const DisplayUnits &units)
{
    if (std::exchange(m_units, units) == units)
        return;
    Q_EMIT dataChanged(index(0, Stimulus), index(rowCount() - 1, Stimulus));
}

void TrialModel::setFilter(Filter filter)
{
    m_filter = filter;
    arrange();
}

void TrialModel::setLetters(std::int64_t a, std::int64_t b)
{
    if (a == m_a && b == m_b)
        return;
    m_a = a;
    m_b = b;
    if (rowCount() > 0)
        Q_EMIT dataChanged(index(0, Number), index(rowCount() - 1, Number));
}

void TrialModel::arrange()
{
    beginResetModel();
    m_rows = arranged(m_trials);
    endResetModel();
}

/// Places of what is listed, row by row.
std::vector<std::size_t> TrialModel::arranged(const std::vector<KeptTrial> &trials) const
{
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < trials.size(); ++i) {
        if (passes(trials[i], m_filter))
            rows.push_back(i);
    }
    std::vector<std::optional<double>> keys(trials.size());
    for (const std::size_t i : rows)
        keys[i] = sortKey(trials[i]);
    const bool up = m_order == Qt::AscendingOrder;
    std::ranges::stable_sort(rows, [&keys, up](std::size_t a, std::size_t b) {
        if (!keys[a] || !keys[b])
            return keys[a].has_value() && !keys[b].has_value();
        return up ? *keys[a] < *keys[b] : *keys[a] > *keys[b];
    });
    return rows;
}

std::optional<double> TrialModel::sortKey(const KeptTrial &kept) const
{
    const tuning::Metrics &metrics = kept.trial.metrics;
    switch (m_sortColumn) {
    case Star: return kept.star ? 1.0 : 0.0;
    case Time: return kept.time;
    case Stimulus: return std::abs(kept.trial.stimulus.to - kept.trial.stimulus.from);
    case GainP:
    case GainI:
    case GainD:
    case GainF: {
        const auto gain = gainOf(kept.trial, m_sortColumn);
        return gain ? std::optional(gain->value) : std::nullopt;
    }
    case Over: return metrics.overshoot;
    case Settle: return metrics.settle;
    case Rise: return metrics.rise;
    case Peak: return metrics.peakCurrent;
    case Flags: return static_cast<double>(kept.trial.flags.size());
    default: return static_cast<double>(kept.number);
    }
}

void TrialModel::sort(int column, Qt::SortOrder order)
{
    m_sortColumn = column;
    m_order = order;
    arrange();
}

const KeptTrial *TrialModel::find(std::int64_t number) const
{
    const auto found = std::ranges::find(m_trials, number, &KeptTrial::number);
    return found == m_trials.end() ? nullptr : &*found;
}

const KeptTrial *TrialModel::at(int row) const
{
    return row >= 0 && row < rowCount() ? &m_trials[m_rows[static_cast<std::size_t>(row)]] : nullptr;
}

int TrialModel::rowOf(std::int64_t number) const
{
    for (int row = 0; row < rowCount(); ++row) {
        if (at(row)->number == number)
            return row;
    }
    return -1;
}

const KeptTrial *TrialModel::best(double overshoot) const
{
    const KeptTrial *best = nullptr;
    for (const KeptTrial &kept : m_trials) {
        const bool good = isClean(kept.trial) && kept.trial.metrics.overshoot.value_or(1.0) <= overshoot;
        if (good && (!best || *kept.trial.metrics.settle < *best->trial.metrics.settle))
            best = &kept;
    }
    return best;
}

int TrialModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int TrialModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QString TrialModel::textOf(const KeptTrial &kept, int column) const
{
    const tuning::Metrics &metrics = kept.trial.metrics;
    switch (column) {
    case Number: {
        const QString letter = kept.number == m_b ? QStringLiteral("  B")
            : kept.number == m_a                  ? QStringLiteral("  A")
                                                  : QString();
        return QStringLiteral("#%1%2").arg(kept.number).arg(letter);
    }
    case Time: {
        const QDateTime time = momentOf(kept.time);
        return time.date() == QDate::currentDate() ? clockText(time) : dateAndClockText(time);
    }
    case Stimulus: return stimulusText(kept.trial, m_units);
    case GainP:
    case GainI:
    case GainD:
    case GainF: {
        const auto gain = gainOf(kept.trial, column);
        return gain ? shortNumber(*gain->row, gain->value) : QString(UnknownMark);
    }
    case Over: return orNone(percentText(metrics.overshoot));
    case Settle: return orNone(milliseconds(metrics.settle));
    case Rise: return orNone(milliseconds(metrics.rise));
    case Peak: return orNone(metrics.peakCurrent ? formatNumber(*metrics.peakCurrent, 1) : QString());
    case Flags: {
        QStringList words;
        for (const std::string &flag : kept.trial.flags)
            words << flagText(flag, kept.trial);
        return words.join(QStringLiteral(", "));
    }
    case Note: return QString::fromStdString(kept.note);
    case Use: return kept.trial.gains.empty() ? QString() : useText();
    default: return {};
    }
}

QVariant TrialModel::data(const QModelIndex &index, int role) const
{
    const KeptTrial *const kept = at(index.row());
    if (!kept)
        return {};
    const int column = index.column();
    const bool lettered = kept->number == m_a || kept->number == m_b;
    switch (role) {
    case NumberRole: return static_cast<qlonglong>(kept->number);
    case Qt::DisplayRole:
    case Qt::EditRole: return textOf(*kept, column);
    case Qt::DecorationRole:
        if (column == Flags)
            return flagIcon(*kept, m_theme.theme());
        return column == Star ? QVariant(symbolIcon(kept->star ? Symbol::StarFilled : Symbol::Star, m_theme.theme(),
                   kept->star ? Tone::Caution : Tone::Faint))
                              : QVariant();
    case Qt::ToolTipRole:
        if (column == Star)
            return kept->star ? tr("Take the star away") : tr("Give it a star");
        if (column == Use)
            return tr("Stages the gains of this trial; nothing is written yet.");
        return kept->trial.detail.empty() ? textOf(*kept, column) : messageText(kept->trial.detail);
    case Qt::AccessibleTextRole:
        return column == Star ? (kept->star ? tr("starred") : tr("no star"))
            : column == Use   ? tr("Use the gains of trial #%1").arg(kept->number)
                              : textOf(*kept, column);
    case Qt::TextAlignmentRole:
        return static_cast<int>(
            (column >= GainP && column <= Peak ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    case Qt::ForegroundRole: return toneOf(*kept, column, m_theme.theme());
    case Qt::BackgroundRole: return lettered ? QVariant(m_theme.theme().sel) : QVariant();
    case Qt::FontRole: {
        QFont bold;
        bold.setBold(true);
        return column == Number ? QVariant(bold) : QVariant();
    }
    default: return {};
    }
}

bool TrialModel::setData(const QModelIndex &index, const QVariant &value, int role)
{
    const KeptTrial *const kept = at(index.row());
    if (!kept || role != Qt::EditRole || index.column() != Note)
        return false;
    m_trials[m_rows[static_cast<std::size_t>(index.row())]].note = value.toString().toStdString();
    Q_EMIT noteWritten(kept->number, value.toString());
    Q_EMIT dataChanged(index, index);
    return true;
}

Qt::ItemFlags TrialModel::flags(const QModelIndex &index) const
{
    if (!index.isValid())
        return Qt::NoItemFlags;
    const Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
    return index.column() == Note ? flags | Qt::ItemIsEditable : flags;
}

QVariant TrialModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole)
        return static_cast<int>(
            (section >= GainP && section <= Peak ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    const QStringList names{QString(), tr("trial"), tr("time"), tr("stimulus"), QStringLiteral("P"),
        QStringLiteral("I"), QStringLiteral("D"), QStringLiteral("F"), tr("over %"), tr("settle"), tr("rise"),
        tr("peak A"), tr("flags"), tr("note"), QString()};
    const QString order = m_order == Qt::AscendingOrder ? QStringLiteral("▲") : QStringLiteral("▼");
    return section == m_sortColumn ? (names.value(section) + QLatin1Char(' ') + order).trimmed() : names.value(section);
}

} // namespace mb
