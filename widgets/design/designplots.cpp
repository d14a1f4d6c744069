// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/design/designplots.h"

#include "tuning/uncertainty.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/design/bodeplot.h"
#include "widgets/plots/curvelegend.h"
#include "widgets/plots/curveplot.h"

namespace mb {
namespace {

constexpr int stepLabelRoom = 78;   ///< units, as beside the Bode plot
constexpr double belowZero = -0.02; ///< of the step

} // namespace

DesignPlots::DesignPlots(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_bode(new BodePlot(theme, this))
    , m_names(new CurveLegend(theme, tr("Step"), this))
    , m_step(new CurvePlot(theme, tr("Step, predicted and measured"), this))
{
    m_step->setSurroundings({false, true, true, stepLabelRoom, true});
    auto *column = layoutIn<QVBoxLayout>(this, 0);
    column->addWidget(m_bode, 3);
    column->addWidget(separatorLine(Qt::Horizontal, this));
    column->addWidget(m_names);
    column->addWidget(m_step, 2);
}

void DesignPlots::setFoot(QWidget *foot)
{
    foot->setParent(this);
    layout()->addWidget(foot);
}

void DesignPlots::show(const tuning::TuneReport &report, const Shown &shown, const tuning::ProposalBasis &basis)
{
    const tuning::Proposal &proposal = shown.proposal;
    m_bode->setCompared(shown.compared ? std::optional(shown.compared->proposal.gains.made) : std::nullopt,
        shown.compared ? shown.compared->name : QString());
    m_bode->setLoop(report.loop, report.plant, proposal.gains.made, proposal.margins);
    const tuning::PredictionBand band
        = tuning::bandOf(proposal.predicted, report.loop, report.plant, tuning::errorsOf(report), proposal.gains.made,
            proposal.step, basis.envelope.duty.value_or(1.0), tuning::predictionPeriod(basis));
    StepCurves step = stepCurves(report, proposal, shown.name, band, shown.compared);
    m_step->setAxes(tr("s"), stepUnit(report.loop), false);
    m_step->setLeastRange(belowZero * proposal.step, step.highest);
    m_step->setBehind(step.behind);
    m_step->setCurves(step.curves);
    m_step->setMarks(step.marks);
    m_step->setNote(step.note);
    nameStep(step);
    m_step->fit();
}

void DesignPlots::nameStep(const StepCurves &step)
{
    std::vector<CurveLegend::Entry> entries;
    for (const std::vector<Curve> *curves : {&step.curves, &step.behind}) {
        for (const Curve &curve : *curves)
            entries.push_back(
                {curve.name, curve.look, curve.low.isEmpty() ? CurveLegend::Shape::Line : CurveLegend::Shape::Band});
    }
    m_names->setTitle(step.title);
    m_names->setEntries(entries);
}

void DesignPlots::setMeasured(const std::vector<tuning::FrequencyPoint> &points)
{
    m_bode->setMeasured(points);
}

void DesignPlots::clear()
{
    m_bode->setMeasured({});
    m_bode->clear();
    m_step->setBehind({});
    m_step->setCurves({});
    m_step->setMarks({});
    m_names->setTitle(tr("Step"));
    m_names->setEntries({});
    m_step->setNote(tr("What the gains will do appears here, before they are written."));
}

void DesignPlots::setWatermark(const QString &text)
{
    m_bode->setWatermark(text);
    m_step->setWatermark(text);
}

} // namespace mb
