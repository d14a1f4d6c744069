// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/answertime.h"

#include "families/abstractdc/codec.h"

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

} // namespace mb::abstractdc
