// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/supermodified/controller.h"

#include "async/sleep.h"
#include "families/supermodified/channels.h"
#include "families/supermodified/parameters.h"
#include "families/supermodified/states.h"
#include "model/family.h"

#include <QScopeGuard>

#include <algorithm>
#include <cmath>
#include <memory>

namespace mb::supermodified {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t stopExchange = 2 * frameOverhead; ///< bytes
constexpr std::size_t longestExchange = 2 * frameOverhead + sizeof(std::int64_t);
constexpr std::chrono::milliseconds turnaround{2};
constexpr std::chrono::milliseconds slowTurnaround{5}; ///< of a node whose loop runs
constexpr std::chrono::milliseconds longestPause{100};
constexpr std::size_t fillerSize = mostDataD1D2 + 2; ///< of a frame whose count or rest is missing
constexpr int stopAttempts = 20;
constexpr Duration stopLimit = 2s;
constexpr Duration lookAgain = 5ms;

} // namespace

Controller::Controller(const Family &family, SerialLink &link, Clock &clock, Identity identity)
    : Device(family, link, clock, std::move(identity))
    , m_serial(link)
    , m_line(Line::of(link, clock))
    , m_node(nodeOf(this->identity(), link))
    , m_motion(*m_line, m_node, gate(),
          {[this] { onMotion(); }, [this](std::span<const std::uint8_t> codes) { onCodes(codes); },
              [this](const Frame &reply) { m_polls.takePosition(reply); },
              [this](Command command, std::int64_t raw) {
                  if (const auto index = parameterWithId(static_cast<std::uint16_t>(command)))
                      parameters().setRead(*index, raw);
              }})
    , m_polls(*m_line, m_node, *telemetry(),
          {[this](const Result<Frame> &reply) { onAnswer(reply); },
              [this](std::int64_t raw) {
                  if (m_motion.count().mayHaveStarted(raw)) { // this sample counts from there already
                      m_presence.zeroed();
                      m_polls.setOrigin(m_motion.count().origin());
                  }
                  if (m_presence.hasJumped(raw))
                      m_motion.reassert();
                  m_presence.located(raw, m_motion.isBusy()); // reassert() has asked it
                  m_motion.setPosition(raw);
              },
              [this](std::uint8_t levels) { setLiveness(liveness(), statesOf(levels), this->clock().now()); }})
    , m_settings(
          *m_line, m_node, parameters(), knowledge(), [this](std::span<const std::uint8_t> codes) { onCodes(codes); })
    , m_presence(*m_line, m_node, {[this] { m_motion.doubt(); }, [this] { updateLiveness(); }})
    , m_followerStop(*m_line, m_node, [this] { stopping().inherit(this->clock().now()); })
    , m_linkState(link.stateChanged().add([this](LinkState state) {
        if (state != LinkState::Open) {
            setHeard(false);
            return;
        }
        m_polls.nodeChanged();
        m_motion.resume();
    }))
    , m_identityChanged(changed().add([this] { identityChanged(); }))
{
    doProfileChanged();
    m_line->roster().note(m_node.id, m_node.baudrate);
}

/// Whoever destroys it while the motor may turn cannot wait for an acknowledgement; on real links the guardian sees to it.
Controller::~Controller()
{
    m_line->driven().set(m_node.id, false);
    if ((m_motion.isEnergized() || m_motion.isStopping()) && m_serial.state() == LinkState::Open) {
        Frame stop = request(m_node.id, m_line->roster().hostId(), Command::Stop);
        (void)m_serial.send(uartBytes(stop), Priority::Urgent);
    }
}

// Control

/// A node that follows this one would move too, unwatched, and one that takes answers for commands might.
Result<void> Controller::doMayMove() const
{
    if (const Message lock = m_line->roster().lockOf(m_node.id); !lock.empty())
        return fail(Fault::Unsafe, lock);
    return {};
}

Message Controller::caution(const SetPoint &setPoint) const
{
    return m_motion.bounds().caution(setPoint);
}

Result<void> Controller::doCommand(const SetPoint &setPoint)
{
    if (!m_node.dialect)
        return fail(Fault::Unsafe, say("its dialect is not known, so no move can be sent"), say("read it again"));
    if (!m_zeroing.expired())
        return fail(Fault::Unsafe, say("its position is being reset"), say("try again"));
    MB_TRY_VOID(m_motion.command(setPoint));
    telemetry()->append({channel::setPoint, clock().now(), setPoint.target});
    return {};
}

