// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/quadquad2drv/axistrial.h"

#include "async/seconds.h"
#include "async/sleep.h"
#include "families/quadquad2drv/channels.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mb::quadquad2drv {
namespace {

using namespace std::chrono_literals;

constexpr Duration lease = 1s; ///< of a running trial (docs/architecture.md#threads)
constexpr Duration tick = 10ms;
constexpr double runaway = 1.6;          ///< times the speed that the power limit gives
constexpr double wrongWay = 0.05;        ///< s of that speed
constexpr double standingSpeed = 12.0;   ///< counts/s
constexpr std::uint8_t shortHistory = 8; ///< edges, for a fast velocity estimate (README.md#gain-scale)
constexpr std::uint8_t shortTime = 16;   ///< bits, 42 ms: nor does it begin slowly
constexpr double steady = 0.015;

bool knowsGains(const ParameterStore &known, int axis)
{
    using enum AxisParameter;
    constexpr std::array gains{PositionP, PositionI, PositionD, PositionWindup, VelocityP, VelocityI, VelocityD};
    return std::ranges::all_of(
        gains, [&](AxisParameter gain) { return known.entry(indexOf(axis, gain)).raw.has_value(); });
}

double secondsOf(Duration time)
{
    return std::chrono::duration<double>(time).count();
}

/// How fast the velocity estimate is at present.
Task<History> askHistory(PacketPort &port)
{
    const Packet reply = co_await port.request(getRequest(PacketId::GetHistory));
    const auto history = parseHistory(reply);
    if (!history)
        co_return fail(Fault::BadReply, say("the history has an unexpected length"));
    co_return *history;
}

} // namespace

AxisTrial::AxisTrial(Controller &board, SetPointStream &stream, const ExperimentOptions &options, Progress &progress)
    : m_board(board)
    , m_clock(board.clock())
    , m_stream(stream)
    , m_options(options)
    , m_progress(progress)
    , m_axis(options.axis - 1)
    , m_mask(maskOf(m_axis))
    , m_most(options.power * fullPower)
    , m_samples(board.telemetry()->samples().add([this](const Sample &sample) {
        if (sample.channel != channelOf(m_axis, AxisChannel::Position))
            return;
        if (!m_from)
            m_from = sample.value;
        m_track.seconds.push_back(secondsOf(sample.time - m_begun));
        m_track.counts.push_back(m_direction * (sample.value - *m_from));
    }))
{
}

AxisTrial::~AxisTrial()
{
    if (m_started)
        m_stream.stop();
}

/// No limit but that of the power, and a velocity estimate that is fast. All of it can be put back.
Task<void> AxisTrial::prepare()
{
    const History history = co_await askHistory(m_board.port());
    m_leavesStartGains = !knowsGains(m_board.parameters(), m_axis);
    if (m_leavesStartGains)
        m_progress.log(Severity::Caution,
            say("the gains of axis %1 are not known here: it will be left with those that the board starts with",
                m_options.axis));
    if (const auto limit = static_cast<double>(m_board.settings().powerLimit(m_axis)); limit < m_most) {
        m_most = limit;
        m_progress.log(Severity::Info,
            say("the axis has a power limit of %1 %, which is kept", std::round(100.0 * m_most / fullPower)));
    }
    m_borrowed.emplace(m_board, m_axis, BorrowedSettings::Part::Axis, history);
    const std::vector<Bytes> requests{
        setPowerLimit(m_mask, static_cast<std::uint16_t>(m_most)),
        setVelocityLimit(m_mask, static_cast<std::uint32_t>(fastest * limitOne)),
        setAccelerationLimit(m_mask, 0),
        setHistory(shortHistory, shortTime),
    };
    for (const Bytes &request : requests)
        co_await m_board.tell(request);
    m_board.settings().accepted(indexOf(m_axis, AxisParameter::LimitPower), static_cast<std::int64_t>(m_most));
    auto atRest = move(Mode::Duty, 0.0); // nothing is measured before the guardian stands by
    co_await std::move(atRest);
    do {
        co_await wait(tick);
    } while (!m_board.guard().stands());
    co_return {};
}

Task<void> AxisTrial::finish()
{
    m_stream.stop();
    m_started = false;
    for (int i = 0; i < 100 && !m_board.isSeenStopped(); ++i)
        co_await Sleep(m_clock, tick);
    if (!m_board.isSeenStopped())
        co_return fail(Fault::Unsafe, say("the motors were told to stop, and are not seen to stand"));
    co_await m_borrowed->giveBack();
    co_return {};
}

