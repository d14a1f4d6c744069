// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/trialsview.h"

#include "tuning/verdict.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/segmented.h"
#include "widgets/control/advicepanel.h"
#include "widgets/control/metricspanel.h"
#include "widgets/control/responseplot.h"
#include "widgets/control/triallist.h"
#include "widgets/plots/plotstack.h"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QPointer>
#include <QScrollArea>
#include <QStackedWidget>
#include <QStandardPaths>

#include <algorithm>
#include <utility>

namespace mb {
namespace {

constexpr int metricsWidth = 400;
constexpr int leastMetrics = 296;
constexpr double metricsShare = 0.4;
constexpr double mostMetrics = 0.5;
constexpr int roomBeside = 700; ///< for plot and metrics beside each other
constexpr int leastBeside = 640;
constexpr int roomyHeight = 620;

bool isSameStimulus(const tuning::Trial &a, const tuning::Trial &b)
{
    return a.stimulus.profile == b.stimulus.profile && a.stimulus.from == b.stimulus.from
        && a.stimulus.to == b.stimulus.to;
}

} // namespace

TrialsView::TrialsView(Workbench &workbench, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_workbench(workbench)
    , m_notebook(workbench.trials())
    , m_theme(theme)
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    m_plot = new ResponsePlot(theme, this);
    m_head = buildHead();
    column->addWidget(m_head);
    auto *top = new QHBoxLayout;
    top->setSpacing(0);
    connect(m_plot, &ResponsePlot::roomChanged, this, &TrialsView::drawPlot);
    m_side = new QWidget(this);
    auto *side = new QHBoxLayout(m_side);
    side->setContentsMargins(0, 0, 0, 0);
    side->setSpacing(0);
    side->addWidget(separatorLine(Qt::Vertical, m_side));
    m_numbers = new QScrollArea(m_side); // so that they never ask for more height than there is
    m_numbers->setWidgetResizable(true);
    m_numbers->setFrameShape(QFrame::NoFrame);
    m_numbers->setFocusPolicy(Qt::NoFocus);
    m_metrics = new MetricsPanel(theme, m_numbers);
    m_numbers->setWidget(m_metrics);
    side->addWidget(m_numbers, 1);
    m_advice = new AdvicePanel(theme, m_metrics);
    m_metrics->append(m_advice);
    connect(m_advice, &AdvicePanel::stageRequested, this,
        [this](const tuning::Advice &advice) { Q_EMIT stageRequested(advice.changes); });
    top->addWidget(m_plot, 1);
    top->addWidget(m_side);
    column->addLayout(top, 1);
    m_footLine = separatorLine(Qt::Horizontal, this);
    column->addWidget(m_footLine);
    m_below = new Segmented(tr("Below the plot"), {tr("Trials"), tr("Metrics")}, this);
    m_below->hide();
    column->addWidget(m_below);
    m_foot = new QStackedWidget(this);
    m_list = new TrialList(theme, m_foot);
    m_foot->addWidget(m_list);
    column->addWidget(m_foot);
    connect(m_below, &Segmented::currentChanged, m_foot, &QStackedWidget::setCurrentIndex);
    connect(&theme, &ThemeSource::changed, this, &TrialsView::arrange);
    connect(m_metrics, &MetricsPanel::leastWidthChanged, this, &TrialsView::arrange);
    connectList();
    arrange();
}

QWidget *TrialsView::buildHead()
{
    const Theme &theme = m_theme.theme();
    auto *head = new QWidget(this);
    auto *row = new QHBoxLayout(head);
    row->setContentsMargins(theme.u(12), theme.u(2), theme.u(8), theme.u(2));
    m_words = textLabel({}, TextRole::Caption, Tone::Dim, head);
    auto *flipping = new IconButton(m_theme, Symbol::Swap, tr("Flip A and B"), head);
    flipping->setKeyHint(QStringLiteral("B"));
    auto *pinning = new IconButton(m_theme, Symbol::Pin, tr("Pin B as A"), head);
    pinning->setKeyHint(QStringLiteral("A"));
    auto *cursors = new IconButton(m_theme, Symbol::Cursors, tr("Cursors A and B"), head);
    cursors->setKeyHint(QStringLiteral("L"));
    cursors->setCheckable(true);
    auto *fit = new IconButton(m_theme, Symbol::Fit, tr("Fit time and value"), head);
    fit->setKeyHint(QStringLiteral("0"));
    row->addWidget(m_words, 1);
    for (IconButton *button : {flipping, pinning, cursors, fit})
        row->addWidget(button);
    connect(flipping, &QToolButton::clicked, this, &TrialsView::flip);
    connect(pinning, &QToolButton::clicked, this, &TrialsView::pinCurrent);
    connect(cursors, &QToolButton::toggled, this, [this](bool shown) { m_plot->stack().setCursorsShown(shown); });
    connect(&m_plot->stack(), &PlotStack::cursorsChanged, cursors,
        [this, cursors] { cursors->setChecked(m_plot->stack().cursorsShown()); });
    connect(fit, &QToolButton::clicked, this, [this] { m_plot->stack().fit(); });
    return head;
}

void TrialsView::connectList()
{
    connect(m_list, &TrialList::chosen, this, [this](qint64 number, bool asA) { asA ? pin(number) : select(number); });
    connect(m_list, &TrialList::useRequested, this, [this](qint64 number) {
        if (const KeptTrial *kept = m_list->model().find(number))
            Q_EMIT useRequested(*kept);
    });
    const auto finished = [self = QPointer<TrialsView>(this)](const Result<void> &result) {
        if (self)
            self->failed(result);
    };
    connect(&m_list->model(), &TrialModel::starChosen, this, [this, finished](qint64 number, bool star) {
        m_notebook.setStar(number, star, finished);
        reload();
    });
    connect(&m_list->model(), &TrialModel::noteWritten, this,
        [this, finished](qint64 number, const QString &note) { m_notebook.setNote(number, note, finished); });
    connect(m_list, &TrialList::deleteRequested, this, [this, finished](qint64 number) {
        m_notebook.remove(number, finished);
        reload();
    });
    connect(m_list, &TrialList::exportRequested, this, &TrialsView::exportAll);
}

void TrialsView::failed(const Result<void> &result)
{
    if (!result)
        m_workbench.report(Severity::Danger, {}, tr("the notebook: %1").arg(errorText(result.error())));
}

void TrialsView::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    arrange();
}

