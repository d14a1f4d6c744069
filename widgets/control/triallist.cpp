// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/triallist.h"

#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/segmented.h"
#include "widgets/common/wraplayout.h"

#include <QApplication>
#include <QHeaderView>
#include <QMenu>
#include <QTableView>

#include <algorithm>
#include <array>

namespace mb {
namespace {

constexpr int mostMeasured = 100;      ///< rows whose texts decide how wide the columns are
constexpr double bestOvershoot = 0.05; ///< the most that the best may have
/// In this order, where there is no room.
constexpr std::array givesWay{TrialModel::Time, TrialModel::Peak, TrialModel::Rise, TrialModel::Stimulus};

bool gives(int column)
{
    return std::ranges::find(givesWay, column) != givesWay.end();
}

} // namespace

TrialList::TrialList(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
    , m_model(new TrialModel(theme, this))
{
    auto *column = layoutIn<QVBoxLayout>(this, 0);
    m_table = new QTableView(this);
    m_head = buildHead();
    column->addWidget(m_head);
    column->addWidget(m_table, 1);
    configure();
    connect(m_model, &QAbstractItemModel::modelReset, this, &TrialList::say);
    connect(&theme, &ThemeSource::changed, this, &TrialList::fit);
    fit();
    say();
}

QWidget *TrialList::buildHead()
{
    const Theme &theme = m_theme.theme();
    auto *head = new QWidget(this);
    auto *row = new WrapLayout(head);
    row->setContentsMargins(theme.u(12), theme.u(4), theme.u(12), theme.u(4));
    m_words = textLabel({}, TextRole::Caption, Tone::Dim, head);
    m_filter = new Segmented(tr("Which trials"), {tr("All"), tr("Starred"), tr("Clean")}, head);
    m_best = new CommandButton(m_theme, Symbol::Undo, tr("Back to best"), head);
    m_best->setToolTip(
        tr("Stages the gains of the quickest clean trial with no more than 5 % overshoot; runs nothing."));
    m_export = new IconButton(m_theme, Symbol::Export, tr("Export the trials as CSV or JSON"), head);
    row->addWidget(new SectionLabel(tr("Trials"), head));
    row->addWidget(m_words);
    row->addSpring();
    row->addWidget(m_filter);
    row->addWidget(m_best);
    row->addWidget(m_export);
    connect(m_filter, &Segmented::currentChanged, this,
        [this](int filter) { m_model->setFilter(static_cast<TrialModel::Filter>(filter)); });
    connect(m_best, &QPushButton::clicked, this, [this] {
        if (const KeptTrial *best = m_model->best(bestOvershoot))
            Q_EMIT useRequested(best->number);
    });
    connect(m_export, &QToolButton::clicked, this, &TrialList::exportRequested);
    return head;
}

void TrialList::configure()
{
    m_table->setModel(m_model);
    m_table->setAccessibleName(tr("Trials of this loop"));
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::SelectedClicked);
    m_table->setShowGrid(false);
    m_table->setProperty("dense", true);
    m_table->setWordWrap(false);
    m_table->setSortingEnabled(true);
    m_table->horizontalHeader()->setSortIndicatorShown(false); // the heads say it beside their words
    m_table->setContextMenuPolicy(Qt::CustomContextMenu);
    m_table->verticalHeader()->hide();
    QHeaderView &head = *m_table->horizontalHeader();
    head.setSortIndicator(TrialModel::Number, Qt::DescendingOrder);
    head.setSectionResizeMode(QHeaderView::Interactive);
    head.setMinimumSectionSize(m_theme.theme().u(24));
    head.setSectionResizeMode(TrialModel::Note, QHeaderView::Stretch);
    m_empty = textLabel(tr("Every experiment appears here with its gains and what became of it."), TextRole::Body,
        Tone::Faint, m_table->viewport());
    auto *middle = new QVBoxLayout(m_table->viewport());
    middle->addWidget(m_empty, 0, Qt::AlignCenter);
    connect(m_table, &QTableView::clicked, this, &TrialList::clicked);
    connect(m_table, &QTableView::activated, this, [this](const QModelIndex &index) {
        if (index.column() == TrialModel::Use)
            clicked(index);
        else
            Q_EMIT chosen(index.data(TrialModel::NumberRole).toLongLong(), false);
    });
    connect(m_table, &QWidget::customContextMenuRequested, this, &TrialList::openMenu);
}

void TrialList::fit()
{
    const Theme &theme = m_theme.theme();
    const int row = std::max(theme.u(26), fontMetrics().height() + theme.u(6));
    m_table->verticalHeader()->setDefaultSectionSize(row);
    const int rows = m_table->horizontalHeader()->sizeHint().height() + m_rows * row + theme.u(4);
    m_table->setMinimumHeight(m_filling ? 0 : rows);
    m_table->setMaximumHeight(m_filling ? QWIDGETSIZE_MAX : rows);
    fitColumns();
    fitHead();
}

/// As wide as what may stand in them. What has no room gives way: it is among the metrics of A and B, or in the tooltip.
void TrialList::fitColumns()
{
    const Theme &theme = m_theme.theme();
    const QFontMetrics caption(theme.font(TextRole::Caption, font()));
    std::array<int, TrialModel::ColumnCount> widths{};
    const auto fitTo = [&](int column, const QString &widest) {
        const QString name = m_model->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
        const int head = caption.horizontalAdvance(name);
        widths.at(static_cast<std::size_t>(column))
            = std::max(fontMetrics().horizontalAdvance(widest), head) + theme.u(10) + 8;
    };
    widths[TrialModel::Star] = theme.u(32);
    QFont bold = font();
    bold.setBold(true);
    fitTo(TrialModel::Number, QStringLiteral("#9999  B"));
    widths[TrialModel::Number] += QFontMetrics(bold).horizontalAdvance(QStringLiteral("#9999  B"))
        - fontMetrics().horizontalAdvance(QStringLiteral("#9999  B"));
    for (int column = TrialModel::Time; column <= TrialModel::Peak; ++column)
        fitTo(column, widestOf(column));
    fitTo(TrialModel::Flags, widestOf(TrialModel::Flags, tr("stopped: speed")));
    widths[TrialModel::Flags] += theme.u(20); // the sign before it
    fitTo(TrialModel::Note, QStringLiteral("000000"));
    fitTo(TrialModel::Use, m_model->useText());
    for (const int column : {TrialModel::GainD, TrialModel::GainF})
        m_table->setColumnHidden(column, !m_model->usesGain(column));
    int sum = 0;
    for (int column = 0; column < TrialModel::ColumnCount; ++column)
        sum += m_table->isColumnHidden(column) && !gives(column) ? 0 : widths.at(static_cast<std::size_t>(column));
    const int room = width() - theme.u(14); // a scroll bar may come
    std::vector<int> gone;
    for (const int column : givesWay) {
        const bool tooWide = sum > room;
        sum -= tooWide ? widths.at(static_cast<std::size_t>(column)) : 0;
        m_table->setColumnHidden(column, tooWide);
        if (tooWide)
            gone.insert(gone.begin(), column);
    }
    for (const int column : gone) { // a wide one may have made room for a narrow one that went before it
        const int width = widths.at(static_cast<std::size_t>(column));
        if (sum + width > room)
            continue;
        sum += width;
        m_table->setColumnHidden(column, false);
    }
    for (int column = 0; column < TrialModel::ColumnCount; ++column) {
        if (column != TrialModel::Note)
            m_table->setColumnWidth(column, widths.at(static_cast<std::size_t>(column)));
    }
}

/// Of the first hundred rows: what one sees before one scrolls; no text counts for more than `most`.
QString TrialList::widestOf(int column, const QString &most) const
{
    QString widest = QStringLiteral("000.0");
    for (int row = 0; row < std::min(m_model->rowCount(), mostMeasured); ++row) {
        const QString text = m_model->index(row, column).data().toString();
        if (!most.isEmpty() && fontMetrics().horizontalAdvance(text) > fontMetrics().horizontalAdvance(most))
            return most;
        if (fontMetrics().horizontalAdvance(text) > fontMetrics().horizontalAdvance(widest))
            widest = text;
    }
    return widest;
}

/// The words of the head go first, what is wrong with the notebook never.
void TrialList::fitHead()
{
    const bool shown = !m_words->isHidden();
    const int words = m_words->sizeHint().width() + m_theme.theme().u(8);
    const int all = m_head->layout()->sizeHint().width() + (shown ? 0 : words);
    m_words->setVisible(!m_trouble.isEmpty() || all <= width());
}

void TrialList::setFilling(bool filling)
{
    if (std::exchange(m_filling, filling) == filling)
        return;
    fit();
}

void TrialList::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    fitColumns();
    fitHead();
}

