// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/tuning/matrix/bruteforce.h"

#include "model/family.h"
#include "tests/tuning/matrix/groundtruth.h"
#include "tuning/gainscale.h"
#include "tuning/margins.h"
#include "tuning/proof.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace mb::test {
namespace {

using tuning::ContinuousGains;

constexpr double mostMs = 1.7;
constexpr double mostMsOff = 1.9;
constexpr double moreGain = 1.2;
constexpr double moreDelay = 1.3;
constexpr double mostOvershoot = 0.05;
constexpr std::size_t bestOfOnePhase = 24;
constexpr std::size_t bestOfFewPhases = 8;
constexpr std::size_t bestOfAllPhases = 3;
constexpr int fewPhases = 3;
constexpr double coarsely = 1.1;
constexpr double finely = 1.04;
constexpr double noiseShare = 0.1;
constexpr double strongestError = 3.0 * 1.001;
constexpr double quickestOfSetPoints = 2.0; ///< natural frequency times their period

/// Looks at gains from some phases, and keeps what is within the bounds from each of them; no two that are the same to the unit.
class Search {
public:
    Search(StepProbe &probe, const Cell &cell, const tuning::PlantModel &truth,
        const std::vector<ParameterChange> &also, StepPhase phase)
        : m_probe(probe)
        , m_cell(cell)
        , m_truth(truth)
        , m_also(also)
        , m_phases{phase}
    {
    }
    void look(const ContinuousGains &gains)
    {
        if (!isWithinBounds(m_cell, m_truth, gains, m_probe.step()))
            return;
        const auto scaled = tuning::scaleGains(m_probe.device(), m_cell.loop, 1, 0, gains, trueScale(m_cell));
        if (!scaled || !m_seen.insert(rawOf(*scaled)).second)
            return;
        std::vector<ParameterChange> changes = scaled->changes;
        changes.insert(changes.end(), m_also.begin(), m_also.end());
        const auto response = m_probe.runAll(changes, m_phases, {worstKept(), mostOvershoot});
        if (!response || !isWithinBounds(m_probe, *response))
            return;
        const BestGains found{gains, *response};
        m_all.insert(std::upper_bound(m_all.begin(), m_all.end(), found, isLess), found);
        if (!best || response->itae < best->response.itae)
            best = found;
    }
    /// The best of what was found are looked at anew, from these phases, and of them a few are kept.
    void lookAgain(std::size_t few, std::vector<StepPhase> phases)
    {
        std::vector<BestGains> again = std::exchange(m_all, {});
        again.resize(std::min(again.size(), m_few));
        m_few = few;
        m_phases = std::move(phases);
        m_seen.clear();
        best.reset();
        for (const BestGains &gains : again)
            look(gains.gains);
    }
    /// Each gain a little up and down from the best, as long as that helps.
    void refine(double factor)
    {
        bool better = best.has_value();
        for (int round = 0; better && round < 4; ++round) {
            better = false;
            for (const auto gain : {&ContinuousGains::p, &ContinuousGains::i, &ContinuousGains::d}) {
                for (const double by : {factor, 1.0 / factor}) {
                    ContinuousGains tried = best->gains;
                    tried.*gain *= by;
                    const double before = best->response.itae;
                    if (tried.*gain != 0.0)
                        look(tried);
                    better = better || best->response.itae < before;
                }
            }
        }
    }

    [[nodiscard]] std::vector<BestGains> bestFew() const
    {
        std::vector<BestGains> few = m_all;
        few.resize(std::min(few.size(), m_few));
        return few;
    }

    std::optional<BestGains> best;

private:
    static bool isLess(const BestGains &a, const BestGains &b) { return a.response.itae < b.response.itae; }
    /// What is not among the best few need not be known.
    [[nodiscard]] double worstKept() const
    {
        return m_all.size() < m_few ? std::numeric_limits<double>::infinity() : m_all[m_few - 1].response.itae;
    }
    static std::vector<std::int64_t> rawOf(const tuning::ScaledGains &scaled)
    {
        std::vector<std::int64_t> raw;
        for (const ParameterChange &change : scaled.changes)
            raw.push_back(change.raw);
        return raw;
    }