/// Metrics beside the plot where there is room; else they share the place of the trials, so that the plot stays large.
void TrialsView::arrange()
{
    const Theme &theme = m_theme.theme();
    const bool beside = m_shown == Shown::All
        && width() >= theme.u(m_beside ? leastBeside : roomBeside); // a bar that comes and goes changes nothing
    m_list->setRows(!beside ? 2 : height() > theme.u(roomyHeight) ? 5 : 3);
    const int share = std::min(std::max(static_cast<int>(width() * metricsShare), m_metrics->leastWidth()),
        static_cast<int>(width() * mostMetrics));
    m_side->setFixedWidth(std::clamp(share, theme.u(leastMetrics), theme.u(metricsWidth)));
    showParts(beside);
    if (std::exchange(m_beside, beside) == beside)
        return;
    if (beside) {
        m_side->layout()->addWidget(m_numbers);
        m_below->setCurrent(0);
        m_foot->setCurrentIndex(0);
    } else {
        m_foot->addWidget(m_numbers);
    }
    m_numbers->show();
}

void TrialsView::showParts(bool beside)
{
    const bool all = m_shown == Shown::All;
    const bool list = m_shown == Shown::Trials || m_shown == Shown::Metrics;
    m_head->setVisible(all);
    m_plot->setVisible(!list);
    m_side->setVisible(all && beside);
    m_footLine->setVisible(all);
    m_below->setVisible(all && !beside);
    m_foot->setVisible(all || list);
    if (all)
        m_foot->setFixedHeight(std::max(m_list->sizeHint().height(), m_list->heightForWidth(width())));
    else
        m_foot->setMaximumHeight(QWIDGETSIZE_MAX);
    if (!all)
        m_foot->setMinimumHeight(0);
    m_list->setFilling(list);
    if (list)
        m_foot->setCurrentIndex(m_shown == Shown::Trials ? 0 : 1);
    else if (all && !beside)
        m_foot->setCurrentIndex(m_below->current());
}

void TrialsView::setShown(Shown shown)
{
    if (shown == m_shown)
        return;
    m_shown = shown;
    arrange();
}

void TrialsView::choose(const Family *family, const std::string &unit, int axis, Mode mode)
{
    if (family == m_family && unit == m_unit && axis == m_axis && mode == m_mode)
        return;
    m_family = family;
    m_unit = unit;
    m_axis = axis;
    m_mode = mode;
    m_a.reset();
    m_b.reset();
    m_pinned = false;
    m_list->setTrials({});
    draw();
    reload();
}

void TrialsView::setUnits(const DisplayUnits &units)
{
    if (units == m_units)
        return;
    m_units = units;
    m_list->setUnits(units);
    draw();
}

