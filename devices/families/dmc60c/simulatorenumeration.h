// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <random>

namespace mb::dmc60c::simulation {

/// The session of a unit, which begins with the first frame that it hears, and when it answers an enumeration.
class Enumeration {
public:
    /// `first`: the session to begin with, else a random one. `answer` sends the responses; false: not now.
    Enumeration(
        Clock &clock, std::mt19937_64 &random, std::optional<std::uint16_t> first, std::function<bool()> answer);

    /// 0: none.
    [[nodiscard]] std::uint16_t session() const { return m_session; }
    void begin();
    void end() { m_session = 0; }
    /// Answers after a while that depends on the number, or on chance.
    void ask(int number, bool inBootloader);
    void stop() { m_timer.stop(); }

private:
    void tell();

    std::mt19937_64 &m_random;
    std::optional<std::uint16_t> m_next;
    std::function<bool()> m_answer;
    std::uint16_t m_session = 0;
    Timer m_timer;
};

} // namespace mb::dmc60c::simulation
