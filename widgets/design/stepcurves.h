// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/autotune.h"
#include "tuning/uncertainty.h"
#include "widgets/plots/curveplot.h"

namespace mb {

/// The step of one proposal as the Design page draws it: what is predicted with its band, over it what was measured of the same gains.
struct StepCurves {
    std::vector<Curve> curves;
    QString note; ///< the size of the step, and what was measured
};

/// `report`: of the motor that is shown; its proof is drawn where it was of these very gains. `band`: empty where no errors are known.
[[nodiscard]] StepCurves stepCurves(const tuning::TuneReport &report, const tuning::Proposal &proposal,
    const QString &name, const tuning::PredictionBand &band);

} // namespace mb