void TrialsView::reload()
{
    if (m_unit.empty())
        return;
    m_notebook.list(
        m_unit, [self = QPointer<TrialsView>(this), unit = m_unit](const Result<std::vector<KeptTrial>> &all) {
            if (!self || self->m_unit != unit)
                return;
            self->m_list->setTrouble(all ? QString() : TrialsView::tr("not kept: %1").arg(errorText(all.error())));
            if (all)
                self->listed(*all);
        });
}

void TrialsView::listed(const std::vector<KeptTrial> &trials)
{
    std::vector<KeptTrial> mine;
    std::copy_if(trials.begin(), trials.end(), std::back_inserter(mine),
        [this](const KeptTrial &kept) { return kept.trial.mode == m_mode && kept.trial.axis == m_axis; });
    for (std::optional<KeptTrial> *shown : {&m_a, &m_b}) { // star and note may be others by now
        const auto found = std::find_if(mine.begin(), mine.end(),
            [shown](const KeptTrial &kept) { return *shown && kept.number == (*shown)->number; });
        if (found != mine.end()) {
            (*shown)->star = found->star;
            (*shown)->note = found->note;
            (*shown)->time = found->time;
        }
    }
    const std::int64_t newest = mine.empty() ? 0 : mine.back().number;
    m_list->setTrials(std::move(mine));
    if (!m_b && newest > 0)
        fetch(newest, false);
}

void TrialsView::fetch(std::int64_t number, bool asA)
{
    const KeptTrial *const kept = m_list->model().find(number);
    if (!kept)
        return;
    m_notebook.fetch(number,
        [self = QPointer<TrialsView>(this), found = *kept, asA](const Result<std::vector<tuning::Signal>> &recorded) {
            if (!self || !recorded || !self->m_list->model().find(found.number))
                return;
            std::optional<KeptTrial> &place = asA ? self->m_a : self->m_b;
            place = found;
            place->trial.signals = *recorded;
            self->draw();
        });
}

void TrialsView::pin(std::int64_t number)
{
    m_pinned = true;
    fetch(number, true);
}

void TrialsView::select(std::int64_t number)
{
    fetch(number, false);
}

void TrialsView::flip()
{
    std::swap(m_a, m_b);
    draw();
}

void TrialsView::pinCurrent()
{
    if (!m_b)
        return;
    m_a = m_b;
    m_pinned = true;
    draw();
}

void TrialsView::showMeasured(const tuning::Trial &trial)
{
    if (!m_pinned && m_b && trial.number != m_b->number && m_b->trial.metrics.settle)
        m_a = m_b;
    KeptTrial kept;
    kept.number = trial.number.value_or(0);
    kept.trial = trial;
    m_b = kept;
    draw();
}

void TrialsView::addFinished(const tuning::Trial &trial)
{
    showMeasured(trial);
    reload();
}

bool TrialsView::isComparable() const
{
    return m_a && m_b && isSameStimulus(m_a->trial, m_b->trial);
}

void TrialsView::drawPlot()
{
    m_plot->setTrials(m_family, m_a && m_b && !isComparable() ? nullptr : a(), b(), m_units);
}

void TrialsView::draw()
{
    const bool other = m_a && m_b && !isComparable();
    const KeptTrial *const shownA = other ? nullptr : a();
    m_words->setText(!m_b ? tr("No trial yet. F5 runs the first.")
            : other       ? tr("A #%1 is another stimulus, it is not drawn").arg(m_a->number)
            : m_a && m_b  ? tr("A #%1 against B #%2").arg(m_a->number).arg(m_b->number)
                          : tr("B #%1; Shift+click on a trial pins it as A").arg(m_b->number));
    drawPlot();
    m_advice->setTrial(m_family, m_b ? &m_b->trial : nullptr);
    m_metrics->setTrials(shownA, b(), m_advice->windup());
    m_list->setLetters(m_a ? m_a->number : 0, m_b ? m_b->number : 0);
    Q_EMIT changed();
}

/// Every trial of this loop; the rest of the notebook is the console's.
void TrialsView::exportAll()
{
    auto *dialog = new QFileDialog(this, tr("Export trials"),
        QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation), tr("Table (*.csv);;JSON (*.json)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("csv"));
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString &path) {
        m_notebook.exportTo(
            path, m_list->model().trials(), [self = QPointer<TrialsView>(this), path](const Result<void> &result) {
                if (self && result)
                    self->m_workbench.report(Severity::Good, {}, TrialsView::tr("trials written to %1").arg(path));
                else if (self)
                    self->failed(result);
            });
    });
    dialog->open();
}

} // namespace mb
