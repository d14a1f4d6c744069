// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/tunedesign.h"

#include "experiment/envelope.h"
#include "experiment/figures.h"
#include "tuning/aside.h"
#include "tuning/autotunerun.h"
#include "tuning/proof.h"
#include "tuning/refinement.h"
#include "tuning/stepcomparison.h"
#include "tuning/windingfit.h"

#include <algorithm>
#include <utility>

namespace mb::tuning {
namespace {

constexpr double worthAProof = 0.97; ///< of the error, that is worth another proof
constexpr double stillOpen = 1.1;    ///< times the error in one direction, which the other may make up for
constexpr double hardlyMore = 2.0;   ///< of the error, that a model of a loop of whole steps may be wrong by
constexpr double mostOfLink = 0.025; ///< s, that it takes from an order to the position that shows it

/// It had no room for pushes, and was identified by a limit cycle.
bool isSwung(const TuneReport &report)
{
    return std::ranges::any_of(report.gates, [](const Gate &gate) { return gate.name == "relay"; });
}

} // namespace

TuneDesign::TuneDesign(AutotuneRun &run)
    : m_run(run)
    , m_plan(run.plan())
{
}

ProposalBasis TuneDesign::basis() const
{
    const Device &device = m_run.device();
    const TuneReport &report = m_run.report();
    const auto entries = device.parameters().entries();
    return {device.family(), device.knowledge().profile(), m_plan.loop, m_plan.axis, m_plan.slot, report.plant,
        m_run.envelope(), report.scale, report.taking, {entries.begin(), entries.end()}};
}

/// What is compared with a proof makes the same step.
ProposalWish TuneDesign::wishFor(Aim aim) const
{
    return {aim, {}, {}, m_isProven, m_steepest, m_isProven ? m_run.report().step : 0.0};
}

/// The three, and what is to be chosen where that is none of them: the plan's own response and damping take the place of its aim's.
std::vector<ProposalWish> TuneDesign::wishes() const
{
    std::vector<ProposalWish> wishes;
    for (const Aim aim : {Aim::Calm, Aim::Normal, Aim::Brisk})
        wishes.push_back(wishFor(aim));
    if (!mayChange())
        wishes.push_back({m_plan.aim, m_plan.response, m_plan.ms});
    return wishes;
}

VelocityTaking TuneDesign::taking() const
{
    const TuneReport &report = m_run.report();
    if (m_plan.loop != Mode::Velocity || report.scale)
        return {};
    if (m_plan.known && m_plan.taking != VelocityTaking())
        return m_plan.taking;
    const double speed = proofStep(Mode::Velocity, report.plant, {}, m_run.envelope());
    return velocityTaking(m_run.device(), speed, report.motor ? report.motor->filter : std::nullopt);
}

Task<void> TuneDesign::propose()
{
    TuneReport &report = m_run.report();
    report.taking = taking();
    report.envelope = m_run.envelope();
    const std::vector<ProposalWish> wanted = wishes();
    std::vector<Result<Proposal>> proposals = co_await designed(m_run.device(), basis(), wanted);
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        auto &proposal = proposals.at(i);
        const bool isOwn = wanted[i].response || wanted[i].ms;
        const bool isChosen = isOwn || (mayChange() && wanted[i].aim == m_plan.aim);
        if (!proposal && isChosen)
            co_return fail(proposal.error());
        if (!proposal)
            continue;
        if (isChosen)
            choose(*proposal);
        if (!isOwn)
            report.proposals.push_back(std::move(*proposal));
    }
    co_return {};
}

void TuneDesign::choose(const Proposal &proposal)
{
    TuneReport &report = m_run.report();
    report.design = proposal.design;
    report.proposed = proposal.gains;
    report.margins = proposal.margins;
    report.predicted = proposal.predicted;
    report.profile = proposal.profile;
    report.step = proposal.step;
}

