// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/guardian/message.h"

#include <deque>

namespace mb::guardian {

/// On the line of some monotonic clock that the caller reads.
using Time = std::chrono::nanoseconds;

/// The link's descriptor, as the runner uses it. Nothing here waits.
class Port {
public:
    enum class Sent {
        All,
        Later, ///< full, or off for now: the same bytes again, and what was written of them is remembered
        Lost,  ///< the device file is dead for good
    };
    Port() = default;
    Port(const Port &) = delete;
    Port &operator=(const Port &) = delete;
    virtual ~Port() = default;

    virtual Sent send(std::span<const std::uint8_t> bytes) = 0;
    /// What has come, in order; empty when there is nothing.
    virtual Bytes read() = 0;
    /// A question is about to be sent: what came before it is no answer to it.
    virtual void prepare() { (void)read(); }
    /// The program drives: as it has set the line up now, stops are sent.
    virtual void keepSetup() { }
    /// A stop begins: somebody may have set the line up otherwise.
    virtual void restoreSetup() { }
    /// What was written of a message that will not be sent again is no part of the next one.
    virtual void forget() { }
    /// Bytes of one message of read(), which answers are looked for in; 1: messages have no bounds.
    [[nodiscard]] virtual std::size_t messageSize() const { return 1; }
};

/// Carries out stop scripts on one line, taking turns after each attempt, so that a device that is silent does not hold up the
/// others. What several have to say at once, and nobody answers, such as a stop for all, is said once. Waiting for an answer keeps
/// the line: half-duplex buses know one request at a time. Pure: the caller brings the time.
class Runner {
public:
    struct Outcome {
        std::uint32_t id = 0;
        bool confirmed = false; ///< all was sent, and every answer came
        bool sent = true;       ///< false: the line takes nothing
        bool proved = false;    ///< confirmed by the device: there were answers to wait for
    };

    explicit Runner(Port &port)
        : m_port(port)
    {
    }
    /// How long an interface that is off may take to come back, such as a CAN controller after bus-off.
    static constexpr std::chrono::seconds usualPatience{10};

    void add(std::uint32_t id, const Script &script, Time now, Time patience = usualPatience);
    /// Does what is due. Yields what came to its end.
    [[nodiscard]] std::vector<Outcome> proceed(Time now);
    /// When to proceed at the latest; nothing when there is nothing to do.
    [[nodiscard]] std::optional<Time> due() const;
    /// Proceed also when something can be read.
    [[nodiscard]] bool isListening() const { return m_answerUntil.has_value(); }
    [[nodiscard]] bool isIdle() const { return m_jobs.empty(); }

private:
    struct Job {
        std::uint32_t id = 0;
        Script script;
        std::size_t step = 0;
        int attempts = 0; ///< of the present step, done
        bool confirmed = true;
        Time notBefore{};
    };

    void listen(Time now);
    [[nodiscard]] bool attempt(Time now);
    void wasSaid(const Step &step, Time now);
    void giveUp();
    void endStep(Job &job, bool good);
    void retire();

    Port &m_port;
    std::deque<Job> m_jobs; ///< the front one is next, or waits for its answer
    std::optional<Time> m_answerUntil;
    std::optional<Time> m_blockedUntil;
    Time m_patientUntil{};
    Bytes m_heard;
    std::vector<Outcome> m_ended;
};

} // namespace mb::guardian
