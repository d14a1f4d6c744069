// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/device.h"

#include "model/family.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mb {
namespace {

constexpr Duration inputsToldEvery = std::chrono::milliseconds(50);

} // namespace

Device::Device(const Family &family, Link &link, Clock &clock, Identity identity)
    : m_family(family)
    , m_link(link)
    , m_clock(clock)
    , m_probedDialect(identity.dialect)
    , m_probedDetail(identity.detail)
    , m_identity(std::move(identity))
    , m_parameters(family.parameters)
    , m_telemetry(std::make_shared<Telemetry>(family.channels))
    , m_guard(*this)
    , m_stop(*this)
{
}

Device::~Device() = default;

bool Device::hasWatchdog() const
{
    return m_family.capabilities.watchdog;
}

namespace {

const DialectChoice *dialectOf(const Family &family, std::string_view key)
{
    const auto found = std::find_if(
        family.dialects.begin(), family.dialects.end(), [key](const DialectChoice &row) { return row.key == key; });
    return found == family.dialects.end() ? nullptr : &*found;
}

} // namespace

void Device::setIdentity(Identity identity)
{
    if (identity == m_identity)
        return;
    if (identity.dialect.empty() && !m_probedDialect.empty() && identity.state == DeviceState::Online) {
        identity.dialect = m_probedDialect; // what was proven once is not taken away by a scan that could not prove it
        identity.detail = m_probedDetail;
    }
    m_probedDialect = identity.dialect;
    m_probedDetail = identity.detail;
    identity = shown(std::move(identity));
    if (identity == m_identity)
        return;
    m_identity = std::move(identity);
    m_changed.notify();
}

/// With the dialect that the user chose, and what that means.
Identity Device::shown(Identity probed) const
{
    probed.dialect = m_probedDialect;
    probed.detail = m_probedDetail;
    const DialectChoice *chosen = dialectOf(m_family, m_profile.dialect);
    if (!chosen || chosen->key == m_probedDialect)
        return probed;
    probed.dialect = chosen->key;
    probed.detail = "Dialect " + std::string(chosen->key) + " was chosen by hand, "
        + (m_probedDialect.empty() ? std::string("none was proven") : "the unit answered as " + m_probedDialect) + ". "
        + std::string(chosen->warning);
    return probed;
}

void Device::setProfile(DeviceProfile profile)
{
    m_profile = std::move(profile);
    for (const auto &[key, raw] : m_profile.written) {
        const auto index = findParameter(m_family.parameters, key);
        if (!index || !isLegal(m_parameters.parameter(*index), raw) || m_profile.lost.contains(key))
            continue;
        if (m_parameters.parameter(*index).access == Access::WriteOnly)
            m_parameters.setWritten(*index, raw);
    }
    applyProfile();
}

void Device::applyProfile()
{
    m_identity = shown(std::move(m_identity));
    doProfileChanged();
    m_changed.notify();
}

Result<void> Device::calibrate(std::string_view key, std::optional<double> value)
{
    const auto row = std::find_if(m_family.calibrations.begin(), m_family.calibrations.end(),
        [key](const Calibration &candidate) { return candidate.key == key; });
    if (row == m_family.calibrations.end())
        return fail(Fault::Unsupported, std::string(m_family.key) + " has no '" + std::string(key) + "' to be set");
    const auto isValue = [value](const Choice &choice) { return static_cast<double>(choice.raw) == value; };
    if (value && !row->choices.empty() && std::none_of(row->choices.begin(), row->choices.end(), isValue)) {
        std::string legal;
        for (const Choice &choice : row->choices)
            legal += (legal.empty() ? "" : ", ") + std::to_string(choice.raw) + " (" + std::string(choice.label) + ')';
        return fail(Fault::OutOfRange, std::string(key) + ": legal is " + legal);
    }
    if (value && (!std::isfinite(*value) || *value < row->minimum || *value > row->maximum))
        return fail(Fault::OutOfRange,
            std::string(key) + ": legal is " + numberText(row->minimum) + " … " + numberText(row->maximum));
    if (value)
        m_profile.calibration[std::string(key)] = *value;
    else
        m_profile.calibration.erase(std::string(key));
    applyProfile();
    m_profileChanged.notify();
    return {};
}

Result<void> Device::setDialect(std::string_view key)
{
    if (!key.empty() && !dialectOf(m_family, key)) {
        std::string known;
        for (const DialectChoice &row : m_family.dialects)
            known += (known.empty() ? "" : ", ") + std::string(row.key);
        return fail(known.empty() ? Fault::Unsupported : Fault::OutOfRange,
            std::string(m_family.key) + " has no dialect '" + std::string(key) + "'",
            known.empty() ? std::string() : "it has " + known);
    }
    m_profile.dialect = key;
    applyProfile();
    m_profileChanged.notify();
    return {};
}

void Device::assume(ParameterIndex index, std::int64_t raw)
{
    m_parameters.setWritten(index, raw);
    const std::string key(m_parameters.parameter(index).key);
    m_profile.written[key] = raw;
    m_profile.lost.erase(key);
    m_profileChanged.notify();
}

void Device::settingsLost()
{
    m_parameters.forgetAll();
    for (const auto &[key, raw] : m_profile.written)
        m_profile.lost.insert(key);
    m_profileChanged.notify();
    m_changed.notify();
}

void Device::setCounter(const std::string &key, std::int64_t value)
{
    m_profile.counters[key] = value;
    m_profileChanged.notify();
}

void Device::setVerdict(const std::string &key, std::string verdict)
{
    m_profile.verdicts[key] = std::move(verdict);
    m_profileChanged.notify();
}

