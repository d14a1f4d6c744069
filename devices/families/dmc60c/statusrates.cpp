// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/statusrates.h"

#include "families/dmc60c/channels.h"
#include "families/dmc60c/parameters.h"

#include <QScopedValueRollback>

#include <algorithm>
#include <cmath>

namespace mb::dmc60c {
namespace {

constexpr Duration sendEvery = std::chrono::seconds(1);

std::optional<std::uint8_t> periodOf(ChannelIndex index)
{
    if (index == channel::position || index == channel::velocity)
        return param::encoderPeriod;
    if (index == channel::duty || index == channel::error)
        return param::generalPeriod;
    if (index == channel::setPoint)
        return std::nullopt;
    return param::analogPeriod;
}

} // namespace

Task<void> StatusRates::set(ChannelIndex channel, double hertz)
{
    const auto number = periodOf(channel);
    if (!number)
        co_return fail(Fault::Unsupported, say("the set-point comes from here, not from the device"));
    if (!std::isfinite(hertz) || hertz < 0.0)
        co_return fail(Fault::OutOfRange, say("a rate is a positive number, or 0 for the usual one"));
    const Parameter &row = parameterTable()[parameterWithId(*number)->value];
    FrameRate &wishes = m_wishes[*number];
    wishes.set(channel, hertz);
    hertz = wishes.highest(); // of what comes in one frame
    const auto usual = m_usual.find(*number);
    if (hertz == 0.0 && usual == m_usual.end())
        co_return {};
    if (usual == m_usual.end()) {
        const std::int64_t present = co_await m_desk.read(*number);
        m_usual[*number] = static_cast<std::uint32_t>(present);
    }
    if (hertz > 0.0)
        m_wanted[*number]
            = static_cast<std::uint32_t>(std::clamp(std::round(1000.0 / hertz), row.minimum, row.maximum));
    else
        m_wanted.erase(*number);
    m_owed.erase(*number);
    const QScopedValueRollback<std::optional<std::uint8_t>> setting(m_setting, *number);
    const Result<std::int64_t> inForce = co_await m_desk.write(row, periodFor(*number)).attempt();
    if (!inForce) {
        const bool mayHaveCome = inForce.error().fault == Fault::Timeout || inForce.error().fault == Fault::LinkLost;
        if (!mayHaveCome)
            m_wanted.erase(*number);
        else if (m_usual.contains(*number)) // else it has restarted meanwhile
            m_owed.insert(*number);
        co_return fail(inForce.error());
    }
    m_known.setRead(*parameterWithId(*number), *inForce);
    settled(*number);
    co_return {};
}

std::uint32_t StatusRates::periodFor(std::uint8_t parameter) const
{
    const auto wanted = m_wanted.find(parameter);
    return wanted == m_wanted.end() ? m_usual.at(parameter) : wanted->second;
}

void StatusRates::settled(std::uint8_t parameter)
{
    m_owed.erase(parameter);
    if (!m_wanted.contains(parameter))
        m_usual.erase(parameter);
}

void StatusRates::forgotten()
{
    std::erase_if(m_usual, [this](const auto &one) { return !m_wanted.contains(one.first); });
    m_owed.clear();
    for (const auto &[parameter, period] : m_wanted) {
        m_usual[parameter] = static_cast<std::uint32_t>(parameterTable()[parameterWithId(parameter)->value].fallback);
        m_owed.insert(parameter);
    }
    m_sentAt.reset();
}

void StatusRates::sendOwed(const UnitContact &contact)
{
    const Instant now = contact.clock.now();
    if (m_owed.empty() || (m_sentAt && now - *m_sentAt < sendEvery))
        return;
    m_sentAt = now;
    const ParameterExchange::Target unit = contact.target();
    for (const std::uint8_t parameter : m_owed)
        (void)contact.link.send(encodeParamSet(unit.device, unit.session, parameter, periodFor(parameter)));
}

void StatusRates::chosen(std::uint8_t parameter, std::uint32_t period)
{
    if (const auto usual = m_usual.find(parameter); usual != m_usual.end())
        usual->second = period;
}

void StatusRates::told(const ParamResponse &response)
{
    const auto usual = m_usual.find(response.parameter);
    if (usual == m_usual.end() || response.parameter == m_setting)
        return;
    const bool isRefused = response.status != ParameterStatus::NoError;
    if (m_owed.contains(response.parameter)) {
        if (isRefused || response.field == periodFor(response.parameter))
            settled(response.parameter);
    } else if (!isRefused && response.field != periodFor(response.parameter)) {
        usual->second = response.field;
    }
}

} // namespace mb::dmc60c
