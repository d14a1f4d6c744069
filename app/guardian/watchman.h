// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/guardian/runner.h"

#include <functional>
#include <map>

namespace mb::guardian {

/// Longest silence of a program that drives motors.
inline constexpr std::chrono::milliseconds silenceLimit{500};

/// How long a stop that failed is tried again.
inline constexpr std::chrono::minutes debtLimit{10};

/// Decides when the devices of one link must be stopped: their program fell silent or ended, or says so. Pure: packets and time
/// come from outside. What is stopped is not watched any more; the program must ask again, and learns why from the report. A stop that
/// failed stays owed: pay() tries it again, until it is confirmed, settled by others, or debtLimit is over.
class Watchman {
public:
    struct Owed {
        std::string name; ///< of the device
        Script script;
        std::string cause;
        Time since{};
    };
    struct Voice {
        std::function<void(const Report &)> report;
        std::function<void(const std::string &)> log;        ///< one line about what was done
        std::function<void(const Owed &, bool owed)> debt{}; ///< a stop is owed from now on, or was confirmed
    };

    Watchman(Port &port, Voice voice);

    void hear(std::span<const std::uint8_t> packet, Time now);
    /// The other end of the pipe is closed.
    void hangUp(Time now);
    /// Does what is due.
    void proceed(Time now);
    [[nodiscard]] std::optional<Time> due() const;
    /// Proceed also when the link can be read. While nobody is stopped, its bytes are the program's.
    [[nodiscard]] bool isListening() const { return m_runner.isListening(); }
    /// The program is gone, and every motor it left behind was stopped or given up.
    [[nodiscard]] bool isDone() const { return m_hungUp && m_runner.isIdle() && m_owed.empty(); }
    [[nodiscard]] bool isOwing() const { return !m_owed.empty(); }
    /// The last stop that failed could not even be sent.
    [[nodiscard]] bool isCut() const { return m_isCut; }
    /// The program has not ended, and did not say that it lives when it had to: it carries out nothing, whatever it holds.
    [[nodiscard]] bool hasFallenSilent() const { return m_silent; }
    /// Nothing is being sent.
    [[nodiscard]] bool isIdle() const { return m_runner.isIdle(); }
    /// The line is there, as far as is known: every stop that is owed is tried now.
    void pay(Time now);
    /// Says again what is owed.
    void tellDebts() const;
    /// Another process has taken the line over, and has settled these.
    void settle(const std::function<bool(const Owed &)> &isSettled);

private:
    struct Watched {
        std::string name;
        Script script;
    };

    void ended(const Runner::Outcome &outcome, Time now);
    void dropOldDebts(Time now);
    void obey(const Order &order, Time now);
    void stop(std::uint32_t id, const char *why, Time now);
    void stopAll(const char *why, Time now);

    Port &m_port;
    Runner m_runner;
    Voice m_voice;
    std::map<std::uint32_t, Watched> m_watched;
    std::map<std::uint32_t, Owed> m_stopping;
    std::map<std::uint32_t, Owed> m_owed; ///< also while they are tried again
    bool m_isCut = false;
    Time m_heardAt{};
    bool m_silent = false;
    bool m_hungUp = false;
};

} // namespace mb::guardian
