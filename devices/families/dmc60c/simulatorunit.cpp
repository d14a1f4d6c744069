// SPDX-License-Identifier: GPL-3.0-or-later
// Supply, resets, and what a running unit does by itself.
#include "families/dmc60c/simulatorunit.h"

#include "families/dmc60c/simulatorgains.h"

#include <algorithm>

namespace mb::dmc60c::simulation {
namespace {

constexpr auto bootTime = std::chrono::milliseconds(15);        ///< from reset to the bootloader's decision
constexpr auto applicationTime = std::chrono::milliseconds(25); ///< from there to the application's first action
constexpr auto supplyGap = std::chrono::milliseconds(200);
constexpr auto busOffTime = std::chrono::milliseconds(100);
constexpr double brownoutVolts = 5.0;
constexpr double brownoutSeconds = 6.0;
constexpr double nominalVolts = 12.0;

std::uint64_t mix(const UnitOptions &options)
{
    return options.seed * std::uint64_t{0x9E3779B97F4A7C15} + static_cast<std::uint64_t>(options.number);
}

ConfigImage factoryConfig(const UnitOptions &options)
{
    ConfigImage image;
    image.sequence = 1;
    image.number = options.number;
    image.text(Descriptor::DevName) = options.name;
    image.text(Descriptor::ProdName) = "Digilent DMC60C";
    image.text(Descriptor::SN) = options.serial;
    storeGains(image.parameters, options.gains, *motorByName(options.motor), options.load, options.velocity);
    return image;
}

} // namespace

Unit::Unit(CanLink &link, Clock &clock, const UnitOptions &options, Notify notify)
    : m_link(link)
    , m_clock(clock)
    , m_options(options)
    , m_notify(std::move(notify))
    , m_random(mix(options))
    , m_application(options.inBootloader ? noApplication : options.firmware)
    , m_flash(factoryConfig(options))
    , m_ram(m_flash)
    , m_rig(*motorByName(options.motor), options.load, mix(options))
    , m_drive(m_rig, m_ram.parameters, options.velocity,
          [this](Instant time, std::string_view what, double value) { this->notify(time, what, value); })
    , m_vendor(*this)
    , m_outbox(link, clock, options.faults)
    , m_nextSession(options.session)
    , m_startTimer(clock)
    , m_enumTimer(clock)
    , m_heartbeat(clock)
    , m_stallTimer(clock)
    , m_configTimer(clock)
    , m_busTimer(clock)
    , m_general(clock)
    , m_encoder(clock)
    , m_analog(clock)
{
    listen();
    scheduleFaults();
    startBootloader(); // it has been powered long enough
    if (m_application.isRunnable())
        startApplication();
}

Unit::~Unit() = default;

void Unit::listen()
{
    m_received = m_link.received().add([this](const CanFrame &frame) { receive(frame); });
    m_traffic = m_link.traffic().add([this](const Traffic &traffic) {
        if (traffic.direction == Direction::Sent && traffic.can != nullptr)
            overhear(*traffic.can);
    });
    m_stateChanged = m_link.stateChanged().add([this](LinkState state) {
        if (state != LinkState::Open)
            loseBus();
    });
}

void Unit::scheduleFaults()
{
    if (m_options.has("encoder-reversed"))
        m_rig.reverseEncoder();
    for (const SimulatedFault &fault : m_options.faults)
        scheduleFault(fault);
}

void Unit::scheduleFault(const SimulatedFault &fault)
{
    if (fault.kind == "reset") {
        at(fault.at, [this] { resetBySelf(); });
    } else if (fault.kind == "busoff") {
        at(fault.at, [this] {
            loseBus();
            m_busOff = true;
            m_busTimer.startIn(busOffTime, [this] { m_busOff = false; });
        });
    } else if (fault.kind == "encoder-dead") {
        at(fault.at, [this] {
            m_drive.advance(m_clock.now());
            m_rig.killEncoder();
        });
    } else if (fault.kind == "brownout") {
        at(fault.at, [this] { disturb("bus-voltage", brownoutVolts); });
        at(fault.at + brownoutSeconds, [this] { disturb("bus-voltage", nominalVolts); });
    } else if (fault.kind == "stall") {
        at(fault.at, [this] { disturb("stall", 1.0); });
    }
}

void Unit::at(double seconds, std::function<void()> work)
{
    const auto delay = std::chrono::duration_cast<Duration>(std::chrono::duration<double>(seconds));
    m_faultTimers.push_back(std::make_unique<Timer>(m_clock));
    m_faultTimers.back()->startIn(delay, std::move(work));
}

void Unit::setPowered(bool powered)
{
    m_takenAway = !powered;
    if (!powered && m_stage != Stage::Off) {
        losePower(false);
    } else if (!powered) {
        m_startTimer.stop();
    } else if (m_stage == Stage::Off) {
        note("power-on", 0.0);
        start();
    }
}

void Unit::losePower(bool returns)
{
    leave(Stage::Off);
    m_session = 0;
    m_stay = false;
    m_announce.reset();
    m_configChanged.reset();
    note("power-lost", 0.0);
    if (returns)
        m_startTimer.startIn(supplyGap, [this] { setPowered(true); });
}

void Unit::leave(Stage next)
{
    m_drive.end(m_clock.now());
    stopStatus();
    for (Timer *timer : {&m_startTimer, &m_enumTimer, &m_heartbeat, &m_stallTimer, &m_configTimer})
        timer->stop();
    m_outbox.clear();
    m_vendor.reset();
    m_stalls.clear();
    m_fifo.clear();
    m_heartbeatMissed = false;
    m_application.forgetRam();
    m_stage = next;
}

void Unit::start()
{
    leave(Stage::Starting);
    m_startTimer.startIn(bootTime, [this] {
        const bool stay = std::exchange(m_stay, false);
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
    m_ram = m_flash;
    m_stage = Stage::Bootloader;
    note("bootloader", 0.0);
    if (m_announce == CommandStatus::InBootloader)
        sendStatus(CommandStatus::InBootloader, 0, 0);
    m_announce.reset();
}

void Unit::startApplication()
{
    m_ram = m_flash;
    m_ram.parameters.forgetVolatile();
    m_stage = Stage::Application;
    m_drive.start(m_clock.now(), m_ram.brake);
    m_configChanged.reset();
    note("application", 0.0);
    if (m_announce == CommandStatus::AckReset)
        sendStatus(CommandStatus::AckReset, 0, 0);
    m_announce.reset();
    if (m_session != 0)
        startStatus();
}

void Unit::restart(bool stay)
{
    m_stay = stay;
    m_announce = stay ? CommandStatus::InBootloader : CommandStatus::AckReset;
    note("reset", 0.0);
    start();
}

void Unit::resetBySelf()
{
    if (m_stage == Stage::Off || m_stage == Stage::Dead)
        return;
    m_session = 0;
    m_stay = false;
    m_announce.reset();
    note("reset", 0.0);
    start();
}

void Unit::loseBus()
{
    if (m_session == 0)
        return;
    const Instant now = m_clock.now();
    m_session = 0;
    m_enumTimer.stop();
    m_heartbeat.stop();
    m_vendor.reset();
    m_outbox.clear();
    stopStatus();
    if (m_stage == Stage::Application) {
        m_drive.halt(now, true);
        m_drive.setOutsideFault(faultbit::communication, true, now);
    }
}

bool Unit::isOutputOn()
{
    m_drive.advance(m_clock.now());
    return m_drive.isOutputOn();
}

double Unit::speed()
{
    m_drive.advance(m_clock.now());
    return m_rig.speed();
}

double Unit::position()
{
    m_drive.advance(m_clock.now());
    return m_rig.position();
}

bool Unit::disturb(std::string_view what, double value)
{
    const Instant now = m_clock.now();
    m_drive.advance(now);
    m_drive.wake();
    if (what == "gate-fault") {
        m_drive.setOutsideFault(faultbit::gateDriver, value != 0.0, now);
        return true;
    }
    if (what == "flash-fail") {
        m_application.spoil(static_cast<int>(value));
        return true;
    }
    return m_rig.disturb(what, value);
}

bool Unit::failsDuring(int page)
{
    const auto &faults = m_options.faults;
    const auto fault = std::find_if(faults.begin(), faults.end(),
        [page](const SimulatedFault &f) { return f.kind == "power-page" && static_cast<int>(f.at) == page; });
    if (fault == faults.end())
        return false;
    m_options.faults.erase(fault); // once
    losePower(true);
    return true;
}

void Unit::notify(Instant time, std::string_view what, double value)
{
    if (what == "fault")
        configChanged({});
    m_notify(time, what, value);
}

} // namespace mb::dmc60c::simulation
