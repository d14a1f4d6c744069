// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/abstractdc/logpoller.h"
#include "families/abstractdc/motionsense.h"
#include "families/abstractdc/outputwatch.h"
#include "families/abstractdc/whereabouts.h"

#include <map>
#include <memory>

namespace mb::abstractdc {

/// What the polled logs of one drive say: samples for its telemetry, whether it turns and where; and how often each log is
/// asked for. Logs that stand still outside their mode are neither asked for nor recorded (README.md#stale-logs). Engine thread.
class LogSense {
public:
    /// What follows from the logs.
    struct Owner {
        std::function<void(Restart)> restarted;                    ///< as far as its positions tell
        std::function<void(const Whereabouts::Counters &)> stands; ///< keeps where
        std::function<void()> wrapped;                     ///< the output has turned to full reverse: OutputWatch
        std::function<void(std::int32_t, Instant)> output; ///< of the loop that runs, PWM units
        std::function<void()> silent;                      ///< several questions in a row have had no answer
        std::function<void()> heard;                       ///< a log was taken
    };

    /// `profile` has the scales of the samples and outlives this.
    LogSense(
        CanLink &link, Clock &clock, std::shared_ptr<Telemetry> telemetry, const DeviceProfile &profile, Owner owner);

    /// nullptr: not proven.
    void speak(const Dialect *dialect, int offset);
    [[nodiscard]] const Dialect *dialect() const { return m_dialect; }
    /// The loop that has the motor from `time` on, nothing while it is not known. True if it is another.
    bool enter(std::optional<Loop> loop, Instant time);
    [[nodiscard]] std::optional<Loop> loop() const { return m_loop; }
    [[nodiscard]] bool isDriven() const { return m_loop && *m_loop != Loop::None; }
    /// Device::setRate().
    [[nodiscard]] Result<void> wish(ChannelIndex channel, double hertz);
    /// Unsafe: what this drive is sent, others do, too (LogPoller::reachesOthers()).
    [[nodiscard]] Result<void> isAddressedAlone() const;
    /// LogPoller::reachesOldest()
    [[nodiscard]] bool reachesOldest() const { return m_poller.reachesOldest(); }
    /// After a silence: nothing that was known holds.
    void forget();

    [[nodiscard]] bool isHeard() const { return m_poller.isHeard(); }
    [[nodiscard]] bool isMoving() const { return m_motion.isMoving(m_clock.now()); }
    [[nodiscard]] const MotionSense &motion() const { return m_motion; }
    [[nodiscard]] const QuestionWatch &questions() const { return m_poller.questions(); }
    [[nodiscard]] OutputWatch &output() { return m_output; }
    [[nodiscard]] const OutputWatch &output() const { return m_output; }
    /// What the loop regulates: counts/s or counts; nothing for other loops, and while it is not known. Where the drive's own
    /// speed and that of its positions differ, the one further from `target`: its own may be older than is known.
    [[nodiscard]] std::optional<double> feedback(Loop loop, double target) const;
    /// What the velocity loop measures until it has passed twice.
    [[nodiscard]] Whereabouts::SpeedRange entrySpeed() const
    {
        return m_whereabouts.entrySpeed(m_motion.velocity(m_clock.now()).value_or(0.0));
    }
    /// The loop has passed twice, so that what the drive tells of it is of this run (README.md#stale-logs).
    [[nodiscard]] bool hasPassed(Instant time) const;

private:
    /// Asks as often as is wished for and the loop deserves.
    void plan();
    [[nodiscard]] double rateOf(Log log) const;
    [[nodiscard]] bool isFresh(Log log) const;
    void take(Log log, std::int32_t value, Instant time);
    void takePosition(std::int32_t value, Instant time);
    void takeVoltage(std::int32_t value, Instant time);

    CanLink &m_link;
    Clock &m_clock;
    std::shared_ptr<Telemetry> m_telemetry;
    const DeviceProfile &m_profile;
    Owner m_owner;
    const Dialect *m_dialect = nullptr;
    LogPoller m_poller;
    MotionSense m_motion;
    Whereabouts m_whereabouts;
    OutputWatch m_output;
    std::map<Log, double> m_wishes;   ///< of setRate()
    std::optional<Loop> m_loop;       ///< last commanded, by us or by somebody we heard
    Instant m_enteredAt{};            ///< this loop
    std::optional<double> m_velocity; ///< as the drive measures it, counts/s
    Timer m_look;
};

} // namespace mb::abstractdc
