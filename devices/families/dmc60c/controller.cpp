// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/controller.h"

#include "async/sleep.h"
#include "families/dmc60c/channels.h"
#include "families/dmc60c/setpoints.h"
#include "families/dmc60c/unitidentity.h"
#include "model/family.h"

#include <algorithm>

namespace mb::dmc60c {
namespace {

using namespace std::chrono_literals;

constexpr Duration askPeriodAtMost = 1s;
constexpr int wakesNeeded = 3; ///< frames may be lost
constexpr Duration answerAtMost
    = 100ms; ///< to the question for a period; it stands still for 54 ms while it writes flash

/// README.md#sessions: a unit that lost its supply for so short a time that only frames seem to be missing, or none, has another session now.
void awaitAnswer(Timer &unanswered, Presence &presence)
{
    if (!unanswered.isActive())
        unanswered.startIn(answerAtMost, [&presence] { presence.enumerate(); });
}

std::uint16_t sessionOf(const Identity &identity)
{
    return static_cast<std::uint16_t>(identity.session.value_or(0));
}

/// Braked where the set-point before was: without the override it would coast where the unit's button says so.
CanFrame stopFrame(int address, bool braked)
{
    Control control;
    if (braked)
        control.brake = true;
    return encodeControl(address, control);
}

} // namespace

Controller::Controller(const Family &family, CanLink &link, Clock &clock, Identity identity)
    : Device(family, link, clock, std::move(identity))
    , m_can(link)
    , m_contact{link, clock,
          [this] {
              return ParameterExchange::Target{this->identity().address, sessionOf(this->identity())};
          },
          [this] { m_presence.enumerate(); }}
    , m_orders(m_contact)
    , m_desk(m_contact, m_orders, parameters())
    , m_rates(m_desk, parameters())
    , m_sense(telemetry())
    , m_presence(clock, this->identity().session, owner())
    , m_unanswered(clock)
    , m_received(link.received().add([this](const CanFrame &frame) { onFrame(frame); }))
    , m_identityChanged(changed().add([this] { sessionChanged(); }))
{
}

Presence::Owner Controller::owner()
{
    return {
        .isBusy = [this] { return !gate().busy().empty(); },
        .period = [this] { return m_sense.generalPeriod(); },
        .askWho =
            [this] {
                if (m_can.state() == LinkState::Open)
                    (void)m_can.send(encodeEnumerate());
            },
        .silent =
            [this] {
                m_faultWatch.forget();
                m_sense.interrupt();
            },
        .doubled =
            [this] {
                Identity known = identity();
                markDuplicate(known, 2);
                setIdentity(std::move(known));
            },
        .renewed =
            [this](std::uint16_t session) {
                Identity known = identity();
                known.session = session;
                setIdentity(std::move(known)); // sessionChanged() follows
            },
        .looked = [this] { updateLiveness(); },
    };
}

// What asks and waits

Task<void> Controller::refresh()
{
    const std::optional<int> before = m_presence.session();
    Result<FirmwareVersions> versions = co_await m_orders.versions().attempt();
    if (!versions && versions.error().fault == Fault::Timeout) {
        co_await Sleep(clock(), 2 * enumWindow); // the question has enumerated; time to judge what answered
        if (m_presence.session() == before)
            co_return fail(versions.error());
        versions = co_await m_orders.versions().attempt();
    }
    if (!versions)
        co_return fail(versions.error());
    const DescriptorList list = co_await m_orders.descriptors();
    Identity known = identity();
    setVersions(known, *versions);
    setDescriptors(known, list);
    m_restarted = false;
    setIdentity(std::move(known));
    updateLiveness();
    co_return {};
}

Task<void> Controller::identify()
{
    auto task = m_orders.ask({Command::FlashLEDs});
    co_await std::move(task);
    co_return {};
}

/// A restart takes what is not in flash yet, so that is waited for, and without it there is none. A bootloader has no such thing.
Task<void> Controller::doRestart()
{
    if (identity().state != DeviceState::Bootloader)
        co_await m_desk.storeWhatWaits();
    auto resetting = m_orders.ask({Command::SoftReset});
    const Result<VendorReply> reply = co_await std::move(resetting).attempt();
    if (!reply && reply.error().fault != Fault::Timeout)
        co_return fail(reply.error());
    if (!reply)
        restarted(); // only its answer may be lost
    const Result<void> refreshed = co_await refresh().attempt();
    if (!reply && !refreshed)
        co_return fail(Fault::Timeout, say("it did not come back"), say("switch it off and on"));
    if (!reply && identity().firmware.empty()) // where there is nothing to start, silence is the answer
        co_return fail(Fault::Refused, say("no application runs in this unit"), say("update its firmware first"));
    if (!reply)
        co_return fail(Fault::Timeout, say("it did not say that it restarts, and may have done so or not"),
            say("restart it once more"));
    co_return refreshed;
}

Task<void> Controller::rename(std::string name)
{
    auto bytes = toLatin1(name);
    if (!bytes)
        co_return fail(Fault::OutOfRange, say("a name may hold Latin-1 characters only"));
    if (bytes->empty() || bytes->size() > static_cast<std::size_t>(maxNameLength))
        co_return fail(Fault::OutOfRange, say("a name has 1 to 64 characters"));
    bytes->push_back(0); // the count of the command includes it, that of the descriptor does not (README.md#names)
    const auto count = static_cast<std::uint16_t>(bytes->size());
    auto set = m_orders.ask({Command::SetDevName, count}, std::move(*bytes));
    co_await std::move(set);
    const DescriptorList list = co_await m_orders.descriptors();
    Identity known = identity();
    setDescriptors(known, list);
    setIdentity(known);
    if (known.name != name)
        co_return fail(Fault::BadCheck, say("the name was written, but the device answers '%1'", known.name));
    co_return {};
}

Task<void> Controller::renumber(int address)
{
    if (address < 1 || address > maxDeviceNumber)
        co_return fail(Fault::OutOfRange, say("a device number is 1 … 63"));
    if (address == identity().address)
        co_return {};
    co_await m_orders.expectFree(address);
    const FirmwareVersions versions = co_await m_orders.moveTo(address);
    Identity known = identity();
    known.address = address;
    known.state = DeviceState::Online; // free a moment ago, so no duplicate
    setVersions(known, versions);
    setIdentity(std::move(known));
    co_return {};
}

Task<std::int64_t> Controller::doRead(ParameterIndex index)
{
    return m_desk.read(static_cast<std::uint8_t>(parameters().parameter(index).id));
}

Task<void> Controller::doMayWrite(ParameterIndex index, std::int64_t, std::span<const ParameterChange>)
{
    // A loop that holds may have no output either; a set-point is told of one frame later, and ends with the heartbeat.
    const bool ordered = m_commandedAt != Instant{} && clock().now() - m_commandedAt <= heartbeat;
    const bool driven = ordered || m_sense.general().mode != ControlMode::NoDrive;
    const bool isPlace = parameters().parameter(index).id == param::encoderPosition;
    if (isPlace && (liveness().moving || driven || m_sense.general().duty != 0))
        co_return fail(
            Fault::Unsafe, say("the position is written only while the output is off"), say("stop the motor first"));
    co_return {};
}

Task<std::int64_t> Controller::doWrite(ParameterIndex index, std::int64_t raw)
{
    const Parameter &row = parameters().parameter(index);
    if (row.nature == Nature::Counter && raw != 0) {
        const std::int64_t before = co_await m_desk.clearCounter(row, raw);
        co_return before;
    }
    const std::int64_t inForce = co_await m_desk.write(row, raw);
    m_rates.chosen(static_cast<std::uint8_t>(row.id), static_cast<std::uint32_t>(inForce));
    co_return inForce;
}

// Control

Result<void> Controller::doCheck(const SetPoint &setPoint) const
{
    MB_TRY_VOID(controlFor(setPoint, identity().address));
    return {};
}

/// A restarted unit counts from 0, and would take a position that was meant for the count before (README.md#sessions).
Result<void> Controller::doMayMove() const
{
    if (m_presence.isDoubted())
        return fail(Fault::Unsafe,
            say("it has restarted, or a second unit has number %1: another session answers", identity().address));
    return {};
}

Result<void> Controller::doCommand(const SetPoint &setPoint)
{
    MB_TRY(const auto control, controlFor(setPoint, identity().address));
    if (m_commandedAt == Instant{} || clock().now() - m_commandedAt > controlLimit)
        m_wakes = wakesNeeded;
    m_commandedAt = clock().now();
    m_isBraked = control.brake.value_or(false);
    if (m_wakes > 0) {
        --m_wakes;
        // README.md#stopping: only a target that is not zero ends the halt. The least there is goes first.
        Control wake = control;
        wake.target = 1;
        if (control.target == 0)
            (void)m_can.send(encodeControl(identity().address, wake));
    }
    MB_TRY_VOID(m_can.send(encodeControl(identity().address, control)));
    telemetry()->append({channel::setPoint, clock().now(), setPoint.target});
    return {};
}

void Controller::doStop()
{
    m_sense.stopped();
    m_commandedAt = {}; // what comes next finds it halted
    const CanFrame noDrive = stopFrame(identity().address, m_isBraked);
    // Twice (README.md#stopping): the first overtakes what waits, the second comes behind a set-point that the kernel may still hold.
    // A link that is gone cannot be helped from here.
    (void)m_can.send(noDrive, Priority::Urgent);
    (void)m_can.send(noDrive);
    telemetry()->breakLine(channel::setPoint);
}

StopScript Controller::stopScript() const
{
    StopStep step;
    step.frame = stopFrame(identity().address, m_isBraked);
    step.wait = std::chrono::milliseconds(10);
    step.attempts = 2; // README.md#stopping
    return {{std::move(step)}};
}

bool Controller::isSeenStopped() const
{
    return m_presence.heardAt() > gate().stoppedAt() && m_sense.isIdle();
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
        if (const auto status = decodeStatusEncoder(frame)) {
            m_sense.take(*status, frame.time, m_presence.isHeard());
            askPeriod(param::encoderPeriod);
            updateLiveness();
        }
        break;
    case id::statusAnalog:
        if (const auto status = decodeStatusAnalog(frame)) {
            m_sense.take(*status, frame.time);
            askPeriod(param::analogPeriod);
        }
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
            m_presence.sessionTold(first->session, frame.time, identity().state == DeviceState::Duplicate);
        else if (const auto second = decodeEnumResponse1(frame))
            onVersions(*second);
        break;
    case id::control: // our own frames do not come back
        if (isMessage(frame, id::control, 8))
            m_presence.commandedByOther(frame.time);
        break;
    default: break;
    }
}

