// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/experiment.h"
#include "tuning/proof.h"

#include <vector>

namespace mb::tuning {

class AutotuneRun;
class TuneDesign;

/// Puts the proposal of a tuning to the proof on its motor, and keeps what was proven. Begins when the report has what was there before.
class TuneProof {
public:
    TuneProof(AutotuneRun &run, const TuneDesign &design);

    /// Steps both ways with the proposal in force: on a device with two slots in the one that does not hold the result. What it
    /// replaces is in force again afterwards. RolledBack in the report where a step did not do what was predicted.
    [[nodiscard]] Task<void> prove();
    /// Writes what was proven; what it replaces is owed meanwhile. RolledBack where it could not be written, with what was there in
    /// force again.
    [[nodiscard]] Task<void> keep();
    /// s that another proof takes, at most.
    [[nodiscard]] double seconds() const;
    /// The same with as few steps as tell anything.
    [[nodiscard]] double leastSeconds() const;

private:
    [[nodiscard]] double profileRate() const;
    [[nodiscard]] double hold() const;
    [[nodiscard]] int repeats(double sign) const;
    [[nodiscard]] double target(double sign) const;
    [[nodiscard]] RestingError resting() const;
    [[nodiscard]] Result<void> checkPromise() const;
    [[nodiscard]] Result<void> checkPass();
    [[nodiscard]] Message withDerivative(Message why) const;
    [[nodiscard]] Message shortcoming();
    [[nodiscard]] std::vector<ParameterChange> inProvingSlot() const;
    [[nodiscard]] ExperimentPlan planOf(double sign) const;
    [[nodiscard]] Task<void> write();
    [[nodiscard]] Task<void> takeBack(std::vector<OwedValue> before, Error cause);

    AutotuneRun &m_run;
    const TuneDesign &m_design;
    int m_slot;           ///< that it is proven in
    double m_heat;        ///< in the winding (windingheat.h)
    bool m_mayStay;       ///< nobody knows the gains that it replaces, and nobody minds
    Message m_unreleased; ///< why the notebook still owes what was there before; empty: it does not
};

} // namespace mb::tuning
