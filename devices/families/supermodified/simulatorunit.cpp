// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/supermodified/simulatorunit.h"

#include <algorithm>

namespace mb::supermodified::simulation {
namespace {

using namespace std::chrono_literals;

constexpr Duration carePeriod = 20ms; ///< how often a turning motor is computed when nobody asks
constexpr Duration halfPacketTime = 50ms;

/// Steps well on a 25d with its load: tests/families/test_supermodified_simulator.cpp.
struct Gains {
    std::uint16_t p;
    std::uint16_t i;
    std::uint16_t d;
};
constexpr Gains tunedGains{1000, 20, 16000};

Eeprom stored(const UnitOptions &options, const SerialLink &link)
{
    Eeprom eeprom;
    eeprom.node = static_cast<std::uint8_t>(options.node);
    eeprom.mask = static_cast<std::uint8_t>(options.mask);
    eeprom.level = static_cast<std::uint8_t>(options.level);
    const bool slower = options.dialect == Dialect::D3 || link.address().isSimulated(); // one rate for a bench
    const int usual = slower ? 57600 : 115200;
    const int rate = options.baudrate.value_or(link.fixedBaudrate().value_or(usual));
    eeprom.baudrate = static_cast<std::uint32_t>(rate);
    if (options.tuned) {
        eeprom.p = tunedGains.p;
        eeprom.i = tunedGains.i;
        eeprom.d = tunedGains.d;
    }
    return eeprom;
}

} // namespace

Unit::Unit(SerialLink &link, Clock &clock, const UnitOptions &options, Notify notify)
    : m_link(link)
    , m_clock(clock)
    , m_options(options)
    , m_notify(std::move(notify))
    , m_drive(options.dialect, *motorByName(options.motor), options.load, options.seed)
    , m_firmware(options.dialect, m_drive, stored(options, link))
    , m_faults(clock, options.faults)
    , m_supply(clock, [this](bool on) { fed(on); })
    , m_reply(clock)
    , m_half(clock)
    , m_care(clock)
    , m_received(link.received().add([this](std::span<const std::uint8_t> bytes) { receive(bytes); }))
    , m_lineErrors(link.lineErrors().add([this] { lineError(); }))
{
    m_drive.switched = [this](bool on) { switched(on); };
    m_drive.fault = [this](std::uint8_t code) {
        m_firmware.report(code);
        m_notify(m_clock.now(), "fault", code);
    };
    m_firmware.died = [this](std::string_view what, double value) { m_notify(m_clock.now(), what, value); };
    m_firmware.setHangs(options.hangs);
    m_firmware.beforeAction = [this] { return beforeAction(); };
    restart();
    scheduleFaults();
}

void Unit::restart()
{
    m_drive.advance(m_clock.now());
    m_firmware.restart(m_clock.now());
    if (m_link.fixedBaudrate() != m_firmware.baudrate())
        (void)m_link.setBaudrate(realRate(m_firmware.baudrate()));
}

// The wire

void Unit::receive(std::span<const std::uint8_t> bytes)
{
    if (!m_supply.isOn())
        return;
    m_drive.advance(m_clock.now());
    for (const std::uint8_t byte : bytes) {
        if (auto reply = m_firmware.take(byte, m_clock.now()))
            answer(std::move(*reply));
        if (!m_supply.isOn())
            return;
    }
    if (m_options.halfPacket && m_firmware.isReceiving())
        m_half.startIn(halfPacketTime, [this] { m_firmware.dropHalf(); });
    else
        m_half.stop();
}

void Unit::lineError()
{
    if (m_supply.isOn())
        m_firmware.report(code::uartFrame);
}

void Unit::answer(Firmware::Answer answer)
{
    const FrameFate fate = m_faults.sent();
    if (fate.lost)
        return;
    if (fate.corrupt)
        answer.bytes[answer.bytes.size() / 2] ^= 0x10U;
    m_reply.startIn(answer.busy + fate.delay.value_or(Duration::zero()),
        [this, bytes = std::move(answer.bytes)] { transmit(bytes); });
}

void Unit::transmit(std::vector<std::uint8_t> bytes)
{
    if (m_supply.isOn() && m_link.state() == LinkState::Open)
        (void)m_link.send(bytes);
}

// Motor

Drive &Unit::drive()
{
    m_drive.advance(m_clock.now());
    return m_drive;
}

void Unit::switched(bool on)
{
    m_notify(m_clock.now(), on ? "output-on" : "output-off", 0.0);
    lookAfter();
}

void Unit::lookAfter()
{
    if (m_care.isActive())
        return;
    m_care.startIn(carePeriod, [this] {
        if (!drive().isResting())
            lookAfter();
    });
}

// Supply and faults

bool Unit::beforeAction()
{
    if (!m_faults.failsWithFrame())
        return true;
    m_supply.lose();
    return false;
}

void Unit::fed(bool on)
{
    if (on) {
        restart();
        m_notify(m_clock.now(), "power-on", 0.0);
        return;
    }
    m_reply.stop();
    m_half.stop();
    drive().stop();
    m_notify(m_clock.now(), "power-lost", 0.0);
}

void Unit::scheduleFaults()
{
    if (m_faults.has(FaultKind::EncoderReversed))
        m_drive.encoder().setReversed();
    m_faults.at(FaultKind::Reset, [this] { m_supply.lose(Duration(1)); });
    m_faults.at(FaultKind::Brownout, [this] { m_supply.lose(FaultPlan::brownoutTime); });
    m_faults.at(FaultKind::EncoderDead, [this] { drive().encoder().setDead(); });
    m_faults.at(FaultKind::Stall, [this] { drive().motor().setLocked(true); });
}

bool Unit::disturb(std::string_view what, double value)
{
    m_drive.advance(m_clock.now());
    if (what == "error")
        m_firmware.report(static_cast<std::uint8_t>(value));
    else if (what.starts_with("input") && what.size() == 6 && what[5] >= '1' && what[5] <= '4') {
        const auto bit = static_cast<std::uint8_t>(1U << static_cast<unsigned>(what[5] - '1'));
        m_firmware.inputs
            = static_cast<std::uint8_t>(value != 0.0 ? m_firmware.inputs | bit : m_firmware.inputs & ~bit);
    } else if (what.starts_with("analog") && what.size() == 7 && what[6] >= '1' && what[6] <= '4')
        m_firmware.analog.at(static_cast<std::size_t>(what[6] - '1'))
            = static_cast<std::uint16_t>(std::clamp(value / adcVolts, 0.0, 1023.0));
    else if (what == "encoder-dead" && value != 0.0)
        m_drive.encoder().setDead(); // it sits on the output shaft, not on the motor
    else if (what == "encoder-reversed" && value != 0.0)
        m_drive.encoder().setReversed();
    else if (!m_drive.motor().disturb(what, value))
        return false;
    lookAfter();
    return true;
}

} // namespace mb::supermodified::simulation
