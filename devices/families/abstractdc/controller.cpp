// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/controller.h"

#include "families/abstractdc/answertime.h"
#include "families/abstractdc/channels.h"
#include "families/abstractdc/codec.h"
#include "families/abstractdc/parameters.h"
#include "model/family.h"

#include <QtGlobal>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace mb::abstractdc {
namespace {

using namespace std::chrono_literals;

constexpr Duration repeatPeriod = 250ms; ///< of a set-point that did not change; the drive holds it by itself
constexpr Duration foreignMemory = 2s;
constexpr int proofAttempts = 3; ///< of its question
constexpr int stopRepeats = 3;   ///< of the stop script

/// Its own length first. The drive ignores the other one, which is for a dialect that was mistaken, and is left out where a drive of
/// dialect LL would take the long one for a set-point; the short one that ignores.
std::vector<CanFrame> stopsOf(const LogSense &logs, int offset, bool mayBoth)
{
    auto frames = stopFrames(offset);
    if (logs.dialect() && logs.dialect()->wide && logs.dialect()->canStop())
        std::swap(frames.front(), frames.back());
    const bool isAlone = !mayBoth || logs.reachesOldest();
    return {frames.begin(), isAlone ? std::next(frames.begin()) : frames.end()};
}

/// A stop has no answer. A question after it has one, and CAN keeps the order: whoever answers has had the stop before.
StopStep proofStep(const Dialect &dialect, int offset, const CanLink &link)
{
    StopStep step;
    step.frame = encodeLogRequest(dialect, offset, Log::Position);
    CanFrame answer;
    answer.id = static_cast<std::uint32_t>(dialect.reply.at(static_cast<std::size_t>(Log::Position)))
        + static_cast<std::uint32_t>(offset);
    answer.size = sizeof(std::int32_t);
    step.replyFrame = answer;
    step.wait = std::clamp(std::chrono::ceil<std::chrono::milliseconds>(answerTime(link)), std::chrono::milliseconds(1),
        std::chrono::milliseconds(500));
    step.attempts = proofAttempts;
    return step;
}

} // namespace

Controller::Controller(const Family &family, CanLink &link, Clock &clock, Identity identity)
    : Device(family, link, clock, std::move(identity))
    , m_can(link)
    , m_logs(link, clock, telemetry(), knowledge().profile(), owner())
    , m_debt(knowledge().profile(),
          [this](std::int64_t owed) {
              knowledge().setCounter(std::string(counter::powerCycle), owed);
              updateLiveness();
          })
    , m_desk(*this, link, m_logs, m_debt,
          [this](const std::string &key, std::int64_t value) { knowledge().setCounter(key, value); })
    , m_received(link.received().add([this](const CanFrame &frame) { onFrame(frame, false); }))
    , m_identityChanged(changed().add([this] { speak(); }))
{
    m_sent = link.traffic().add([this](const Traffic &traffic) {
        if (traffic.can && traffic.direction == Direction::Sent)
            onSent(*traffic.can);
    });
    speak();
}

LogSense::Owner Controller::owner()
{
    return {
        .restarted = [this](Restart restart) { onRestart(restart); },
        .stands = [this](const Whereabouts::Counters &values) { knowledge().setCounters(values); },
        .wrapped =
            [this] {
                if (m_ours)
                    sendStop();
            },
        .output = [this](std::int32_t output, Instant time) { m_probe.heard(output, time); },
        .silent = [this] { onSilence(); },
        .heard = [this] { updateLiveness(); },
    };
}

void Controller::speak()
{
    const Dialect *const dialect = dialectByKey(identity().dialect);
    if (dialect == m_logs.dialect() && m_logs.isHeard())
        return;
    if (dialect != m_logs.dialect())
        enter(std::nullopt, clock().now());
    m_logs.speak(dialect, identity().address);
}

void Controller::doProfileChanged()
{
    telemetry()->useTable(channelTable(knowledge().profile().calibrated(calibration::amperes) > 0.0,
        knowledge().profile().calibrated(calibration::degrees) > 0.0));
    updateLiveness();
}

// Control

