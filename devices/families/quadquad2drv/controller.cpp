// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/quadquad2drv/controller.h"

#include "async/sleep.h"
#include "families/quadquad2drv/channels.h"
#include "families/quadquad2drv/scan.h"
#include "model/family.h"

#include <utility>

namespace mb::quadquad2drv {
namespace {

using namespace std::chrono_literals;

constexpr Duration pollPeriod = 10ms;
constexpr Duration silence = 300ms;
constexpr Duration lookPeriod = 100ms;
constexpr Duration startTime = 100ms; ///< after a reset (README.md#waiting-packets)

Task<void> ask(PacketPort &port)
{
    co_await port.request(getRequest(PacketId::GetMotion), 1);
    co_return {};
}

constexpr int refreshTries = 3; ///< as for every other question; the polls are asked once

Task<void> sendAll(PacketPort &port, std::vector<Bytes> requests)
{
    for (const Bytes &request : requests)
        co_await port.request(request);
    co_return {};
}

} // namespace

extern const Family family;

Controller::Controller(const Family &known, SpiLink &link, Clock &clock, Identity identity)
    : Device(known, link, clock, std::move(identity))
    , m_spi(link)
    , m_port(link, clock)
    , m_layout(link, m_port, clock,
          {[this] { return knowledge().holdsSettings(); }, [this] { onReset(); }, [this] { schedulePoll(); }})
    , m_settings(parameters(), knowledge().profile())
    , m_sense(telemetry())
    , m_orders(clock, m_port, m_layout, [this] { stop(); })
    , m_drives(clock, *telemetry(), m_sense, m_settings, m_orders)
    , m_stopProof(
          clock, m_port,
          [this] { // takes the modes of all axes, and the settings; a bootloader that is written to would begin anew
              if (gate().busy().empty() && m_spi.pulseReset())
                  m_layout.forget();
          },
          [this] { m_orders.stopEnded(); })
    , m_received(m_port.received().add([this](const Packet &packet, Instant time) { onPacket(packet, time); }))
    , m_state(link.stateChanged().add([this](LinkState) { look(); }))
    , m_poll(clock)
    , m_look(clock)
    , m_scope(clock)
{
    m_readyRaised = link.readyRaised().add([this] {
        if (m_layout.streamPeriod() > 0 && m_spi.turns().isFree())
            m_scope.spawn(m_port.fetch());
    });
    look();
}

void Controller::onPacket(const Packet &packet, Instant time)
{
    const bool stream = packet.id == static_cast<std::uint8_t>(PacketId::Stream);
    if (stream || packet.id == static_cast<std::uint8_t>(PacketId::GetMotion)) {
        if (const auto motion = parseMotion(packet, m_port.masks(), m_port.streamConfig())) {
            if (stream)
                m_sense.missed(m_port.masks(),
                    m_missed.before(motion->elapsed, time, streamUnit * m_layout.streamPeriod(), m_port.takeDamage()));
            onMotion(*motion, time);
        } else if (!m_learning && gate().busy().empty()) { // another program has changed what the board sends
            m_learning = true;
            m_scope.spawn<void>(m_layout.read(), [this](const Result<void> &) { m_learning = false; });
        }
    }
}

void Controller::onMotion(const Motion &motion, Instant time)
{
    m_motionAt = time;
    m_heard = true;
    LiveStates told = states();
    m_sense.take(motion, m_port.masks(), time, told);
    setLiveness(liveness(), told, time);
    telemetry()->commit();
    updateLiveness();
}

void Controller::schedulePoll()
{
    if (m_layout.streamPeriod() > 0 || m_spi.state() != LinkState::Open) {
        m_poll.stop();
        return;
    }
    m_poll.startIn(pollPeriod, [this] {
        if (m_polling) {
            m_missed.pollHeldUp();
        } else if (gate().busy().empty()) {
            m_polling = true;
            m_scope.spawn<void>(ask(m_port), [this](const Result<void> &asked) {
                m_polling = false;
                const std::uint64_t missing = m_missed.polled(asked.has_value());
                if (m_heard && m_spi.state() == LinkState::Open)
                    m_sense.missed(m_port.masks(), missing);
            });
        }
        schedulePoll();
    });
}

void Controller::look()
{
    const bool wasHeard = m_heard;
    if (m_spi.state() != LinkState::Open)
        m_heard = false;
    const Instant now = clock().now();
    if (m_motionAt && now - *m_motionAt > silence)
        m_heard = false;
    if (!m_heard)
        setLiveness(liveness(), {}, now);
    if (wasHeard && !m_heard)
        breakLines();
    const auto followOwedRate = [this] {
        if (!gate().busy().empty() || !m_layout.takeOwedRate())
            return;
        m_scope.spawn<bool>(m_layout.resumeRate(), [this](const Result<bool> &another) {
            if (another && *another)
                breakLines();
        });
    };
    const bool streamGone
        = m_layout.streamPeriod() > 0 && (!m_missed.streamAt() || now - *m_missed.streamAt() > silence);
    if ((streamGone || m_layout.isInDoubt(m_heard)) && !m_checking && gate().busy().empty()
        && m_spi.state() == LinkState::Open) {
        m_checking = true;
        // another program may have ended the stream
        auto looking = streamGone && !m_heard ? m_layout.read() : m_layout.check();
        m_scope.spawn<void>(std::move(looking), [this, followOwedRate](const Result<void> &answered) {
            m_checking = false;
            if (answered)
                followOwedRate();
        });
    }
    if (m_heard)
        followOwedRate();
    if (!m_poll.isActive())
        schedulePoll();
    updateLiveness();
    m_look.startIn(lookPeriod, [this] { look(); });
}

void Controller::onReset()
{
    m_drives.forget();
    m_orders.clear();
    m_sense.forget();
    knowledge().settingsLost();
    schedulePoll();
    updateLiveness();
}

void Controller::updateLiveness()
{
    Liveness now;
    now.heard = m_heard;
    now.restarted = m_layout.hasRestarted();
    for (int axis = 0; axis < axes; ++axis) {
        const bool moving = m_drives.isDriven(axis) || (m_heard && m_sense.isTurning(axis));
        now.moving = now.moving || moving;
        now.axes.push_back({m_heard ? std::optional(m_drives.mode(axis)) : std::nullopt, moving});
    }
    now.faults = m_sense.faults();
    setLiveness(now);
}

// Set-points and the stop

Result<void> Controller::doCommand(const SetPoint &setPoint)
{
    auto taken = m_drives.command(setPoint);
    if (taken)
        updateLiveness();
    return taken;
}

void Controller::doStop()
{
    m_orders.stop();
    m_drives.stop();
    m_stopProof.begin();
    updateLiveness();
}

/// README.md#stopping: the board has no watchdog. A transfer may come in the middle of another one, so it is sent three times.
StopScript Controller::stopScript() const
{
    StopStep off;
    off.bytes = setControlMode(allAxes, ControlMode::Off);
    off.wait = 10ms;
    off.attempts = 3;
    return {{off}};
}

bool Controller::isSeenStopped() const
{
    return m_stopProof.isConfirmed() && m_heard && m_motionAt && *m_motionAt > gate().stoppedAt();
}

// What asks and waits

Task<void> Controller::refresh()
{
    const Packet reply = co_await m_port.request(getRequest(PacketId::GetVersion));
    const auto version = parseVersion(reply);
    if (!version)
        co_return fail(Fault::BadReply, say("the version has an unexpected length"));
    co_await m_layout.check(refreshTries);
    co_await m_layout.read();
    Identity known = identity();
    setVersion(known, version->major, version->minor, version->protocol);
    m_layout.refreshed();
    setIdentity(std::move(known));
    updateLiveness();
    co_return {};
}

Task<std::int64_t> Controller::doRead(ParameterIndex index)
{
    return readParameter(m_port, index);
}

Task<void> Controller::doMayWrite(ParameterIndex index, std::int64_t, std::span<const ParameterChange>)
{
    const int axis = index.value / parametersPerAxis;
    const bool isCounter
        = !isBoard(index) && static_cast<AxisParameter>(index.value % parametersPerAxis) == AxisParameter::Counter;
    if (isCounter && m_drives.controlMode(axis) == ControlMode::Position)
        co_return fail(
            Fault::Unsafe, say("in position mode a new counter would make the motor jump"), say("stop it first"));
    co_return {};
}

Task<std::int64_t> Controller::doWrite(ParameterIndex index, std::int64_t raw)
{
    const Parameter &row = parameters().parameter(index);
    const bool ofAxis = !isBoard(index);
    const int axis = index.value / parametersPerAxis;
    const auto which = static_cast<AxisParameter>(index.value % parametersPerAxis);
    if (!ofAxis) { // its two halves travel together
        for (const BoardParameter other : {BoardParameter::HistoryLength, BoardParameter::HistoryTimeBits}) {
            auto reading = readParameter(m_port, indexOf(other));
            parameters().setRead(indexOf(other), co_await std::move(reading));
        }
    }
    if (m_port.masks()[0] == datamask::startUp)
        co_await m_layout.tellEverything();
    Bytes request = m_settings.write(index, raw);
    m_layout.noteChange();
    const Result<Packet> reply = co_await m_port.request(std::move(request)).attempt();
    if (!reply)
        co_return fail(reply.error().about(row.key));
    m_settings.accepted(index, raw);
    m_layout.chosen(index, raw);
    if (ofAxis && which == AxisParameter::DataMask) {
        DataMasks masks = m_port.masks(); // told, and so no sign of a reset
        masks[static_cast<std::size_t>(axis)] = static_cast<std::uint8_t>(raw);
        m_port.setLayout(masks, m_port.streamConfig());
    }
    co_await m_layout.read();
    if (row.access == Access::WriteOnly)
        co_return raw;
    const std::int64_t inForce = co_await readParameter(m_port, index);
    co_return inForce;
}

Task<bool> Controller::store(Progress &)
{
    co_return fail(Fault::Unsupported, say("the board keeps nothing without power"),
        say("the values stay with this program and are written again after a reset"));
}

Task<std::vector<FaultRecord>> Controller::readFaults()
{
    co_return m_sense.records();
}

Task<void> Controller::doRestart()
{
    if (auto pulsed = m_spi.pulseReset(); !pulsed)
        co_return pulsed;
    m_layout.forget();
    co_await Sleep(clock(), startTime);
    co_await refresh();
    co_return {};
}

Task<void> Controller::renumber(int)
{
    co_return fail(Fault::Unsupported, say("the board has no number: chip select tells boards apart"));
}

Task<void> Controller::setRate(ChannelIndex channel, double hertz)
{
    if (const bool another = co_await m_layout.setRate(channel, hertz); another)
        breakLines();
    co_return {};
}

/// Of what is measured: nobody knows what was between.
void Controller::breakLines()
{
    m_missed.interrupt();
    for (int axis = 0; axis < axes; ++axis) {
        for (std::uint16_t i = 0; i < measuredPerAxis; ++i)
            telemetry()->breakLine(channelOf(axis, static_cast<AxisChannel>(i)));
    }
}

/// Inputs that were written with the other reading are written again, so that they are what the parameters say.
void Controller::doProfileChanged()
{
    const bool changed = m_settings.takeReadingChange();
    if (changed && m_layout.isResetKnown() && m_spi.state() == LinkState::Open)
        m_scope.spawn<void>(sendAll(m_port, m_settings.writtenInputs()));
}

// For experiments

Task<void> Controller::tell(Bytes request)
{
    if (!m_layout.tellsEverything())
        co_await m_layout.tellEverything();
    m_layout.noteChange();
    co_await m_port.request(std::move(request));
    co_return {};
}

std::unique_ptr<Device> open(Link &link, Clock &clock, const Identity &identity)
{
    if (link.kind() != LinkKind::Spi)
        return nullptr;
    return std::make_unique<Controller>(family, static_cast<SpiLink &>(link), clock, identity);
}

} // namespace mb::quadquad2drv
