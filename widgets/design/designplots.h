// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/frequencyresponse.h"
#include "tuning/proposals.h"
#include "widgets/common/theme.h"

#include <QWidget>

namespace mb {

class BodePlot;
class CurvePlot;

/// What one set of gains will do: the Bode plot of its loop, and its step with the band that the errors of the model leave.
class DesignPlots : public QWidget {
    Q_OBJECT
public:
    DesignPlots(const ThemeSource &theme, QWidget *parent);

    /// `name` of the set in front of people. What was measured of the same gains is drawn over it.
    void show(const tuning::TuneReport &report, const tuning::Proposal &proposal, const QString &name,
        const tuning::ProposalBasis &basis);
    /// A frequency response of the motor that is shown; empty: none was measured.
    void setMeasured(const std::vector<tuning::FrequencyPoint> &points);
    void clear();
    void setWatermark(const QString &text);

private:
    BodePlot *m_bode = nullptr;
    CurvePlot *m_step = nullptr;
};

} // namespace mb