Result<void> Controller::doMayMove() const
{
    if (!m_logs.dialect())
        return fail(Fault::Unsafe,
            say("it is not proven which codes this drive speaks, and the wrong ones start it at full power"),
            say("scan again, or choose its dialect by hand"));
    if (!m_logs.dialect()->canStop())
        return fail(Fault::Unsafe, say("a drive of dialect LL has no code for stop"), say("only its power stops it"));
    MB_TRY_VOID(m_logs.isAddressedAlone());
    if (!m_debt.isOwed())
        return {};
    Message remedy = say("switch it off and on");
    if (m_desk.overrunsEver())
        remedy = say("write an averaging of 1 … 500, then switch it off and on");
    else if (std::abs(m_logs.motion().position().value_or(0)) < Whereabouts::provesPower)
        remedy = say("turn its shaft until its position is %1 counts away from 0, which shows that it was off, then "
                     "switch it off and on",
            Whereabouts::provesPower);
    return fail(Fault::Unsafe,
        say("its averaging was lowered, or set beyond 500, as far as can be known, and until it has lost its power "
            "once it may overwrite its own memory"),
        std::move(remedy));
}

Result<void> Controller::doCheck(const SetPoint &setPoint) const
{
    MB_TRY(const auto command, commandOf(setPoint, knowledge().profile()));
    const double unknown = LeadProbe().most();
    if (greatestError(parameters(), command.loop, true, unknown) < 1.0)
        return fail(Fault::Unsafe,
            say("p and d are so high for the divisor that an error of 1 turns the output to full reverse"),
            say("lower them, or raise the divisor"));
    if (command.loop != Loop::Velocity || m_logs.loop() == Loop::Velocity)
        return {};
    return mayEnterVelocity(m_logs.entrySpeed(), parameters(), unknown);
}

Message Controller::caution(const SetPoint &setPoint) const
{
    const auto command = commandOf(setPoint, knowledge().profile());
    if (!command || knowsGains(parameters(), command->loop))
        return {};
    const double lead = LeadProbe().most();
    if (std::abs(command->target - m_logs.feedback(command->loop, command->target).value_or(0.0)) <= lead)
        return {};
    if (m_logs.dialect() && m_logs.dialect()->has(Log::Voltage))
        return say("the gains of this loop are not known here, so its target begins within %1 of where it is, and goes "
                   "further as its output is seen to allow it; write its p, d and divisor once",
            lead);
    return say("the gains of this loop are not known here, so its target stays within %1 of where it is: a weak loop "
               "may not move it; write its p, d and divisor once",
        lead);
}

Result<void> Controller::doCommand(const SetPoint &setPoint)
{
    MB_TRY(const auto command, commandOf(setPoint, knowledge().profile()));
    if (m_logs.output().hasWrapped())
        return fail(Fault::Unsafe, say("the output of its loop passed 32767, where it turns to full reverse"),
            say("lower the gains or the steps"));
    const bool beginsFromPosition = command.loop == Loop::Position
        || (command.loop == Loop::Velocity && m_logs.loop() != Loop::Velocity); // README.md#first-pass
    if (beginsFromPosition && !m_logs.motion().position())
        return fail(Fault::Unsafe, say("its position is not known yet"),
            say("a step from the wrong place could be far too large"));
    const Instant now = clock().now();
    if (m_logs.loop() != command.loop || !m_ours) {
        m_lead.reset();
        m_probe.reset();
    }
    const auto feedback = m_logs.feedback(command.loop, command.target);
    const bool hasPassed = m_ours && m_logs.loop() == command.loop && m_logs.hasPassed(now);
    const double most = greatestError(parameters(), command.loop, hasPassed, m_probe.most(), m_desk.unproven());
    const Whereabouts::SpeedRange entry = m_logs.entrySpeed();
    const std::int32_t target = command.loop == Loop::Velocity && !hasPassed // README.md#first-pass
        ? m_lead.next(command, setPoint.ramp, entry.middle(), std::max(0.0, most - entry.halfWidth()), now)
        : m_lead.next(command, setPoint.ramp, feedback, most, now);
    const bool news = m_logs.loop() != command.loop || !m_ours || target != m_sentTarget;
    // At low bit rates set-points would fill the wire: then a newer one waits for the next call.
    const Duration spacing = news ? 2 * roundTrip(m_can) : std::max<Duration>(repeatPeriod, 10 * roundTrip(m_can));
    if (m_ours && m_logs.loop() == command.loop && now - m_sentAt < spacing)
        return {};
    MB_TRY_VOID(m_can.send(encodeSetPoint(*m_logs.dialect(), identity().address, command.loop, target)));
    m_sentTarget = target;
    m_sentAt = now;
    m_ours = true;
    m_probe.sent(std::abs(target - feedback.value_or(0.0)) + 1.0 >= m_probe.most(), now);
    enter(command.loop, now);
    const double perCount
        = command.loop == Loop::Current ? knowledge().profile().calibrated(calibration::amperes, 1.0) : 1.0;
    telemetry()->append(
        {channel::setPoint, now, command.loop == Loop::Direct ? target / double{fullPwm} : target * perCount});
    return {};
}

