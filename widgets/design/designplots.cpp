// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/design/designplots.h"

#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/design/bodeplot.h"
#include "widgets/design/stepcurves.h"
#include "widgets/plots/curveplot.h"

namespace mb {
namespace {

QString unitWord(Mode loop)
{
    return loop == Mode::Velocity ? DesignPlots::tr("counts/s")
        : loop == Mode::Current   ? DesignPlots::tr("A")
                                  : DesignPlots::tr("counts");
}

} // namespace

DesignPlots::DesignPlots(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
{
    auto *column = layoutIn<QVBoxLayout>(this, 0);
    m_bode = new BodePlot(theme, this);
    m_step = new CurvePlot(theme, tr("Step, predicted and measured"), this);
    m_step->setLegendPlace(Qt::AlignBottom | Qt::AlignRight);
    column->addWidget(m_bode, 7);
    column->addWidget(separatorLine(Qt::Horizontal, this));
    column->addWidget(m_step, 4);
}

void DesignPlots::show(const tuning::TuneReport &report, const tuning::Proposal &proposal, const QString &name,
    const tuning::ProposalBasis &basis)
{
    m_bode->setLoop(report.loop, report.plant, proposal.gains.made, proposal.margins);
    const tuning::PredictionBand band
        = tuning::bandOf(proposal.predicted, report.loop, report.plant, tuning::errorsOf(report.motor),
            proposal.gains.made, proposal.step, basis.envelope.duty.value_or(1.0), tuning::predictionPeriod(basis));
    const StepCurves step = stepCurves(report, proposal, name, band);
    m_step->setAxes(tr("s"), unitWord(report.loop), false);
    m_step->setCurves(step.curves);
    m_step->setNote(step.note);
    m_step->fit();
}

void DesignPlots::setMeasured(const std::vector<tuning::FrequencyPoint> &points)
{
    m_bode->setMeasured(points);
}

void DesignPlots::clear()
{
    m_bode->clear();
    m_step->setCurves({});
    m_step->setNote(tr("What the gains will do appears here, before they are written."));
}

void DesignPlots::setWatermark(const QString &text)
{
    m_bode->setWatermark(text);
    m_step->setWatermark(text);
}

} // namespace mb
