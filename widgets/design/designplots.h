// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/frequencyresponse.h"
#include "tuning/proposals.h"
#include "widgets/design/stepcurves.h"

#include <QWidget>

namespace mb {

class BodePlot;
class CurveLegend;
class CurvePlot;

/// What one set of gains will do: the Bode plot of its loop, and its step with the band that the errors of the model leave; each below
/// the names of its lines.
class DesignPlots : public QWidget {
    Q_OBJECT
public:
    DesignPlots(const ThemeSource &theme, QWidget *parent);

    /// One set in front of people, and what it is compared with. What was measured of the same gains is drawn over it.
    struct Shown {
        const tuning::Proposal &proposal;
        QString name;
        std::optional<ComparedGains> compared{};
    };
    void show(const tuning::TuneReport &report, const Shown &shown, const tuning::ProposalBasis &basis);
    /// A frequency response of the motor that is shown; empty: none was measured.
    void setMeasured(const std::vector<tuning::FrequencyPoint> &points);
    void clear();
    void setWatermark(const QString &text);
    /// Below the plots: an order that measures what they show. Takes it.
    void setFoot(QWidget *foot);

private:
    void nameStep(const StepCurves &step);

    BodePlot *m_bode = nullptr;
    CurveLegend *m_names = nullptr;
    CurvePlot *m_step = nullptr;
};

} // namespace mb
