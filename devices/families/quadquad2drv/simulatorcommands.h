// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/quadquad2drv/simulatoraxis.h"

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace mb::quadquad2drv::simulation {

using Axes = std::array<std::unique_ptr<Axis>, axes>;

/// What a simulated board does with a request, and what it answers; the settings that it has once.
class Commands {
public:
    using Bytes = std::vector<std::uint8_t>;
    using Values = std::span<const std::uint8_t>;

    /// The axes outlive it. `shiftedTarget`: velocity targets are expected times 4096. `streamChanged`: another period.
    Commands(Axes &axes, bool shiftedTarget, std::function<void()> streamChanged);

    /// The board is reset.
    void restart();
    /// The answer to a question, without its return code; nothing when it is none.
    [[nodiscard]] std::optional<Bytes> answer(std::uint8_t id, Values payload);
    [[nodiscard]] ReturnCode set(std::uint8_t id, Values payload);
    /// The motion data of all axes, by their masks.
    void appendMotion(Bytes &out);
    [[nodiscard]] std::uint16_t streamPeriod() const { return m_streamPeriod; }
    [[nodiscard]] std::uint8_t streamConfig() const { return m_streamConfig; }

    std::array<std::uint8_t, 3> version{1, 3, 1}; ///< major, minor, protocol

private:
    [[nodiscard]] ReturnCode setWhole(std::uint8_t id, Values payload);
    [[nodiscard]] ReturnCode setTuples(std::uint8_t id, Values payload);
    [[nodiscard]] ReturnCode setTuple(std::uint8_t id, Axis &axis, Values values);
    [[nodiscard]] ReturnCode setMotion(std::uint8_t id, Axis &axis, Values values);
    [[nodiscard]] Bytes positions(Values payload);

    Axes &m_axes;
    bool m_shiftedTarget;
    std::function<void()> m_streamChanged;
    std::uint16_t m_streamPeriod = 0;
    std::uint8_t m_streamConfig = 0;
    std::uint8_t m_historyLength = 31;
    std::uint8_t m_historyBits = 20;
};

} // namespace mb::quadquad2drv::simulation
