// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/experimentplan.h"
#include "model/device.h"

#include <array>
#include <span>
#include <string_view>
#include <vector>

namespace mb::tuning {

/// Samples of an axis come as often as an experiment needs them, and afterwards as before.
class RaisedRates {
public:
    explicit RaisedRates(Device &device)
        : m_device(device)
    {
    }
    static constexpr std::array<std::string_view, 4> ofLoops{"position", "velocity", "current", "duty"};
    /// Samples per second of what a loop is judged by, or of these; they share the line. LinkLost fails; a channel that has no such
    /// rate stays as it is, and one whose rate could not be set is said.
    [[nodiscard]] Task<void> raise(
        int axis, double rate, const ExperimentSurroundings &around, std::span<const std::string_view> keys = ofLoops);
    /// Whatever could not be put back is said.
    [[nodiscard]] Task<void> lower(const ExperimentSurroundings &around);

private:
    Device &m_device;
    std::vector<ChannelIndex> m_raised;
};

} // namespace mb::tuning
