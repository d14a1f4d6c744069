// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/trialsview.h"

#include "experiment/verdict.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/guarded.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/segmented.h"
#include "widgets/control/advicepanel.h"
#include "widgets/control/metricspanel.h"
#include "widgets/control/responseplot.h"
#include "widgets/control/triallist.h"
#include "widgets/control/trialorders.h"
#include "widgets/control/trialshead.h"

#include <QScrollArea>
#include <QStackedWidget>

#include <algorithm>
#include <utility>

namespace mb {
namespace {

constexpr int metricsWidth = 400;
constexpr int leastMetrics = 272;
constexpr int leastPlot = 480; ///< beside metrics that have what they need
constexpr double metricsShare = 0.4;
constexpr double mostMetrics = 0.5;
constexpr int roomBeside = 700; ///< for plot and metrics beside each other
constexpr int leastBeside = 640;
constexpr int tallHeight = 620;

} // namespace

TrialsView::TrialsView(Workbench &workbench, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_notebook(workbench.trials())
    , m_theme(theme)
{
    auto *column = layoutIn<QVBoxLayout>(this, 0);
    m_plot = new ResponsePlot(theme, this);
    m_head = new TrialsHead(m_plot->stack(), theme, this);
    column->addWidget(m_head);
    buildSide();
    auto *top = new QHBoxLayout;
    top->setSpacing(0);
    top->addWidget(m_plot, 1);
    top->addWidget(m_side);
    column->addLayout(top, 1);
    buildFoot();
    for (QWidget *const part : {m_footLine, static_cast<QWidget *>(m_below), static_cast<QWidget *>(m_foot)})
        column->addWidget(part);
    connect(new TrialOrders(workbench, *m_list), &TrialOrders::changed, this, &TrialsView::reload);
    connect(m_head, &TrialsHead::flipRequested, this, &TrialsView::flip);
    connect(m_head, &TrialsHead::pinRequested, this, &TrialsView::pinCurrent);
    connect(m_plot, &ResponsePlot::roomChanged, this, &TrialsView::drawPlot);
    connect(&theme, &ThemeSource::changed, this, &TrialsView::arrange);
    arrange();
}

void TrialsView::buildSide()
{
    m_side = new QWidget(this);
    auto *side = layoutIn<QHBoxLayout>(m_side, 0);
    side->addWidget(separatorLine(Qt::Vertical, m_side));
    m_numbers = new QScrollArea(m_side); // so that they never ask for more height than there is
    m_numbers->setWidgetResizable(true);
    m_numbers->setFrameShape(QFrame::NoFrame);
    m_numbers->setFocusPolicy(Qt::NoFocus);
    m_metrics = new MetricsPanel(m_theme, m_numbers);
    m_numbers->setWidget(m_metrics);
    side->addWidget(m_numbers, 1);
    m_advice = new AdvicePanel(m_theme, m_metrics);
    m_metrics->append(m_advice);
    connect(m_metrics, &MetricsPanel::leastWidthChanged, this, &TrialsView::arrange);
    connect(m_advice, &AdvicePanel::stageRequested, this,
        [this](const tuning::Advice &advice) { Q_EMIT stageRequested(advice.changes); });
}

void TrialsView::buildFoot()
{
    m_footLine = separatorLine(Qt::Horizontal, this);
    m_below = new Segmented(tr("Below the plot"), {tr("Trials"), tr("Metrics")}, this);
    m_below->hide();
    m_foot = new QStackedWidget(this);
    m_list = new TrialList(m_theme, m_foot);
    m_foot->addWidget(m_list);
    connect(m_below, &Segmented::currentChanged, m_foot, &QStackedWidget::setCurrentIndex);
    connect(m_list, &TrialList::chosen, this, [this](qint64 number, bool asA) { asA ? pin(number) : select(number); });
    connect(m_list, &TrialList::useRequested, this, [this](qint64 number) {
        if (const KeptTrial *kept = m_list->model().find(number))
            Q_EMIT useRequested(*kept);
    });
}

/// Metrics beside the plot where there is room; else they share the place of the trials, so that the plot stays large.
void TrialsView::arrange()
{
    const Theme &theme = m_theme.theme();
    const bool beside = m_shown == Shown::All
        && width() >= theme.u(m_beside ? leastBeside : roomBeside); // a bar that comes and goes changes nothing
    m_list->setRows(!beside ? 2 : height() > theme.u(tallHeight) ? 5 : 3);
    const int wished = std::min(static_cast<int>(width() * metricsShare), width() - theme.u(leastPlot));
    const int share = std::min(std::max(wished, m_metrics->leastWidth()), static_cast<int>(width() * mostMetrics));
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
    m_plot->setHead(!all); // where the head above has no room
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
    if (std::exchange(m_shown, shown) == shown)
        return;
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
    m_pair = {};
    m_list->setFamily(family);
    m_list->setTrials({});
    draw();
    reload();
}

void TrialsView::setUnits(const DisplayUnits &units)
{
    if (std::exchange(m_units, units) == units)
        return;
    m_list->setUnits(units);
    draw();
}

void TrialsView::reload()
{
    if (m_unit.empty())
        return;
    m_notebook.list(m_unit, guarded(this, [this, unit = m_unit](const Result<std::vector<KeptTrial>> &all) {
        if (m_unit != unit)
            return;
        m_list->setTrouble(all ? QString() : tr("not kept: %1").arg(errorText(all.error())));
        if (all)
            listed(*all);
    }));
}

void TrialsView::listed(const std::vector<KeptTrial> &trials)
{
    std::vector<KeptTrial> mine;
    std::copy_if(trials.begin(), trials.end(), std::back_inserter(mine),
        [this](const KeptTrial &kept) { return kept.trial.mode == m_mode && kept.trial.axis == m_axis; });
    std::int64_t pushed = 0;
    for (const KeptTrial &kept : trials) {
        if (kept.trial.mode == Mode::Duty && kept.trial.axis == m_axis && kept.trial.reason == tuning::EndReason::Done)
            pushed = kept.number;
    }
    m_list->setIdentified(pushed);
    const bool isLetGo = m_pair.update(mine);
    const std::int64_t newest = mine.empty() ? 0 : mine.back().number;
    m_list->setTrials(std::move(mine));
    if (isLetGo)
        draw();
    if (!m_pair.b() && newest > 0)
        fetch(newest, false);
}

void TrialsView::fetch(std::int64_t number, bool asA)
{
    const KeptTrial *const kept = m_list->model().find(number);
    if (!kept)
        return;
    m_notebook.fetch(
        number, guarded(this, [this, found = *kept, asA](const Result<std::vector<tuning::Signal>> &recorded) {
            if (!recorded || !m_list->model().find(found.number))
                return;
            KeptTrial whole = found;
            whole.trial.signals = *recorded;
            asA ? m_pair.setA(std::move(whole)) : m_pair.setB(std::move(whole));
            draw();
        }));
}

void TrialsView::pin(std::int64_t number)
{
    m_pair.pin();
    fetch(number, true);
}

void TrialsView::select(std::int64_t number)
{
    fetch(number, false);
}

void TrialsView::flip()
{
    m_pair.flip();
    draw();
}

void TrialsView::pinCurrent()
{
    if (!m_pair.b())
        return;
    m_pair.pinCurrent();
    draw();
}

void TrialsView::showMeasured(const tuning::Trial &trial)
{
    if (trial.mode != m_mode || trial.axis != m_axis)
        return; // another loop was chosen while it ran
    m_pair.measured(trial);
    draw();
}

void TrialsView::addFinished(const tuning::Trial &trial)
{
    showMeasured(trial);
    reload();
}

void TrialsView::drawPlot()
{
    m_plot->setTrials(m_family, m_pair.comparedA(), b(), m_units);
    m_head->show(m_pair, m_plot->legend());
}

void TrialsView::draw()
{
    drawPlot();
    m_advice->setTrial(m_family, b() ? &b()->trial : nullptr);
    m_metrics->setTrials(m_pair.comparedA(), b(), m_advice->windup());
    m_list->setLetters(a() ? a()->number : 0, b() ? b()->number : 0);
    Q_EMIT changed();
}

} // namespace mb
