// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/supermodified/motion.h"

#include "families/supermodified/movecommand.h"
#include "model/parameter.h"

#include <algorithm>
#include <cmath>

namespace mb::supermodified {
namespace {

Error notAcknowledged()
{
    return {Fault::Unsafe, say("a buffered move is not acknowledged yet"), say("try again")};
}

bool isReleased(const MotionGate &gate)
{
    return gate.kept().state == KeptMove::State::Released;
}

} // namespace

Motion::Motion(Line &line, const Node &node, MotionGate &gate, Events events)
    : m_line(line)
    , m_node(node)
    , m_gate(gate)
    , m_events(std::move(events))
    , m_stop(line, node, {[this] { stopped(); }, m_events.codes})
    , m_releasing(line.driven().releasing().add([this](DrivenNodes::Release &release) {
        if (!release.isBegun) {
            release.allowed = release.allowed ? mayBegin() : release.allowed;
            return;
        }
        if (!m_gate.moveReleased()) // DoMove is on the wire
            return;
        m_ticket.reset(); // an order behind it would take the place of what is kept
        m_step.reset();
        pump();
    }))
{
}

// What can be done

Result<void> Motion::check(const SetPoint &setPoint) const
{
    if (setPoint.mode == Mode::Off)
        return {};
    if (setPoint.axis != 1 || setPoint.slot != 0)
        return mb::fail(Fault::Unsupported, say("a Supermodified has one axis and one set of gains"));
    const auto command = commandFor(setPoint);
    if (!command)
        return mb::fail(command.error());
    MB_TRY_VOID(checkNumber(say("the target"), setPoint.target, -9e15, 9e15, unitOf(setPoint.mode)));
    if (auto fits
        = request(m_node.id, usualHostId, *command, m_node.dialect.value_or(Dialect::D3), m_count.targetOf(setPoint));
        !fits)
        return mb::fail(fits.error());
    MB_TRY_VOID(bounds().checkProfile(setPoint));
    if (!m_count.ofNode() && !setPoint.relative)
        return {}; // a move looks before it goes
    return bounds().checkReach(setPoint, m_count.stepOf(setPoint, m_energized));
}

// Set-points

Result<void> Motion::command(const SetPoint &setPoint)
{
    if (m_failure)
        return mb::fail(Fault::Unsafe, *m_failure);
    if (m_stop.isPending())
        return mb::fail(Fault::Unsafe, say("the stop before it is not acknowledged yet"));
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

bool Motion::isBusy() const
{
    return m_step || !m_orders.empty() || isReleased(m_gate);
}

void Motion::pump()
{
    if (m_step || !isBusy() || m_stop.isPending())
        return;
    m_tries = 0;
    send(nextStep());
}

Motion::Step Motion::nextStep() const
{
    if (isReleased(m_gate))
        return Step::Begin;
    const SetPoint &order = m_orders.front();
    const Roster::Entry &known = m_line.roster().entry(m_node.id);
    if (!m_energized && !m_knownOff)
        return Step::Stop;
    // A relative move is sent once, so nothing older may still be answered or reported.
    if (!m_looked && (!m_energized || order.relative))
        return Step::Look;
    if (!m_energized)
        return Step::Start;
    // every write costs a cycle of the EEPROM
    if (isProfiled(order.mode) && order.velocity > 0.0 && known.profileVelocity != std::llround(order.velocity))
        return Step::Velocity;
    if (isProfiled(order.mode) && order.acceleration > 0.0
        && known.profileAcceleration != std::llround(order.acceleration))
        return Step::Acceleration;
    return Step::Move;
}

Result<Line::Request> Motion::requestFor(Step step) const
{
    const SetPoint &order = step == Step::Begin ? m_gate.kept().order : m_orders.front();
    if (step == Step::Start || step == Step::Move || step == Step::Begin) { // the position is known now
        MB_TRY_VOID(bounds().checkReach(order, m_count.stepOf(order, m_energized)));
    }
    switch (step) {
    case Step::Stop: return asking(m_node, Command::Stop);
    case Step::Look: return asking(m_node, Command::GetPosition);
    case Step::Start: return asking(m_node, Command::Start);
    case Step::Begin: return asking(m_node, Command::DoMove);
    case Step::Velocity: return setting(m_node, Command::ProfileVelocity, std::llround(order.velocity));
    case Step::Acceleration: return setting(m_node, Command::ProfileAcceleration, std::llround(order.acceleration));
    case Step::Move: break;
    }
    if (isHold(order))
        return asking(m_node, Command::Halt);
    const auto command = commandFor(order);
    return command ? setting(m_node, *command, m_count.targetOf(order)) : mb::fail(command.error());
}

void Motion::send(Step step)
{
    auto request = requestFor(step);
    if (!request) {
        fail(request.error().message());
        return;
    }
    request->rank = Line::Rank::Move;
    request->settles = step == Step::Look && m_orders.front().relative;
    // whether the node has it is not known before it says so
    m_line.roster().noteSetting(m_node.id, static_cast<Command>(request->frame.command), std::nullopt);
    m_step = step;
    ++m_tries;
    if (step == Step::Move && m_orders.front().buffered)
        request->left = [this] { m_gate.moveSent(); };
    m_ticket = m_line.submit(*request, [this, step](const Result<Frame> &reply) { answered(step, reply); });
    if (step == Step::Start) {
        ++m_starts;
        m_count.startSent();
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
        fail(reply.error().message());
        return;
    }
    m_looked = false; // its answer may still come
    if (step == Step::Move && m_orders.front().relative && !isHold(m_orders.front()))
        fail(say("a relative move was not answered, and is never sent twice: look where the motor stands"));
    else if (m_tries < patientTries && m_starts < patientTries)
        send(step == Step::Start ? Step::Stop : step);
    else
        fail(say("the device does not answer"));
}

void Motion::refused(Step step, std::span<const std::uint8_t> codes)
{
    const std::vector<std::uint8_t> kept(codes.begin(), codes.end());
    if (step == Step::Move && m_orders.front().buffered)
        m_gate.moveRefused();
    m_events.codes(kept);
    if (m_failure || m_stop.isPending()) // the listener heard of a stall, or stopped
        return;
    if ((step == Step::Move || step == Step::Begin) && kept.back() == code::invalidForState) {
        setEnergized(false);
        fail(say("the device says that the motor is not started; it may have lost its supply"));
    } else if (m_tries < patientTries && m_starts < patientTries) {
        send(step == Step::Start ? Step::Stop : step); // not executed, so also a relative move may be sent again
    } else {
        fail(say("refused: %1", codesText(kept)));
    }
}

void Motion::done(Step step, const Frame &reply)
{
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
        m_count.started();
        m_starts = 0;
        setEnergized(true);
        break;
    case Step::Velocity:
    case Step::Acceleration: stored(step); break;
    case Step::Begin:
        if (isReleased(m_gate)) // a restart has taken it otherwise
            begun(m_gate.kept().order);
        m_gate.forgetMove();
        m_events.changed();
        break;
    case Step::Move:
        if (const SetPoint &order = m_orders.front(); order.buffered)
            m_gate.moveAcknowledged(order);
        else
            begun(order);
        m_looked = false;
        m_orders.pop_front();
        m_events.changed();
        break;
    }
    if (!m_stop.isPending())
        pump();
}

/// The roster knows it from now on, and the device's table follows.
void Motion::stored(Step step)
{
    const SetPoint &order = m_orders.front();
    const bool speed = step == Step::Velocity;
    const std::int64_t raw = std::llround(speed ? order.velocity : order.acceleration);
    const Command command = speed ? Command::ProfileVelocity : Command::ProfileAcceleration;
    m_line.roster().noteSetting(m_node.id, command, raw);
    m_events.stored(command, raw);
}

// A target that is passed

/// The node moves to it now.
void Motion::begun(const SetPoint &order)
{
    m_count.began(order);
    m_applied = order;
    m_applied->buffered = false;                         // once more it would be kept
    m_applied->velocity = m_applied->acceleration = 0.0; // what it has by then, which may be another since
    m_run.reset();
    if (!m_count.ofNode())
        return;
    const auto from = static_cast<double>(*m_count.ofNode());
    const double target = static_cast<double>(m_count.targetOf(order)) + (order.relative ? from : 0.0);
    if (const auto overrun = bounds().overrun(order, target - from))
        m_run = ProfiledRun(from, target, *overrun);
}

void Motion::setPosition(std::int64_t raw)
{
    m_count.told(raw);
    if (!m_run || !m_energized || m_stop.isPending() || !m_run->hasPassed(static_cast<double>(raw)))
        return;
    stop();
    fail(say("the profiled move passed its target by more than its stopping distance, as this firmware may above "
             "2500 counts/s; use a lower profile.velocity"));
}

Result<void> Motion::release()
{
    if (m_failure)
        return mb::fail(Fault::Unsafe, *m_failure);
    if (isBusy())
        return mb::fail(notAcknowledged());
    MB_TRY_VOID(m_line.driven().mayRelease());
    Line::Request tell = telling(m_node, Command::DoMove);
    tell.rank = Line::Rank::Move;
    tell.left = [&driven = m_line.driven()] { driven.released(); }; // even when nobody waits for it any more
    m_releaseTicket = m_line.submit(tell, [](const Result<Frame> &) {});
    return {};
}

/// The move that it keeps, from where the motor is by now.
Result<void> Motion::mayBegin() const
{
    if (std::ranges::any_of(m_orders, [](const SetPoint &order) { return order.buffered; }))
        return mb::fail(notAcknowledged());
    const KeptMove &kept = m_gate.kept();
    if (kept.state == KeptMove::State::None)
        return {};
    if (m_failure)
        return mb::fail(Fault::Unsafe, *m_failure);
    if (kept.state == KeptMove::State::Sent || kept.state == KeptMove::State::Released)
        return mb::fail(notAcknowledged());
    if (kept.state == KeptMove::State::Stale)
        return mb::fail(Fault::Unsafe,
            say("number %1 still keeps a move that was stopped before it began, and would begin it too", m_node.id),
            say("give it a new one, or switch it off and on"));
    return bounds().checkReach(kept.order, m_count.stepOf(kept.order, m_energized));
}

void Motion::reassert()
{
    if (!m_energized || m_failure || isBusy() || m_stop.isPending() || !m_applied || m_applied->relative)
        return;
    m_orders.push_back(*m_applied);
    pump();
}

void Motion::fail(Message why)
{
    m_ticket.reset();
    m_step.reset();
    m_orders.clear();
    if (!m_failure)
        m_failure = std::move(why);
    m_events.changed();
}

void Motion::tripped(Message why)
{
    m_energized = false;
    m_line.driven().set(m_node.id, false);
    fail(std::move(why));
}

void Motion::doubt()
{
    m_count.doubted();
    if (std::exchange(m_knownOff, false))
        m_events.changed();
}

void Motion::setEnergized(bool energized)
{
    m_energized = energized;
    if (!energized)
        m_run.reset();
    m_line.driven().set(m_node.id, energized);
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
    m_looked = false;
    m_starts = 0;
    m_stop.begin();
}

void Motion::stopped()
{
    m_looked = false;
    m_knownOff = true;
    setEnergized(false);
}

} // namespace mb::supermodified
