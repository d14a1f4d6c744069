// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/experimentplan.h"
#include "model/device.h"

#include <vector>

namespace mb::tuning {

/// Samples of an axis come as often as an experiment needs them, and afterwards as before.
class RaisedRates {
public:
    explicit RaisedRates(Device &device)
        : m_device(device)
    {
    }
    /// Samples per second of what a loop is judged by. LinkLost fails; a channel that has no such rate stays as it is, and one
    /// whose rate could not be set is said.
    [[nodiscard]] Task<void> raise(int axis, double rate, const ExperimentSurroundings &around);
    /// Whatever could not be put back is said.
    [[nodiscard]] Task<void> lower(const ExperimentSurroundings &around);

private:
    Device &m_device;
    std::vector<ChannelIndex> m_raised;
};

} // namespace mb::tuning
