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
    /// Milliseconds by the number of the parameter; the unit forgets them in a restart.
    [[nodiscard]] const std::map<std::uint8_t, std::uint32_t> &wanted() const { return m_wanted; }
    /// The unit has forgotten them.
    void forgotten() { m_owed = true; }
    /// They are to be sent again; once.
    [[nodiscard]] bool takeOwed() { return std::exchange(m_owed, false); }

private:
    ParameterDesk &m_desk;
    ParameterStore &m_known;
    std::map<std::uint8_t, FrameRate> m_wishes;    ///< by status frame
    std::map<std::uint8_t, std::uint32_t> m_usual; ///< what set() goes back to, ms
    std::map<std::uint8_t, std::uint32_t> m_wanted;
    bool m_owed = false;
};

} // namespace mb::dmc60c
