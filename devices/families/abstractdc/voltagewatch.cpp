// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/voltagewatch.h"

#include "families/abstractdc/codec.h"

#include <algorithm>

namespace mb::abstractdc {
namespace {

constexpr int unknownBitrate = 50'000;
/// Such a link has other programs, not drives, at its other end, which answer when they get the processor.
constexpr auto programSlack = std::chrono::milliseconds(80);

int bitrateOf(const CanLink &link)
{
    return link.bitrate() > 0 ? link.bitrate() : unknownBitrate;
}

} // namespace

Duration roundTrip(const CanLink &link)
{
    return Duration(std::chrono::seconds(1)) * roundTripBits / bitrateOf(link);
}

Duration answerTime(const CanLink &link)
{
    return 2 * roundTrip(link) + answerSlack + (link.bitrate() > 0 ? Duration::zero() : Duration(programSlack));
}

VoltageWatch::VoltageWatch(CanLink &link, Clock &clock)
    : m_clock(clock)
    , m_link(link)
    , m_traffic(link.traffic().add([this](const Traffic &traffic) {
        if (traffic.can)
            pass(*traffic.can);
    }))
{
}

bool VoltageWatch::isFree() const
{
    return std::none_of(
        m_open.begin(), m_open.end(), [now = m_clock.now()](const Asked &open) { return open.until > now; });
}

void VoltageWatch::pass(const CanFrame &frame)
{
    if (frame.extended || frame.error || frame.remote)
        return;
    for (auto *asked : {&m_open, &m_positions})
        std::erase_if(*asked, [now = m_clock.now()](const Asked &open) { return open.until <= now; });
    if (frame.size == 1 && frame.id >= id::logRequest && frame.id <= id::logRequest + maxOffset) {
        const int offset = static_cast<int>(frame.id - id::logRequest); // 900 is both everybody and offset 0
        auto *const asked = frame.data[0] == dialectF.codeOf(Log::Voltage) ? &m_open
            : frame.data[0] == dialectF.codeOf(Log::Position)              ? &m_positions
                                                                           : nullptr;
        if (!asked)
            return;
        std::erase_if(*asked, [offset](const Asked &open) { return open.offset == offset; });
        asked->push_back({offset, m_clock.now() + answerTime(m_link)});
    } else if (frame.id == id::voltageLog && frame.size == 4) {
        m_owner = m_open.size() == 1 ? std::optional<int>(m_open.front().offset) : std::nullopt;
        if (m_owner)
            m_open.clear();
    } else if (frame.id >= id::positionLog && frame.id <= id::positionLog + maxOffset && frame.size == 4) {
        positionOf(static_cast<int>(frame.id - id::positionLog));
    }
}

/// Where dialect D answers the code of the voltage. It is no such answer when the position itself was asked for.
void VoltageWatch::positionOf(int offset)
{
    const auto same = [offset](const Asked &asked) { return asked.offset == offset; };
    if (std::erase_if(m_positions, same) == 0)
        std::erase_if(m_open, same);
}

} // namespace mb::abstractdc