void Device::setLiveness(const Liveness &liveness)
{
    setLiveness(liveness, m_states, m_statesToldAt);
}

void Device::setLiveness(const Liveness &liveness, const LiveStates &states, Instant time)
{
    m_keepsMove = m_keepsMove && (m_liveness.restarted || !liveness.restarted);
    const bool changed = liveness != m_liveness;
    if (changed)
        m_liveness = liveness;
    const bool moved = states != m_states;
    m_states = states;
    if (moved)
        m_statesChanged.notify(time);
    const bool due = states != m_toldStates
        && (time - m_statesToldAt >= inputsToldEvery
            || conditionsOf(m_family.states, states) != conditionsOf(m_family.states, m_toldStates));
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
        co_return fail(
            Fault::Unsupported, std::string(m_parameters.parameter(index).key) + " cannot be read from the device");
    auto task = doRead(index);
    const Result<std::int64_t> raw = co_await std::move(task).attempt();
    if (raw)
        m_parameters.setRead(index, *raw);
    else
        m_parameters.setFailed(index);
    co_return raw;
}

Task<std::int64_t> Device::write(ParameterIndex index, std::int64_t raw)
{
    const Parameter &parameter = m_parameters.parameter(index);
    if (parameter.access == Access::ReadOnly)
        co_return fail(Fault::OutOfRange, std::string(parameter.key) + " is read-only");
    auto task = doWrite(index, raw);
    const Result<std::int64_t> inForce = co_await std::move(task).attempt();
    const bool forgotten = !m_family.capabilities.keepsSettings && parameter.nature == Nature::Setting;
    if (inForce && (parameter.access == Access::WriteOnly || forgotten))
        assume(index, *inForce);
    else if (inForce && parameter.nature != Nature::Counter)
        m_parameters.setWritten(index, *inForce);
    if (inForce && m_family.capabilities.storesAtOnce)
        m_parameters.setAllStored();
    co_return inForce;
}

Result<void> Device::mayMove() const
{
    if (!m_busy.empty())
        return fail(Fault::Unsafe, selector() + ": " + m_busy);
    if (m_link.state() != LinkState::Open)
        return fail(Fault::LinkLost, m_link.address().shortName() + ": " + m_link.reason());
    if (m_link.address().isRecording())
        return fail(Fault::Unsupported,
            m_link.address().shortName() + " is a recording: what is in it can be watched, not driven",
            "open the link that it was made on");
    switch (m_identity.state) {
    case DeviceState::Duplicate:
        return fail(Fault::Unsafe, "several units answer as number " + std::to_string(m_identity.address),
            "control is locked until one has another number");
    case DeviceState::Unassigned:
        return fail(Fault::Unsafe, "this unit has no number yet", "assign one before it is driven");
    case DeviceState::Bootloader:
        return fail(Fault::Unsafe, "no application runs in this unit", "update its firmware first");
    case DeviceState::Online: break;
    }
    if (m_liveness.foreignMaster)
        return fail(Fault::Unsafe, "another master drives " + selector(), "stop it there first");
    if (auto guarded = m_guard.possible(); !guarded)
        return guarded;
    return doMayMove();
}

Result<void> Device::command(const SetPoint &setPoint)
{
    if (setPoint.mode == Mode::Off) {
        if (m_family.capabilities.axes > 1)
            return doCommand(setPoint); // the other axes go on
        stop();
        return {};
    }
    if (auto allowed = mayMove(); !allowed)
        return allowed;
    if (!m_guard.stands())
        return fail(Fault::Unsafe, m_guard.reason());
    if (isStopPressed())
        return fail(Fault::Unsafe, "STOP was pressed");
    if (auto checked = doCheck(setPoint); !checked)
        return checked;
    if (auto sent = doCommand(setPoint); !sent)
        return sent;
    m_keepsMove = m_keepsMove || setPoint.buffered;
    m_stop.driven();
    return {};
}

Result<void> Device::releaseMoves()
{
    if (auto allowed = mayMove(); !allowed)
        return allowed;
    if (!m_guard.stands())
        return fail(Fault::Unsafe, m_guard.reason());
    if (isStopPressed())
        return fail(Fault::Unsafe, "STOP was pressed");
    return doReleaseMoves();
}

void Device::moveReleased()
{
    if (std::exchange(m_keepsMove, false))
        m_stop.driven();
}

Result<void> Device::mayStop() const
{
    if (m_link.address().isRecording())
        return fail(Fault::Unsafe, "it is a recording");
    if (!m_busy.empty())
        return fail(Fault::Unsafe, m_busy);
    if (m_identity.state == DeviceState::Bootloader)
        return fail(Fault::Unsafe, "bootloader");
    return doMayStop();
}

Result<void> Device::doReleaseMoves()
{
    return fail(Fault::Unsupported, std::string(m_family.title) + " has no buffered moves");
}

Task<void> Device::restart()
{
    if (!m_busy.empty())
        co_return fail(Fault::Unsafe, selector() + ": " + m_busy);
    stop();
    auto restarting = doRestart();
    co_await std::move(restarting);
    co_return {};
}

Task<void> Device::doRestart()
{
    co_return fail(
        Fault::Unsupported, std::string(m_family.title) + " cannot be restarted from here; switch it off and on");
}

Task<void> Device::doZeroPosition()
{
    co_return fail(Fault::Unsupported, std::string(m_family.title) + " has no command that zeroes its position");
}

void Device::stop()
{
    if (m_link.address().isRecording())
        return; // what moves there moved when it was recorded
    m_stoppedAt = m_clock.now();
    doStop();
    m_stop.told();
}

} // namespace mb
