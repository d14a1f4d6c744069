// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/twopointruns.h"

#include "experiment/figures.h"
#include "tuning/twopointsteps.h"

#include <algorithm>
#include <cmath>

namespace mb::tuning {
namespace {

constexpr double mostResidual = 0.08;    ///< of a step
constexpr double mostUncertainty = 0.3;  ///< of what D does
constexpr double mostLoad = 0.1;         ///< of what P makes of a step
constexpr double earlierWhenSmall = 0.8; ///< of the time that a larger step takes to its middle
constexpr double heldMore = 1.15;        ///< times what was seen, that friction may hold

} // namespace

double doubtOf(const LoopFit &fit)
{
    return std::hypot(fit.pushError, fit.dError / fit.d);
}

bool isDoubtful(const LoopFit &fit)
{
    return fit.residual > mostResidual || doubtOf(fit) > mostUncertainty;
}

std::vector<LoopRun> TwoPointRuns::all() const
{
    std::vector<LoopRun> both = steps;
    both.insert(both.end(), creeping.begin(), creeping.end());
    return both;
}

double TwoPointRuns::holding() const
{
    double friction = 0.0;
    for (const auto *const runs : {&steps, &creeping}) {
        for (const LoopRun &one : *runs)
            friction = std::max(friction, heldMore * (std::abs(leftOf(one)) + one.p));
    }
    return friction;
}

bool TwoPointRuns::isLinear(double drive, bool isKnown) const
{
    std::vector<double> small;
    std::vector<double> large;
    double rise = 0.0; // of the larger ones
    for (const LoopRun &run : steps) {
        if (run.p == steps.back().p && run.d == steps.back().d) {
            (std::abs(run.step) * run.p < 0.75 * drive ? small : large).push_back(halfWay(run));
            rise = std::max(rise, run.rise());
        }
    }
    if (isKnown || small.empty() || large.empty())
        return true;
    return median(small) + 0.5 * rise >= earlierWhenSmall * (median(large) + 0.5 * rise);
}

std::vector<Gate> TwoPointRuns::gates(const LoopFit &fit, double drive, bool isKnown) const
{
    const double friction = holding() / drive;
    double load = 0.0;
    for (const LoopRun &one : steps)
        load += leftOf(one) / static_cast<double>(steps.size());
    load = std::abs(load) / drive;
    const bool linear = isLinear(drive, isKnown);
    const double doubt = doubtOf(fit);
    return {{"fit", say("what is left over is %1 of the steps, at most 8 %", percentText(fit.residual)),
                fit.residual <= mostResidual, say("see that nothing is loose and that steps look alike")},
        {"damping", say("what D does is known within %1, at most 30 %", percentText(doubt)), doubt <= mostUncertainty,
            say("write a larger gain.d once, with which it still comes to rest")},
        {"friction", say("friction takes %1 of what P makes of a step, at most 60 %", percentText(friction)),
            friction <= TwoPointSteps::mostFriction, say("allow more travel or duty")},
        {"asymmetric load", say("a load takes %1 of what P makes of a step, at most 10 %", percentText(load)),
            load <= mostLoad, say("see whether a load always pulls one way")},
        {"output", linear ? say("no step met the end of the output") : say("the steps met the end of the output"),
            linear, say("write a smaller gain.p once")}};
}

} // namespace mb::tuning