void TrialList::setRows(int rows)
{
    if (std::exchange(m_rows, rows) == rows)
        return;
    fit();
}

void TrialList::setTrials(std::vector<KeptTrial> trials)
{
    const qint64 before = current();
    m_model->setTrials(std::move(trials));
    const int row = m_model->rowOf(before);
    if (row >= 0 && current() != before)
        m_table->selectRow(row);
    say();
}

void TrialList::setLetters(std::int64_t a, std::int64_t b)
{
    m_model->setLetters(a, b);
    m_table->viewport()->update(); // not as changed data, which would take the words of a note that is being written
}

void TrialList::setTrouble(const QString &text)
{
    m_trouble = text;
    say();
}

void TrialList::say()
{
    const int all = m_model->countOf(TrialModel::Filter::All);
    m_words->setText(!m_trouble.isEmpty() ? m_trouble
            : all == 0                    ? QString()
                                          : tr("%n, every run is kept", nullptr, all));
    setTone(*m_words, m_trouble.isEmpty() ? Tone::Dim : Tone::Caution);
    m_filter->setText(0, tr("All %1").arg(all));
    m_filter->setText(1, tr("Starred %1").arg(m_model->countOf(TrialModel::Filter::Starred)));
    m_filter->setText(2, tr("Clean %1").arg(m_model->countOf(TrialModel::Filter::Clean)));
    const KeptTrial *const best = m_model->best(bestOvershoot);
    m_best->setText(best ? tr("Back to best #%1").arg(best->number) : tr("Back to best"));
    m_best->setEnabled(best);
    m_export->setEnabled(all > 0);
    m_empty->setVisible(m_model->rowCount() == 0);
    fitColumns();
    fitHead();
}

