// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/deviceknowledge.h"

#include "model/family.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mb {
namespace {

const DialectChoice *dialectOf(const Family &family, std::string_view key)
{
    const auto found = std::ranges::find(family.dialects, key, &DialectChoice::key);
    return found == family.dialects.end() ? nullptr : &*found;
}

} // namespace

UnsettledWrite::UnsettledWrite(std::weak_ptr<DeviceKnowledge *> knowledge, ParameterIndex index)
    : m_knowledge(std::move(knowledge))
    , m_index(index)
{
}

UnsettledWrite::~UnsettledWrite()
{
    if (const auto knowledge = m_knowledge.lock())
        (*knowledge)->doubt(m_index, ParameterState::Failed);
}

DeviceKnowledge::DeviceKnowledge(const Family &family, ParameterStore &parameters, const Identity &identity)
    : m_family(family)
    , m_parameters(parameters)
    , m_probedDialect(identity.dialect)
    , m_probedDetail(identity.detail)
{
}

Identity DeviceKnowledge::probed(Identity identity)
{
    if (identity.dialect.empty() && !m_probedDialect.empty() && identity.state == DeviceState::Online) {
        identity.dialect = m_probedDialect; // what was proven once is not taken away by a scan that could not prove it
        identity.detail = m_probedDetail;
    }
    m_probedDialect = identity.dialect;
    m_probedDetail = identity.detail;
    return shown(std::move(identity));
}

/// With the dialect that the user chose, and what that means.
Identity DeviceKnowledge::shown(Identity probed) const
{
    probed.dialect = m_probedDialect;
    probed.detail = m_probedDetail;
    const DialectChoice *chosen = dialectOf(m_family, m_profile->dialect);
    if (!chosen || chosen->key == m_probedDialect)
        return probed;
    probed.dialect = chosen->key;
    const Message warning = Message::label(chosen->warning);
    probed.detail = m_probedDialect.empty()
        ? say("Dialect %1 was chosen by hand, none was proven. %2", chosen->key, warning)
        : say("Dialect %1 was chosen by hand, the unit answered as %2. %3", chosen->key, m_probedDialect, warning);
    return probed;
}

void DeviceKnowledge::setProfile(DeviceProfile profile)
{
    m_profile.edit() = std::move(profile);
    reassume();
    m_applied.notify();
}

void DeviceKnowledge::reassume()
{
    for (const auto &[key, raw] : m_profile->written) {
        const auto index = findParameter(m_family.parameters, key);
        if (!index || !isLegal(m_parameters.parameter(*index), raw) || m_profile->lost.contains(key))
            continue;
        if (m_parameters.parameter(*index).access == Access::WriteOnly)
            m_parameters.setWritten(*index, raw);
    }
}

Result<void> DeviceKnowledge::calibrate(std::string_view key, std::optional<double> value)
{
    const auto row = std::ranges::find_if(
        m_family.calibrations, [key](const Calibration &candidate) { return candidate.key == key; });
    if (row == m_family.calibrations.end())
        return fail(Fault::Unsupported, say("%1 has no '%2' to be set", m_family.key, key));
    const auto isValue = [value](const Choice &choice) { return static_cast<double>(choice.raw) == value; };
    if (value && !row->choices.empty() && std::ranges::none_of(row->choices, isValue)) {
        Message legal;
        for (const Choice &choice : row->choices) {
            const Message one = say("%1 (%2)", choice.raw, Message::label(choice.label));
            legal = legal.empty() ? one : say("%1, %2", legal, one);
        }
        return fail(Fault::OutOfRange, say("%1: legal is %2", key, legal));
    }
    if (value && (!std::isfinite(*value) || *value < row->minimum || *value > row->maximum))
        return fail(Fault::OutOfRange, say("%1: legal is %2 … %3", key, row->minimum, row->maximum));
    if (value)
        m_profile.edit().calibration[std::string(key)] = *value;
    else
        m_profile.edit().calibration.erase(std::string(key));
    m_applied.notify();
    m_changed.notify();
    return {};
}

Result<void> DeviceKnowledge::setDialect(std::string_view key)
{
    if (!key.empty() && !dialectOf(m_family, key)) {
        std::string known;
        for (const DialectChoice &row : m_family.dialects)
            known += (known.empty() ? "" : ", ") + std::string(row.key);
        return fail(known.empty() ? Fault::Unsupported : Fault::OutOfRange,
            say("%1 has no dialect '%2'", m_family.key, key), known.empty() ? Message() : say("it has %1", known));
    }
    m_profile.edit().dialect = key;
    m_applied.notify();
    m_changed.notify();
    return {};
}

void DeviceKnowledge::assume(ParameterIndex index, std::int64_t raw)
{
    m_parameters.setWritten(index, raw);
    const std::string key(m_parameters.parameter(index).key);
    m_profile.edit().written[key] = raw;
    m_profile.edit().lost.erase(key);
    m_changed.notify();
}

void DeviceKnowledge::doubt(ParameterIndex index, ParameterState state)
{
    m_parameters.forget(index, state);
    const std::string key(m_parameters.parameter(index).key);
    if (m_profile->written.contains(key))
        m_profile.edit().lost.insert(key);
    m_changed.notify();
}

void DeviceKnowledge::settingsLost()
{
    m_parameters.forgetAll();
    for (const auto &[key, raw] : m_profile->written)
        m_profile.edit().lost.insert(key);
    m_changed.notify();
}

void DeviceKnowledge::unitExchanged()
{
    m_parameters.forgetAll();
    m_profile.edit().written.clear();
    m_profile.edit().lost.clear();
    m_exchanged.notify();
    m_changed.notify();
}

Task<void> DeviceKnowledge::kept() const
{
    if (m_keeper) {
        auto keeping = m_keeper();
        co_return co_await std::move(keeping).attempt();
    }
    co_return {};
}

void DeviceKnowledge::setCounters(const std::map<std::string, std::int64_t> &values)
{
    for (const auto &[key, value] : values)
        m_profile.edit().counters[key] = value;
    m_changed.notify();
}

void DeviceKnowledge::setVerdict(const std::string &key, DirectionVerdict verdict)
{
    m_profile.edit().verdicts[key] = verdict;
    m_changed.notify();
}

} // namespace mb
