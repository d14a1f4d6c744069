// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/quadquad2drv/simulatorboard.h"

#include <algorithm>

namespace mb::quadquad2drv::simulation {
namespace {

constexpr Duration loopPeriod = std::chrono::milliseconds(2);
constexpr Duration startTime = std::chrono::milliseconds(50); ///< README.md#reset

} // namespace

Board::Board(SpiSlaveLink &link, Clock &clock, const BoardOptions &options, Notify notify)
    : m_link(link)
    , m_clock(clock)
    , m_notify(std::move(notify))
    , m_commands(m_axes, options.shiftedTarget,
          [this] {
              m_elapsed = 0;
              armStream();
          })
    , m_reader(clock, [this](const std::vector<std::uint8_t> &packet) { execute(packet); })
    , m_begun(clock.now())
    , m_due(m_begun + loopPeriod)
    , m_loop(clock)
    , m_stream(clock)
    , m_faults(clock, options.faults)
    , m_supply(clock, [this](bool on) { switched(on); })
{
    m_commands.version = options.version;
    for (std::size_t i = 0; i < axes; ++i) {
        m_axes[i] = std::make_unique<Axis>(*motorByName(options.motors[i]), options.loads[i]);
        m_axes[i]->setNature(options.gainScale, options.libraryPolarity);
    }
    scheduleFaults();
    m_link.attach(this);
    m_loop.start(m_due, [this] { loop(); });
}

Board::~Board()
{
    m_link.attach(nullptr);
}

/// The board's clock does not wait for a machine that is late: what was missed is caught up, up to a tenth of a second.
Instant Board::next(Instant due, Duration period) const
{
    constexpr Duration most = std::chrono::milliseconds(100);
    return std::max(due + period, m_clock.now() - most);
}

/// The motors turn on without supply.
void Board::loop()
{
    const double seconds = std::chrono::duration<double>(m_due - m_begun).count();
    for (const auto &axis : m_axes)
        axis->step(seconds);
    noteOutput();
    m_due = next(m_due, loopPeriod);
    m_loop.start(m_due, [this] { loop(); });
}

void Board::scheduleFaults()
{
    MotorModel &motor = m_axes.front()->motor();
    motor.setEncoderReversed(m_faults.has(FaultKind::EncoderReversed));
    constexpr Duration behindTheLoop(1); // which passes at the same moment
    m_faults.after(FaultKind::Reset, behindTheLoop, [this] { reset(); });
    m_faults.after(FaultKind::Brownout, behindTheLoop, [this] { m_supply.lose(FaultPlan::brownoutTime); });
    m_faults.after(FaultKind::EncoderDead, behindTheLoop, [&motor] { motor.setEncoderDead(true); });
    m_faults.after(FaultKind::Stall, behindTheLoop, [&motor] { motor.setLocked(true); });
}

void Board::noteOutput()
{
    const bool on = std::ranges::any_of(m_axes, [](const auto &axis) { return axis->output() != 0.0; });
    if (on != m_outputOn)
        m_notify(on ? "output-on" : "output-off", 0.0);
    m_outputOn = on;
}

void Board::reset()
{
    if (m_supply.isOn())
        begin();
}

/// The processor starts, which asks for the jumper.
void Board::begin()
{
    restart();
    m_awake = m_clock.now() + startTime;
    if (m_startListener)
        m_startListener(true);
}

void Board::restart()
{
    for (const auto &axis : m_axes)
        axis->reset();
    m_reader.clear();
    m_late.clear();
    m_out.clear();
    m_commands.restart();
    m_stream.stop();
    m_notify("reset", 0.0);
    noteOutput();
    m_link.readyChanged();
}

void Board::switched(bool on)
{
    if (on)
        return begin();
    restart();
    if (m_startListener)
        m_startListener(false);
}

bool Board::failsWithLine(int line)
{
    const bool fails = m_faults.failsWithPage(line);
    if (fails)
        m_supply.lose();
    return fails;
}

void Board::setRunning(bool running)
{
    if (std::exchange(m_running, running) == running)
        return;
    m_awake = m_clock.now() + startTime;
    restart();
}

void Board::transfer(std::span<const std::uint8_t> mosi, std::span<std::uint8_t> miso)
{
    for (std::size_t i = 0; i < mosi.size(); ++i) {
        miso[i] = 0;
        if (!answers())
            continue;
        miso[i] = m_out.next();
        m_reader.take(mosi[i]);
    }
    m_link.readyChanged();
}

void Board::execute(const Bytes &packet)
{
    if (m_faults.failsWithFrame())
        return m_supply.lose();
    const std::uint8_t id = packet[2];
    const std::span<const std::uint8_t> payload(packet.data() + 3, packet.size() - overhead);
    if (auto reply = m_commands.answer(id, payload)) {
        reply->insert(reply->begin(), 0);
        send(id, *reply);
        return;
    }
    const ReturnCode code = m_commands.set(id, payload);
    const auto written = static_cast<PacketId>(id);
    if (written == PacketId::SetPositionGains || written == PacketId::SetVelocityGains)
        m_notify("gains-written", 0.0);
    noteOutput();
    send(id, {static_cast<std::uint8_t>(code)});
}

void Board::send(std::uint8_t id, const Bytes &payload)
{
    Bytes packet{stx, static_cast<std::uint8_t>(payload.size() + overhead), id};
    packet.insert(packet.end(), payload.begin(), payload.end());
    packet.push_back(static_cast<std::uint8_t>(0x100U - sumOf(packet)));
    const FrameFate fate = m_faults.sent();
    if (fate.lost)
        return;
    if (fate.corrupt)
        packet.back() ^= 0x10U;
    if (!fate.delay)
        return deliver(std::move(packet));
    m_late.emplace_back(m_clock).startIn(*fate.delay, [this, packet] { deliver(packet); });
}

void Board::deliver(Bytes packet)
{
    m_out.push(std::move(packet));
    m_link.readyChanged();
}

void Board::armStream()
{
    if (m_commands.streamPeriod() == 0) {
        m_stream.stop();
        return;
    }
    const Duration asked = streamUnit * m_commands.streamPeriod();
    m_stream.start(m_clock.now() + std::max<Duration>(asked, loopPeriod), [this] { stream(); });
}

void Board::stream()
{
    armStream();
    if (m_out.hasStream()) {
        m_elapsed = static_cast<std::uint8_t>(std::min(255, m_elapsed + 1));
        return;
    }
    Bytes payload;
    if ((m_commands.streamConfig() & streamconfig::timing) != 0) {
        payload.push_back(static_cast<std::uint8_t>(m_commands.streamPeriod() & 0xFFU));
        payload.push_back(static_cast<std::uint8_t>(m_commands.streamPeriod() >> 8U));
    }
    if ((m_commands.streamConfig() & streamconfig::elapsed) != 0)
        payload.push_back(std::exchange(m_elapsed, std::uint8_t{0}));
    m_commands.appendMotion(payload);
    send(static_cast<std::uint8_t>(PacketId::Stream), payload);
}

} // namespace mb::quadquad2drv::simulation
