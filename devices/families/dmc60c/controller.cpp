// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/controller.h"

#include "families/dmc60c/channels.h"
#include "families/dmc60c/parameters.h"
#include "families/dmc60c/setpoints.h"
#include "families/dmc60c/unitidentity.h"
#include "model/family.h"
#include "wire/fixedpoint.h"

#include <algorithm>

namespace mb::dmc60c {
namespace {

using namespace std::chrono_literals;

constexpr Duration silenceAtLeast = 100ms; ///< section 5
constexpr int silencePeriods = 5;
constexpr Duration foreignMemory = 500ms;
constexpr Duration enumeratePeriod = 2s; ///< while the device is silent
constexpr Duration candidateStep = 70ms; ///< the latest answer to an enumeration starts after 63.5 ms
constexpr int candidateRounds = 3;
constexpr Duration askPeriodAtMost = 1s;
constexpr Duration stallTolerance = 20ms;
constexpr int idleFramesNeeded = 2; ///< one may be a zero crossing of a closed loop
constexpr Duration turningMemory = 500ms;

} // namespace

Controller::Controller(const Family &family, CanLink &link, Clock &clock, Identity identity)
    : Device(family, link, clock, std::move(identity))
    , m_can(link)
    , m_exchange(link, clock)
    , m_knownSession(this->identity().session)
    , m_general(telemetry(), {channel::duty, channel::error}, defaultGeneralPeriod)
    , m_encoder(telemetry(), {channel::position, channel::velocity}, defaultEncoderPeriod)
    , m_analog(telemetry(), {channel::analog1, channel::current, channel::temperature, channel::busVoltage}, defaultAnalogPeriod)
    , m_enumerateAt(clock.now() + enumeratePeriod)
    , m_timer(clock)
    , m_received(link.received().add([this](const CanFrame &frame) { onFrame(frame); }))
    , m_identityChanged(changed().add([this] { sessionChanged(); }))
{
    armTick();
}

// Control -----------------------------------------------------------------------------------------------------------------

Result<void> Controller::doCheck(const SetPoint &setPoint) const
{
    const auto control = controlFor(setPoint, identity().address);
    if (!control)
        return fail(control.error());
    return {};
}

Result<void> Controller::doCommand(const SetPoint &setPoint)
{
    const auto control = controlFor(setPoint, identity().address);
    if (!control)
        return fail(control.error());
    if (auto sent = m_can.send(encodeControl(identity().address, *control)); !sent)
        return sent;
    telemetry()->append({channel::setPoint, clock().now(), setPoint.target});
    return {};
}

void Controller::doStop()
{
    m_idleFrames = 0;
    const CanFrame noDrive = encodeControl(identity().address, Control {});
    (void)m_can.send(noDrive, Priority::Urgent); // twice (6.1); a link that is gone cannot be helped from here
    (void)m_can.send(noDrive, Priority::Urgent);
    telemetry()->breakLine(channel::setPoint);
}

bool Controller::doIsSeenStopped() const
{
    if (!m_generalAt || *m_generalAt <= stoppedAt() || m_lastGeneral.duty != 0)
        return false;
    return m_lastGeneral.mode == ControlMode::NoDrive || m_idleFrames >= idleFramesNeeded;
}

// What the bus tells ------------------------------------------------------------------------------------------------------

void Controller::onFrame(const CanFrame &frame)
{
    if (!frame.extended || deviceOf(frame) != identity().address)
        return;
    switch (frame.id & id::messageMask) {
    case id::statusGeneral:
        if (const auto status = decodeStatusGeneral(frame))
            onGeneral(*status, frame.time);
        break;
    case id::statusEncoder:
        if (const auto status = decodeStatusEncoder(frame))
            onEncoder(*status, frame.time);
        break;
    case id::statusAnalog:
        if (const auto status = decodeStatusAnalog(frame))
            onAnalog(*status, frame.time);
        break;
    case id::paramResponse:
        if (const auto response = decodeParamResponse(frame))
            onParameter(*response);
        break;
    case id::vendorStatus:
        if (const auto status = decodeVendorStatus(frame))
            onVendorStatus(*status);
        break;
    case id::enumResponse:
        if (const auto first = decodeEnumResponse0(frame))
            onSession(first->session, frame.time);
        else if (const auto second = decodeEnumResponse1(frame))
            onVersions(*second);
        break;
    case id::control: // our own frames do not come back
        m_foreignAt = frame.time;
        updateLiveness();
        armTick();
        break;
    default: break;
    }
}

void Controller::onGeneral(const StatusGeneral &status, Instant time)
{
    m_general.add(time, {std::clamp(status.duty / static_cast<double>(fullDuty), -1.0, 1.0),
                            status.mode == ControlMode::Voltage ? errorOf(status) / fullDuty
                                : status.mode == ControlMode::Velocity ? errorOf(status) * velocityPerSecond : errorOf(status)});
    askPeriod(m_general, param::generalPeriod);
    m_idleFrames = status.duty == 0 && time > stoppedAt() ? m_idleFrames + 1 : 0;
    m_lastGeneral = status;
    m_generalAt = time;
    const bool first = !m_heard;
    m_heard = true;
    updateLiveness();
    if (first)
        armTick();
}

void Controller::onEncoder(const StatusEncoder &status, Instant time)
{
    m_encoder.add(time, {static_cast<double>(status.position), static_cast<double>(status.velocity) * velocityPerSecond});
    askPeriod(m_encoder, param::encoderPeriod);
    m_turning = status.velocity != 0;
    m_turningAt = time;
    updateLiveness();
}

void Controller::onAnalog(const StatusAnalog &status, Instant time)
{
    m_analog.add(time, {status.analogIn, status.current, status.temperature, status.busVoltage});
    askPeriod(m_analog, param::analogPeriod);
}

void Controller::onParameter(const ParamResponse &response)
{
    StatusStream *const stream = streamOf(response.parameter);
    if (stream && response.status == ParameterStatus::NoError && response.field > 0)
        stream->setPeriod(std::chrono::milliseconds(response.field));
}

void Controller::onVendorStatus(const VendorStatus &status)
{
    if (identity().state == DeviceState::Duplicate)
        return; // whose status is it?
    if (status.status == CommandStatus::InBootloader)
        setState(DeviceState::Bootloader, "The bootloader runs; restart the unit or update its firmware.");
    else if (status.status == CommandStatus::AckReset) {
        if (identity().state == DeviceState::Bootloader)
            setState(DeviceState::Online, {});
        restarted();
    }
}

void Controller::onSession(std::uint16_t session, Instant time)
{
    if (m_knownSession == session) {
        m_ownSeenAt = time;
        return;
    }
    if (identity().state == DeviceState::Duplicate || !busy().empty() || m_candidate)
        return;
    m_candidate = Candidate {session, 0, clock().now() + candidateStep};
    m_candidateSince = time;
    armTick();
}

void Controller::onVersions(const EnumResponse1 &response)
{
    if (m_knownSession != response.session)
        return;
    Identity known = identity();
    setVersions(known, {response.image, response.application, response.bootloader});
    setIdentity(std::move(known));
}

StatusStream *Controller::streamOf(std::uint8_t periodParameter)
{
    switch (periodParameter) {
    case param::generalPeriod: return &m_general;
    case param::encoderPeriod: return &m_encoder;
    case param::analogPeriod: return &m_analog;
    default: return nullptr;
    }
}

void Controller::askPeriod(const StatusStream &stream, std::uint8_t parameter)
{
    if (!stream.isHolding() || !busy().empty() || clock().now() - m_periodAskedAt < askPeriodAtMost)
        return;
    m_periodAskedAt = clock().now();
    (void)m_can.send(encodeParamRequest(identity().address, session(), parameter));
}

// What follows from it, and from silence ----------------------------------------------------------------------------------

Duration Controller::silenceLimit() const
{
    return std::max<Duration>(silencePeriods * m_general.period(), silenceAtLeast);
}

void Controller::armTick()
{
    Instant next = m_heard && m_generalAt ? *m_generalAt + silenceLimit() : m_enumerateAt;
    if (m_foreignAt)
        next = std::min(next, *m_foreignAt + foreignMemory);
    if (m_candidate)
        next = std::min(next, m_candidate->nextAt);
    m_armedFor = std::max(next, clock().now());
    m_timer.start(m_armedFor, [this] { tick(); });
}

void Controller::tick()
{
    const Instant now = clock().now();
    if (now - m_armedFor > stallTolerance) { // we were stalled: first let the link deliver what came meanwhile
        m_armedFor = now + stallTolerance;
        m_timer.start(m_armedFor, [this] { tick(); });
        return;
    }
    if (m_foreignAt && now - *m_foreignAt >= foreignMemory)
        m_foreignAt.reset();
    if (m_heard && m_generalAt && now - *m_generalAt >= silenceLimit())
        fallSilent();
    if (m_candidate && now >= m_candidate->nextAt)
        judgeCandidate();
    if (!m_heard && now >= m_enumerateAt)
        enumerate();
    updateLiveness();
    armTick();
}

void Controller::fallSilent()
{
    m_heard = false;
    m_turning = false;
    m_general.interrupt();
    m_encoder.interrupt();
    m_analog.interrupt();
    m_enumerateAt = clock().now();
}

void Controller::enumerate()
{
    m_enumerateAt = clock().now() + enumeratePeriod;
    if (busy().empty() && m_can.state() == LinkState::Open)
        (void)m_can.send(encodeEnumerate());
}

/// A new session alone is a restarted unit; with the known one still answering it is a second unit. Answers may be lost, so
/// that the known one gets several chances.
void Controller::judgeCandidate()
{
    if (m_candidate->enumerations < candidateRounds && busy().empty()) {
        ++m_candidate->enumerations;
        m_candidate->nextAt = clock().now() + candidateStep;
        enumerate();
        return;
    }
    const std::uint16_t session = m_candidate->session;
    m_candidate.reset();
    if (!busy().empty())
        return;
    Identity known = identity();
    if (m_knownSession && m_ownSeenAt + candidateStep >= m_candidateSince) {
        markDuplicate(known, 2);
        setIdentity(std::move(known));
        return;
    }
    known.session = session;
    setIdentity(std::move(known)); // sessionChanged() follows
    m_enumerateAt = clock().now(); // for its versions
}

void Controller::sessionChanged()
{
    if (identity().session == m_knownSession)
        return;
    m_knownSession = identity().session;
    m_candidate.reset();
    restarted();
}

void Controller::restarted()
{
    m_restarted = true;
    m_flashLost = m_flashLost || m_flash.isPending();
    m_flash.settle();
    for (StatusStream *stream : {&m_general, &m_encoder, &m_analog})
        stream->restart();
    parameters().forgetAll();
    if (busy().empty()) {
        for (const auto &[parameter, period] : m_wantedPeriods)
            (void)m_can.send(encodeParamSet(identity().address, session(), parameter, period));
    }
    updateLiveness();
}

void Controller::setState(DeviceState state, std::string detail)
{
    Identity known = identity();
    known.state = state;
    known.detail = std::move(detail);
    setIdentity(std::move(known));
}

void Controller::updateLiveness()
{
    const bool turning = m_turning && clock().now() - m_turningAt < std::max<Duration>(turningMemory, 3 * m_encoder.period());
    const bool moving = m_heard && (m_lastGeneral.duty != 0 || turning);
    // One frame in ten thousand changes any of this: compare a word before building texts.
    const std::uint32_t key = (m_heard ? 1U : 0U) | (moving ? 2U : 0U) | (m_foreignAt ? 4U : 0U) | (m_restarted ? 8U : 0U) | (m_lastGeneral.overTemperature ? 16U : 0U)
        | (m_lastGeneral.underVoltage ? 32U : 0U) | (m_lastGeneral.gateDriver ? 64U : 0U) | (static_cast<std::uint32_t>(m_lastGeneral.mode) << 8U);
    if (key == m_livenessKey)
        return;
    m_livenessKey = key;
    Liveness now;
    now.heard = m_heard;
    now.moving = moving;
    now.foreignMaster = m_foreignAt.has_value();
    now.restarted = m_restarted;
    if (m_heard) {
        now.mode = modeOf(m_lastGeneral.mode);
        if (m_lastGeneral.overTemperature)
            now.faults.emplace_back("over_temperature");
        if (m_lastGeneral.underVoltage)
            now.faults.emplace_back("under_voltage");
        if (m_lastGeneral.gateDriver)
            now.faults.emplace_back("gate_driver");
    }
    setLiveness(now);
}

std::unique_ptr<Device> open(Link &link, Clock &clock, const Identity &identity)
{
    extern const Family family;
    auto *const can = dynamic_cast<CanLink *>(&link);
    return can ? std::make_unique<Controller>(family, *can, clock, identity) : nullptr;
}

} // namespace mb::dmc60c
