// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/snapshot.h"
#include "tuning/proposals.h"

#include <QString>

#include <optional>

namespace mb {

/// Gains to compare a proposal with, and how people call them.
struct ComparedGains {
    tuning::Proposal proposal;
    QString name;
};

/// The gains that the loop of a device has, as a proposal for the same step. Where those are the proposal's own: what they replaced in the
/// last tuning. Keeps what it has computed, as only other gains or another step change it. GUI thread.
class GainComparison {
public:
    /// Nothing where they are not known, or make nothing on this model.
    [[nodiscard]] const std::optional<ComparedGains> &with(const DeviceView &view, const tuning::ProposalBasis &basis,
        const tuning::TuneReport &report, const tuning::Proposal &proposal);
    /// Another model.
    void forget() { m_numbers.clear(); }

private:
    tuning::KnownGains m_numbers;
    double m_step = 0.0;
    QString m_name;
    std::optional<ComparedGains> m_compared;
};

/// "over 20.1 %, Ms 1.90", in front of people.
[[nodiscard]] QString comparedText(const ComparedGains &compared);

} // namespace mb
