// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/device.h"

#include "model/family.h"

#include <QScopeGuard>

#include <utility>

namespace mb {
namespace {

constexpr Duration inputsToldEvery = std::chrono::milliseconds(50);

/// Of an order that failed so nobody knows whether the device obeyed it.
bool mayHaveCome(Fault fault)
{
    return fault == Fault::Timeout || fault == Fault::LinkLost || fault == Fault::BadReply || fault == Fault::BadCheck
        || fault == Fault::Cancelled;
}

} // namespace

Device::Device(const Family &family, Link &link, Clock &clock, Identity identity)
    : Stoppable(family.capabilities.watchdog, family.capabilities.watchdogLimit)
    , DeviceDriver(family)
    , m_link(link)
    , m_clock(clock)
    , m_identity(std::move(identity))
    , m_parameters(family.parameters)
    , m_knowledge(family, m_parameters, *m_identity)
    , m_telemetry(std::make_shared<Telemetry>(family.channels))
    , m_guard(*this)
    , m_stop(*this)
    , m_profileApplied(m_knowledge.applied().add([this] {
        m_identity.edit() = m_knowledge.shown(*m_identity);
        doProfileChanged();
        m_changed.notify();
    }))
{
}

Device::~Device() = default;

void Device::setIdentity(Identity identity)
{
    if (identity == *m_identity)
        return;
    identity = m_knowledge.probed(std::move(identity));
    if (identity == *m_identity)
        return;
    m_identity.edit() = std::move(identity);
    m_changed.notify();
}

void Device::setLiveness(const Liveness &liveness)
{
    setLiveness(liveness, m_states, m_statesToldAt);
}

void Device::setLiveness(const Liveness &liveness, const LiveStates &states, Instant time)
{
    if (liveness.restarted && !m_liveness.restarted) {
        m_gate.forgetMove();
        m_gate.originMoved();
    }
    const bool changed = liveness != m_liveness;
    if (changed)
        m_liveness = liveness;
    const bool moved = states != m_states;
    m_states = states;
    if (moved)
        m_statesChanged.notify(time);
    const bool due = states != m_toldStates
        && (time - m_statesToldAt >= inputsToldEvery
            || conditionsOf(family().states, states) != conditionsOf(family().states, m_toldStates));
    if (due) {
        m_toldStates = states;
        m_statesToldAt = time;
    }
    if (changed || due)
        m_changed.notify();
}

Task<std::int64_t> Device::read(ParameterIndex index)
{
    if (m_parameters.parameter(index).access == Access::WriteOnly)
        co_return fail(Fault::Unsupported, say("%1 cannot be read from the device", m_parameters.parameter(index).key));
    const Result<std::int64_t> raw = co_await doRead(index).attempt();
    if (raw)
        m_parameters.setRead(index, *raw);
    else
        m_parameters.setFailed(index);
    co_return raw;
}

Task<std::int64_t> Device::write(ParameterIndex index, std::int64_t raw)
{
    const Parameter &parameter = m_parameters.parameter(index);
    co_await mayWrite(index, raw);
    UnsettledWrite unsettled = m_knowledge.writing(index);
    if (parameter.access != Access::WriteOnly || m_link.state() != LinkState::Open)
        unsettled.settle();
    auto moves = qScopeGuard([isPlace = parameter.nature == Nature::Live, moved = m_gate.originMover()] {
        if (isPlace) // also where nobody knows whether it came
            moved();
    });
    const Result<std::int64_t> inForce = co_await doWrite(index, raw).attempt();
    const bool isRefused = !inForce && !mayHaveCome(inForce.error().fault);
    if (inForce || isRefused)
        unsettled.settle();
    if (isRefused)
        moves.dismiss();
    const bool forgotten = !family().capabilities.keepsSettings && parameter.nature == Nature::Setting;
    if (inForce && (parameter.access == Access::WriteOnly || forgotten))
        m_knowledge.assume(index, *inForce);
    else if (inForce && parameter.nature != Nature::Counter)
        m_parameters.setWritten(index, *inForce, m_clock.now());
    if (inForce && family().capabilities.storesAtOnce)
        m_parameters.setAllStored();
    co_return inForce;
}

Result<void> Device::mayMove() const
{
    if (!m_gate.busy().empty())
        return fail(Fault::Unsafe, say("%1: %2", selector(), m_gate.busy()));
    if (m_link.state() != LinkState::Open)
        return fail(Fault::LinkLost, say("%1: %2", m_link.address().shortName(), m_link.loss().message()));
    MB_TRY_VOID(m_link.address().takesOrders());
    switch (m_identity->state) {
    case DeviceState::Duplicate:
        return fail(Fault::Unsafe, say("several units answer as number %1", m_identity->address),
            say("control is locked until one has another number"));
    case DeviceState::Unassigned:
        return fail(Fault::Unsafe, say("this unit has no number yet"), say("assign one before it is driven"));
    case DeviceState::Bootloader:
        return fail(Fault::Unsafe, say("no application runs in this unit"), say("update its firmware first"));
    case DeviceState::Online: break;
    }
    if (m_liveness.foreignMaster)
        return fail(Fault::Unsafe, say("another master drives %1", selector()), say("stop it there first"));
    MB_TRY_VOID(m_guard.possible());
    MB_TRY_VOID(doMayMove());
    if (m_liveness.restarted) // SetPointStream would stop it at once
        return fail(Fault::Unsafe, say("%1 has restarted, and nobody has looked at it since", selector()),
            say("look at it again"));
    return {};
}

Result<void> Device::command(const SetPoint &setPoint)
{
    if (setPoint.mode == Mode::Off) {
        if (family().capabilities.axes > 1)
            return doCommand(setPoint); // the other axes go on
        stop();
        return {};
    }
    MB_TRY_VOID(mayMove());
    if (!m_guard.stands())
        return fail(Fault::Unsafe, m_guard.reason());
    if (m_gate.isStopPressed())
        return fail(Fault::Unsafe, say("STOP was pressed"));
    MB_TRY_VOID(check(setPoint));
    MB_TRY_VOID(doCommand(setPoint));
    if (m_link.state() != LinkState::Open)
        return fail(m_link.notOpen()); // it went with this order, and a stop is owed
    m_stop.driven();
    return {};
}

Result<void> Device::releaseMoves()
{
    MB_TRY_VOID(mayMove());
    if (!m_guard.stands())
        return fail(Fault::Unsafe, m_guard.reason());
    if (m_gate.isStopPressed())
        return fail(Fault::Unsafe, say("STOP was pressed"));
    return doReleaseMoves();
}

Result<void> Device::mayStop() const
{
    if (m_link.address().isRecording())
        return fail(Fault::Unsafe, say("it is a recording"));
    if (!m_gate.busy().empty())
        return fail(Fault::Unsafe, m_gate.busy());
    if (m_identity->state == DeviceState::Bootloader)
        return fail(Fault::Unsafe, say("bootloader"));
    return doMayStop();
}

Task<void> Device::restart()
{
    if (!m_gate.busy().empty())
        co_return fail(Fault::Unsafe, say("%1: %2", selector(), m_gate.busy()));
    co_await m_link.address().takesOrders();
    stop();
    co_await doRestart();
    co_return {};
}

void Device::stop()
{
    if (m_link.address().isRecording())
        return; // what moves there moved when it was recorded
    m_gate.stopped(m_clock.now());
    doStop();
    m_stop.told();
}

} // namespace mb