void Controller::onGeneral(const StatusGeneral &status, Instant time)
{
    m_sense.take(status, time, gate().stoppedAt());
    askPeriod(param::generalPeriod);
    const bool first = m_presence.heard(time);
    if (gate().busy().empty()) // an update talks alone: they are sent after it
        m_rates.sendOwed(m_contact);
    updateLiveness();
    askFaults();
    if (first)
        m_presence.follow();
}

void Controller::onParameter(const ParamResponse &response)
{
    m_unanswered.stop();
    StatusStream *const stream = m_sense.streamOf(response.parameter);
    if (stream && response.status == ParameterStatus::NoError && response.field > 0)
        stream->setPeriod(std::chrono::milliseconds(response.field));
    m_faultWatch.take(response, clock().now());
    m_rates.told(response);
    updateLiveness();
}

void Controller::onVendorStatus(const VendorStatus &status)
{
    if (identity().state == DeviceState::Duplicate)
        return; // whose status is it?
    if (status.status == CommandStatus::InBootloader) {
        m_rates.forgotten(); // also where the answer to the reset that ends it is lost
        setState(DeviceState::Bootloader, say("The bootloader runs; restart the unit or update its firmware."));
    } else if (status.status == CommandStatus::AckReset) {
        if (identity().state == DeviceState::Bootloader)
            setState(DeviceState::Online, {});
        restarted();
    }
}

