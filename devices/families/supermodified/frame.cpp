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

void FrameReader::feed(std::span<const std::uint8_t> bytes)
{
    for (const std::uint8_t byte : bytes) {
        m_buffer[m_size++] = byte;
        for (Verdict verdict = judge(); verdict != Verdict::Incomplete; verdict = judge()) {
            if (verdict == Verdict::Garbage) {
                drop(1);
                ++m_discarded;
                continue;
            }
            const Frame frame = frameAt(std::span(m_buffer).subspan(2));
            drop(frameOverhead + frame.size);
            m_sink(frame);
        }
    }
}

FrameReader::Verdict FrameReader::judge()
{
    if (m_size == 0)
        return Verdict::Incomplete;
    if (m_buffer[0] != header0 || (m_size > 1 && m_buffer[1] != header1))
        return Verdict::Garbage;
    if (m_size < headSize)
        return Verdict::Incomplete;
    const std::size_t count = m_buffer[headSize - 1];
    if (count > mostData)
        return Verdict::Garbage;
    if (m_size < frameOverhead + count)
        return Verdict::Incomplete;
    if (lrcOf(frameAt(std::span(m_buffer).subspan(2))) == m_buffer[headSize + count])
        return Verdict::Frame;
    ++m_badChecks;
    return Verdict::Garbage;
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
