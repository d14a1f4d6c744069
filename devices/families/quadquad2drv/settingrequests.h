// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/quadquad2drv/packetport.h"
#include "families/quadquad2drv/parameters.h"
#include "model/deviceprofile.h"
#include "model/parameterstore.h"

namespace mb::quadquad2drv {

[[nodiscard]] constexpr bool isBoard(ParameterIndex index)
{
    return index.value >= axes * parametersPerAxis;
}

/// The requests that set the parameters of a board. Most travel in groups: what was not written of one is taken to be what the board
/// starts with, and assumed once the board has accepted it.
class SettingRequests {
public:
    /// Until somebody gives an axis another one: a quarter, since wrong polarity means full speed away (README.md#polarity).
    static constexpr std::int64_t firstPowerLimit = 2048;

    /// Both outlive it; the profile has the readings of the reference that experiments found.
    SettingRequests(ParameterStore &known, const DeviceProfile &profile)
        : m_known(known)
        , m_profile(profile)
    {
    }

    [[nodiscard]] Readings readings() const;
    /// Sets one parameter, and what travels with it.
    [[nodiscard]] Bytes write(ParameterIndex index, std::int64_t raw) const;
    /// The board has taken it, with this value if it is another one: so is assumed what travelled with it.
    void accepted(ParameterIndex index, std::optional<std::int64_t> raw = {});
    /// Of an axis (0…3): limits and gains as they are known or assumed to be.
    [[nodiscard]] std::vector<Bytes> ofAxis(int axis) const;
    /// The one of the input alone.
    [[nodiscard]] Bytes input(int axis) const;
    /// The profile reads inputs differently than when they were written; once.
    [[nodiscard]] bool takeReadingChange();
    /// Those of the inputs that were written.
    [[nodiscard]] std::vector<Bytes> writtenInputs() const;
    /// The limit of the power, for an axis of which none was accepted yet.
    [[nodiscard]] std::optional<Bytes> firstLimit(int axis) const;
    /// The one that an axis has, or would get.
    [[nodiscard]] std::int64_t powerLimit(int axis) const { return known(axis, AxisParameter::LimitPower); }

private:
    [[nodiscard]] Bytes writeBoard(BoardParameter which, std::uint32_t bits) const;
    [[nodiscard]] Bytes group(int axis, AxisParameter which, std::int64_t raw) const;
    /// Or what the reference says of a board that is new.
    [[nodiscard]] std::int64_t known(ParameterIndex index) const;
    [[nodiscard]] std::int64_t known(int axis, AxisParameter which) const;
    void assume(int axis, AxisParameter from, AxisParameter to);

    ParameterStore &m_known;
    const DeviceProfile &m_profile;
    bool m_libraryPolarity = true; ///< as inputs were written last
};

/// Raw value of a parameter that the board tells. The port outlives the task.
[[nodiscard]] Task<std::int64_t> readParameter(PacketPort &port, ParameterIndex index);

} // namespace mb::quadquad2drv
