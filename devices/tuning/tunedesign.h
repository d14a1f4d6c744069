// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/proposals.h"
#include "tuning/tunereport.h"

namespace mb::tuning {

class AutotuneRun;

/// What one tuning proposes: at first, and after its proofs have told more of the motor. Writes design, proposals and model of its
/// report; moves nothing.
class TuneDesign {
public:
    explicit TuneDesign(AutotuneRun &run);

    /// Gains, rounded to the device's, and what they will do.
    [[nodiscard]] Task<void> propose();
    /// What to prove after a proposal did not do what was predicted: the same on the model as those steps correct it, then the calm one.
    /// False where there is none, or numbers were asked for.
    [[nodiscard]] Task<bool> reconsider();
    /// After a proof that held, and again after one that was better for it: the same aim on the model as its steps correct it, which needs
    /// less caution. False where that promises no clearly smaller error, where `seconds` of another proof are too many, or where numbers
    /// were asked for.
    [[nodiscard]] Task<bool> sharpen(double seconds);
    /// Once, after a proof that held: the gains that were there, where they are known, may be tried and promise hardly more error. False
    /// where they do not, where `seconds` of another proof are too many, or where calm gains or numbers were asked for.
    [[nodiscard]] bool recallFormer(double seconds);
    /// The steps in one direction of what sharpen() or recallFormer() proposed left hardly more error than those of what was proven before:
    /// both directions together may leave less.
    [[nodiscard]] bool isPromising() const;
    /// After the proof of what they proposed: goes back to what was proven before unless the new one held and its steps left less
    /// error.
    void takeTheBetter();

    /// What sharpen() or recallFormer() proposed was not proven to its end, and why: it ends with what was proven before.
    void giveUp(Message why) { m_givenUp = std::move(why); }

    /// What gains did that were proven before these; empty: none were, or they held.
    [[nodiscard]] const Message &before() const { return m_before; }
    /// How these came to be, where they are not the first proposal; empty: they are.
    [[nodiscard]] Message story() const;
    /// What is proven is what was there.
    [[nodiscard]] bool isFormer() const { return m_former == Former::Better; }

private:
    enum class Former { Untried, Tried, Better, Worse, Untold };

    [[nodiscard]] ProposalBasis basis() const;
    [[nodiscard]] ProposalWish wishFor(Aim aim) const;
    [[nodiscard]] std::vector<ProposalWish> wishes() const;
    [[nodiscard]] VelocityTaking taking() const;
    [[nodiscard]] bool mayChange() const { return !m_plan.response && !m_plan.ms; }
    [[nodiscard]] Task<bool> improved();
    [[nodiscard]] Task<std::optional<PlantModel>> corrected();
    [[nodiscard]] Task<bool> proposeOn(PlantModel plant);
    void choose(const Proposal &proposal);
    void beginAnew();
    void goBack();

    AutotuneRun &m_run;
    TunePlan m_plan;           ///< its aim as it has become
    bool m_refined = false;    ///< the model was corrected after a failure, or could not be
    bool m_isCalmed = false;   ///< the calm proposal took the place of the one that was asked for
    bool m_isProven = false;   ///< a loop on this model was seen to do what was predicted
    bool m_isBettered = false; ///< what was designed on it then left less error
    double m_steepest = 0.0;   ///< of the models before that was corrected
    double m_less = 0.0; ///< error of the steps over that of those before, where what was tried beside them was better
    bool m_isLevel = false; ///< what was tried beside them is kept though noise does not tell which is better
    Former m_former = Former::Untried;
    Message m_before;
    Message m_givenUp;                ///< why what was tried beside these was not proven to its end; empty: it was
    Message m_beyond;                 ///< why what was there was not tried, though it might be better
    std::optional<TuneReport> m_held; ///< what was proven, while something better is tried
};

} // namespace mb::tuning
