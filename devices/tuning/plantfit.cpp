// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/plantfit.h"

#include "tuning/leastsquares.h"

#include <algorithm>
#include <cmath>

namespace mb::tuning {

double GainFit::asymmetry() const
{
    return forward > 0.0 && reverse > 0.0 ? std::abs(forward - reverse) / (0.5 * (forward + reverse)) : 0.0;
}

Result<GainFit> fitGain(std::span<const double> duties, std::span<const double> speeds)
{
    LeastSquares<2> fit;
    LeastSquares<3> withLoad;
    std::array<std::pair<double, int>, 2> ways{};
    for (std::size_t i = 0; i < duties.size(); ++i) {
        const double sign = duties[i] > 0.0 ? 1.0 : -1.0;
        if (duties[i] * speeds[i] <= 0.0)
            return fail(Fault::OutOfRange, say("the motor did not turn the way it was pushed"));
        fit.add({1.0, std::abs(speeds[i])}, std::abs(duties[i]));
        withLoad.add({sign, 1.0, speeds[i]}, duties[i]);
    }
    const auto plain = fit.solve();
    if (!plain || plain->values[1] <= 0.0)
        return fail(
            Fault::OutOfRange, say("pushes of one size do not tell friction from gain"), say("push with two sizes"));
    GainFit result;
    result.friction = std::max(plain->values[0], 0.0);
    result.gain = 1.0 / plain->values[1];
    result.gainError = plain->errors[1] * result.gain * result.gain;
    result.frictionError = plain->errors[0];
    if (const auto loaded = withLoad.solve(); loaded && loaded->values[2] > 0.0) {
        result.friction = std::max(loaded->values[0], 0.0);
        result.offset = loaded->values[1];
        result.offsetError = loaded->errors[1];
        result.gain = 1.0 / loaded->values[2];
        result.gainError = loaded->errors[2] * result.gain * result.gain;
        result.frictionError = loaded->errors[0];
    }
    for (std::size_t i = 0; i < duties.size(); ++i) {
        auto &way = ways[duties[i] > 0.0 ? 0 : 1];
        const double pushed = std::abs(duties[i]) - result.friction;
        if (pushed > 0.0) {
            way.first += std::abs(speeds[i]) / pushed;
            ++way.second;
        }
    }
    result.forward = ways[0].second > 0 ? ways[0].first / ways[0].second : 0.0;
    result.reverse = ways[1].second > 0 ? ways[1].first / ways[1].second : 0.0;
    return result;
}

} // namespace mb::tuning
