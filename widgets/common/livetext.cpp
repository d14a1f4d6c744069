// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/livetext.h"

#include "widgets/common/displayunits.h"
#include "widgets/common/numberformat.h"

namespace mb {

std::optional<double> liveValue(const DeviceView &device, std::string_view channel, Instant now, Duration staleAfter)
{
    const auto index = device.telemetry->find(channel);
    if (!index)
        return std::nullopt;
    const auto last = device.telemetry->last(*index);
    if (!last || last->isGap() || now - last->time > staleAfter)
        return std::nullopt;
    return last->value;
}

bool LiveText::isKnown() const
{
    return number != QString(UnknownMark);
}

QString LiveText::whole() const
{
    return unit.isEmpty() || !isKnown() ? number : number + QChar(QChar::Nbsp) + unit;
}

LiveText liveText(const DeviceView &device, std::string_view channel, Instant now)
{
    const auto index = device.telemetry->find(channel);
    return index ? liveText(device.telemetry->channels()[index->value], liveValue(device, channel, now))
                 : LiveText{UnknownMark, {}};
}

LiveText liveText(const Channel &row, std::optional<double> value)
{
    const ShownUnit unit = shownUnit(row, {});
    return {value ? formatNumber(*value * unit.scale, unit.decimals) : QString(UnknownMark), unit.text};
}

} // namespace mb
