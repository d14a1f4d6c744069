// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/progress.h"
#include "async/task.h"
#include "model/devicedriver.h"
#include "model/deviceguard.h"
#include "model/deviceknowledge.h"
#include "model/devicestop.h"
#include "model/identity.h"
#include "model/liveness.h"
#include "model/livestate.h"
#include "model/motiongate.h"
#include "model/parameterstore.h"
#include "model/shared.h"
#include "model/stoppable.h"
#include "telemetry/telemetry.h"
#include "transport/link.h"

#include <memory>

namespace mb {

/// One controller. Engine thread only, but for `telemetry()`, whose readers may be anywhere. Tasks it returns must end or be
/// destroyed before it; one of its tasks at a time.
class Device : public Stoppable, public DeviceDriver {
public:
    virtual ~Device();

    [[nodiscard]] Link &link() const override { return m_link; }
    [[nodiscard]] Clock &clock() const override { return m_clock; }
    [[nodiscard]] const Identity &identity() const { return *m_identity; }
    /// The same object until it changes; for other threads.
    [[nodiscard]] const Shared<Identity> &sharedIdentity() const { return m_identity.shared(); }
    /// What a newer scan found.
    void setIdentity(Identity identity);
    [[nodiscard]] std::string selector() const override { return selectorOf(m_link.address(), *m_identity).text(); }

    [[nodiscard]] ParameterStore &parameters() { return m_parameters; }
    [[nodiscard]] const ParameterStore &parameters() const { return m_parameters; }
    [[nodiscard]] const std::shared_ptr<Telemetry> &telemetry() const { return m_telemetry; }
    [[nodiscard]] const Liveness &liveness() const override { return m_liveness; }
    /// What it tells of itself by the rows of Family::states: limits that hold, a halt, levels of pins. Nothing while it is not heard.
    [[nodiscard]] const LiveStates &states() const { return m_states; }
    /// Identity, liveness, faults or states changed; of inputs it is told every 50 ms at most.
    [[nodiscard]] Listeners<> &changed() { return m_changed; }
    /// Any of states() changed, with the time of the frame that told it; as often as frames come.
    [[nodiscard]] Listeners<Instant> &statesChanged() { return m_statesChanged; }

    /// Raw value in force; the store follows. Unsupported for a write-only parameter.
    [[nodiscard]] Task<std::int64_t> read(ParameterIndex index);
    /// Writes, and yields what the device says is in force (for a write-only one, what was sent). For a Counter, the
    /// value before it was cleared. Does not compare: see parametertransfer.h.
    [[nodiscard]] Task<std::int64_t> write(ParameterIndex index, std::int64_t raw);
    /// Stops the motor and restarts the device (Capabilities::restart); ends when it has answered again. Unsafe while busy.
    [[nodiscard]] Task<void> restart();

    /// Who stops the motor if this program dies. A device without a watchdog takes commands only while it stands.
    [[nodiscard]] DeviceGuard &guard() { return m_guard; }

    /// What this program knows of the device that the device cannot tell.
    [[nodiscard]] DeviceKnowledge &knowledge() { return m_knowledge; }
    [[nodiscard]] const DeviceKnowledge &knowledge() const { return m_knowledge; }

    /// What of this program stands before a motion.
    [[nodiscard]] MotionGate &gate() { return m_gate; }
    [[nodiscard]] const MotionGate &gate() const { return m_gate; }
    /// Why this device must not be driven now: duplicate, bootloader, foreign master, a restart until refresh(), update …, or success.
    [[nodiscard]] Result<void> mayMove() const;
    /// One control frame, now. Unsafe while a guard is needed and does not stand. Must be repeated within the device's watchdog time: SetPointStream does.
    [[nodiscard]] Result<void> command(const SetPoint &setPoint);
    /// Starts the buffered moves of every device on this link at the same moment (Capabilities::bufferedMoves). Unsafe while a
    /// guard is needed and does not stand. It knows of this device only: SessionStops::releaseMoves() looks at the others.
    [[nodiscard]] Result<void> releaseMoves();
    /// Stop, now, without waiting for anything; before everything that is queued on the link. Always allowed. stopping() follows
    /// it up.
    void stop() override;
    /// Whether STOP does it no harm even when it does not move: Unsafe with the reason for a unit in its bootloader or under
    /// update, a recording, and where what stops others of the family may start this one.
    [[nodiscard]] Result<void> mayStop() const override;
    [[nodiscard]] DeviceStop &stopping() { return m_stop; }
    /// The same stop once more; telemetry that is younger than the first counts. Families that repeat a stop by themselves do
    /// nothing here.
    void repeatStop() override { doStop(); }

protected:
    Device(const Family &family, Link &link, Clock &clock, Identity identity);
    /// For families: updates what is known, and notifies if it differs.
    void setLiveness(const Liveness &liveness);
    /// The same with what it tells of itself; `time` is that of the frame that told. Call it with every such frame.
    void setLiveness(const Liveness &liveness, const LiveStates &states, Instant time);

private:
    Link &m_link;
    Clock &m_clock;
    Published<Identity> m_identity;
    ParameterStore m_parameters;
    DeviceKnowledge m_knowledge;
    std::shared_ptr<Telemetry> m_telemetry;
    Liveness m_liveness;
    LiveStates m_states;
    LiveStates m_toldStates; ///< as changed() told them
    Instant m_statesToldAt{};
    Listeners<Instant> m_statesChanged;
    Listeners<> m_changed;
    MotionGate m_gate;
    DeviceGuard m_guard;
    DeviceStop m_stop;
    Subscription m_profileApplied;
};

} // namespace mb
