// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/supermodified/decode.h"

#include "families/supermodified/codec.h"

#include <algorithm>

namespace mb::supermodified {
namespace {

constexpr std::array<std::string_view, analogInputs> analogNames{"AIN1", "AIN2", "AIN3", "AIN4"};
constexpr std::array<std::string_view, mostCodes> codeFields{"c1", "c2", "c3", "c4", "c5", "c6", "c7", "c8"};
constexpr std::array<std::string_view, reactionCount> reactionNames{"r0", "r1", "r2", "r3", "r4", "r5", "r6", "r7",
    "r8", "r9", "r10", "r11", "r12", "r13", "r14", "r15", "r16", "r17", "r18", "r19"};

/// The format of some dialect that has data of this length.
std::optional<Format> formatFor(const CommandForm &message, std::size_t size)
{
    for (const Format format : message.formats) {
        const bool fits = format == Format::Codes ? size <= mostCodes : sizeOf(format) == size;
        if (format != Format::Absent && fits)
            return format;
    }
    return std::nullopt;
}

bool takesData(const CommandForm &message)
{
    return std::ranges::any_of(
        message.formats, [](Format format) { return format != Format::Absent && format != Format::None; });
}

bool isHost(int id)
{
    return id == usualHostId || id == vendorHostId;
}

/// Whether a node sent it. Without data on both ways (start, stop …) only the usual ids of hosts tell.
bool isReply(const Frame &frame, const CommandForm &message)
{
    if (frame.is(Command::Error))
        return true;
    if (isGet(frame.command) && !frame.is(Command::GetWarnings))
        return frame.size > 0;
    if (takesData(message) && !isGet(frame.command))
        return frame.size == 0;
    return frame.size > 0 || (isHost(frame.to) && !isHost(frame.from));
}

template <std::size_t N>
void addBytes(DecodedFrame &decoded, std::span<const std::uint8_t> bytes, const std::array<std::string_view, N> &names)
{
    for (std::size_t i = 0; i < std::min(bytes.size(), N); ++i)
        decoded.fields.push_back({names.at(i), static_cast<double>(bytes[i]), {}});
}

bool addData(DecodedFrame &decoded, const Frame &frame, const CommandForm &message)
{
    const auto format = formatFor(message, frame.size);
    if (!format)
        return false;
    decoded.message = message.nameOf(*format);
    if (*format == Format::Codes) {
        addBytes(decoded, frame.payload(), codeFields);
        return true;
    }
    if (*format == Format::Reactions) {
        addBytes(decoded, frame.payload(), reactionNames);
        return true;
    }
    if (const auto analog = analogOf(frame.payload()); analog && *format == Format::Analog) {
        for (std::size_t i = 0; i < analog->size(); ++i)
            decoded.fields.push_back({analogNames.at(i), static_cast<double>(analog->at(i)), message.unit});
        return true;
    }
    const auto value = valueOf(frame.payload(), *format);
    if (value)
        decoded.fields.push_back({message.field, static_cast<double>(*value), message.unit});
    return value.has_value();
}

} // namespace

std::optional<DecodedFrame> decodeFrame(const Frame &frame)
{
    const CommandForm *const message = messageOf(frame.command);
    if (!message || (frame.is(Command::Error) && !codesOf(frame)))
        return std::nullopt;
    const bool reply = isReply(frame, *message);
    DecodedFrame decoded{"supermodified", message->name, reply ? frame.from : frame.to, message->control && !reply, {}};
    decoded.fields.push_back({"AndID", static_cast<double>(frame.to), {}});
    decoded.fields.push_back({"OndID", static_cast<double>(frame.from), {}});
    if (frame.size > 0 && !addData(decoded, frame, *message))
        return std::nullopt;
    return decoded;
}

namespace {

class Decoder final : public ByteDecoder {
public:
    void take(Duration time, Direction direction, std::span<const std::uint8_t> chunk,
        std::vector<DecodedBytes> &out) override
    {
        Stream &stream = streamOf(direction);
        stream.time = time;
        stream.bytes.insert(stream.bytes.end(), chunk.begin(), chunk.end());
        std::vector<std::uint8_t> junk;
        for (Shape shape = shapeOf(stream.bytes); shape != Shape::Incomplete; shape = shapeOf(stream.bytes)) {
            if (shape == Shape::Garbage) {
                junk.push_back(stream.bytes.front());
                stream.bytes.erase(stream.bytes.begin());
                continue;
            }
            flush(time, direction, junk, out);
            const Frame frame = frameIn(stream.bytes);
            const auto size = static_cast<std::ptrdiff_t>(frameOverhead + frame.size);
            out.push_back({time, direction, {stream.bytes.begin(), stream.bytes.begin() + size}, decodeFrame(frame)});
            stream.bytes.erase(stream.bytes.begin(), stream.bytes.begin() + size);
        }
        flush(time, direction, junk, out);
    }
    void finish(std::vector<DecodedBytes> &out) override
    {
        for (const Direction direction : {Direction::Sent, Direction::Received}) {
            Stream &stream = streamOf(direction);
            flush(stream.time, direction, stream.bytes, out);
        }
    }

private:
    struct Stream {
        std::vector<std::uint8_t> bytes; ///< that may become a frame
        Duration time{};
    };
    static void flush(
        Duration time, Direction direction, std::vector<std::uint8_t> &bytes, std::vector<DecodedBytes> &out)
    {
        if (!bytes.empty())
            out.push_back({time, direction, std::exchange(bytes, {}), std::nullopt});
    }
    Stream &streamOf(Direction direction) { return direction == Direction::Sent ? m_sent : m_received; }

    Stream m_sent;
    Stream m_received;
};

} // namespace

std::unique_ptr<ByteDecoder> decodeBytes(std::string_view)
{
    return std::make_unique<Decoder>();
}

} // namespace mb::supermodified
