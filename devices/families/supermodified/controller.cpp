// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/supermodified/controller.h"

#include "families/supermodified/channels.h"
#include "families/supermodified/parameters.h"
#include "families/supermodified/states.h"
#include "model/family.h"

#include <algorithm>

namespace mb::supermodified {
namespace {

using namespace std::chrono_literals;

constexpr int missesOfSilence = 3;
constexpr Duration foreignMemory = 500ms;
constexpr std::size_t stopExchange = 2 * frameOverhead; ///< bytes
constexpr std::size_t longestExchange = 2 * frameOverhead + sizeof(std::int64_t);
constexpr std::chrono::milliseconds turnaround{2};
constexpr std::chrono::milliseconds longestPause{100};
constexpr std::size_t fillerSize = mostDataD1D2 + 2; ///< of a frame whose count or rest is missing
constexpr int stopAttempts = 20;

/// Codes that say that the bridge is off.
bool endsMotion(std::uint8_t code)
{
    return code >= code::motorStalled && code <= code::encoderUnderflow;
}

} // namespace

Controller::Controller(const Family &family, SerialLink &link, Clock &clock, Identity identity)
    : Device(family, link, clock, std::move(identity))
    , m_serial(link)
    , m_line(Line::of(link, clock))
    , m_node(nodeOf(this->identity(), link))
    , m_motion(*m_line, m_node,
          {[this] { onMotion(); }, [this](std::span<const std::uint8_t> codes) { onCodes(codes); },
              [this](const Frame &reply) { m_polls.takePosition(reply); },
              [this](Command command, std::int64_t raw) { onStored(command, raw); }})
    , m_polls(*m_line, m_node, *telemetry(),
          {[this](const Result<Frame> &reply) { onAnswer(reply); }, [this](std::int64_t raw) { onPosition(raw); },
              [this](std::uint8_t levels) { setStates(statesOf(levels), this->clock().now()); }})
    , m_foreignTimer(clock)
    , m_followerStop(clock)
    , m_followersTold(m_line->followersTold().add([this] { stopAsFollower(); }))
    , m_overheard(m_line->overheard().add([this](const Frame &frame) { onOverheard(frame); }))
    , m_linkState(link.stateChanged().add([this](LinkState state) { onLinkState(state); }))
    , m_identityChanged(changed().add([this] { identityChanged(); }))
{
    doProfileChanged();
    m_line->roster().note(m_node.id, m_node.baudrate);
    m_followerStop.startIn(Duration::zero(), [this] { stopAsFollower(); }); // once somebody follows its stops up
}

/// Another node was driven, and this one has done the same.
void Controller::stopAsFollower()
{
    if (m_line->takeFollowerStop(m_node.id))
        stopping().inherit();
}

/// Whoever destroys it while the motor may turn cannot wait for an acknowledgement; on real links the guardian sees to it.
Controller::~Controller()
{
    m_line->setDriving(m_node.id, false);
    if ((m_motion.isEnergized() || m_motion.isStopping()) && m_serial.state() == LinkState::Open) {
        Frame stop = request(m_node.id, m_line->roster().hostId(), Command::Stop);
        (void)m_serial.send(uartBytes(stop), Priority::Urgent);
    }
}

// Control

bool Controller::doOffers(ParameterIndex index) const
{
    return isOffered(parameters().parameter(index), m_node.dialect);
}

Result<void> Controller::doCheck(const SetPoint &setPoint) const
{
    return m_motion.check(setPoint);
}

/// A node that follows this one would move too, unwatched, and one that takes answers for commands might.
Result<void> Controller::doMayMove() const
{
    if (const Message lock = m_line->roster().lockOf(m_node.id); !lock.empty())
        return fail(Fault::Unsafe, lock);
    return {};
}

Message Controller::doCaution(const SetPoint &setPoint) const
{
    return m_motion.caution(setPoint);
}

Result<void> Controller::doCommand(const SetPoint &setPoint)
{
    if (!m_node.dialect)
        return fail(Fault::Unsafe, say("its dialect is not known, so no move can be sent"), say("read it again"));
    if (auto taken = m_motion.command(setPoint); !taken)
        return taken;
    telemetry()->append({channel::setPoint, clock().now(), setPoint.target});
    return {};
}

Result<void> Controller::doReleaseMoves()
{
    return m_motion.release();
}

void Controller::doStop()
{
    if (stopping().hasMoved())
        m_line->leaderStopped(m_node.id);
    m_motion.stop();
    telemetry()->breakLine(channel::setPoint);
    updateLiveness();
}

bool Controller::doIsSeenStopped() const
{
    const auto acknowledged = m_motion.stoppedAt();
    return !m_motion.isStopping() && acknowledged && *acknowledged >= stoppedAt();
}

/// What was asked last is answered first, because bytes that collide can lock D1 and D2 up; then zeros end the half of a frame
/// that a dying program left there: else the node would take the stop for the rest of it.
StopScript Controller::doStopScript() const
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
    StopStep step;
    step.bytes = uartBytes(request(m_node.id, host, Command::Stop));
    step.reply = uartBytes(request(host, m_node.id, Command::Stop));
    step.wait = legal(onWire(stopExchange) + answerTime);
    step.attempts = stopAttempts;
    StopStep everybody;
    everybody.bytes = uartBytes(request(broadcastId, host, Command::GlobalStop));
    everybody.wait = 1ms;
    return StopScript{{std::move(pause), std::move(filler), std::move(step), std::move(everybody)}};
}