void Controller::onVersions(const EnumResponse1 &response)
{
    if (m_presence.session() != response.session)
        return;
    Identity known = identity();
    setVersions(known, {response.image, response.application, response.bootloader});
    setIdentity(std::move(known));
}

void Controller::askPeriod(std::uint8_t parameter)
{
    if (!m_sense.streamOf(parameter)->isHolding() || !gate().busy().empty()
        || clock().now() - m_periodAskedAt < askPeriodAtMost)
        return;
    m_periodAskedAt = clock().now();
    (void)m_can.send(encodeParamRequest(identity().address, sessionOf(identity()), parameter));
    awaitAnswer(m_unanswered, m_presence);
}

/// With no task waiting: an answer that does not come is asked for again a second later.
void Controller::askFaults()
{
    const bool listened
        = identity().state == DeviceState::Online && gate().busy().empty() && !link().address().isRecording();
    if (!listened || !m_faultWatch.isDue(clock().now()))
        return;
    for (const std::uint8_t parameter : FaultWatch::questions)
        (void)m_can.send(encodeParamRequest(identity().address, sessionOf(identity()), parameter));
    awaitAnswer(m_unanswered, m_presence);
}

void Controller::sessionChanged()
{
    if (m_presence.takeSession(identity().session))
        restarted();
}

