// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/noncopyable.h"
#include "families/supermodified/motioncount.h"
#include "families/supermodified/motionstop.h"
#include "families/supermodified/movebounds.h"
#include "families/supermodified/profiledrun.h"
#include "model/motiongate.h"

#include <deque>
#include <functional>

namespace mb::supermodified {

/// What moves one node: turns set-points into starts and moves, each acknowledged before the next, and stops it.
///
/// A node has no set-point that must be kept alive, so an equal set-point sends nothing. Start zeroes the node's position
/// (README.md#start); positions stay continuous here (count()). Start resets the encoder, which
/// can hang a node that is started already (README.md#hang): where it is not known to be off, a stop goes first.
class Motion : NonCopyable {
public:
    struct Events {
        std::function<void()> changed;                     ///< isEnergized(), isStopping(), failure()
        CodeSink codes;                                    ///< error codes instead of an answer
        std::function<void(const Frame &)> positioned;     ///< a position was read on the way
        std::function<void(Command, std::int64_t)> stored; ///< a move needed this setting, which the node keeps
    };

    /// They outlive it. The gate is told of the moves that the node keeps.
    Motion(Line &line, const Node &node, MotionGate &gate, Events events);

    /// Whether the node could do it: Unsupported, OutOfRange. A node of unknown dialect is taken for the widest.
    [[nodiscard]] Result<void> check(const SetPoint &setPoint) const;
    /// By what is known of the node now.
    [[nodiscard]] MoveBounds bounds() const { return {m_node, m_line.roster().entry(m_node.id)}; }
    /// Takes a set-point; what it needs is sent one after the other. Fails with why the motion before it ended (stall, no
    /// answer) until stop() was called, and while a stop is not acknowledged.
    [[nodiscard]] Result<void> command(const SetPoint &setPoint);
    /// Broadcasts DoMove once everything that was commanded has been acknowledged; never after a motion that failed. Begins what other
    /// nodes of the line keep as well, so all must be ready. Each is then asked to begin by its own address, because a broadcast may
    /// be lost (README.md#buffered); one that has begun has nothing left to begin.
    [[nodiscard]] Result<void> release();
    /// Stops now, and goes on until the node has acknowledged it; across a lost link, too.
    void stop();
    /// A poll got no answer, or came back after silence: sends the present set-point again where that is harmless, so that
    /// a node that lost its power says that it is not started.
    void reassert();
    /// The node switched its bridge off by itself.
    void tripped(Message why);
    /// The link is open again.
    void resume() { m_stop.resume(); }
    /// Somebody else may have started it, or its supply was gone.
    void doubt();

    /// The bridge is on, as far as was acknowledged.
    [[nodiscard]] bool isEnergized() const { return m_energized; }
    /// A stop was acknowledged, and nothing since can have started it.
    [[nodiscard]] bool isKnownOff() const { return m_knownOff; }
    [[nodiscard]] bool isStopping() const { return m_stop.isPending(); }
    /// A move was commanded and its acknowledgement is not there.
    [[nodiscard]] bool isBusy() const;
    /// When the last stop was acknowledged.
    [[nodiscard]] std::optional<Instant> stoppedAt() const { return m_stop.acknowledgedAt(); }
    /// What it moves by; nothing before its first move has begun.
    [[nodiscard]] const std::optional<SetPoint> &applied() const { return m_applied; }
    [[nodiscard]] MotionCount &count() { return m_count; }
    /// The last position that the node told, without origin.
    void setPosition(std::int64_t raw);

private:
    enum class Step { Stop, Look, Start, Velocity, Acceleration, Move, Begin };
    [[nodiscard]] Result<void> mayBegin() const;
    void begun(const SetPoint &order);
    void pump();
    [[nodiscard]] Step nextStep() const;
    [[nodiscard]] Result<Line::Request> requestFor(Step step) const;
    void send(Step step);
    void answered(Step step, const Result<Frame> &reply);
    void done(Step step, const Frame &reply);
    void stored(Step step);
    void refused(Step step, std::span<const std::uint8_t> codes);
    void fail(Message why);
    void stopped();
    void setEnergized(bool energized);

    Line &m_line;
    const Node &m_node;
    MotionGate &m_gate;
    Events m_events;
    std::deque<SetPoint> m_orders; ///< not acknowledged yet; the first one is under way
    std::optional<SetPoint> m_wanted;
    std::optional<SetPoint> m_applied; ///< the node moves by it
    std::optional<Step> m_step;
    int m_tries = 0;
    bool m_looked = false;
    int m_starts = 0; ///< without an answer, in a row
    std::optional<ProfiledRun> m_run;
    bool m_energized = false;
    bool m_knownOff = false;
    std::optional<Message> m_failure;
    MotionCount m_count;
    Line::Ticket m_ticket;
    Line::Ticket m_releaseTicket;
    MotionStop m_stop;
    Subscription m_releasing;
};

} // namespace mb::supermodified