// What the node says

void Controller::onAnswer(const Result<Frame> &reply)
{
    if (!reply) {
        if (reply.error().fault == Fault::LinkLost || ++m_misses >= missesOfSilence)
            setHeard(false);
        return;
    }
    m_missed = std::exchange(m_misses, 0) > 0;
    if (const auto codes = codesOf(*reply)) {
        const std::vector<std::uint8_t> kept(codes->begin(), codes->end());
        onCodes(kept);
    }
    setHeard(true);
    if (m_missed)
        m_motion.reassert(); // it may have lost its supply meanwhile
    updateLiveness();
}

void Controller::onCodes(std::span<const std::uint8_t> codes)
{
    for (const std::uint8_t code : codes) {
        Reported &reported = m_codes[code];
        ++reported.count;
        if (!endsMotion(code))
            continue;
        reported.active = true;
        if (m_motion.isEnergized())
            m_motion.tripped(say("%1, and the device switched its output off", codeText(code)));
    }
    updateLiveness();
}

void Controller::onPosition(std::int64_t raw)
{
    if (m_missed && m_position.value_or(0) != 0 && raw == 0)
        m_restarted = true; // counts are gone after a silence: it lost its supply
    m_position = raw;
    m_motion.setPosition(raw);
}

void Controller::onOverheard(const Frame &frame)
{
    const CommandForm *const message = messageOf(frame.command);
    const bool forUs = frame.to == m_node.id || frame.to == broadcastId;
    if (!forUs || frame.from == m_line->roster().hostId() || message == nullptr || !message->control)
        return;
    m_motion.doubt();
    m_foreignAt = clock().now();
    m_foreignTimer.startIn(foreignMemory, [this] {
        m_foreignAt.reset();
        updateLiveness();
    });
    updateLiveness();
}

void Controller::onLinkState(LinkState state)
{
    if (state != LinkState::Open) {
        setHeard(false);
        return;
    }
    m_polls.nodeChanged();
    m_motion.resume();
}

void Controller::onMotion()
{
    const bool energized = m_motion.isEnergized();
    if (energized && !std::exchange(m_energized, energized)) {
        m_position = 0; // by Start
        for (auto &[code, reported] : m_codes)
            reported.active = false;
    }
    m_energized = energized;
    m_polls.setOrigin(m_motion.origin());
    m_polls.setDriven(energized);
    m_polls.setKnownOff(m_motion.isKnownOff());
    updateLiveness();
}

void Controller::onStored(Command command, std::int64_t raw)
{
    if (const auto index = parameterWithId(static_cast<std::uint16_t>(command)))
        parameters().setRead(*index, raw);
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
    const double scale = profile().calibrated(calibration::amperes);
    m_polls.setCurrentScale(scale);
    telemetry()->useTable(channelTable(m_node.dialect == Dialect::D3 || scale > 0.0));
}

void Controller::setHeard(bool heard)
{
    if (std::exchange(m_heard, heard) && !heard)
        m_motion.doubt(); // whatever happens to it now is not seen
    m_polls.setHeard(heard);
    if (!heard)
        setStates({}, clock().now());
    updateLiveness();
}

void Controller::updateLiveness()
{
    Liveness now;
    now.heard = m_heard;
    now.moving = m_motion.isEnergized() || (m_heard && m_polls.isTurning());
    now.foreignMaster = m_foreignAt.has_value();
    now.restarted = m_restarted;
    if (const auto &applied = m_motion.applied(); applied && m_motion.isEnergized())
        now.mode = applied->mode;
    for (const CodeName &name : codeNames()) {
        const auto reported = m_codes.find(name.code);
        if (reported != m_codes.end() && reported->second.active)
            now.faults.emplace_back(name.key);
    }
    setLiveness(now);
}

std::unique_ptr<Device> open(Link &link, Clock &clock, const Identity &identity)
{
    extern const Family family;
    auto *const serial = dynamic_cast<SerialLink *>(&link);
    return serial ? std::make_unique<Controller>(family, *serial, clock, identity) : nullptr;
}

} // namespace mb::supermodified
