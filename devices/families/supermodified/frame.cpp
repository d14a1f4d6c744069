// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/supermodified/frame.h"

#include <algorithm>

namespace mb::supermodified {
namespace {

constexpr std::size_t i2cOverhead = 5;

void appendBody(std::vector<std::uint8_t> &out, const Frame &frame)
{
    out.insert(out.end(), {frame.to, frame.from, frame.command, frame.size});
    const auto payload = frame.payload();
    out.insert(out.end(), payload.begin(), payload.end());
    out.push_back(lrcOf(frame));
}

/// From AndID on; the caller has looked at the length.
Frame frameAt(std::span<const std::uint8_t> body)
{
    Frame frame{body[0], body[1], body[2], body[3], {}};
    std::copy_n(body.begin() + 4, frame.size, frame.data.begin());
    return frame;
}

} // namespace

std::uint8_t lrcOf(const Frame &frame)
{
    std::uint8_t lrc = frame.command ^ frame.size;
    for (const std::uint8_t byte : frame.payload())
        lrc ^= byte;
    return lrc;
}

std::vector<std::uint8_t> uartBytes(const Frame &frame)
{
    std::vector<std::uint8_t> bytes{header0, header1};
    appendBody(bytes, frame);
    return bytes;
}

std::vector<std::uint8_t> i2cBytes(const Frame &frame)
{
    std::vector<std::uint8_t> bytes;
    appendBody(bytes, frame);
    return bytes;
}

std::optional<Frame> fromI2c(std::span<const std::uint8_t> bytes)
{
    if (bytes.size() < i2cOverhead || bytes[3] > mostData || bytes.size() != i2cOverhead + bytes[3])
        return std::nullopt;
    const Frame frame = frameAt(bytes);
    return lrcOf(frame) == bytes.back() ? std::optional(frame) : std::nullopt;
}

Shape shapeOf(std::span<const std::uint8_t> bytes)
{
    if (bytes.empty())
        return Shape::Incomplete;
    if (bytes[0] != header0 || (bytes.size() > 1 && bytes[1] != header1))
        return Shape::Garbage;
    if (bytes.size() < headSize)
        return Shape::Incomplete;
    const std::size_t count = bytes[headSize - 1];
    if (count > mostData)
        return Shape::Garbage;
    if (bytes.size() < frameOverhead + count)
        return Shape::Incomplete;
    return lrcOf(frameIn(bytes)) == bytes[headSize + count] ? Shape::Frame : Shape::Garbage;
}

Frame frameIn(std::span<const std::uint8_t> bytes)
{
    return frameAt(bytes.subspan(2));
}

void FrameReader::feed(std::span<const std::uint8_t> bytes)
{
    for (const std::uint8_t byte : bytes) {
        m_buffer[m_size++] = byte;
        for (;;) {
            const auto held = std::span(m_buffer).first(m_size);
            const Shape shape = shapeOf(held);
            if (shape == Shape::Incomplete)
                break;
            if (shape == Shape::Garbage) {
                drop(1);
                ++m_discarded;
                continue;
            }
            const Frame frame = frameIn(held);
            drop(frameOverhead + frame.size);
            m_sink(frame);
        }
    }
}

void FrameReader::drop(std::size_t count)
{
    std::copy(m_buffer.begin() + static_cast<std::ptrdiff_t>(count),
        m_buffer.begin() + static_cast<std::ptrdiff_t>(m_size), m_buffer.begin());
    m_size -= count;
}

void FrameReader::forget()
{
    m_discarded += m_size;
    m_size = 0;
}

} // namespace mb::supermodified
