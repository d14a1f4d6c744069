// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/controller.h"

#include "families/abstractdc/answertime.h"
#include "families/abstractdc/channels.h"
#include "families/abstractdc/codec.h"
#include "families/abstractdc/parameters.h"
#include "model/family.h"

#include <QtGlobal>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <span>

namespace mb::abstractdc {
namespace {

using namespace std::chrono_literals;

constexpr Duration repeatPeriod = 250ms; ///< of a set-point that did not change; the drive holds it by itself
constexpr int proofAttempts = 3;         ///< of its question
constexpr int stopRepeats = 3;           ///< of the stop script

} // namespace

Controller::Controller(const Family &family, CanLink &link, Clock &clock, Identity identity)
    : Device(family, link, clock, std::move(identity))
    , m_can(link)
    , m_poller(link, clock,
          {[this](Log log, std::int32_t value, Instant time) { onLog(log, value, time); }, [this] { onSilence(); },
              [this](Log log) {
                  if (log == Log::Position)
                      telemetry()->lost(channel::position, 1);
              }})
    , m_look(clock)
    , m_received(link.received().add([this](const CanFrame &frame) { onFrame(frame, false); }))
    , m_identityChanged(changed().add([this] { speak(); }))
{
    if (link.address().isRecording())
        m_sent = link.traffic().add([this](const Traffic &traffic) {
            if (traffic.can && traffic.direction == Direction::Sent)
                onFrame(*traffic.can, true);
        });
    speak();
    planPolling();
}

void Controller::speak()
{
    const Dialect *const dialect = dialectByKey(identity().dialect);
    if (dialect == m_dialect && m_poller.isHeard())
        return;
    if (dialect != m_dialect)
        enter(std::nullopt);
    m_dialect = dialect;
    m_poller.speak(dialect, identity().address);
}

void Controller::doProfileChanged()
{
    telemetry()->useTable(channelTable(
        profile().calibrated(calibration::amperes) > 0.0, profile().calibrated(calibration::degrees) > 0.0));
}

/// Kept with its profile: another run of this program must know it, too.
bool Controller::needsPowerCycle() const
{
    const auto owed = profile().counters.find(std::string(counter::powerCycle));
    return owed != profile().counters.end() && owed->second != 0;
}

// Control

Result<void> Controller::doMayMove() const
{
    if (!m_dialect)
        return fail(Error::fromPhrase(Fault::Unsafe,
            QT_TRANSLATE_NOOP("table",
                "it is not proven which codes this drive speaks, and the wrong ones start it at full power; scan "
                "again, or "
                "choose its dialect by hand")));
    if (!m_dialect->canStop())
        return fail(Error::fromPhrase(Fault::Unsafe,
            QT_TRANSLATE_NOOP("table", "a drive of dialect LL has no code for stop; only its power stops it")));
    if (needsPowerCycle())
        return fail(Error::fromPhrase(Fault::Unsafe,
            QT_TRANSLATE_NOOP("table",
                "its averaging was lowered, as far as can be known, and until it has lost its power once it may "
                "overwrite "
                "its own memory; switch it off and on")));
    return {};
}

Result<void> Controller::doCheck(const SetPoint &setPoint) const
{
    const auto command = commandOf(setPoint, profile());
    if (!command)
        return fail(command.error());
    return {};
}

std::optional<double> Controller::feedback(Loop loop) const
{
    switch (loop) {
    case Loop::Velocity: return m_velocity ? m_velocity : m_sense.velocity(clock().now());
    case Loop::Position: {
        const auto position = m_sense.position();
        return position ? std::optional<double>(*position) : std::nullopt;
    }
    default: return std::nullopt;
    }
}

std::string Controller::doCaution(const SetPoint &setPoint) const
{
    const auto command = commandOf(setPoint, profile());
    if (!command || knowsGains(parameters(), command->loop))
        return {};
    const double lead = greatestError(parameters(), command->loop);
    if (std::abs(command->target - feedback(command->loop).value_or(0.0)) <= lead)
        return {};
    return "the gains of this loop are not known here, so its target stays within " + numberText(lead)
        + " of where it is: a weak loop may not move it; write its p and divisor once";
}

Result<void> Controller::doCommand(const SetPoint &setPoint)
{
    const auto command = commandOf(setPoint, profile());
    if (!command)
        return fail(command.error());
    if (m_wrapped)
        return fail(Error::fromPhrase(Fault::Unsafe,
            QT_TRANSLATE_NOOP("table",
                "the output of its loop passed 32767, where it turns to full reverse; lower the gains or the steps")));
    if (command->loop == Loop::Position && !m_sense.position())
        return fail(Error::fromPhrase(Fault::Unsafe,
            QT_TRANSLATE_NOOP(
                "table", "its position is not known yet; a step from the wrong place could be far too large")));
    const Instant now = clock().now();
    if (m_loop != command->loop || !m_ours)
        m_lead.reset();
    const std::int32_t target = m_lead.next(
        *command, setPoint.ramp, feedback(command->loop), greatestError(parameters(), command->loop), now);
    const bool news = m_loop != command->loop || !m_ours || target != m_sentTarget;
    // At low bit rates set-points would fill the wire: then a newer one waits for the next call.
    const Duration spacing = news ? 2 * roundTrip(m_can) : std::max<Duration>(repeatPeriod, 10 * roundTrip(m_can));
    if (m_ours && m_loop == command->loop && now - m_sentAt < spacing)
        return {};
    if (auto sent = m_can.send(encodeSetPoint(*m_dialect, identity().address, command->loop, target)); !sent)
        return sent;
    m_sentTarget = target;
    m_sentAt = now;
    m_ours = true;
    enter(command->loop);
    const double perCount = command->loop == Loop::Current ? profile().calibrated(calibration::amperes, 1.0) : 1.0;
    telemetry()->append(
        {channel::setPoint, now, command->loop == Loop::Direct ? target / double{fullPwm} : target * perCount});
    return {};
}

void Controller::doStop()
{
    const auto frames = stopFrames(identity().address);
    const std::size_t own = m_dialect && m_dialect->wide && m_dialect->canStop() ? 1 : 0;
    // Its own length first. The drive ignores the other one, which is for a dialect that was mistaken. Twice (README.md#no-watchdog): the
    // first overtakes what waits, the last comes behind a set-point that the kernel may still hold.
    // A drive of dialect LL takes the long one for a set-point; the short one it ignores.
    (void)m_can.send(frames.at(own), Priority::Urgent);
    if (doMayStop())
        (void)m_can.send(frames.at(1 - own), Priority::Urgent);
    (void)m_can.send(frames.at(own));
    m_wrapped = false;
    m_lead.reset();
    telemetry()->breakLine(channel::setPoint);
    enter(Loop::None);
    m_ours = false;
}

Result<void> Controller::doMayStop() const
{
    if (!m_dialect)
        return fail(Fault::Unsafe,
            QT_TRANSLATE_NOOP("table", "it is not proven which codes it speaks, and a stop of others may start it"));
    if (!m_dialect->canStop())
        return fail(Fault::Unsafe, QT_TRANSLATE_NOOP("table", "dialect LL has no code for stop"));
    return {};
}

StopScript Controller::doStopScript() const
{
    StopScript script;
    const auto frames = stopFrames(identity().address);
    for (const CanFrame &frame : std::span(frames).first(doMayStop() ? 2 : 1)) {
        StopStep step;
        step.frame = frame;
        step.wait = std::chrono::milliseconds(10);
        step.attempts = stopRepeats;
        script.steps.push_back(std::move(step));
    }
    if (doMayStop())
        script.steps.push_back(proofStep());
    return script;
}

/// A stop has no answer. A question after it has one, and CAN keeps the order: whoever answers has had the stop before.
StopStep Controller::proofStep() const
{
    StopStep step;
    step.frame = encodeLogRequest(*m_dialect, identity().address, Log::Position);
    CanFrame answer;
    answer.id = static_cast<std::uint32_t>(m_dialect->reply.at(static_cast<std::size_t>(Log::Position)))
        + static_cast<std::uint32_t>(identity().address);
    answer.size = sizeof(std::int32_t);
    step.replyFrame = answer;
    step.wait = std::clamp(std::chrono::ceil<std::chrono::milliseconds>(answerTime(m_can)),
        std::chrono::milliseconds(1), std::chrono::milliseconds(500));
    step.attempts = proofAttempts;
    return step;
}

bool Controller::doIsSeenStopped() const
{
    return m_poller.isHeard() && m_sense.standsSince(std::max(stoppedAt(), m_sentAt));
}

std::unique_ptr<Device> open(Link &link, Clock &clock, const Identity &identity)
{
    extern const Family family;
    return std::make_unique<Controller>(family, static_cast<CanLink &>(link), clock, identity);
}

} // namespace mb::abstractdc