void Controller::doStop()
{
    if (stopping().hasMoved())
        m_line->driven().leaderStopped(m_node.id);
    m_motion.stop();
    telemetry()->breakLine(channel::setPoint);
    updateLiveness();
}

bool Controller::isSeenStopped() const
{
    const auto acknowledged = m_motion.stoppedAt();
    return !m_motion.isStopping() && acknowledged && *acknowledged >= gate().stoppedAt();
}

/// What was asked last is answered first, because bytes that collide can lock D1 and D2 up; then zeros end the half of a frame
/// that a dying program left there: else the node would take the stop for the rest of it. All are told at once, which nobody answers,
/// before this one is until it acknowledges.
StopScript Controller::stopScript() const
{
    const auto onWire = [this](std::size_t bytes) {
        const auto time = std::chrono::nanoseconds(std::chrono::seconds(10)) * bytes / m_node.baudrate;
        return std::chrono::ceil<std::chrono::milliseconds>(time);
    };
    const auto legal
        = [](std::chrono::milliseconds wait) { return std::clamp<std::chrono::milliseconds>(wait, 1ms, 500ms); };
    const int host = m_line->roster().hostId();
    StopStep pause;
    pause.wait = legal(std::min(onWire(longestExchange) + turnaround, longestPause));
    StopStep filler;
    filler.bytes.assign(fillerSize, 0);
    filler.wait = legal(onWire(fillerSize));
    StopStep everybody;
    everybody.bytes = uartBytes(request(broadcastId, host, Command::GlobalStop));
    everybody.wait = legal(onWire(frameOverhead));
    everybody.forAll = true;
    StopStep step;
    step.bytes = uartBytes(request(m_node.id, host, Command::Stop));
    step.reply = uartBytes(request(host, m_node.id, Command::Stop));
    step.wait = legal(onWire(stopExchange) + answerTime);
    step.taken = legal(onWire(stopExchange) + slowTurnaround);
    step.attempts = stopAttempts;
    return StopScript{{std::move(pause), std::move(filler), std::move(everybody), std::move(step)}};
}

// What the node says

void Controller::onAnswer(const Result<Frame> &reply)
{
    if (!reply) {
        if (reply.error().fault == Fault::LinkLost || m_presence.missed())
            setHeard(false);
        return;
    }
    const bool wasMissed = m_presence.answered();
    if (const auto codes = codesOf(*reply)) {
        const std::vector<std::uint8_t> kept(codes->begin(), codes->end());
        onCodes(kept);
    }
    setHeard(true);
    if (wasMissed)
        m_motion.reassert(); // it may have lost its supply meanwhile
    updateLiveness();
}

void Controller::onCodes(std::span<const std::uint8_t> codes)
{
    for (const std::uint8_t code : codes) {
        if (code == code::invalidForState)
            m_presence.notStarted();
        if (m_codes.take(code) && m_motion.isEnergized())
            m_motion.tripped(say("%1, and the device switched its output off", codeText(code)));
    }
    updateLiveness();
}

void Controller::onMotion()
{
    const bool energized = m_motion.isEnergized();
    if (energized && !std::exchange(m_energized, energized)) {
        m_presence.zeroed(); // by Start
        m_codes.started();
    }
    m_energized = energized;
    if (energized && !m_motion.isBusy())
        m_presence.moved();
    m_polls.setOrigin(m_motion.count().origin());
    m_polls.setDriven(energized);
    m_polls.setKnownOff(m_motion.isKnownOff());
    updateLiveness();
}

void Controller::identityChanged()
{
    const Node now = nodeOf(identity(), m_serial);
    if (now.id == m_node.id && now.baudrate == m_node.baudrate && now.dialect == m_node.dialect)
        return;
    m_node = now;
    doProfileChanged();
    m_polls.nodeChanged();
}

/// D3 tells mA; what a count of the others stands for only the user knows.
void Controller::doProfileChanged()
{
    const double scale = knowledge().profile().calibrated(calibration::amperes);
    m_polls.setCurrentScale(scale);
    telemetry()->useTable(channelTable(m_node.dialect == Dialect::D3 || scale > 0.0));
}

void Controller::setHeard(bool heard)
{
    if (m_presence.setHeard(heard) && !heard)
        m_motion.doubt(); // whatever happens to it now is not seen
    if (Roster &roster = m_line->roster(); heard && !roster.nodes().contains(m_node.id)) { // a scan missed it
        roster.note(m_node.id, m_node.baudrate);
        if (const auto mask = maskOf(identity()))
            roster.noteMask(m_node.id, *mask);
        else
            roster.noteUnreadMask(m_node.id);
    }
    m_polls.setHeard(heard);
    if (!heard)
        setLiveness(liveness(), {}, clock().now());
    updateLiveness();
}

