// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/statusrates.h"

#include "families/dmc60c/channels.h"
#include "families/dmc60c/parameters.h"

#include <algorithm>
#include <cmath>

namespace mb::dmc60c {
namespace {

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
        auto reading = m_desk.read(*number);
        const std::int64_t present = co_await std::move(reading);
        m_usual[*number] = static_cast<std::uint32_t>(present);
    }
    const double milliseconds
        = hertz > 0.0 ? std::clamp(std::round(1000.0 / hertz), row.minimum, row.maximum) : m_usual[*number];
    auto writing = m_desk.write(row, static_cast<std::int64_t>(milliseconds));
    const std::int64_t inForce = co_await std::move(writing);
    m_known.setRead(*parameterWithId(*number), inForce);
    if (hertz > 0.0) {
        m_wanted[*number] = static_cast<std::uint32_t>(inForce);
    } else {
        m_wanted.erase(*number);
        m_usual.erase(*number);
    }
    co_return {};
}

void StatusRates::sendOwed(const UnitContact &contact)
{
    if (!std::exchange(m_owed, false))
        return;
    const ParameterExchange::Target unit = contact.target();
    for (const auto &[parameter, period] : m_wanted)
        (void)contact.link.send(encodeParamSet(unit.device, unit.session, parameter, period));
}

} // namespace mb::dmc60c
