// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/proof.h"
#include "tuning/tunereport.h"

namespace mb {
struct DeviceProfile;
} // namespace mb

namespace mb::tuning {

/// What gains of a loop are designed on. No device is asked and nothing moves: the window designs with it while somebody drags a
/// slider. Family and profile outlive it.
struct ProposalBasis {
    const Family &family;
    const DeviceProfile &profile; ///< its calibrations, where the family's scales need them
    Mode loop = Mode::Velocity;
    int axis = 1;
    int slot = 0;
    PlantModel plant;
    Envelope envelope;               ///< in force: what the step may use
    std::optional<TriedScale> scale; ///< of its gains, where they had to be tried
    VelocityTaking taking{};         ///< of a velocity loop, where it is known
    /// Of the unit, in table order, as far as they are known: what bounds its output by itself.
    std::vector<ParameterStore::Entry> entries{};
};

constexpr double largestMs = 1.7; ///< sensitivity of any set, on the model

/// What one set is to be like: an aim, or numbers in its place.
struct ProposalWish {
    Aim aim = Aim::Normal;
    std::optional<double> response; ///< s
    std::optional<double> ms;       ///< largest sensitivity on the model
    bool isProven = false;          ///< a loop was seen to do what the model predicts: less caution is needed
    double steepest = 0.0;          ///< as SearchTask has it
    double step = 0.0;              ///< that it is searched and proven for; 0: the usual one
};

/// Largest sensitivity that is allowed: on the model, and where its gain is 20 % and its delay 30 % more than thought.
struct MsBounds {
    double model = 0.0;
    double off = 0.0;
};
[[nodiscard]] MsBounds msBoundsOf(const ProposalWish &wish);

/// A, that the proof of a current loop asks for, of a motor that draws `stall` A at standstill.
[[nodiscard]] double currentStep(double stall, const Envelope &envelope);

/// s, between the points that predictStep() computes for this loop.
[[nodiscard]] double predictionPeriod(const ProposalBasis &basis);

/// Gains for it, rounded to what the device stores, their margins and the step that they would make. Pure; under 16 ms for numbers.
/// For an aim they are those of the rule, bettered by a search on the model (gainsearch.h): a tenth of a second. OutOfRange or
/// Unsupported where the device cannot have such gains.
[[nodiscard]] Result<Proposal> proposalFor(const ProposalBasis &basis, const ProposalWish &wish);

/// Gains that a device had, like a proposal for a step of some size.
struct FormerProposal {
    Proposal proposal;
    Message
        beyond; ///< which bound of every proposal, those of a brisk one, they do not keep on the model; empty: they keep all
};
/// Nothing where they are not known (gainsMadeBy()).
[[nodiscard]] std::optional<FormerProposal> formerProposal(
    const ProposalBasis &basis, const KnownGains &numbers, double step);

/// s², integral of time times error over the step, of the steps that would prove this loop, on the model alone.
[[nodiscard]] double promisedError(
    const ProposalBasis &basis, const ContinuousGains &gains, const LoopShape &shape, double step);

/// The same gains as parameters of the basis' axis and slot, with the help against friction and the bounds that go with them, and what
/// they will do in the step that the basis' limits leave. Nothing is searched: under 16 ms.
[[nodiscard]] Result<Proposal> movedTo(const ProposalBasis &basis, Proposal proposal);

/// These limits in place of the basis' leave sets like one with these gains as they are: they make the same step, to a hundredth, with the
/// same duty and current.
[[nodiscard]] bool isAlikeWithin(const Envelope &limits, const ProposalBasis &basis, const ContinuousGains &gains);

/// Several at once, each as proposalFor() has it, in the background of the device's link where it has one (aside.h).
[[nodiscard]] Task<std::vector<Result<Proposal>>> designed(
    Device &device, ProposalBasis basis, std::vector<ProposalWish> wishes);

} // namespace mb::tuning