void AxisTrial::begin()
{
    m_track = {};
    m_begun = m_clock.now();
    const auto here = m_board.telemetry()->latest(channelOf(m_axis, AxisChannel::Position));
    m_from = here ? std::optional(here->value) : std::nullopt;
}

Task<void> AxisTrial::move(Mode mode, double target)
{
    SetPoint setPoint;
    setPoint.axis = m_options.axis;
    setPoint.mode = mode;
    setPoint.target = target;
    const Result<void> sent
        = m_started ? m_stream.follow(setPoint) : m_stream.start(setPoint, lease, {}, SetPointStream::Since::Renewal);
    if (!sent)
        co_return fail(sent.error());
    m_started = true;
    co_return {};
}

/// docs/safety.md#what-ends-an-experiment, as far as the board tells: the stream is the user's consent and the guard's, the rest is physics.
Result<void> AxisTrial::look() const
{
    if (!m_stream.isRunning())
        return fail(Fault::Unsafe, say("the motor was stopped: %1", m_stream.reason()));
    if (m_plant.gain <= 0.0)
        return {};
    const double fast = m_plant.speedAt(m_most);
    const double now = m_track.speed(m_track.end() - 0.06, m_track.end());
    if (std::abs(now) > runaway * fast)
        return fail(Fault::Unsafe, say("the motor ran faster than the power limit allows"), say("it was stopped"));
    if (m_track.way() < -std::max(50.0, wrongWay * fast) && now < 0.0)
        return fail(Fault::Unsafe, say("the loop drives the motor the wrong way"),
            say("exchange the wires of the motor or the phases of the encoder"));
    return {};
}

Task<void> AxisTrial::wait(Duration time, double way)
{
    const Instant end = m_clock.now() + time;
    while (m_clock.now() < end) {
        co_await Sleep(m_clock, tick);
        co_await look();
        if (way > 0.0 && m_track.way() >= way)
            break;
    }
    co_return {};
}

/// Without power until it stands.
Task<void> AxisTrial::rest()
{
    co_await move(Mode::Duty, 0.0);
    for (int i = 0; i < 20; ++i) {
        begin();
        co_await wait(100ms);
        if (std::abs(m_track.speed(0.0, m_track.end())) < standingSpeed)
            break;
    }
    co_return {};
}

Task<Track> AxisTrial::drive(Run run)
{
    const auto gain = [&run](std::size_t which) { return static_cast<std::uint16_t>(run.gains[which]); };
    auto telling = m_board.tell(run.loop == Loop::Velocity
            ? setVelocityGains(m_mask, {gain(0), gain(1), gain(2)})
            : setPositionGains(m_mask, {gain(0), gain(1), gain(2), static_cast<std::uint16_t>(m_most)}));
    co_await std::move(telling);
    m_direction = -m_direction;
    begin();
    if (!m_from)
        co_return fail(Fault::Timeout, say("the board does not tell its position"));
    const bool velocity = run.loop == Loop::Velocity;
    auto moving = move(velocity ? Mode::Velocity : Mode::Position, (velocity ? 0.0 : *m_from) + m_direction * run.aim);
    co_await std::move(moving);
    co_await wait(fromSeconds(run.seconds), run.way);
    Track track = m_track;
    co_await rest();
    co_return track;
}

Task<PowerStep> AxisTrial::powerStep(double power)
{
    m_direction = -m_direction;
    begin();
    co_await move(Mode::Duty, m_direction * power / fullPower);
    PowerStep step{power, 0.0, 0.0};
    for (int i = 0; i < 10; ++i) {
        auto waiting = wait(i == 0 ? 1200ms : 400ms);
        co_await std::move(waiting);
        const double end = m_track.end();
        step.speed = m_track.speed(end - 0.5, end);
        if (std::abs(step.speed - m_track.speed(end - 1.0, end - 0.5)) <= steady * std::abs(step.speed))
            break;
    }
    if (m_track.way() < -10.0 && step.speed < 0.0)
        co_return fail(Fault::Unsafe, say("the encoder counts against the power"),
            say("exchange the wires of the motor or the phases of the encoder before any loop is closed"));
    if (m_track.way() < 10.0)
        step.speed = 0.0;
    if (step.speed > 0.0)
        step.lag = m_track.end() - m_track.counts.back() / step.speed;
    co_await rest();
    co_return step;
}

} // namespace mb::quadquad2drv
