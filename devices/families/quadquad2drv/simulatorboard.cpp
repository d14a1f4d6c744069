// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/quadquad2drv/simulatorboard.h"

#include "wire/bytes.h"

#include <algorithm>
#include <numeric>

namespace mb::quadquad2drv::simulation {
namespace {

constexpr Duration loopPeriod = std::chrono::milliseconds(2);
constexpr Duration thinking
    = std::chrono::microseconds(20); ///< from a request to its answer; the real time is not known
constexpr std::size_t mostWaiting = 8;

std::uint8_t sumOf(const std::vector<std::uint8_t> &bytes)
{
    return static_cast<std::uint8_t>(std::accumulate(bytes.begin(), bytes.end(), 0U));
}

} // namespace

Board::Board(SpiSlaveLink &link, Clock &clock, const BoardOptions &options, Notify notify)
    : m_link(link)
    , m_clock(clock)
    , m_options(options)
    , m_notify(std::move(notify))
    , m_begun(clock.now())
    , m_loop(clock)
    , m_stream(clock)
    , m_answer(clock)
{
    for (std::size_t i = 0; i < axes; ++i) {
        m_axes[i] = std::make_unique<Axis>(*motorByName(options.motors[i]), options.loads[i]);
        m_axes[i]->setNature(options.gainScale, options.libraryPolarity);
    }
    for (const SimulatedFault &fault : options.faults) {
        if (fault.kind == "encoder-reversed")
            m_axes.front()->motor().setEncoderReversed(true);
    }
    m_link.attach(this);
    start();
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

void Board::start()
{
    m_started = m_clock.now();
    m_due = m_started + loopPeriod;
    m_loop.start(m_due, [this] { loop(); });
}

void Board::loop()
{
    const double seconds = std::chrono::duration<double>(m_due - m_started).count();
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
        const bool timed = fault.kind == "reset" || fault.kind == "encoder-dead" || fault.kind == "stall";
        if (timed && fault.at > seconds)
            return;
        if (fault.kind == "reset")
            restart();
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
    restart();
    if (m_pulsed)
        m_pulsed();
}

void Board::restart()
{
    for (const auto &axis : m_axes)
        axis->reset();
    m_in.clear();
    m_out.clear();
    m_pending.clear();
    m_outAt = 0;
    m_streamWaits = false;
    m_streamPeriod = 0;
    m_streamConfig = 0;
    m_historyLength = 31;
    m_historyBits = 20;
    m_stream.stop();
    m_answer.stop();
    m_notify("reset", 0.0);
    noteOutput();
    m_link.readyChanged();
}

void Board::setPowered(bool powered)
{
    if (powered == m_powered)
        return;
    m_powered = powered;
    restart();
    if (powered)
        start();
    else
        m_loop.stop();
}

void Board::setRunning(bool running)
{
    if (running == m_running)
        return;
    m_running = running;
    restart();
}

void Board::transfer(std::span<const std::uint8_t> mosi, std::span<std::uint8_t> miso)
{
    for (std::size_t i = 0; i < mosi.size(); ++i) {
        miso[i] = 0;
        if (!m_powered || !m_running)
            continue;
        if (!m_out.empty()) {
            miso[i] = m_out.front()[m_outAt++];
            if (m_outAt == m_out.front().size()) {
                m_streamWaits = m_streamWaits && m_out.front()[2] != static_cast<std::uint8_t>(PacketId::Stream);
                m_out.pop_front();
                m_outAt = 0;
            }
        }
        listen(mosi[i]);
    }
    m_link.readyChanged();
}

void Board::listen(std::uint8_t byte)
{
    if (m_in.empty() && byte != stx)
        return;
    m_in.push_back(byte);
    understand();
}

void Board::understand()
{
    if (m_in.size() < 2 || (m_in[1] >= overhead && m_in.size() < m_in[1]))
        return;
    if (m_in[1] >= overhead && sumOf(m_in) == 0) {
        m_pending.push_back(std::exchange(m_in, {}));
        if (!m_answer.isActive())
            m_answer.startIn(thinking, [this] {
                while (!m_pending.empty()) {
                    const Bytes packet = std::move(m_pending.front());
                    m_pending.pop_front();
                    execute(packet);
                }
            });
        return;
    }
    // No packet: drop this start and look for one in what followed.
    const Bytes rest(m_in.begin() + 1, m_in.end());
    m_in.clear();
    for (const std::uint8_t byte : rest)
        listen(byte);
}

void Board::execute(const Bytes &packet)
{
    const std::uint8_t id = packet[2];
    const std::span<const std::uint8_t> payload(packet.data() + 3, packet.size() - overhead);
    if (auto reply = answerGet(id, payload)) {
        reply->insert(reply->begin(), 0);
        send(id, *reply);
        return;
    }
    const ReturnCode code = set(id, payload);
    noteOutput();
    send(id, {static_cast<std::uint8_t>(code)});
}

void Board::send(std::uint8_t id, const Bytes &payload)
{
    ++m_sent;
    Bytes packet{stx, static_cast<std::uint8_t>(payload.size() + overhead), id};
    packet.insert(packet.end(), payload.begin(), payload.end());
    packet.push_back(static_cast<std::uint8_t>(0x100U - sumOf(packet)));
    for (const SimulatedFault &fault : m_options.faults) {
        const bool now = static_cast<int>(fault.at) == m_sent;
        if ((fault.kind == "drop" && now) || (fault.kind == "silent" && fault.at <= m_sent))
            return;
        if (fault.kind == "power" && now) {
            setPowered(false);
            return;
        }
        if (fault.kind == "corrupt" && now)
            packet.back() ^= 0x10U;
    }
    if (m_out.size() < mostWaiting)
        m_out.push_back(std::move(packet));
    m_link.readyChanged();
}

void Board::armStream()
{
    if (m_streamPeriod == 0) {
        m_stream.stop();
        return;
    }
    const Duration asked = streamUnit * m_streamPeriod;
    m_stream.start(m_clock.now() + std::max<Duration>(asked, loopPeriod), [this] { stream(); });
}

void Board::stream()
{
    armStream();
    if (m_streamWaits) {
        m_elapsed = static_cast<std::uint8_t>(std::min(255, m_elapsed + 1));
        return;
    }
    Bytes payload;
    if ((m_streamConfig & streamconfig::timing) != 0) {
        payload.push_back(static_cast<std::uint8_t>(m_streamPeriod & 0xFFU));
        payload.push_back(static_cast<std::uint8_t>(m_streamPeriod >> 8U));
    }
    if ((m_streamConfig & streamconfig::elapsed) != 0)
        payload.push_back(std::exchange(m_elapsed, std::uint8_t{0}));
    appendMotion(payload);
    m_streamWaits = true;
    send(static_cast<std::uint8_t>(PacketId::Stream), payload);
}

} // namespace mb::quadquad2drv::simulation
