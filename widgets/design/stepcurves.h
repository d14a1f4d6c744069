// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/uncertainty.h"
#include "widgets/design/comparedgains.h"
#include "widgets/plots/curveplot.h"

namespace mb {

/// The step of one proposal as the Design page draws it: what is predicted with its band, over it what was measured of the same gains.
struct StepCurves {
    std::vector<Curve> curves;
    std::vector<Curve> behind; ///< of other gains, to compare with
    std::vector<CurveMark> marks;
    double highest = 0.0; ///< that is to be seen in any case
    QString title;        ///< from where to where
    QString note;         ///< the size of the step, what was measured, and what the band is
};

/// `report`: of the motor that is shown; its proof is drawn where it was of these very gains. `band`: empty where no errors are known.
[[nodiscard]] StepCurves stepCurves(const tuning::TuneReport &report, const tuning::Proposal &proposal,
    const QString &name, const tuning::PredictionBand &band, const std::optional<ComparedGains> &compared = {});
/// The unit of what a loop measures.
[[nodiscard]] QString stepUnit(Mode loop);

} // namespace mb
