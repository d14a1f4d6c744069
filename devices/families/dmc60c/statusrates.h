// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/dmc60c/parameterdesk.h"
#include "telemetry/framerate.h"

#include <map>
#include <optional>
#include <set>

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
    /// The unit has forgotten what was set, in a restart, or it is another one.
    void forgotten();
    /// What is owed after that, or because no answer came, once a second until it is answered; waits for none.
    void sendOwed(const UnitContact &contact);
    /// Somebody here has written a parameter, perhaps to what it was raised to; a period is what set() goes back to.
    void chosen(std::uint8_t parameter, std::uint32_t period);
    /// The unit has told a parameter. A period that nobody here wished for is somebody's choice, which set() goes back to.
    void told(const ParamResponse &response);

private:
    [[nodiscard]] std::uint32_t periodFor(std::uint8_t parameter) const;
    void settled(std::uint8_t parameter);

    ParameterDesk &m_desk;
    ParameterStore &m_known;
    std::map<std::uint8_t, FrameRate> m_wishes;     ///< by status frame
    std::map<std::uint8_t, std::uint32_t> m_usual;  ///< what set() goes back to, ms
    std::map<std::uint8_t, std::uint32_t> m_wanted; ///< by parameter, ms
    std::set<std::uint8_t> m_owed;                  ///< parameters
    std::optional<std::uint8_t> m_setting;          ///< parameter that may still be told as it was before
    std::optional<Instant> m_sentAt;                ///< of what is owed
};

} // namespace mb::dmc60c