void Controller::updateLiveness()
{
    Liveness now;
    now.heard = m_presence.isHeard();
    now.moving = m_motion.isEnergized() || (m_presence.isHeard() && m_polls.isTurning());
    now.foreignMaster = m_presence.hasForeignMaster();
    now.restarted = m_presence.hasRestarted();
    if (const auto &order = m_motion.applied(); order && m_motion.isEnergized())
        now.mode = order->mode;
    now.faults = m_codes.active();
    setLiveness(now);
}

// What asks and waits

Task<void> Controller::doMayWrite(ParameterIndex index, std::int64_t raw, std::span<const ParameterChange>)
{
    if (parameters().parameter(index).id == id::gainP && m_motion.isEnergized())
        co_await m_motion.bounds().checkGain(raw, m_motion.applied().value_or(SetPoint()), m_motion.count().error());
    co_await m_settings.mayWrite(index, raw);
    co_return {};
}

Task<void> Controller::refresh()
{
    const Interview said = co_await interview(*m_line, m_node);
    m_presence.refreshed();
    Identity known = identityOf(m_line->roster(), m_node, said);
    known.name = identity().name;
    setIdentity(std::move(known));
    updateLiveness();
    co_return {};
}

/// A set is answered after its EEPROM was written (README.md#time-outs), so there is nothing left to prove.
Task<bool> Controller::store(Progress &)
{
    parameters().setAllStored();
    co_return true;
}

/// Errors come by themselves, in place of answers; a reading makes sure that none waits.
Task<std::vector<FaultRecord>> Controller::readFaults()
{
    (void)co_await m_settings.talk(asking(m_node, Command::GetPosition));
    co_return m_codes.records();
}

Task<std::vector<FaultRecord>> Controller::clearFaults()
{
    if (m_node.dialect == Dialect::D3) {
        (void)co_await m_settings.talk(asking(m_node, Command::ResetErrors));
    } else {
        (void)co_await m_settings.talk(asking(m_node, Command::GetPosition));
    }
    const std::vector<FaultRecord> were = m_codes.records();
    m_codes.clear();
    updateLiveness();
    co_return were;
}

// Position

/// README.md#start: a motor that runs would jump to where its old set-point is now. One that stands does not, and Start takes 0 for its
/// set-point afterwards.
Task<void> Controller::zeroPosition()
{
    stop();
    const auto zeroing
        = std::make_shared<bool>(true); // README.md#hang: the reset is sent again when its answer is lost
    m_zeroing = zeroing;
    const Instant limit = clock().now() + stopLimit;
    while (!isSeenStopped()) {
        if (clock().now() >= limit || m_serial.state() != LinkState::Open)
            co_return fail(Fault::Unsafe,
                say("the stop was not acknowledged, so the position was not reset: a motor that runs would jump"));
        co_await Sleep(clock(), lookAgain);
    }
    if (const Message lock = m_line->roster().lockOf(m_node.id); !lock.empty())
        co_return fail(Fault::Unsafe, say("the position was not reset: %1", lock));
    if (!m_motion.isKnownOff()) // README.md#hang
        co_return fail(Fault::Unsafe, say("somebody may have started it again, so the position was not reset"));
    const auto zeroes = qScopeGuard(gate().originMover()); // also when nobody knows whether it was
    (void)co_await m_settings.talk(asking(m_node, Command::ResetPosition));
    m_presence.zeroed();
    m_motion.count().zeroed();
    m_polls.zeroed();
    co_return {};
}

// Identity and rates

Task<void> Controller::renumber(int address)
{
    if (address < lowestNode || address > highestNode)
        co_return fail(Fault::OutOfRange, say("a node id is 1 … 127"));
    (void)co_await write(*parameterWithId(id::nodeId), address);
    co_return {};
}

Task<void> Controller::setRate(ChannelIndex channel, double hertz)
{
    if (!std::isfinite(hertz) || hertz < 0.0)
        co_return fail(Fault::OutOfRange, say("a rate is a positive number, or 0 for the usual one"));
    if (!m_polls.setRate(channel, hertz))
        co_return fail(Fault::Unsupported, say("the set-point comes from here, not from the device"));
    co_return {};
}

std::unique_ptr<Device> open(Link &link, Clock &clock, const Identity &identity)
{
    extern const Family family;
    auto *const serial = dynamic_cast<SerialLink *>(&link);
    return serial ? std::make_unique<Controller>(family, *serial, clock, identity) : nullptr;
}

} // namespace mb::supermodified
