// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/framedecoder.h"

#include <algorithm>

namespace mb {

FrameDecoder::FrameDecoder(std::span<const Family *const> families)
{
    for (const Family *family : families) {
        if (family->decodeCan)
            m_families.push_back(family);
    }
}

void FrameDecoder::addDialect(const Family *family, int address, std::string dialect)
{
    if (!dialect.empty())
        m_dialects[{family, address}] = std::move(dialect);
}

std::optional<FrameMeaning> FrameDecoder::decode(const CanFrame &frame) const
{
    if (frame.error)
        return std::nullopt;
    for (const auto &[device, dialect] : m_dialects) {
        auto decoded = device.first->decodeCan(frame, dialect);
        if (decoded && decoded->address == device.second)
            return FrameMeaning{device.first, std::move(*decoded)};
    }
    for (const Family *family : m_families) {
        if (auto decoded = family->decodeCan(frame, {}))
            return FrameMeaning{family, std::move(*decoded)};
    }
    return std::nullopt;
}

std::optional<FrameMeaning> FrameDecoder::control(const CanFrame &frame) const
{
    for (const Family *family : m_families) {
        if (auto decoded = family->decodeCan(frame, {}); decoded && decoded->control)
            return FrameMeaning{family, std::move(*decoded)};
    }
    for (const auto &[device, dialect] : m_dialects) {
        if (auto decoded = device.first->decodeCan(frame, dialect); decoded && decoded->control)
            return FrameMeaning{device.first, std::move(*decoded)};
    }
    return std::nullopt;
}

FrameFollower::FrameFollower(std::span<const Family *const> families)
{
    for (const Family *family : families) {
        if (family->followCan)
            m_decoders.emplace_back(family, family->followCan({}));
    }
}

std::optional<int> FrameFollower::addressOf(const CanFrame &frame)
{
    std::optional<int> address;
    for (const auto &[family, follow] : m_decoders) {
        const auto followed = follow(frame);
        if (!followed || followed->address < 0)
            continue;
        if (const auto alone = family->decodeCan(frame, {}); alone && alone->address < 0)
            address = followed->address;
    }
    return address;
}

ByteFollower::ByteFollower(std::span<const Family *const> families, LinkKind kind)
{
    for (const Family *family : families) {
        if (family->decodeBytes && std::ranges::find(family->links, kind) != family->links.end())
            m_decoders.emplace_back(family, family->decodeBytes({}));
    }
}

/// Of several families that one counts which finds something first.
std::vector<FrameMeaning> ByteFollower::take(const TrafficRecord &record)
{
    std::vector<FrameMeaning> meanings;
    for (const auto &[family, decoder] : m_decoders) {
        std::vector<DecodedBytes> found;
        decoder->take(record.frame.time.time_since_epoch(), record.direction, record.bytes, found);
        for (DecodedBytes &bytes : found) {
            const bool first = meanings.empty() || meanings.front().family == family;
            if (bytes.frame && first)
                meanings.push_back({family, std::move(*bytes.frame)});
        }
    }
    return meanings;
}

FrameDecoder decoderFor(std::span<const Family *const> families, const Snapshot &shot, const std::string &link)
{
    FrameDecoder decoder(families);
    for (const DeviceView &device : shot.devices) {
        if (device.link == link && device.family && device.family->decodeCan)
            decoder.addDialect(device.family, device.identity->address, device.identity->dialect);
    }
    return decoder;
}

} // namespace mb
