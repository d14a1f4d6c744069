// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/simulatorunit.h"

#include "families/dmc60c/simulatorgains.h"
#include "wire/bytes.h"

#include <algorithm>

namespace mb::dmc60c::simulation {
namespace {

constexpr auto bootTime = std::chrono::milliseconds(15);        ///< from reset to the bootloader's decision
constexpr auto applicationTime = std::chrono::milliseconds(25); ///< from there to the application's first action

constexpr std::uint32_t edition = 0x00103U; ///< pdid bits 19…0

std::uint64_t mix(const UnitOptions &options)
{
    return options.seed * std::uint64_t{0x9E3779B97F4A7C15} + static_cast<std::uint64_t>(options.number);
}

ConfigImage factoryConfig(const UnitOptions &options)
{
    ConfigImage image;
    image.sequence = 1;
    image.number = options.number;
    image.brake = options.brake;
    image.text(Descriptor::DevName) = options.name;
    image.text(Descriptor::ProdName) = "Digilent DMC60C";
    image.text(Descriptor::SN) = options.serial;
    storeGains(image.parameters, options.gains, *motorByName(options.motor), options.load, options.velocity);
    return image;
}

std::uint32_t messageOf(const CanFrame &frame)
{
    return frame.id & id::messageMask;
}

/// The filter of the controller: the standard part of the identifier.
bool passesFilter(const CanFrame &frame)
{
    const std::uint32_t standardPart = frame.id >> 18U;
    return frame.extended && (standardPart == (id::control >> 18U) || messageOf(frame) == id::enumerate);
}

bool isAddressed(const CanFrame &frame, int number)
{
    return messageOf(frame) == id::enumerate || static_cast<int>(frame.id & id::deviceMask) == number;
}

} // namespace

Unit::Unit(CanLink &link, Clock &clock, const UnitOptions &options, Notify notify)
    : m_clock(clock)
    , m_options(options)
    , m_notify(std::move(notify))
    , m_random(mix(options))
    , m_application(options.inBootloader ? noApplication : options.firmware)
    , m_processor(clock, {[this](const CanFrame &frame) { handle(frame); }, [this] { m_heartbeat.freed(); }})
    , m_memory(clock, m_processor, factoryConfig(options),
          [this](std::string_view what, double value) { note(what, value); })
    , m_drive(Rig(*motorByName(options.motor), options.load, mix(options)), m_memory.ram().parameters, options.velocity,
          [this](Instant time, std::string_view what, double value) { this->notify(time, what, value); })
    , m_vendor(*this, m_processor, m_memory, m_application, options.crc)
    , m_faults(clock, options.faults)
    , m_outbox(link, clock, m_faults)
    , m_status(clock, m_drive, m_memory, m_outbox, m_random,
          [this] { return m_stage == Stage::Application && m_enumeration.session() != 0; })
    , m_parameters(clock, m_drive, m_memory, m_status,
          [this](std::span<const std::uint8_t> bytes) { sendReply(id::paramResponse, bytes); })
    , m_enumeration(clock, m_random, options.session, [this] { return sendEnumeration(); })
    , m_heartbeat(clock, m_processor, m_drive)
    , m_supply(clock, [this](bool on) { switched(on); })
    , m_startTimer(clock)
{
    listen(link);
    scheduleFaults();
    if (m_faults.has(FaultKind::EncoderReversed))
        m_drive.rig().reverseEncoder();
    startBootloader(); // it has been powered long enough
    if (m_application.isRunnable())
        startApplication();
}

Drive &Unit::drive()
{
    m_drive.advance(m_clock.now());
    return m_drive;
}

void Unit::listen(CanLink &link)
{
    m_heard[0] = link.received().add([this](const CanFrame &frame) { receive(frame); });
    m_heard[1] = link.traffic().add([this](const Traffic &traffic) {
        if (traffic.direction == Direction::Sent && traffic.can != nullptr)
            takeMasterStatus(*traffic.can);
    });
    m_heard[2] = link.stateChanged().add([this](LinkState state) {
        if (state != LinkState::Open)
            loseBus();
    });
}

void Unit::scheduleFaults()
{
    m_faults.at(FaultKind::Reset, [this] { resetBySelf(); });
    m_faults.at(FaultKind::BusOff, [this] { loseBus(); });
    m_faults.at(FaultKind::EncoderDead, [this] { drive().rig().killEncoder(); });
    m_faults.at(FaultKind::Stall, [this] { disturb("stall", 1.0); });
    m_faults.sag([this](double volts) { disturb("bus-voltage", volts); });
}

void Unit::switched(bool on)
{
    if (on) {
        note("power-on", 0.0);
        return start();
    }
    leave(Stage::Off);
    m_enumeration.end();
    m_order = {};
    m_memory.forgetChange();
    note("power-lost", 0.0);
}

void Unit::leave(Stage next)
{
    m_drive.end(m_clock.now());
    m_status.stop();
    m_startTimer.stop();
    m_enumeration.stop();
    m_heartbeat.clear();
    m_memory.stop();
    m_outbox.clear();
    m_vendor.reset();
    m_processor.clear();
    m_application.forgetRam();
    m_stage = next;
}

void Unit::start()
{
    leave(Stage::Starting);
    m_startTimer.startIn(bootTime, [this] {
        const bool stay = std::exchange(m_order.stay, false);
        if (!m_application.isBootable()) {
            m_stage = Stage::Dead;
            return note("bricked", 0.0);
        }
        if (stay || m_application.version() == noApplication)
            return startBootloader();
        m_startTimer.startIn(applicationTime, [this] {
            if (m_application.isRunnable())
                return startApplication();
            m_stage = Stage::Dead;
            note("bricked", 0.0);
        });
    });
}

void Unit::startBootloader()
{
    m_memory.load();
    m_stage = Stage::Bootloader;
    note("bootloader", 0.0);
    if (m_order.announce == CommandStatus::InBootloader)
        sendStatus(CommandStatus::InBootloader, 0, 0);
    m_order.announce.reset();
}

void Unit::startApplication()
{
    m_memory.load();
    m_memory.ram().parameters.forgetVolatile();
    m_stage = Stage::Application;
    m_drive.start(m_clock.now(), m_memory.ram().brake);
    m_memory.forgetChange();
    note("application", 0.0);
    if (m_order.announce == CommandStatus::AckReset)
        sendStatus(CommandStatus::AckReset, 0, 0);
    m_order.announce.reset();
    if (m_enumeration.session() != 0)
        m_status.start();
}

void Unit::restart(bool stay)
{
    m_order = {stay, stay ? CommandStatus::InBootloader : CommandStatus::AckReset};
    note("reset", 0.0);
    start();
}

void Unit::resetBySelf()
{
    if (m_stage == Stage::Off || m_stage == Stage::Dead)
        return;
    m_enumeration.end();
    m_order = {};
    note("reset", 0.0);
    start();
}

void Unit::loseBus()
{
    if (m_enumeration.session() == 0)
        return;
    const Instant now = m_clock.now();
    m_enumeration.end();
    m_enumeration.stop();
    m_heartbeat.stop();
    m_vendor.reset();
    m_outbox.clear();
    m_status.stop();
    if (m_stage == Stage::Application) {
        m_drive.halt(now, true);
        m_drive.setOutsideFault(faultbit::communication, true, now);
    }
}

bool Unit::disturb(std::string_view what, double value)
{
    drive().wake();
    if (what == "gate-fault") {
        m_drive.setOutsideFault(faultbit::gateDriver, value != 0.0, m_clock.now());
        return true;
    }
    if (what == "flash-fail") {
        m_application.spoil(static_cast<int>(value));
        return true;
    }
    return m_drive.rig().disturb(what, value);
}

bool Unit::failsDuring(int page)
{
    if (!m_faults.failsWithPage(page))
        return false;
    m_supply.lose();
    return true;
}

void Unit::notify(Instant time, std::string_view what, double value)
{
    if (what == "fault")
        m_memory.changed({});
    m_notify(time, what, value);
}

// What it hears

void Unit::receive(const CanFrame &frame)
{
    const bool deaf
        = m_stage == Stage::Off || m_stage == Stage::Starting || m_stage == Stage::Dead || m_faults.isBusOff();
    if (deaf || frame.error || frame.remote)
        return;
    if (m_enumeration.session() == 0) {
        m_enumeration.begin();
        if (m_stage == Stage::Application) {
            m_drive.setOutsideFault(faultbit::communication, false, m_clock.now());
            m_status.start();
        }
    }
    if (!passesFilter(frame))
        return;
    if (isAddressed(frame, m_memory.ram().number) && m_faults.failsWithFrame())
        return m_supply.lose();
    m_processor.take(frame);
}

void Unit::takeMasterStatus(const CanFrame &frame)
{
    const int device = static_cast<int>(frame.id & id::deviceMask);
    if (m_stage != Stage::Application || messageOf(frame) != id::statusGeneral || frame.size != 8
        || device == m_memory.ram().number)
        return;
    if (device == drive().master())
        m_drive.masterHeard(signExtend(readU16le(frame.bytes(), 0), 16), m_clock.now());
}

void Unit::handle(const CanFrame &frame)
{
    const std::uint32_t message = messageOf(frame);
    if (message == id::enumerate) {
        if (frame.size == 0)
            m_enumeration.ask(m_memory.ram().number, isInBootloader());
    } else if (message == id::statusGeneral) {
        takeMasterStatus(frame);
    } else if (isAddressed(frame, m_memory.ram().number)) {
        handleForNumber(message, frame);
    }
}

void Unit::handleForNumber(std::uint32_t message, const CanFrame &frame)
{
    const bool application = m_stage == Stage::Application;
    const auto bytes = frame.bytes();
    if (message == id::vendorDout && frame.size > 0)
        return m_vendor.data(bytes);
    if (message == id::control && frame.size == 8 && application) {
        m_drive.command(ControlWord::decode(bytes), m_clock.now());
        return m_heartbeat.beat(frame.time);
    }
    if (frame.size < 2 || readU16le(bytes, 0) != m_enumeration.session())
        return;
    if (message == id::vendorCommand && frame.size == 8)
        m_vendor.command(bytes);
    else if (message == id::paramRequest && frame.size == 3 && application)
        m_parameters.read(bytes[2]);
    else if (message == id::paramSet && frame.size == 7 && application)
        m_parameters.write(bytes[2], readU32le(bytes, 3));
}

// What it answers

bool Unit::sendEnumeration()
{
    if (m_processor.isBusy())
        return false;
    std::array<std::uint8_t, 6> first{};
    writeU16le(first, 0, m_enumeration.session());
    writeU32le(first, 2, (m_options.product << 20U) | edition);
    std::array<std::uint8_t, 8> second{};
    writeU16le(second, 0, m_enumeration.session());
    writeU16le(
        second, 2, static_cast<std::uint16_t>(isInBootloader() ? ImageType::Bootloader : ImageType::Application));
    writeU16le(second, 4, m_application.version());
    writeU16le(second, 6, bootloaderVersion);
    const auto identifier = id::enumResponse | static_cast<std::uint32_t>(m_memory.ram().number);
    m_outbox.send(extendedFrame(identifier, first));
    m_outbox.send(extendedFrame(identifier, second));
    return true;
}

void Unit::sendReply(std::uint32_t message, std::span<const std::uint8_t> bytes)
{
    const auto delay = std::chrono::microseconds(120 + m_random() % 180);
    m_outbox.post(extendedFrame(message | static_cast<std::uint32_t>(m_memory.ram().number), bytes), delay);
}

void Unit::sendStatus(CommandStatus status, std::uint8_t terminal, std::size_t bytes)
{
    std::array<std::uint8_t, 4> payload{};
    payload[0] = static_cast<std::uint8_t>(status);
    payload[1] = terminal;
    writeU16le(payload, 2, static_cast<std::uint16_t>(bytes));
    sendReply(id::vendorStatus, payload);
}

void Unit::sendData(std::span<const std::uint8_t> bytes)
{
    const auto identifier = id::vendorDin | static_cast<std::uint32_t>(m_memory.ram().number);
    for (std::size_t at = 0; at < bytes.size(); at += 8)
        m_outbox.post(extendedFrame(identifier, bytes.subspan(at, std::min<std::size_t>(8, bytes.size() - at))),
            Duration::zero());
}

} // namespace mb::dmc60c::simulation