void Controller::doStop()
{
    m_logs.output().release();
    sendStop();
}

/// Its own length twice (README.md#no-watchdog): the first overtakes what waits, the last comes behind a set-point that the kernel
/// may still hold.
void Controller::sendStop()
{
    const auto frames = stopsOf(m_logs, identity().address, doMayStop().has_value());
    for (const CanFrame &frame : frames)
        (void)m_can.send(frame, Priority::Urgent);
    (void)m_can.send(frames.front());
    m_lead.reset();
    telemetry()->breakLine(channel::setPoint);
    enter(Loop::None, clock().now());
    m_ours = false;
}

Result<void> Controller::doMayStop() const
{
    if (!m_logs.dialect())
        return fail(Fault::Unsafe, say("it is not proven which codes it speaks, and a stop of others may start it"));
    if (!m_logs.dialect()->canStop())
        return fail(Fault::Unsafe, say("dialect LL has no code for stop"));
    const bool isShared = !m_logs.isAddressedAlone() && !m_ours; // what moves by us is stopped first
    if (m_logs.dialect()->wide && m_logs.reachesOldest() && isShared)
        return fail(Fault::Unsafe, say("a drive of dialect LL hears its stop, too, and would be started by it"));
    return {};
}

StopScript Controller::stopScript() const
{
    StopScript script;
    for (const CanFrame &frame : stopsOf(m_logs, identity().address, doMayStop().has_value())) {
        StopStep step;
        step.frame = frame;
        step.wait = std::chrono::milliseconds(10);
        step.attempts = stopRepeats;
        script.steps.push_back(std::move(step));
    }
    if (doMayStop())
        script.steps.push_back(proofStep(*m_logs.dialect(), identity().address, m_can));
    return script;
}

bool Controller::isSeenStopped() const
{
    return m_logs.isHeard() && m_logs.motion().standsSince(std::max(gate().stoppedAt(), m_sentAt));
}

// What the bus tells

void Controller::enter(std::optional<Loop> loop, Instant time)
{
    if (loop)
        m_isHeldByOther = *loop != Loop::None && !m_ours;
    if (m_logs.enter(loop, time))
        updateLiveness();
}

/// Set-points and settings of other masters; `ours`: of a recording, those of its recorder.
void Controller::onFrame(const CanFrame &frame, bool ours)
{
    if (!m_logs.dialect() || frame.extended)
        return;
    if (const auto loop = decodeSetPoint(*m_logs.dialect(), identity().address, frame)) {
        const bool driven = *loop != Loop::None;
        const bool isTaken = !ours && (driven || m_ours); // also by a stop, which our next set-point would undo
        m_ours = ours && driven;
        m_foreignAt = isTaken ? std::optional<Instant>(frame.time) : std::nullopt;
        if (ours && !driven)
            m_logs.output().release();
        enter(*loop, frame.time);
        updateLiveness();
    } else if (const auto settings = decodeSettings(*m_logs.dialect(), identity().address, frame)) {
        if (const auto index = parameterOf(settings->loop, settings->field)) {
            knowledge().assume(*index, settings->value);
            m_desk.written(*index, settings->value);
        }
    } else if (const auto saved = decodeSave(*m_logs.dialect(), identity().address, frame)) {
        m_desk.saved(*saved);
    }
}

/// On a live link what this program sends to this drive is known; what it sends to the one with offset 0 reaches it, too.
void Controller::onSent(const CanFrame &frame)
{
    const bool isToAll = frame.id == id::setPoint || frame.id == id::settings;
    if (m_can.address().isRecording())
        onFrame(frame, true);
    else if (isToAll && identity().address != 0)
        onFrame(frame, false);
}

void Controller::onSilence()
{
    m_logs.forget();
    enter(std::nullopt, clock().now());
    breakLines();
    updateLiveness();
}

/// What was not saved is not in force. One that is seen is off, and counts from 0: what it was driven to is not there any more
/// (README.md#restarts).
void Controller::onRestart(Restart restart)
{
    if (restart == Restart::Seen)
        breakLines();
    const bool isOfRecording = restart == Restart::Seen && m_can.address().isRecording();
    if (isOfRecording)
        return;
    m_desk.restarted();
    if (restart != Restart::Maybe) {
        if (!m_desk.overrunsEver())
            m_debt.pay();
        m_isHeldByOther = false;
    }
    if (restart != Restart::Seen)
        return;
    m_restarted = true;
    if (m_ours)
        sendStop();
    else
        enter(Loop::None, clock().now());
    updateLiveness();
}

