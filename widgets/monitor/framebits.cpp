// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/framebits.h"

#include <algorithm>
#include <bit>

namespace mb {

std::vector<std::uint64_t> fieldBits(const CanFrame &frame, const FrameDecoder &decoder)
{
    const auto plain = decoder.decode(frame);
    if (!plain)
        return {};
    const auto &fields = plain->frame.fields;
    std::vector<std::uint64_t> masks(fields.size(), 0);
    for (std::size_t bit = 0; bit < std::size_t{frame.size} * 8; ++bit) {
        CanFrame turned = frame;
        turned.data.at(bit / 8) = static_cast<std::uint8_t>(turned.data.at(bit / 8) ^ (1U << (bit % 8)));
        const auto other = decoder.decode(turned);
        if (!other || other->frame.message != plain->frame.message || other->frame.fields.size() != fields.size())
            continue;
        for (std::size_t i = 0; i < fields.size(); ++i) {
            if (other->frame.fields[i].value != fields[i].value)
                masks[i] |= std::uint64_t{1} << bit;
        }
    }
    std::vector<std::size_t> bySize(masks.size());
    for (std::size_t i = 0; i < bySize.size(); ++i)
        bySize[i] = i;
    std::ranges::stable_sort(
        bySize, [&masks](std::size_t a, std::size_t b) { return std::popcount(masks[a]) < std::popcount(masks[b]); });
    std::uint64_t taken = 0;
    for (const std::size_t i : bySize) {
        const std::uint64_t own = masks[i] & ~taken;
        if (own != 0)
            masks[i] = own;
        taken |= masks[i];
    }
    return masks;
}

QString bitsText(std::uint64_t mask)
{
    if (mask == 0)
        return {};
    const int first = std::countr_zero(mask);
    const int last = 63 - std::countl_zero(mask);
    const bool whole = first % 8 == 0 && last % 8 == 7;
    const auto place = [whole](int bit) {
        return whole ? QString::number(bit / 8) : QStringLiteral("%1.%2").arg(bit / 8).arg(bit % 8);
    };
    if (whole ? first / 8 == last / 8 : first == last)
        return place(first);
    const QString end = !whole && first / 8 == last / 8 ? QString::number(last % 8) : place(last);
    return place(first) + QChar(0x2013) + end;
}

} // namespace mb
