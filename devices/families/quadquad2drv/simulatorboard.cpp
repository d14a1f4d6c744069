// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/quadquad2drv/simulatorboard.h"

#include <algorithm>

namespace mb::quadquad2drv::simulation {
namespace {

constexpr Duration loopPeriod = std::chrono::milliseconds(2);
constexpr Duration powerBack = std::chrono::milliseconds(200);
constexpr Duration brownout = std::chrono::seconds(6);
constexpr Duration startTime = std::chrono::milliseconds(50); ///< README.md#reset

} // namespace

Board::Board(SpiSlaveLink &link, Clock &clock, const BoardOptions &options, Notify notify)
    : m_link(link)
    , m_clock(clock)
    , m_options(options)
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
    , m_supply{true, {}, Timer(clock)}
{
    m_commands.version = options.version;
    for (std::size_t i = 0; i < axes; ++i) {
        m_axes[i] = std::make_unique<Axis>(*motorByName(options.motors[i]), options.loads[i]);
        m_axes[i]->setNature(options.gainScale, options.libraryPolarity);
    }
    for (const SimulatedFault &fault : options.faults) {
        if (fault.kind == "encoder-reversed")
            m_axes.front()->motor().setEncoderReversed(true);
    }
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
    afterFault(std::chrono::duration<double>(m_clock.now() - m_begun).count());
    noteOutput();
    m_due = next(m_due, loopPeriod);
    m_loop.start(m_due, [this] { loop(); });
}

void Board::afterFault(double seconds)
{
    for (; m_nextFault < m_options.faults.size(); ++m_nextFault) {
        const SimulatedFault &fault = m_options.faults[m_nextFault];
        const bool timed = fault.kind == "reset" || fault.kind == "encoder-dead" || fault.kind == "stall"
            || fault.kind == "brownout";
        if (timed && fault.at > seconds)
            return;
        if (fault.kind == "reset")
            reset();
        else if (fault.kind == "brownout")
            losePower(brownout);
        else if (fault.kind == "encoder-dead")
            m_axes.front()->motor().setEncoderDead(true);
        else if (fault.kind == "stall")
            m_axes.front()->motor().setLocked(true);
    }
}

void Board::noteOutput()
{
    const bool on = std::any_of(m_axes.begin(), m_axes.end(), [](const auto &axis) { return axis->output() != 0.0; });
    if (on != m_outputOn)
        m_notify(on ? "output-on" : "output-off", 0.0);
    m_outputOn = on;
}

void Board::reset()
{
    if (m_supply.on)
        begin();
}

/// The processor starts, which asks for the jumper.
void Board::begin()
{
    restart();
    m_supply.awake = m_clock.now() + startTime;
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

void Board::setPowered(bool powered)
{
    m_supply.back.stop();
    if (powered == m_supply.on)
        return;
    m_supply.on = powered;
    if (powered) {
        begin();
        return;
    }
    restart();
    if (m_startListener)
        m_startListener(false);
}

void Board::losePower()
{
    losePower(powerBack);
}

void Board::losePower(Duration gap)
{
    if (!m_supply.on)
        return;
    setPowered(false);
    m_supply.back.startIn(gap, [this] { setPowered(true); });
}

void Board::setRunning(bool running)
{
    if (running == m_running)
        return;
    m_running = running;
    m_supply.awake = m_clock.now() + startTime;
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
    ++m_counts.heard;
    for (const SimulatedFault &fault : m_options.faults) {
        if (fault.kind == "power" && static_cast<int>(fault.at) == m_counts.heard) {
            losePower();
            return;
        }
    }
    const std::uint8_t id = packet[2];
    const std::span<const std::uint8_t> payload(packet.data() + 3, packet.size() - overhead);
    if (auto reply = m_commands.answer(id, payload)) {
        reply->insert(reply->begin(), 0);
        send(id, *reply);
        return;
    }
    const ReturnCode code = m_commands.set(id, payload);
    noteOutput();
    send(id, {static_cast<std::uint8_t>(code)});
}

void Board::send(std::uint8_t id, const Bytes &payload)
{
    ++m_counts.sent;
    Bytes packet{stx, static_cast<std::uint8_t>(payload.size() + overhead), id};
    packet.insert(packet.end(), payload.begin(), payload.end());
    packet.push_back(static_cast<std::uint8_t>(0x100U - sumOf(packet)));
    for (const SimulatedFault &fault : m_options.faults) {
        const bool now = static_cast<int>(fault.at) == m_counts.sent;
        if ((fault.kind == "drop" && now) || (fault.kind == "silent" && fault.at <= m_counts.sent))
            return;
        if (fault.kind == "corrupt" && now)
            packet.back() ^= 0x10U;
        if (fault.kind == "delay" && now) {
            const std::chrono::duration<double, std::milli> late(fault.argument);
            m_late.emplace_back(m_clock).startIn(
                std::chrono::duration_cast<Duration>(late), [this, packet] { deliver(packet); });
            return;
        }
    }
    deliver(std::move(packet));
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