qint64 TrialList::current() const
{
    const auto *selection = m_table->selectionModel();
    const QModelIndexList rows = selection ? selection->selectedRows() : QModelIndexList{};
    return rows.isEmpty() ? 0 : rows.first().data(TrialModel::NumberRole).toLongLong();
}

void TrialList::clicked(const QModelIndex &index)
{
    const KeptTrial *const kept = m_model->at(index.row());
    if (!kept)
        return;
    const qint64 number = kept->number;
    if (index.column() == TrialModel::Star)
        Q_EMIT m_model->starChosen(number, !kept->star);
    else if (index.column() == TrialModel::Use && !kept->trial.gains.empty())
        Q_EMIT useRequested(number);
    else
        Q_EMIT chosen(number, QApplication::keyboardModifiers().testFlag(Qt::ShiftModifier));
}

void TrialList::openMenu(const QPoint &at)
{
    const KeptTrial *const kept = m_model->at(m_table->indexAt(at).row());
    if (!kept)
        return;
    const qint64 number = kept->number;
    auto *menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(tr("Show as B"), this, [this, number] { Q_EMIT chosen(number, false); });
    menu->addAction(tr("Pin as A  A"), this, [this, number] { Q_EMIT chosen(number, true); });
    menu->addAction(tr("Use these gains"), this, [this, number] { Q_EMIT useRequested(number); });
    menu->addAction(kept->star ? tr("Take the star away") : tr("Give it a star"), this,
        [this, number, star = !kept->star] { Q_EMIT m_model->starChosen(number, star); });
    menu->addAction(tr("Edit the note"), this,
        [this, number] { m_table->edit(m_model->index(m_model->rowOf(number), TrialModel::Note)); });
    menu->addSeparator();
    menu->addAction(tr("Forget this trial"), this, [this, number] { Q_EMIT deleteRequested(number); });
    menu->popup(m_table->viewport()->mapToGlobal(at));
}

} // namespace mb