    StepProbe &m_probe;
    const Cell &m_cell;
    tuning::PlantModel m_truth;
    const std::vector<ParameterChange> &m_also;
    std::vector<StepPhase> m_phases;
    std::set<std::vector<std::int64_t>> m_seen;
    std::size_t m_few = bestOfOnePhase;
    std::vector<BestGains> m_all; ///< the best first
};

const Family &familyOf(const Cell &cell)
{
    const auto all = families();
    return **std::find_if(all.begin(), all.end(), [&cell](const Family *family) { return family->key == cell.family; });
}

double commandPeriodOf(const Cell &cell)
{
    return std::chrono::duration<double>(familyOf(cell).capabilities.commandPeriod).count();
}

/// A position loop that is as quick as the set-points of a hand come answers each of them by itself, and the proposals are held to the
/// same bound.
bool answersSetPoints(const Cell &cell, const tuning::PlantModel &truth, const ContinuousGains &gains)
{
    const double omega = std::sqrt(truth.gain * gains.p / truth.tau);
    return cell.loop == Mode::Position && omega * commandPeriodOf(cell) > quickestOfSetPoints;
}

void lookAtVelocities(Search &search, const tuning::PlantModel &truth)
{
    for (double response = 0.4; response <= 12.0; response *= 1.25) {
        const double p = truth.tau / (truth.gain * truth.delay * (1.0 + response));
        for (double share = 0.25; share <= 4.0; share *= 1.35)
            search.look({p, p / (share * truth.tau), 0.0, 0.0});
    }
}

void lookAtPositions(Search &search, const tuning::PlantModel &truth, bool withIntegral)
{
    const double slowest = std::min(0.03 / truth.delay, 0.4 / truth.tau);
    for (double omega = slowest; omega <= 0.5 / truth.delay; omega *= 1.3) {
        for (const double zeta : {0.6, 0.7, 0.8, 0.9, 1.0, 1.15, 1.3, 1.6}) {
            if (!withIntegral)
                search.look(tuning::positionRule(truth, omega, zeta));
            for (const double alpha : {0.03, 0.06, 0.1, 0.2}) {
                if (withIntegral)
                    search.look(tuning::positionRuleWithIntegral(truth, omega, zeta, alpha));
            }
        }
    }
}

} // namespace

bool isWithinBounds(const StepProbe &probe, const ShaftResponse &response)
{
    return response.isStable && response.overshoot <= mostOvershoot && !probe.drawsTooMuch(response);
}

bool isWithinBounds(const Cell &cell, const tuning::PlantModel &truth, const ContinuousGains &gains, double step)
{
    const auto scale = trueScale(cell);
    const double share = scale ? scale->strongest * scale->d / scale->cycle : noiseShare;
    if (gains.p <= 0.0 || gains.p * step > strongestError || gains.d / cycleOf(cell) > share * 1.001)
        return false;
    tuning::PlantModel off = truth;
    off.gain *= moreGain;
    off.delay *= moreDelay;
    if (answersSetPoints(cell, truth, gains))
        return false;
    return tuning::marginsOf(cell.loop, truth, gains).ms <= mostMs
        && tuning::marginsOf(cell.loop, off, gains).ms <= mostMsOff;
}

std::vector<BestGains> bruteForce(StepProbe &probe, const Cell &cell, const tuning::PlantModel &truth,
    const std::vector<ParameterChange> &also, const std::vector<StepPhase> &phases)
{
    Search search(probe, cell, truth, also, phases.front());
    if (cell.loop == Mode::Position)
        lookAtPositions(search, truth, !trueScale(cell) && !tuning::hasFrictionHelp(probe.device().family()));
    else
        lookAtVelocities(search, truth);
    search.refine(coarsely);
    search.refine(finely);
    search.lookAgain(bestOfFewPhases, {phases.begin(), phases.begin() + fewPhases});
    search.lookAgain(bestOfAllPhases, phases);
    search.refine(finely);
    return search.bestFew();
}

} // namespace mb::test
