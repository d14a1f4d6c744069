// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/simulatorunit.h"

#include "wire/bytes.h"

#include <algorithm>
#include <array>
#include <utility>

namespace mb::abstractdc::simulation {
namespace {

using namespace std::chrono_literals;

constexpr double glitchWindow = 20e-6; ///< how long after a wrap a reading may be wrong
constexpr Duration answerTime = 15us;  ///< replies are sent from the receive interrupt
constexpr std::size_t mailboxes = 3;   ///< further replies are dropped

template <std::size_t N> int placeOf(const std::array<int, N> &codes, int code)
{
    const auto found = std::ranges::find(codes, code);
    return found == codes.end() ? absent : static_cast<int>(found - codes.begin());
}

std::int32_t valueAt(const CanFrame &frame, std::size_t place)
{
    return signExtend(readU32le(frame.data, place), 32);
}

} // namespace

Unit::Unit(CanLink &link, Clock &clock, const UnitOptions &options, Notify notify)
    : m_clock(clock)
    , m_options(options)
    , m_notify(std::move(notify))
    , m_dialect(*options.dialect)
    , m_shaft(clock, options, m_notify)
    , m_loops(clock, m_shaft, m_notify)
    , m_faults(clock, options.faults)
    , m_supply(clock, [this](bool on) { switched(on); })
    , m_outbox(link, clock, m_faults)
    , m_received(link.received().add([this](const CanFrame &frame) { hear(frame); }))
{
    const auto stored = storedGains(options);
    for (int page = 0; options.gains != StoredGains::Default && page < 3; ++page)
        m_flash.save(page, stored.at(static_cast<std::size_t>(page)));
    start();
    scheduleFaults();
}

void Unit::start()
{
    m_shaft.zero();
    m_loops.start({m_flash.load(0), m_flash.load(1), m_flash.load(2)});
    m_notify(m_clock.now(), "power-on", 0.0);
}

void Unit::stop()
{
    m_shaft.advance();
    m_outbox.clear();
    m_loops.stop();
}

void Unit::switched(bool on)
{
    if (on)
        return start();
    stop();
    m_notify(m_clock.now(), "power-lost", 0.0);
}

void Unit::scheduleFaults()
{
    m_faults.at(FaultKind::Reset, [this] {
        if (!m_supply.isOn())
            return;
        stop();
        m_notify(m_clock.now(), "reset", 0.0);
        start();
    });
    m_faults.at(FaultKind::BusOff, [this] { m_outbox.clear(); });
    m_faults.at(FaultKind::EncoderDead, [this] { m_shaft.motor().setEncoderDead(true); });
    m_faults.at(FaultKind::Stall, [this] { (void)disturb("stall", 1.0); });
    m_faults.sag([this](double volts) { (void)disturb("bus-voltage", volts); });
}

double Unit::speed()
{
    m_shaft.advance();
    return m_shaft.motor().countSpeed();
}

double Unit::position()
{
    m_shaft.advance();
    return m_shaft.motor().countPosition();
}

double Unit::current()
{
    m_shaft.advance();
    return m_shaft.motor().current();
}

std::optional<std::int64_t> Unit::gain(std::string_view key)
{
    using Field = std::pair<std::string_view, std::int32_t Record::*>;
    static constexpr std::array<std::string_view, 3> loops{"velocity", "current", "position"};
    static constexpr std::array<Field, 4> fields{
        {{"p", &Record::p}, {"i", &Record::i}, {"d", &Record::d}, {"divisor", &Record::divisor}}};
    const std::size_t dot = key.find('.');
    const auto loop = std::ranges::find(loops, key.substr(0, dot));
    const auto field = std::ranges::find(fields, key.substr(dot + 1), &Field::first);
    if (loop == loops.end() || field == fields.end())
        return std::nullopt;
    return m_loops.gainsOf(static_cast<Loop>(loop - loops.begin() + 1)).*field->second;
}

bool Unit::disturb(std::string_view what, double value)
{
    if (what != "glitch")
        return m_loops.disturb(what, value) || m_shaft.disturb(what, value);
    m_glitchNext = true;
    return true;
}

// What it hears

void Unit::hear(const CanFrame &frame)
{
    if (!m_supply.isOn() || m_faults.isBusOff() || frame.extended || frame.remote || frame.error)
        return;
    if (m_faults.failsWithFrame())
        return m_supply.lose();
    m_shaft.advance();
    dispatch(frame);
}

/// In this order: settings, set-point, log (README.md#voltage-log).
void Unit::dispatch(const CanFrame &frame)
{
    const auto own = [&](std::uint32_t base) {
        return frame.id == base || frame.id == base + static_cast<std::uint32_t>(m_options.offset);
    };
    if (own(id::settings))
        onSettings(frame);
    else if (own(id::setPoint))
        onSetPoint(frame);
    else if (m_dialect.request == id::logRequest
            ? own(id::logRequest)
            : frame.id == id::logRequestOld + static_cast<std::uint32_t>(m_options.offset))
        onLogRequest(frame);
}

void Unit::onSettings(const CanFrame &frame)
{
    const bool save = frame.size == 1;
    if (!save && frame.size != (m_dialect.wide ? 8 : 6))
        return;
    const int type = m_dialect.wide && !save ? frame.data[0] & 0xF : frame.data[0];
    const int loop = placeOf(m_dialect.type, type);
    if (loop < static_cast<int>(Loop::Velocity) || loop > static_cast<int>(Loop::Position))
        return;
    Record &gains = m_loops.gainsOf(static_cast<Loop>(loop));
    if (save) {
        m_flash.save(loop - 1, gains);
        m_notify(m_clock.now(), "settings-saved", loop);
        return;
    }
    const std::int32_t value = valueAt(frame, m_dialect.wide ? 4 : 2);
    switch (placeOf(m_dialect.field, m_dialect.wide ? frame.data[0] >> 4 : frame.data[1])) {
    case 0: gains.p = value; break;
    case 1: gains.i = value; break;
    case 2: gains.d = value; break;
    case 3: gains.divisor = value; break;
    case 4:
        if (loop == static_cast<int>(Loop::Current))
            gains.averaging = value & 0xFFFF;
        break;
    default: return;
    }
    m_notify(m_clock.now(), "gains-written", loop);
}

void Unit::onSetPoint(const CanFrame &frame)
{
    if (frame.size != (m_dialect.wide ? 8 : 5))
        return;
    const int loop = placeOf(m_dialect.type, frame.data[0]);
    if (loop != absent)
        m_loops.enter(static_cast<Loop>(loop), valueAt(frame, m_dialect.wide ? 4 : 1));
}

void Unit::onLogRequest(const CanFrame &frame)
{
    if (frame.size != 1)
        return;
    const int log = placeOf(m_dialect.log, frame.data[0]);
    if (log == absent)
        return;
    switch (static_cast<Log>(log)) {
    case Log::Position: reply(Log::Position, positionLog()); break;
    case Log::Velocity: reply(Log::Velocity, m_loops.velocity()); break;
    case Log::Current: reply(Log::Current, m_loops.current()); break;
    case Log::Temperature:
        reply(Log::Temperature, std::min(m_loops.temperature() + m_options.temperatureOffset, adcMost));
        break;
    case Log::Voltage: reply(Log::Voltage, static_cast<std::int32_t>(m_loops.output())); break;
    }
}

void Unit::reply(Log log, std::int32_t value)
{
    if (m_outbox.waiting() >= mailboxes)
        return;
    std::array<std::uint8_t, 4> data{};
    writeU32le(data, 0, static_cast<std::uint32_t>(value));
    const int base = m_dialect.reply.at(static_cast<std::size_t>(log));
    const bool shifted = log != Log::Voltage || m_dialect.voltageOffset;
    m_outbox.post(standardFrame(static_cast<std::uint32_t>(base + (shifted ? m_options.offset : 0)), data), answerTime);
}

/// README.md#position: the reading is not atomic with the interrupt of a wrap.
std::int32_t Unit::positionLog()
{
    ++m_positionLogs;
    const std::int64_t counts = m_shaft.counts();
    const double speed = m_shaft.motor().countSpeed();
    const auto low = static_cast<double>(counts & 0xFFFF);
    const double passed = speed * glitchWindow;
    const bool justWrapped
        = (passed > 0.0 && low < passed && counts > 65535) || (passed < 0.0 && 65536.0 - low < -passed);
    const bool wanted = m_glitchNext || (m_options.glitches > 0 && m_positionLogs % m_options.glitches == 0);
    m_glitchNext = false;
    if (!justWrapped && !wanted)
        return m_shaft.encoder();
    return m_shaft.encoder() + (speed >= 0.0 ? -wrapLoss : wrapLoss);
}

} // namespace mb::abstractdc::simulation
