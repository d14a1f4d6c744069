// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/snapshot.h"

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace mb {

/// What a family says of a frame.
struct FrameMeaning {
    const Family *family = nullptr;
    DecodedFrame frame;
};

/// Finds the family that knows a frame. What a device that is known here may have sent or been sent is read in its dialect, although the
/// same bits mean something else in its family's usual one, of a device that is not there.
class FrameDecoder {
public:
    FrameDecoder() = default;
    explicit FrameDecoder(std::span<const Family *const> families);

    void addDialect(const Family *family, int address, std::string dialect);
    [[nodiscard]] std::optional<FrameMeaning> decode(const CanFrame &frame) const;
    /// Whether the frame makes a motor move, in any dialect that is known here.
    [[nodiscard]] std::optional<FrameMeaning> control(const CanFrame &frame) const;

    friend bool operator==(const FrameDecoder &, const FrameDecoder &) = default;

private:
    std::vector<const Family *> m_families;
    std::map<std::pair<const Family *, int>, std::string> m_dialects;
};

/// Shown all frames of one link in their order: whom a frame is from that does not tell it by itself (Family::followCan).
class FrameFollower {
public:
    explicit FrameFollower(std::span<const Family *const> families);
    /// Nothing where the frame says it itself, or nobody can know.
    [[nodiscard]] std::optional<int> addressOf(const CanFrame &frame);

private:
    std::vector<std::pair<const Family *, CanDecoder>> m_decoders;
};

/// Shown all bytes of one serial or SPI link in their order: which packets they complete, as `motorbenchctl decode` tells them.
class ByteFollower {
public:
    ByteFollower(std::span<const Family *const> families, LinkKind kind);
    [[nodiscard]] std::vector<FrameMeaning> take(const TrafficRecord &record);

private:
    std::vector<std::pair<const Family *, std::unique_ptr<ByteDecoder>>> m_decoders; ///< of the families on such links
};

/// With the dialects of the devices that were found on a link.
[[nodiscard]] FrameDecoder decoderFor(
    std::span<const Family *const> families, const Snapshot &shot, const std::string &link);

} // namespace mb