Task<bool> TuneDesign::reconsider()
{
    if (!mayChange())
        co_return false;
    const Message why = m_run.report().evidence;
    const std::string_view aim = toString(m_plan.aim);
    const bool isSeen = m_run.report().predicted->shape.windowCounts == 0.0; // else its edges hide what play does
    if (!std::exchange(m_refined, true) && isSeen) {
        const std::optional<PlantModel> plant = co_await corrected();
        bool proposed = false;
        if (plant) {
            proposed = co_await proposeOn(*plant);
        }
        if (proposed) {
            m_before = say("the %1 gains of the first model did not: %2", Message::label(aim), why);
            m_run.note(joined(m_before, say("now those of the model as that step has corrected it")));
            beginAnew();
            co_return true;
        }
    }
    const auto &proposals = m_run.report().proposals;
    const auto calm = std::ranges::find(proposals, Aim::Calm, &Proposal::aim);
    if (m_plan.aim == Aim::Calm || calm == proposals.end())
        co_return false;
    m_before = say("the %1 gains did not: %2", Message::label(aim), why);
    m_run.note(joined(m_before, say("now the calm ones")));
    m_plan.aim = Aim::Calm;
    m_isCalmed = true;
    choose(*calm);
    beginAnew();
    co_return true;
}

Task<bool> TuneDesign::sharpen(double seconds)
{
    TuneReport &report = m_run.report();
    if (!mayChange() || m_plan.aim == Aim::Calm || m_run.left() < seconds)
        co_return false;
    if (report.predicted->shape.windowCounts
        > 0.0) // counted over so few edges, it does not show what play and steps do to the shaft
        co_return false;
    m_held = report;
    if (const bool better = co_await improved(); !better) {
        goBack();
        co_return false;
    }
    beginAnew();
    co_return true;
}

/// On the model as the steps have corrected it; again where that was better.
Task<bool> TuneDesign::improved()
{
    if (std::exchange(m_isProven, true) && !std::exchange(m_isBettered, false))
        co_return false;
    const std::optional<PlantModel> plant = co_await corrected();
    if (m_plan.loop != Mode::Current)
        m_steepest = std::max(m_steepest, m_held->plant.gain / m_held->plant.tau);
    if (!plant && m_plan.loop == Mode::Current)
        co_return false; // what is not known of its winding has cost it nothing that less caution would give back
    if (const bool proposed = co_await proposeOn(plant.value_or(m_held->plant)); !proposed)
        co_return false;
    const TuneReport &report = m_run.report();
    const double promised = promisedError(basis(), m_held->proposed.made, m_held->predicted->shape, report.step);
    const double better = promisedError(basis(), report.proposed.made, report.predicted->shape, report.step);
    if (!(better < worthAProof * promised))
        co_return false;
    m_run.note(say("on the model as these steps have corrected it, other gains leave less error; now those"));
    co_return true;
}

bool TuneDesign::recallFormer(double seconds)
{
    TuneReport &report = m_run.report();
    if (!mayChange() || m_plan.loop == Mode::Current || m_run.plan().aim == Aim::Calm || m_former != Former::Untried)
        return false;
    const auto former = formerProposal(basis(), report.before, report.step);
    if (!former || former->proposal.gains.made == report.proposed.made)
        return false;
    const double kept = promisedError(basis(), report.proposed.made, report.predicted->shape, report.step);
    const Prediction &predicted = former->proposal.predicted;
    const double its = promisedError(basis(), former->proposal.gains.made, predicted.shape, report.step);
    if (!former->beyond.empty()) {
        if (its < kept)
            m_beyond = say("those that were there would leave less error, but are not for keeping: %1", former->beyond);
        return false;
    }
    if (its > hardlyMore * kept)
        return false;
    if (m_run.left() < seconds) {
        m_beyond = say("there was no time to compare them with those that were there");
        return false;
    }
    m_run.note(say("the gains that were there may leave as little error; now those"));
    m_former = Former::Tried;
    m_held = report;
    choose(former->proposal);
    beginAnew();
    return true;
}

bool TuneDesign::isPromising() const
{
    const auto &proof = m_run.report().proof;
    if (!m_held || proof.empty() || proof.size() > m_held->proof.size())
        return true;
    const LoopShape &shape = m_held->predicted->shape;
    if (m_plan.loop == Mode::Current) // noise is forgiven each way
        return isBetter({proof.back()}, {m_held->proof[proof.size() - 1]}, shape);
    if (proof.size() == m_held->proof.size())
        return true; // both ways together tell
    const std::vector<Trial> same(m_held->proof.begin(), m_held->proof.begin() + std::ssize(proof));
    return isBetter(proof, same, shape, stillOpen);
}

