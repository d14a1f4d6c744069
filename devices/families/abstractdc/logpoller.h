// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/abstractdc/codec.h"
#include "families/abstractdc/questionwatch.h"
#include "transport/canlink.h"

#include <array>
#include <functional>

namespace mb::abstractdc {

/// Asks one drive for its logs, one question at a time, as often as wished for and as the bit rate carries: questions and answers
/// of all drives polled on the link, by whomever, take at most half of the wire. A silent drive is asked twice a second.
/// Only what answers a question to this drive is taken for its log; questions whose answers could be taken for each other wait for
/// one another. On a recording nobody is asked: questions in it are taken for this one's, so that losses and silence are those of the live run.
class LogPoller {
public:
    struct Events {
        std::function<void(Log, std::int32_t, Instant)> answered;
        std::function<void()> silent; ///< several questions in a row have had no answer
        std::function<void(Log)> missed;
    };

    LogPoller(CanLink &link, Clock &clock, Events events);

    /// Nothing is asked while the dialect is not known (nullptr), but whether somebody is there: speed has one code in all.
    void speak(const Dialect *dialect, int offset);
    /// Times per second, 0 for never.
    void wish(Log log, double hertz);
    [[nodiscard]] bool isHeard() const { return m_heard; }
    [[nodiscard]] const QuestionWatch &questions() const { return m_questions; }
    /// What this drive is sent, others do, too: it has offset 0, and others answer. Then nobody is asked for the voltage log.
    [[nodiscard]] bool reachesOthers() const { return m_offset == 0 && m_questions.hearsOthers(); }
    /// One that was heard at any time, a drive of dialect LL, takes a stop of eight bytes for a set-point.
    [[nodiscard]] bool reachesOldest() const { return m_offset == 0 && m_questions.hears(dialectLL); }

private:
    void receive(const CanFrame &frame);
    void count(const CanFrame &frame);
    void followRequest(const CanFrame &frame);
    void schedule();
    void ask();
    void expired();
    void timedOut();
    void arrived(Log log, std::int32_t value, Instant time);
    [[nodiscard]] std::optional<LogReply> replyIn(const CanFrame &frame) const;
    [[nodiscard]] std::size_t pollers() const;
    [[nodiscard]] Duration gap() const;
    [[nodiscard]] Log mostUrgent() const;

    struct Wish {
        Duration period{}; ///< zero: never
        Instant due{};
    };

    CanLink &m_link;
    Clock &m_clock;
    Events m_events;
    bool m_isRecording;
    QuestionWatch m_questions;
    const Dialect *m_dialect = nullptr;
    int m_offset = 0;
    std::array<Wish, logCount> m_wishes{};
    std::array<Instant, maxOffset + 1> m_askedSeen{}; ///< when each drive of the link was asked last
    std::optional<Log> m_open;
    Instant m_freeAt{}; ///< not before then: the wire is for others too
    Instant m_askedAt{};
    Instant m_wireFreeAt{}; ///< when what this program has sent to other families will have left, as far as it knows
    int m_missed = 0;
    bool m_heard = false;
    Timer m_timer;
    Subscription m_traffic;
    Subscription m_received;
};

} // namespace mb::abstractdc
