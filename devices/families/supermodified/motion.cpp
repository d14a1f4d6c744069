// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/supermodified/motion.h"

#include "model/parameter.h"

#include <cmath>

namespace mb::supermodified {
namespace {

using namespace std::chrono_literals;

constexpr int hurriedStops = 20;             ///< without a pause
constexpr Duration stopPeriod = 100ms;       ///< after that
constexpr Duration stopPatience = 10ms;      ///< shorter than usual: a stop may be repeated at any time
constexpr double unreachable = 2147483648.0; ///< D1, D2: 32-bit arithmetic of the loop overflows at this P·e (4)
constexpr double fastestProfile = 46340.0;   ///< D1, D2: its square must fit 32 bits (4)
constexpr double surestProfile = 2500.0;     ///< D1, D2: beyond it the knee of the profile may be missed (trap 19)
constexpr double leastOverrun = 100.0;       ///< ticks that a loop may swing past its target

bool isPosition(Mode mode)
{
    return mode == Mode::Position || mode == Mode::RampPosition;
}
bool isProfiled(Mode mode)
{
    return mode == Mode::RampPosition || mode == Mode::RampVelocity;
}

Result<void> checkNumber(std::string_view name, double value, double low, double high, std::string_view unit)
{
    if (std::isfinite(value) && value >= low && value <= high)
        return {};
    return mb::fail(Fault::OutOfRange,
        std::string(name) + ' ' + numberText(value) + " is outside " + numberText(low) + " … " + numberText(high) + ' '
            + std::string(unit));
}

} // namespace

Motion::Motion(Line &line, const Node &node, Events events)
    : m_line(line)
    , m_node(node)
    , m_events(std::move(events))
    , m_stopTimer(line.clock())
{
}

// What can be done

Result<Command> Motion::commandFor(const SetPoint &setPoint) const
{
    struct Row {
        Mode mode;
        bool relative;
        Command now;
        Command buffered;
    };
    constexpr std::array rows{
        Row{Mode::Velocity, false, Command::MoveVelocity, Command::BufferVelocity},
        Row{Mode::RampVelocity, false, Command::MoveProfiledVelocity, Command::BufferProfiledVelocity},
        Row{Mode::Position, false, Command::MoveAbsolute, Command::BufferAbsolute},
        Row{Mode::Position, true, Command::MoveRelative, Command::BufferRelative},
        Row{Mode::RampPosition, false, Command::MoveProfiledAbsolute, Command::BufferProfiledAbsolute},
        Row{Mode::RampPosition, true, Command::MoveProfiledRelative, Command::BufferProfiledRelative},
    };
    for (const Row &row : rows) {
        if (row.mode == setPoint.mode && (row.relative == setPoint.relative || !isPosition(row.mode)))
            return setPoint.buffered ? row.buffered : row.now;
    }
    return mb::fail(Fault::Unsupported, "a Supermodified has no mode '" + std::string(toString(setPoint.mode)) + "'");
}

bool Motion::isHold(const SetPoint &setPoint) const
{
    return setPoint.relative && !setPoint.buffered && isPosition(setPoint.mode) && setPoint.target == 0.0;
}

std::int64_t Motion::valueFor(const SetPoint &setPoint) const
{
    const auto target = static_cast<std::int64_t>(std::llround(setPoint.target));
    return isPosition(setPoint.mode) && !setPoint.relative ? target - m_origin : target;
}

Result<void> Motion::check(const SetPoint &setPoint) const
{
    if (setPoint.mode == Mode::Off)
        return {};
    if (setPoint.axis != 1 || setPoint.slot != 0)
        return mb::fail(Fault::Unsupported, "a Supermodified has one axis and one set of gains");
    const auto command = commandFor(setPoint);
    if (!command)
        return mb::fail(command.error());
    if (auto good = checkNumber("the target", setPoint.target, -9e15, 9e15, unitOf(setPoint.mode)); !good)
        return good;
    if (auto fits = request(m_node.id, usualHostId, *command, dialect(), valueFor(setPoint)); !fits)
        return mb::fail(fits.error());
    const bool narrow = dialect() == Dialect::D1;
    const double fastest = narrow || dialect() == Dialect::D2 ? fastestProfile : 4294967295.0;
    if (auto good = checkNumber("--velocity", setPoint.velocity, 0.0, fastest, "counts/s"); !good)
        return good;
    if (auto good
        = checkNumber("--acceleration", setPoint.acceleration, 0.0, narrow ? 65535.0 : 4294967295.0, "counts/s²");
        !good)
        return good;
    if (auto good = checkProfile(setPoint); !good)
        return good;
    return m_position || setPoint.relative ? checkReach(setPoint) : Result<void>(); // a move looks before it goes
}

/// What stops a move that passes its target must be known before it goes.
Result<void> Motion::checkProfile(const SetPoint &setPoint) const
{
    if (setPoint.mode != Mode::RampPosition || !isNarrow()
        || (profileVelocity(setPoint) && profileAcceleration(setPoint)))
        return {};
    return mb::fail(Fault::Unsafe,
        "its profile is not known, so a move that passes its target could not be told; read profile.velocity and "
        "profile.acceleration");
}

std::optional<double> Motion::profileVelocity(const SetPoint &setPoint) const
{
    if (setPoint.velocity > 0.0)
        return setPoint.velocity;
    return known().profileVelocity ? std::optional(static_cast<double>(*known().profileVelocity)) : std::nullopt;
}

std::optional<double> Motion::profileAcceleration(const SetPoint &setPoint) const
{
    if (setPoint.acceleration > 0.0)
        return setPoint.acceleration;
    return known().profileAcceleration ? std::optional(static_cast<double>(*known().profileAcceleration))
                                       : std::nullopt;
}

std::string Motion::caution(const SetPoint &setPoint) const
{
    if (!isProfiled(setPoint.mode) || !m_node.dialect)
        return {};
    std::string text;
    const auto changes = [&text](std::string_view key, double wanted, std::optional<std::int64_t> stands) {
        if (wanted <= 0.0 || stands == std::llround(wanted))
            return;
        text += (text.empty() ? "" : "; ") + std::string(key) + " becomes " + numberText(std::round(wanted))
            + (stands ? ", it was " + std::to_string(*stands) : std::string()) + ": the device stores it";
    };
    changes("profile.velocity", setPoint.velocity, known().profileVelocity);
    changes("profile.acceleration", setPoint.acceleration, known().profileAcceleration);
    if (isNarrow() && setPoint.mode == Mode::RampPosition && profileVelocity(setPoint).value_or(0.0) > surestProfile)
        text += (text.empty() ? "" : "; ")
            + std::string(
                "this firmware may pass the target of a profiled move above 2500 counts/s; it is stopped then");
    return text;
}

/// An un-profiled move is one step of the error, which the loop of D1 and D2 multiplies by P in 32 bits.
Result<void> Motion::checkReach(const SetPoint &setPoint) const
{
    if (setPoint.mode != Mode::Position || !isNarrow())
        return {};
    if (!known().gainP || (!m_position && !setPoint.relative))
        return mb::fail(Fault::Unsafe,
            "its P or its position is not known, so whether this step overflows its loop is not either; read gain.p");
    if (*known().gainP == 0)
        return {};
    const double distance = setPoint.relative
        ? setPoint.target
        : setPoint.target - static_cast<double>(m_position.value_or(0) + m_origin);
    const double farthest = std::floor(unreachable / static_cast<double>(*known().gainP)) - 1.0;
    if (std::abs(distance) <= farthest)
        return {};
    return mb::fail(Fault::OutOfRange,
        "a step of " + numberText(distance) + " counts overflows the loop of this firmware; at most "
            + numberText(farthest) + " with its P: use a profiled mode or several moves");
}

// Set-points

Result<void> Motion::command(const SetPoint &setPoint)
{
    if (m_failure)
        return mb::fail(Fault::Unsafe, *m_failure);
    if (m_stopping)
        return mb::fail(Fault::Unsafe, "the stop before it is not acknowledged yet");
    if (m_wanted == setPoint)
        return {};
    m_wanted = setPoint;
    // the newest target replaces what waits, but a relative move is never skipped
    const std::size_t underWay = m_step ? 1 : 0;
    if (m_orders.size() > underWay && !setPoint.relative && !m_orders.back().relative)
        m_orders.back() = setPoint;
    else
        m_orders.push_back(setPoint);
    pump();
    return {};
}

void Motion::pump()
{
    if (m_step || m_orders.empty() || m_stopping)
        return;
    m_tries = 0;
    send(nextStep());
}

Motion::Step Motion::nextStep() const
{
    const SetPoint &order = m_orders.front();
    if (!m_energized && !m_knownOff)
        return Step::Stop;
    // A relative move is sent once, so nothing older may still be answered or reported.
    if (!m_looked && (!m_energized || order.relative))
        return Step::Look;
    if (!m_energized)
        return Step::Start;
    // every write costs a cycle of the EEPROM
    if (isProfiled(order.mode) && order.velocity > 0.0 && known().profileVelocity != std::llround(order.velocity))
        return Step::Velocity;
    if (isProfiled(order.mode) && order.acceleration > 0.0
        && known().profileAcceleration != std::llround(order.acceleration))
        return Step::Acceleration;
    return Step::Move;
}

Result<Line::Request> Motion::requestFor(Step step) const
{
    const SetPoint &order = m_orders.front();
    if (step == Step::Start || step == Step::Move) { // the position is known now
        if (auto reachable = checkReach(order); !reachable)
            return mb::fail(reachable.error());
    }
    switch (step) {
    case Step::Stop: return asking(m_node, Command::Stop);
    case Step::Look: return asking(m_node, Command::GetPosition);
    case Step::Start: return asking(m_node, Command::Start);
    case Step::Velocity: return setting(m_node, Command::ProfileVelocity, std::llround(order.velocity));
    case Step::Acceleration: return setting(m_node, Command::ProfileAcceleration, std::llround(order.acceleration));
    case Step::Move: break;
    }
    if (isHold(order))
        return asking(m_node, Command::Halt);
    const auto command = commandFor(order);
    return command ? setting(m_node, *command, valueFor(order)) : mb::fail(command.error());
}

void Motion::send(Step step)
{
    auto request = requestFor(step);
    if (!request) {
        fail(request.error().detail);
        return;
    }
    request->rank = Line::Rank::Move;
    m_step = step;
    ++m_tries;
    m_ticket = m_line.submit(std::move(*request), [this, step](const Result<Frame> &reply) { answered(step, reply); });
    if (step == Step::Start) {
        ++m_starts;
        doubt();
    }
}

void Motion::answered(Step step, const Result<Frame> &reply)
{
    m_step.reset();
    const auto codes = reply ? codesOf(*reply) : std::nullopt;
    if (reply && !codes) {
        done(step, *reply);
        return;
    }
    if (codes) {
        refused(step, *codes);
        return;
    }
    if (reply.error().fault != Fault::Timeout) {
        fail(reply.error().detail);
        return;
    }
    if (step == Step::Move && m_orders.front().relative && !isHold(m_orders.front()))
        fail("a relative move was not answered, and is never sent twice: look where the motor stands");
    else if (m_tries < patientTries && m_starts < patientTries)
        send(step == Step::Start ? Step::Stop : step);
    else
        fail("the device does not answer");
}

void Motion::refused(Step step, std::span<const std::uint8_t> codes)
{
    const std::vector<std::uint8_t> kept(codes.begin(), codes.end());
    m_events.codes(kept);
    if (m_failure || m_stopping) // the listener heard of a stall, or stopped
        return;
    if (step == Step::Move && kept.back() == code::invalidForState) {
        setEnergized(false);
        fail("the device says that the motor is not started; it may have lost its supply");
    } else if (m_tries < patientTries && m_starts < patientTries) {
        send(step == Step::Start ? Step::Stop : step); // not executed, so also a relative move may be sent again
    } else {
        fail("refused: " + codesText(kept));
    }
}

void Motion::done(Step step, const Frame &reply)
{
    SetPoint &order = m_orders.front();
    switch (step) {
    case Step::Stop:
        m_knownOff = true;
        m_events.changed();
        break;
    case Step::Look:
        m_looked = true;
        m_events.positioned(reply);
        break;
    case Step::Start:
        m_origin += m_position.value_or(0); // the node counts from 0 again
        m_position = 0;
        m_starts = 0;
        setEnergized(true);
        break;
    case Step::Velocity:
    case Step::Acceleration: stored(step); break;
    case Step::Move:
        m_applied = order;
        beginRun(order);
        m_looked = false;
        m_orders.pop_front();
        m_events.changed();
        break;
    }
    if (!m_stopping)
        pump();
}

/// The roster knows it from now on, and the device's table follows.
void Motion::stored(Step step)
{
    const SetPoint &order = m_orders.front();
    const bool speed = step == Step::Velocity;
    const std::int64_t raw = std::llround(speed ? order.velocity : order.acceleration);
    if (speed)
        m_line.roster().noteProfileVelocity(m_node.id, raw);
    else
        m_line.roster().noteProfileAcceleration(m_node.id, raw);
    m_events.stored(speed ? Command::ProfileVelocity : Command::ProfileAcceleration, raw);
}

// A target that is passed

void Motion::beginRun(const SetPoint &setPoint)
{
    m_run.reset();
    const auto velocity = profileVelocity(setPoint);
    const auto acceleration = profileAcceleration(setPoint);
    if (setPoint.mode != Mode::RampPosition || !isNarrow() || !velocity || !acceleration || !m_position)
        return;
    const auto from = static_cast<double>(*m_position);
    Run run;
    run.target = static_cast<double>(valueFor(setPoint)) + (setPoint.relative ? from : 0.0);
    const double distance = std::abs(run.target - from);
    run.direction = run.target < from ? -1.0 : 1.0;
    const double stopping = *velocity * *velocity / (2.0 * std::max(*acceleration, 1.0));
    run.overrun = std::max(std::min(stopping, distance / 2.0), leastOverrun); // a short move never gets that fast
    m_run = run;
}

void Motion::watchRun()
{
    if (!m_run || !m_energized || m_stopping)
        return;
    if ((static_cast<double>(*m_position) - m_run->target) * m_run->direction > m_run->overrun)
        abort("the profiled move passed its target by more than its stopping distance, as this firmware may above 2500 "
              "counts/s; use a lower profile.velocity");
}

void Motion::setPosition(std::int64_t raw)
{
    m_position = raw;
    watchRun();
}

void Motion::zeroed()
{
    m_origin = 0;
    m_position = 0;
}

void Motion::abort(std::string why)
{
    stop();
    m_failure = std::move(why);
    m_events.changed();
}

Result<void> Motion::release()
{
    if (isBusy())
        return mb::fail(Fault::Unsafe, "a buffered move is not acknowledged yet; try again");
    Line::Request tell = telling(m_node, Command::DoMove);
    tell.rank = Line::Rank::Move;
    m_releaseTicket = m_line.submit(std::move(tell), [](const Result<Frame> &) {});
    return {};
}

void Motion::reassert()
{
    if (!m_energized || isBusy() || m_stopping || !m_applied || m_applied->relative || m_applied->buffered)
        return;
    m_orders.push_back(*m_applied);
    pump();
}

void Motion::fail(std::string why)
{
    m_ticket.reset();
    m_step.reset();
    m_orders.clear();
    if (!m_failure)
        m_failure = std::move(why);
    m_events.changed();
}

void Motion::tripped(std::string why)
{
    m_energized = false;
    m_line.setDriving(m_node.id, false);
    fail(std::move(why));
}

void Motion::doubt()
{
    if (std::exchange(m_knownOff, false))
        m_events.changed();
}

void Motion::setEnergized(bool energized)
{
    m_energized = energized;
    if (!energized)
        m_run.reset();
    m_line.setDriving(m_node.id, energized);
    m_events.changed();
}

// Stop

void Motion::stop()
{
    m_ticket.reset();
    m_releaseTicket.reset();
    m_step.reset();
    m_orders.clear();
    m_wanted.reset();
    m_applied.reset();
    m_failure.reset();
    m_run.reset();
    m_looked = false;
    m_starts = 0;
    m_stopTries = 0;
    if (std::exchange(m_stopping, true) && m_stopTimer.isActive())
        m_stopTimer.stop();
    sendStop(Duration::zero());
}

void Motion::sendStop(Duration delay)
{
    if (delay > Duration::zero()) {
        m_stopTimer.startIn(delay, [this] { sendStop(Duration::zero()); });
        return;
    }
    if (m_line.link().state() != LinkState::Open)
        return; // resume() goes on
    Line::Request request = asking(m_node, Command::Stop);
    request.rank = Line::Rank::Stop;
    request.patience = stopPatience;
    m_stopTicket = m_line.submit(std::move(request), [this](const Result<Frame> &reply) { stopAnswered(reply); });
}

void Motion::stopAnswered(const Result<Frame> &reply)
{
    if (reply && reply->is(Command::Stop)) {
        m_stopping = false;
        m_stoppedAt = m_line.clock().now();
        m_looked = false;
        m_knownOff = true;
        setEnergized(false);
        return;
    }
    if (const auto codes = reply ? codesOf(*reply) : std::nullopt) {
        const std::vector<std::uint8_t> kept(codes->begin(), codes->end());
        m_events.codes(kept);
    }
    if (!reply && reply.error().fault == Fault::LinkLost)
        return;
    sendStop(++m_stopTries < hurriedStops ? Duration::zero() : stopPeriod);
}

void Motion::resume()
{
    if (m_stopping)
        sendStop(Duration::zero());
}

} // namespace mb::supermodified