void Controller::restarted()
{
    m_restarted = true;
    m_rates.forgotten();
    m_desk.restarted();
    m_sense.restart();
    parameters().forgetAll();
    if (gate().busy().empty())
        m_rates.sendOwed(m_contact);
    updateLiveness();
}

void Controller::setState(DeviceState state, Message detail)
{
    Identity known = identity();
    known.state = state;
    known.detail = std::move(detail);
    setIdentity(std::move(known));
}

void Controller::updateLiveness()
{
    const StatusGeneral &last = m_sense.general();
    const bool heard = m_presence.isHeard();
    const bool moving = heard && (last.duty != 0 || m_sense.isTurning(clock().now()));
    const std::uint32_t frameless = m_faultWatch.present(clock().now());
    // One frame in ten thousand changes any of this: compare it before building texts.
    const decltype(m_livenessKey) key{heard, moving, m_presence.hasForeignMaster(), m_restarted, last.overTemperature,
        last.underVoltage, last.gateDriver, static_cast<std::uint32_t>(last.mode), frameless};
    if (key == m_livenessKey) {
        setLiveness(liveness(), m_sense.states(), m_sense.statesAt());
        return;
    }
    m_livenessKey = key;
    Liveness now;
    now.heard = heard;
    now.moving = moving;
    now.foreignMaster = m_presence.hasForeignMaster();
    now.restarted = m_restarted;
    if (heard) {
        now.mode = modeOf(last.mode);
        if ((frameless & faultbit::overCurrent) != 0U)
            now.faults.emplace_back("over_current");
        if (last.overTemperature)
            now.faults.emplace_back("over_temperature");
        if (last.underVoltage)
            now.faults.emplace_back("under_voltage");
        if (last.gateDriver)
            now.faults.emplace_back("gate_driver");
        if ((frameless & faultbit::communication) != 0U)
            now.faults.emplace_back("communication");
    }
    setLiveness(now, m_sense.states(), m_sense.statesAt());
}

std::unique_ptr<Device> open(Link &link, Clock &clock, const Identity &identity)
{
    extern const Family family;
    auto *const can = dynamic_cast<CanLink *>(&link);
    return can ? std::make_unique<Controller>(family, *can, clock, identity) : nullptr;
}

} // namespace mb::dmc60c
