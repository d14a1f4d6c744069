// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/controller.h"

#include "families/dmc60c/channels.h"
#include "families/dmc60c/setpoints.h"
#include "families/dmc60c/states.h"
#include "families/dmc60c/unitidentity.h"
#include "model/family.h"

#include <algorithm>

namespace mb::dmc60c {
namespace {

using namespace std::chrono_literals;

constexpr Duration askPeriodAtMost = 1s;
constexpr int idleFramesNeeded = 2; ///< one may be a zero crossing of a closed loop
constexpr int wakesNeeded = 3;      ///< frames may be lost

} // namespace

Controller::Controller(const Family &family, CanLink &link, Clock &clock, Identity identity)
    : Device(family, link, clock, std::move(identity))
    , m_can(link)
    , m_exchange(link, clock)
    , m_knownSession(this->identity().session)
    , m_general(telemetry(), {channel::duty, channel::error}, defaultGeneralPeriod)
    , m_encoder(telemetry(), {channel::position, channel::velocity}, defaultEncoderPeriod)
    , m_analog(telemetry(), {channel::analog1, channel::current, channel::temperature, channel::busVoltage},
          defaultAnalogPeriod)
    , m_enumerateAt(clock.now() + enumeratePeriod)
    , m_timer(clock)
    , m_received(link.received().add([this](const CanFrame &frame) { onFrame(frame); }))
    , m_identityChanged(changed().add([this] { sessionChanged(); }))
{
    armTick();
}

// Control

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
    if (m_commandedAt == Instant{} || clock().now() - m_commandedAt > controlLimit)
        m_wakes = wakesNeeded;
    m_commandedAt = clock().now();
    if (m_wakes > 0) {
        --m_wakes;
        // README.md#stopping: only a target that is not zero ends the halt. The least there is goes first.
        Control wake = *control;
        wake.target = 1;
        if (control->target == 0)
            (void)m_can.send(encodeControl(identity().address, wake));
    }
    if (auto sent = m_can.send(encodeControl(identity().address, *control)); !sent)
        return sent;
    telemetry()->append({channel::setPoint, clock().now(), setPoint.target});
    return {};
}

void Controller::doStop()
{
    m_idleFrames = 0;
    m_commandedAt = {}; // what comes next finds it halted
    const CanFrame noDrive = encodeControl(identity().address, Control{});
    // Twice (README.md#stopping): the first overtakes what waits, the second comes behind a set-point that the kernel may still hold.
    // A link that is gone cannot be helped from here.
    (void)m_can.send(noDrive, Priority::Urgent);
    (void)m_can.send(noDrive);
    telemetry()->breakLine(channel::setPoint);
}

StopScript Controller::doStopScript() const
{
    StopStep step;
    step.frame = encodeControl(identity().address, Control{});
    step.wait = std::chrono::milliseconds(10);
    step.attempts = 2; // 6.1
    return {{std::move(step)}};
}

bool Controller::doIsSeenStopped() const
{
    if (!m_generalAt || *m_generalAt <= stoppedAt() || m_lastGeneral.duty != 0)
        return false;
    return m_lastGeneral.mode == ControlMode::NoDrive || m_idleFrames >= idleFramesNeeded;
}

// What the bus tells

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
    m_general.add(time,
        {std::clamp(status.duty / static_cast<double>(fullDuty), -1.0, 1.0),
            status.mode == ControlMode::Voltage        ? errorOf(status) / fullDuty
                : status.mode == ControlMode::Velocity ? errorOf(status) * velocityPerSecond
                                                       : errorOf(status)});
    askPeriod(m_general, param::generalPeriod);
    m_idleFrames = status.duty == 0 && time > stoppedAt() ? m_idleFrames + 1 : 0;
    m_lastGeneral = status;
    m_generalAt = time;
    const bool first = !m_heard;
    m_heard = true;
    takeStates(m_told, status);
    m_toldAt = time;
    updateLiveness();
    askFaults();
    if (first)
        armTick();
}

void Controller::onEncoder(const StatusEncoder &status, Instant time)
{
    m_encoder.add(
        time, {static_cast<double>(status.position), static_cast<double>(status.velocity) * velocityPerSecond});
    askPeriod(m_encoder, param::encoderPeriod);
    if (m_heard) {
        takeStates(m_told, status);
        m_toldAt = time;
    }
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
    m_faultWatch.take(response, clock().now());
    updateLiveness();
}

void Controller::onVendorStatus(const VendorStatus &status)
{
    if (identity().state == DeviceState::Duplicate)
        return; // whose status is it?
    if (status.status == CommandStatus::InBootloader)
        setState(DeviceState::Bootloader, say("The bootloader runs; restart the unit or update its firmware."));
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
    m_candidate = Candidate{session, 0, clock().now() + candidateStep};
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

/// With no task waiting: an answer that does not come is asked for again a second later.
void Controller::askFaults()
{
    const bool listened = identity().state == DeviceState::Online && busy().empty() && !link().address().isRecording();
    if (!listened || !m_faultWatch.isDue(clock().now()))
        return;
    for (const std::uint8_t parameter : FaultWatch::questions)
        (void)m_can.send(encodeParamRequest(identity().address, session(), parameter));
}

std::unique_ptr<Device> open(Link &link, Clock &clock, const Identity &identity)
{
    extern const Family family;
    auto *const can = dynamic_cast<CanLink *>(&link);
    return can ? std::make_unique<Controller>(family, *can, clock, identity) : nullptr;
}

} // namespace mb::dmc60c
