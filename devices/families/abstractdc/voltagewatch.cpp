// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/voltagewatch.h"

#include "families/abstractdc/codec.h"

#include <utility>

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

void VoltageWatch::pass(const CanFrame &frame)
{
    if (frame.extended || frame.error || frame.remote)
        return;
    const bool asks = frame.size == 1 && frame.id >= id::logRequest && frame.id <= id::logRequest + maxOffset
        && frame.data[0] == dialectF.codeOf(Log::Voltage);
    if (asks) {
        const int offset = static_cast<int>(frame.id - id::logRequest);
        const bool alone = isFree() || m_asked == offset;
        m_asked = alone && offset > 0 ? std::optional<int>(offset) : std::nullopt;
        if (offset == 0 && alone) // 900 is both everybody and offset 0: then there is only this one
            m_asked = 0;
        m_until = m_clock.now() + answerTime(m_link);
    } else if (frame.id == id::voltageLog && frame.size == 4) {
        m_owner = isFree() ? std::nullopt : std::exchange(m_asked, std::nullopt);
        if (m_owner)
            m_until = m_clock.now();
    } else if (m_link.address().isRecording() && frame.size == 4 && m_asked
        && frame.id == id::positionLog + static_cast<std::uint32_t>(*m_asked)) {
        m_until = m_clock.now(); // dialect D: this code asks it for its position; nobody has to wait for safety here
    }
}

} // namespace mb::abstractdc
