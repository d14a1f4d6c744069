// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/dmc60c/parameterdesk.h"
#include "telemetry/framerate.h"

#include <map>
#include <utility>

namespace mb::dmc60c {

/// How often one unit sends its status frames: who wishes for what, and what to go back to. Engine thread; outlives its tasks.
class StatusRates {
public:
    StatusRates(ParameterDesk &desk, ParameterStore &known)
        : m_desk(desk)
        , m_known(known)
    {
    }
    /// Device::setRate().
    [[nodiscard]] Task<void> set(ChannelIndex channel, double hertz);
    /// The unit has forgotten what was set, in a restart.
    void forgotten() { m_owed = true; }
    /// Once after that; waits for no answer.
    void sendOwed(const UnitContact &contact);

private:
    ParameterDesk &m_desk;
    ParameterStore &m_known;
    std::map<std::uint8_t, FrameRate> m_wishes;     ///< by status frame
    std::map<std::uint8_t, std::uint32_t> m_usual;  ///< what set() goes back to, ms
    std::map<std::uint8_t, std::uint32_t> m_wanted; ///< by parameter, ms
    bool m_owed = false;
};

} // namespace mb::dmc60c