void TuneDesign::takeTheBetter()
{
    if (!m_held)
        return;
    TuneReport &report = m_run.report();
    const bool held = report.result != TuneResult::RolledBack && report.proof.size() == m_held->proof.size();
    const LoopShape &shape = m_held->predicted->shape;
    const double less = held ? errorRatio(report.proof, m_held->proof, shape) : 1.0;
    const bool better = held && isBetter(report.proof, m_held->proof, shape);
    if (m_former == Former::Tried)
        m_former = less < 1.0 ? Former::Better : m_givenUp.empty() ? Former::Worse : Former::Untold;
    else if (m_former == Former::Better && less < 1.0)
        m_former = Former::Worse;
    if (less < 1.0)
        m_less = (m_less > 0.0 ? m_less : 1.0) * less;
    m_isLevel = better && less >= 1.0;
    m_isBettered = m_isProven && less < 1.0 && m_plan.loop != Mode::Current;
    if (!better)
        goBack();
    m_held.reset();
}

/// To what was proven; the trials that were made meanwhile stay.
void TuneDesign::goBack()
{
    TuneReport &report = m_run.report();
    std::vector<std::int64_t> trials = std::move(report.trials);
    report = std::move(*m_held);
    report.trials = std::move(trials);
    m_held.reset();
}

Message TuneDesign::story() const
{
    if (isFormer())
        return say(
            "those that were found left more error: these, which were there, leave %1 of it", percentText(m_less));
    Message told;
    const auto tell = [&told](const Message &more) { told = told.empty() ? more : joined(told, more); };
    if (!m_before.empty())
        tell(m_isCalmed ? say("these are the calm gains, %1", m_before)
                        : say("their model was corrected by a step, %1", m_before));
    if (m_less > 0.0)
        tell(say("those that were proven first left more error, these leave %1 of it", percentText(m_less)));
    if (m_isLevel)
        tell(say("their model was corrected by those that were proven first, which left no clearly more error"));
    if (m_former == Former::Worse)
        tell(say("those that were there leave more error"));
    if (!m_beyond.empty())
        tell(m_beyond);
    if (!m_givenUp.empty())
        tell(say("others that may leave less error were given up: %1", m_givenUp));
    return told;
}

void TuneDesign::beginAnew()
{
    TuneReport &report = m_run.report();
    report.result = TuneResult::Refused;
    report.evidence = {};
    report.proof.clear();
}

/// A model that explains the steps that were just seen; nothing where they do not tell one.
Task<std::optional<PlantModel>> TuneDesign::corrected()
{
    const TuneReport &report = m_run.report();
    if (isSwung(report))
        co_return std::nullopt; // so short steps tell less of its lag than it did when it swung
    const bool isSteps = report.scale && report.scale->rate == 0.0; // what is led tells too little of its link
    const SteppedLoop stepped{report.proposed.made, report.predicted->shape, report.proof, isSteps ? mostOfLink : 0.0,
        report.scale.has_value(), report.heat};
    if (m_plan.loop == Mode::Current)
        co_return withWindingOf(stepped, report.plant);
    auto working = aside<std::optional<PlantModel>>(m_run.device(),
        [stepped, plant = report.plant]() -> Result<std::optional<PlantModel>> { return refinedBy(stepped, plant); });
    co_return co_await std::move(working);
}

/// New gains on it; false, and everything as it was, where the device cannot have them.
Task<bool> TuneDesign::proposeOn(PlantModel plant)
{
    TuneReport &report = m_run.report();
    const PlantModel first = std::exchange(report.plant, plant);
    std::vector<Proposal> proposals = std::exchange(report.proposals, {});
    const Result<void> proposed = co_await propose().attempt();
    if (!proposed) {
        report.plant = first;
        report.proposals = std::move(proposals);
    }
    co_return proposed ? true : false;
}

} // namespace mb::tuning
