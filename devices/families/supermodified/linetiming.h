// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/supermodified/answertime.h"
#include "families/supermodified/linerequest.h"
#include "transport/seriallink.h"

#include <map>
#include <optional>

namespace mb::supermodified {

/// How long a line waits for the answer to a question: as its answers were measured, late ones included, and longer for a node
/// that has missed some.
class LineTiming {
public:
    /// Both outlive it.
    LineTiming(SerialLink &link, Clock &clock)
        : m_link(link)
        , m_clock(clock)
    {
    }

    /// After the wire time of both frames.
    [[nodiscard]] Duration patienceFor(const LineRequest &request) const;
    /// The answer to what was sent until `sentEnd` has come. Not measured where it may also answer the same question that was given
    /// up before.
    void answered(const Frame &question, Instant sentEnd, const Frame &reply);
    /// An answer to what was given up before may look like this one.
    [[nodiscard]] bool mayBeEarlier(const Frame &question, const Frame &reply) const;
    /// There was no answer; `known`: by a node that was there before.
    void gaveUp(const Frame &question, Instant sentEnd, bool known);
    /// A frame that nobody waits for: the answer to what was given up says how long answers take now.
    void late(const Frame &reply);
    /// A deadline of this program was served so long after its time.
    void addLateness(Duration lateness) { m_times.addLateness(lateness); }
    [[nodiscard]] const AnswerTime &times() const { return m_times; }

private:
    /// A question that was given up; its answer may still come.
    struct Missed {
        Frame frame;
        Instant sentEnd{};
    };
    void measure(const Frame &reply, Instant sentEnd);

    SerialLink &m_link;
    Clock &m_clock;
    AnswerTime m_times;
    std::map<int, int> m_misses; ///< of a node, in a row
    std::optional<Missed> m_missed;
};

} // namespace mb::supermodified
