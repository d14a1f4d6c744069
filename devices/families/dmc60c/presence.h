// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"

#include <cstdint>
#include <functional>
#include <optional>

namespace mb::dmc60c {

/// Whether a unit is there, whether it is still the same, and whether somebody else commands it: follows from frames, and from
/// silence. Engine thread.
class Presence {
public:
    /// What it asks of the controller, and tells it.
    struct Owner {
        std::function<bool()> isBusy;               ///< an update has the unit: nothing is sent and nothing judged
        std::function<Duration()> period;           ///< of the frames that prove that it is there
        std::function<void()> askWho;               ///< enumerate the bus
        std::function<void()> silent;               ///< it is not heard any more
        std::function<void()> doubled;              ///< two units have its number
        std::function<void(std::uint16_t)> renewed; ///< it answers with another session
        std::function<void()> looked;               ///< time has passed: what is told of it may have changed
    };

    Presence(Clock &clock, std::optional<int> session, Owner owner);

    [[nodiscard]] bool isHeard() const { return m_heard; }
    [[nodiscard]] bool hasForeignMaster() const { return m_foreignAt.has_value(); }
    /// Another session answers under its number, and whether that is a restarted or a second unit is not judged yet.
    [[nodiscard]] bool isDoubted() const { return m_candidate.has_value(); }
    [[nodiscard]] std::optional<int> session() const { return m_session; }
    /// Of the newest frame that proves that it is there.
    [[nodiscard]] std::optional<Instant> heardAt() const { return m_heardAt; }

    /// That frame; whether it was silent before.
    bool heard(Instant time);
    /// After heard() and what came of it.
    void follow() { armTick(); }
    /// Somebody else has sent it a control frame.
    void commandedByOther(Instant time);
    /// A unit with this number has told its session.
    void sessionTold(std::uint16_t session, Instant time, bool judged);
    /// The identity has this session now; whether that is another one.
    bool takeSession(std::optional<int> session);
    /// Asks who is there now, and again in a while as long as it is silent.
    void enumerate();

private:
    /// Another session that answers under this number.
    struct Candidate {
        std::uint16_t session = 0;
        int enumerations = 0;
        Instant nextAt{};
    };
    void tick();
    void armTick();
    [[nodiscard]] Duration silenceLimit() const;
    void judgeCandidate();

    Clock &m_clock;
    Owner m_owner;
    std::optional<int> m_session;
    bool m_heard = false;
    std::optional<Instant> m_heardAt;
    std::optional<Instant> m_foreignAt;
    std::optional<Candidate> m_candidate;
    Instant m_ownSeenAt{};
    Instant m_candidateSince{};
    Instant m_enumerateAt{};
    Timer m_timer;
    Instant m_armedFor{};
};

} // namespace mb::dmc60c