void Controller::breakLines()
{
    for (std::uint16_t i = 0; i < telemetry()->channels().size(); ++i)
        telemetry()->breakLine({i});
}

void Controller::updateLiveness()
{
    if (m_foreignAt && clock().now() - *m_foreignAt > foreignMemory && !m_logs.isMoving() && !m_isHeldByOther)
        m_foreignAt.reset();
    Liveness now;
    now.heard = m_logs.isHeard();
    now.moving = m_logs.isMoving() || (m_logs.isDriven() && m_ours);
    if (const auto loop = m_logs.loop())
        now.mode = modeOf(*loop);
    now.foreignMaster = m_foreignAt.has_value();
    now.restarted = m_restarted;
    now.faults = m_logs.output().faults();
    if (m_debt.isOwed())
        now.faults.emplace_back(PowerCycleDebt::fault);
    setLiveness(now);
}

// What asks and waits

Task<void> Controller::refresh()
{
    co_await m_desk.expectAnswer();
    Identity known = identity();
    known.descriptors = {{"position_glitches", std::to_string(m_logs.motion().glitches())}};
    for (auto &&saves : m_desk.saves())
        known.descriptors.emplace_back(std::move(saves));
    setIdentity(std::move(known));
    if (m_restarted)
        knowledge().reassume(); // what was saved
    m_restarted = false;
    updateLiveness();
    co_return {};
}

Task<std::int64_t> Controller::doRead(ParameterIndex)
{
    co_return fail(Fault::Unsupported, say("an Abstract DC Drive cannot be asked for its settings"));
}

Task<void> Controller::doMayWrite(ParameterIndex index, std::int64_t raw, std::span<const ParameterChange> before)
{
    const Parameter &parameter = parameters().parameter(index);
    co_await m_desk.mayWrite(parameter, raw);
    if (const Loop loop = loopOf(parameter); m_ours && m_logs.loop() == loop) {
        const double error = m_logs.hasPassed(clock().now())
            ? std::abs(m_sentTarget - m_logs.feedback(loop, m_sentTarget).value_or(0.0))
            : std::numeric_limits<double>::infinity(); // README.md#first-pass
        std::vector<ParameterChange> changes(before.begin(), before.end());
        changes.push_back({index, raw});
        co_return mayChange(parameters(), changes, error, m_probe.most());
    }
    co_return {};
}

Task<std::int64_t> Controller::doWrite(ParameterIndex index, std::int64_t raw)
{
    const Parameter &parameter = parameters().parameter(index);
    if (const Loop loop = loopOf(parameter); m_ours && m_logs.loop() == loop) {
        const std::array change{ParameterChange{index, raw}};
        m_probe.limit(greatestError(parameters(), loop, m_logs.hasPassed(clock().now()), m_probe.most(), change));
    }
    co_return co_await m_desk.write(parameter, raw);
}

void Controller::settingsReplaced(bool blank)
{
    m_desk.replaced(blank);
    for (std::uint16_t i = 0; i < parameterTable().size(); ++i) {
        if (blank)
            knowledge().assume({i}, fieldOf(parameterTable()[i]) == Field::Averaging ? 1 : 0);
        else
            knowledge().doubt({i});
    }
}

Task<std::vector<FaultRecord>> Controller::readFaults()
{
    std::vector<FaultRecord> records = m_logs.output().records();
    records.push_back({PowerCycleDebt::fault, m_debt.isOwed(), m_debt.isOwed(), std::nullopt});
    co_return records;
}

Task<std::vector<FaultRecord>> Controller::clearFaults()
{
    std::vector<FaultRecord> records = co_await readFaults();
    m_logs.output().clearCounts();
    co_return records;
}

Task<void> Controller::renumber(int)
{
    co_return fail(Fault::Unsupported, say("the offset of an Abstract DC Drive is compiled into its firmware"));
}

Task<void> Controller::setRate(ChannelIndex channel, double hertz)
{
    co_return m_logs.wish(channel, hertz);
}

std::unique_ptr<Device> open(Link &link, Clock &clock, const Identity &identity)
{
    extern const Family family;
    return std::make_unique<Controller>(family, static_cast<CanLink &>(link), clock, identity);
}

} // namespace mb::abstractdc
