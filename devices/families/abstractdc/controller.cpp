// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/controller.h"

#include "families/abstractdc/channels.h"
#include "families/abstractdc/codec.h"
#include "families/abstractdc/parameters.h"
#include "model/family.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace mb::abstractdc {
namespace {

using namespace std::chrono_literals;

constexpr Duration foreignMemory = 2s;
constexpr Duration repeatPeriod = 250ms; ///< of a set-point that did not change; the drive holds it by itself
constexpr Duration lookPeriod = 100ms;
constexpr int stopRepeats = 3;        ///< of the stop script
constexpr double positionRate = 20.0; ///< samples per second nobody asked for
constexpr double loopRate = 20.0;
constexpr double slowRate = 5.0;
constexpr double temperatureRate = 1.0;
constexpr double drivenRate = 50.0; ///< the loop of the drive is no faster

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
    , m_received(link.received().add([this](const CanFrame &frame) { onFrame(frame); }))
    , m_identityChanged(changed().add([this] { speak(); }))
{
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

// Control

Result<void> Controller::doMayMove() const
{
    if (!m_dialect)
        return fail(Fault::Unsafe,
            "it is not proven which codes this drive speaks, and the wrong ones start it at full power; scan again, or "
            "choose its dialect by hand");
    if (!m_dialect->canStop())
        return fail(Fault::Unsafe, "a drive of dialect LL has no code for stop; only its power stops it");
    if (m_needsPowerCycle)
        return fail(Fault::Unsafe,
            "its averaging was lowered, and until it has lost its power once it overwrites its own memory; switch it "
            "off "
            "and on");
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

Result<void> Controller::doCommand(const SetPoint &setPoint)
{
    const auto command = commandOf(setPoint, profile());
    if (!command)
        return fail(command.error());
    if (m_wrapped)
        return fail(Fault::Unsafe,
            "the output of its loop passed 32767, where it turns to full reverse; lower the gains or the steps");
    if (command->loop == Loop::Position && !m_sense.position())
        return fail(Fault::Unsafe, "its position is not known yet; a step from the wrong place could be far too large");
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
    const std::size_t own = m_dialect && m_dialect->wide ? 1 : 0;
    // Its own length first. The drive ignores the other one, which is for a dialect that was mistaken. Twice (trap 11): the
    // first overtakes what waits, the last comes behind a set-point that the kernel may still hold.
    (void)m_can.send(frames.at(own), Priority::Urgent);
    (void)m_can.send(frames.at(1 - own), Priority::Urgent);
    (void)m_can.send(frames.at(own));
    m_wrapped = false;
    m_lead.reset();
    telemetry()->breakLine(channel::setPoint);
    enter(Loop::None);
    m_ours = false;
}

StopScript Controller::doStopScript() const
{
    StopScript script;
    for (const CanFrame &frame : stopFrames(identity().address)) {
        StopStep step;
        step.frame = frame;
        step.wait = std::chrono::milliseconds(10);
        step.attempts = stopRepeats;
        script.steps.push_back(std::move(step));
    }
    return script;
}

bool Controller::doIsSeenStopped() const
{
    return m_poller.isHeard() && m_sense.standsSince(std::max(stoppedAt(), m_sentAt));
}

// Polling

/// Logs that stand still in this mode are not asked for (trap 7).
bool Controller::isFresh(Log log) const
{
    if (log == Log::Velocity)
        return m_loop == Loop::Velocity;
    if (log == Log::Voltage)
        return isDriven();
    return true;
}

double Controller::rateOf(Log log) const
{
    if (!isFresh(log))
        return 0.0;
    const auto wished = m_wishes.find(log);
    const double wish = wished == m_wishes.end() ? 0.0 : wished->second;
    switch (log) {
    case Log::Position: return std::max(wish, isDriven() || m_look.isActive() ? drivenRate : positionRate);
    case Log::Velocity: return std::max(wish, drivenRate);
    case Log::Voltage: return std::max(wish, loopRate);
    case Log::Current: return wish > 0.0 ? wish : slowRate;
    case Log::Temperature: return wish > 0.0 ? wish : temperatureRate;
    }
    return 0.0;
}

void Controller::planPolling()
{
    for (std::size_t i = 0; i < logCount; ++i)
        m_poller.wish(static_cast<Log>(i), rateOf(static_cast<Log>(i)));
}

void Controller::enter(std::optional<Loop> loop)
{
    if (loop == Loop::None) // look closely until it is seen to stand
        m_look.startIn(2s, [this] { planPolling(); });
    else
        m_look.stop();
    if (loop == m_loop) {
        planPolling();
        return;
    }
    m_loop = loop;
    m_velocity.reset();
    m_saturated = false;
    for (const ChannelIndex stale : {channel::velocity, channel::duty})
        telemetry()->breakLine(stale);
    planPolling();
    updateLiveness();
}

// What the bus tells

/// Other masters: their set-points and what they write.
void Controller::onFrame(const CanFrame &frame)
{
    if (!m_dialect || frame.extended)
        return;
    if (const auto loop = decodeSetPoint(*m_dialect, identity().address, frame)) {
        m_ours = false;
        m_foreignAt = *loop == Loop::None ? std::nullopt : std::optional<Instant>(frame.time);
        enter(*loop);
        updateLiveness();
    } else if (const auto settings = decodeSettings(*m_dialect, identity().address, frame)) {
        if (const auto index = parameterOf(settings->loop, settings->field))
            assume(*index, settings->value);
    }
}

void Controller::onLog(Log log, std::int32_t value, Instant time)
{
    switch (log) {
    case Log::Position: onPosition(value, time); break;
    case Log::Velocity:
        if (!isFresh(log))
            break;
        m_velocity = value;
        telemetry()->append({channel::velocity, time, static_cast<double>(value)});
        break;
    case Log::Current:
        telemetry()->append({channel::current, time, value * profile().calibrated(calibration::amperes, 1.0)});
        break;
    case Log::Temperature:
        telemetry()->append({channel::temperature, time, value * profile().calibrated(calibration::degrees, 1.0)});
        break;
    case Log::Voltage: onVoltage(value, time); break;
    }
    updateLiveness();
}

void Controller::onPosition(std::int32_t value, Instant time)
{
    const MotionSense::Verdict verdict = m_sense.add(value, time);
    if (verdict.glitch) {
        telemetry()->lost(channel::position, 1);
        return;
    }
    if (verdict.mended)
        telemetry()->breakLine(channel::position);
    telemetry()->append({channel::position, time, static_cast<double>(value)});
    if (isFresh(Log::Velocity))
        return; // the drive measures it itself
    if (const auto velocity = m_sense.velocity(time))
        telemetry()->append({channel::velocity, time, *velocity});
}

void Controller::onVoltage(std::int32_t value, Instant time)
{
    if (!isFresh(Log::Voltage))
        return;
    const bool saturated = std::abs(std::int64_t{value}) > fullPwm;
    m_saturations += saturated && !m_saturated ? 1 : 0;
    m_saturated = saturated;
    if (std::abs(std::int64_t{value}) >= outputWraps && !m_wrapped) {
        m_wrapped = true; // the next command is refused, which ends the stream
        ++m_wraps;
        if (m_ours) {
            doStop();
            m_wrapped = true;
        }
        updateLiveness();
        return;
    }
    const double duty = std::clamp(value / double{fullPwm}, -1.0, 1.0);
    telemetry()->append({channel::duty, time, duty});
}

void Controller::onSilence()
{
    m_sense.forget();
    m_velocity.reset();
    m_needsPowerCycle = false; // it was off, or cannot be reached
    enter(std::nullopt);
    for (std::uint16_t i = 0; i < telemetry()->channels().size(); ++i)
        telemetry()->breakLine({i});
    updateLiveness();
}

void Controller::updateLiveness()
{
    if (m_foreignAt && clock().now() - *m_foreignAt > foreignMemory && !m_sense.isMoving(clock().now()))
        m_foreignAt.reset();
    Liveness now;
    now.heard = m_poller.isHeard();
    now.moving = m_sense.isMoving(clock().now()) || (isDriven() && m_ours);
    if (m_loop)
        now.mode = modeOf(*m_loop);
    now.foreignMaster = m_foreignAt.has_value();
    if (m_saturated)
        now.faults.emplace_back("output_saturated");
    if (m_wrapped)
        now.faults.emplace_back("output_wrapped");
    setLiveness(now);
}

std::unique_ptr<Device> open(Link &link, Clock &clock, const Identity &identity)
{
    extern const Family family;
    return std::make_unique<Controller>(family, static_cast<CanLink &>(link), clock, identity);
}

} // namespace mb::abstractdc
