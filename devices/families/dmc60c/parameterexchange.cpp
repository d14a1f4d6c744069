// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/parameterexchange.h"

#include <algorithm>

namespace mb::dmc60c {
namespace {

using namespace std::chrono_literals;

constexpr Duration longestWait = 250ms; ///< README.md#parameters
constexpr Duration shortest = 5ms;
constexpr int mostDoublings = 5; ///< of the shortest, up to the longest

} // namespace

Task<ParamResponse> ParameterExchange::get(Target target, std::uint8_t parameter)
{
    return run(encodeParamRequest(target.device, target.session, parameter), target.device, parameter, tries);
}

Task<ParamResponse> ParameterExchange::set(Target target, std::uint8_t parameter, std::uint32_t field)
{
    return run(encodeParamSet(target.device, target.session, parameter, field), target.device, parameter, tries);
}

Task<ParamResponse> ParameterExchange::setOnce(Target target, std::uint8_t parameter, std::uint32_t field)
{
    return run(encodeParamSet(target.device, target.session, parameter, field), target.device, parameter, 1);
}

Task<ParamResponse> ParameterExchange::run(CanFrame request, int device, std::uint8_t parameter, int most)
{
    CanInbox inbox(m_link, m_clock, [device, parameter](const CanFrame &frame) {
        const auto response = decodeParamResponse(frame);
        return response && response->device == device && response->parameter == parameter;
    });
    Error last{Fault::Timeout, say("no answer")};
    for (int attempt = 0; attempt < m_link.settings().patience.tries(most); ++attempt) {
        const Instant sentAt = m_clock.now();
        co_await m_link.send(request);
        const Result<CanFrame> frame = co_await inbox.next(patienceAt(attempt));
        if (frame) {
            if (attempt == 0) // a later answer may belong to an earlier try
                measured(m_clock.now() - sentAt);
            // A unit that was busy with its flash answers every try once it is back. None of these answers may be taken for
            // that of the next question about this parameter.
            const Duration between = m_roundTrip ? std::min<Duration>(shortest, 4 * *m_roundTrip) : shortest;
            for (int late = 0; late < attempt; ++late) {
                const Result<CanFrame> another = co_await inbox.next(between);
                if (!another)
                    break;
            }
            co_return *decodeParamResponse(*frame);
        }
        last = frame.error();
        if (last.fault == Fault::LinkLost)
            break;
    }
    co_return fail(last);
}

Duration ParameterExchange::patienceAt(int attempt) const
{
    const Patience &patience = m_link.settings().patience;
    if (!m_roundTrip || patience.timeout)
        return patience.answer(longestWait);
    const int doubled = 1 << std::min(attempt, mostDoublings);
    return std::clamp<Duration>(
        4 * *m_roundTrip * doubled, shortest * doubled, std::max(longestWait, 4 * *m_roundTrip));
}

void ParameterExchange::measured(Duration roundTrip)
{
    m_roundTrip = m_roundTrip ? std::max(roundTrip, (7 * *m_roundTrip + roundTrip) / 8) : roundTrip;
}

Result<void> check(const ParamResponse &response, std::string_view key)
{
    const std::string name(key);
    switch (response.status) {
    case ParameterStatus::NoError: return {};
    case ParameterStatus::BadParameter:
        return fail(Fault::Refused, say("%1: this firmware does not know the parameter", name));
    case ParameterStatus::BadValue: return fail(Fault::Refused, say("%1: the device refused the value", name));
    }
    return fail(Fault::BadReply, say("%1: status %2 has no meaning", name, static_cast<int>(response.status)));
}

} // namespace mb::dmc60c
