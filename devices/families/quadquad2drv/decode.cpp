// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/quadquad2drv/decode.h"

#include "families/quadquad2drv/codec.h"
#include "families/quadquad2drv/literal.h"
#include "wire/bytes.h"

#include <array>

namespace mb::quadquad2drv {
namespace {

using Names = std::array<std::string_view, axes>;

template <Literal Name>
constexpr auto numberedText = [] {
    std::array<std::array<char, sizeof(Name.data) + 1>, axes> all{};
    for (std::size_t i = 0; i < axes; ++i) {
        std::copy_n(Name.data, sizeof(Name.data) - 1, all[i].data());
        all[i][sizeof(Name.data) - 1] = '_';
        all[i][sizeof(Name.data)] = static_cast<char>('1' + i);
    }
    return all;
}();

/// name, name_2, name_3, name_4: of the tuples of a packet. With `first`, name_1 … name_4: of the channels.
template <Literal Name> constexpr Names namesOf(bool first)
{
    Names names;
    for (std::size_t i = 0; i < axes; ++i) {
        const auto &text = numberedText<Name>[i];
        names[i] = {text.data(), i == 0 && !first ? text.size() - 2 : text.size()};
    }
    return names;
}

enum class Wire : std::uint8_t { U8, U16, I16, I32, U32, Shifted, SizedByMask };

struct Field {
    Names names;
    Wire wire = Wire::U8;
    std::string_view unit;
};

struct Layout {
    PacketId id{};
    std::string_view name;
    bool control = false;
    bool tuples = false;
    std::array<Field, 5> request{};
    std::array<Field, 3> reply{};
};

template <Literal Name> constexpr Field field(Wire wire, std::string_view unit = {})
{
    return {namesOf<Name>(false), wire, unit};
}

constexpr Field chan = field<"chan">(Wire::U8);
constexpr std::string_view counts = "counts";
constexpr std::string_view speed = "counts/s";
constexpr std::string_view acceleration = "counts/s²";

constexpr std::array layouts{
    Layout{PacketId::GetVersion, "get version", false, false, {},
        {field<"major">(Wire::U8), field<"minor">(Wire::U8), field<"protocol">(Wire::U8)}},
    Layout{PacketId::GetMotion, "get motion data"},
    Layout{PacketId::Stream, "stream data"},
    Layout{PacketId::SetStreamPeriod, "set stream period", false, false, {field<"period">(Wire::U16, "40.96 µs")}},
    Layout{PacketId::GetStreamPeriod, "get stream period", false, false, {}, {field<"period">(Wire::U16, "40.96 µs")}},
    Layout{PacketId::SetDataMask, "set data mask", false, true, {chan, field<"data_mask">(Wire::U8)}},
    Layout{PacketId::GetDataMask, "get data mask"},
    Layout{PacketId::SetStreamConfig, "set stream config", false, false, {field<"config">(Wire::U8)}},
    Layout{PacketId::GetStreamConfig, "get stream config", false, false, {}, {field<"config">(Wire::U8)}},
    Layout{PacketId::SetPosition, "set position", false, true, {chan, field<"position">(Wire::SizedByMask, counts)}},
    Layout{PacketId::GetPosition, "get position"},
    Layout{
        PacketId::SetHistory, "set history", false, false, {field<"length">(Wire::U8), field<"time_bits">(Wire::U8)}},
    Layout{PacketId::GetHistory, "get history", false, false, {},
        {field<"length">(Wire::U8), field<"time_bits">(Wire::U8)}},
    Layout{PacketId::SetInputMode, "set input mode", false, true,
        {chan, field<"cfg">(Wire::U8), field<"spacing">(Wire::U16, counts), field<"position">(Wire::I32, counts)}},
    Layout{PacketId::SetControlMode, "set control mode", true, true, {chan, field<"mode">(Wire::U8)}},
    Layout{PacketId::SetPower, "set motor power", true, true, {chan, field<"power">(Wire::I16, "1/8191")}},
    Layout{PacketId::SetPositionTarget, "position target", true, true, {chan, field<"position">(Wire::I32, counts)}},
    Layout{PacketId::SetVelocityTarget, "velocity target", true, true, {chan, field<"velocity">(Wire::I32, speed)}},
    Layout{PacketId::SetPowerLimit, "power limit", false, true, {chan, field<"power">(Wire::U16, "1/8191")}},
    Layout{PacketId::SetVelocityLimit, "velocity limit", false, true, {chan, field<"velocity">(Wire::Shifted, speed)}},
    Layout{PacketId::SetAccelerationLimit, "acceleration limit", false, true,
        {chan, field<"acceleration">(Wire::Shifted, acceleration)}},
    Layout{PacketId::SetPositionGains, "position PID", false, true,
        {chan, field<"p">(Wire::U16), field<"i">(Wire::U16), field<"d">(Wire::U16), field<"windup">(Wire::U16)}},
    Layout{PacketId::SetVelocityGains, "velocity PID", false, true,
        {chan, field<"p">(Wire::U16), field<"i">(Wire::U16), field<"d">(Wire::U16)}},
    Layout{PacketId::RampPosition, "position ramp", true, true,
        {chan, field<"position">(Wire::I32, counts), field<"velocity">(Wire::Shifted, speed),
            field<"acceleration">(Wire::Shifted, acceleration)}},
    Layout{PacketId::RampVelocity, "velocity ramp", true, true,
        {chan, field<"velocity">(Wire::I32, speed), field<"acceleration">(Wire::Shifted, acceleration)}},
};

constexpr Names positionNames = namesOf<"position">(true);
constexpr Names velocityNames = namesOf<"velocity">(true);
constexpr Names statusNames = namesOf<"status">(true);
constexpr Names maskNames = namesOf<"data_mask">(true);
constexpr Names sizeNames = namesOf<"size">(true);

const Layout *layoutOf(std::uint8_t id)
{
    for (const Layout &layout : layouts) {
        if (static_cast<std::uint8_t>(layout.id) == id)
            return &layout;
    }
    return nullptr;
}

std::size_t sizeOf(Wire wire, std::uint8_t mask)
{
    constexpr std::array<std::size_t, 4> positions{0, 1, 2, 4};
    switch (wire) {
    case Wire::U8: return 1;
    case Wire::U16:
    case Wire::I16: return 2;
    case Wire::SizedByMask: return positions[(mask >> 4U) & 3U];
    default: return 4;
    }
}

double valueOf(Wire wire, std::span<const std::uint8_t> bytes)
{
    switch (wire) {
    case Wire::U8: return bytes[0];
    case Wire::U16: return readU16le(bytes, 0);
    case Wire::I16: return signExtend(readU16le(bytes, 0), 16);
    case Wire::U32: return readU32le(bytes, 0);
    case Wire::Shifted: return readU32le(bytes, 0) / limitOne;
    case Wire::I32: return signExtend(readU32le(bytes, 0), 32);
    case Wire::SizedByMask: break;
    }
    if (bytes.empty())
        return 0.0;
    return bytes.size() == 1 ? signExtend(bytes[0], 8)
        : bytes.size() == 2  ? signExtend(readU16le(bytes, 0), 16)
                             : signExtend(readU32le(bytes, 0), 32);
}

class PacketDecoder final : public ByteDecoder {
public:
    void take(Duration time, Direction direction, std::span<const std::uint8_t> chunk,
        std::vector<DecodedBytes> &out) override
    {
        Stream &stream = m_streams[direction == Direction::Sent ? 0 : 1];
        stream.bytes.insert(stream.bytes.end(), chunk.begin(), chunk.end());
        while (step(stream, time, direction, out)) { }
        flushPlain(stream, time, direction, out);
    }
    void finish(std::vector<DecodedBytes> &out) override
    {
        for (const Direction direction : {Direction::Sent, Direction::Received}) {
            Stream &stream = m_streams[direction == Direction::Sent ? 0 : 1];
            stream.plain.insert(stream.plain.end(), stream.bytes.begin(), stream.bytes.end());
            stream.bytes.clear();
            flushPlain(stream, {}, direction, out);
        }
    }

private:
    struct Stream {
        Bytes bytes; ///< not yet judged
        Bytes plain; ///< of no packet
    };

    /// Takes one packet, or one byte that begins none; false when more bytes are needed.
    bool step(Stream &stream, Duration time, Direction direction, std::vector<DecodedBytes> &out)
    {
        Bytes &bytes = stream.bytes;
        if (bytes.empty() || (bytes[0] == stx && bytes.size() < 2))
            return false;
        const std::size_t size = bytes[0] == stx ? bytes[1] : 0;
        if (size >= overhead && layoutKnown(bytes) && bytes.size() < size)
            return false;
        if (size < overhead || !layoutKnown(bytes) || checksum({bytes.data(), size}) != 0) {
            stream.plain.push_back(bytes[0]);
            bytes.erase(bytes.begin());
            return true;
        }
        flushPlain(stream, time, direction, out);
        const auto end = bytes.begin() + static_cast<std::ptrdiff_t>(size);
        const Packet packet{bytes[2], Bytes(bytes.begin() + 3, end - 1)};
        out.push_back({time, direction, Bytes(bytes.begin(), end), decode(packet, direction)});
        bytes.erase(bytes.begin(), end);
        return true;
    }
    [[nodiscard]] static bool layoutKnown(const Bytes &bytes)
    {
        return bytes.size() < 3 || layoutOf(bytes[2]) != nullptr;
    }
    static void flushPlain(Stream &stream, Duration time, Direction direction, std::vector<DecodedBytes> &out)
    {
        if (!stream.plain.empty())
            out.push_back({time, direction, std::exchange(stream.plain, {}), std::nullopt});
    }

    DecodedFrame decode(const Packet &packet, Direction direction)
    {
        const Layout &layout = *layoutOf(packet.id);
        DecodedFrame frame{"quadquad2drv", layout.name, 0, layout.control && direction == Direction::Sent, {}};
        if (direction == Direction::Sent)
            ask(layout, packet, frame);
        else
            decodeReply(layout, packet, frame);
        return frame;
    }

    void decodeRequest(const Layout &layout, std::span<const std::uint8_t> payload, DecodedFrame &frame)
    {
        for (std::size_t tuple = 0; !payload.empty() && tuple < axes; ++tuple) {
            const std::uint8_t mask = payload[0];
            for (const Field &field : layout.request) {
                const std::size_t size = sizeOf(field.wire, mask);
                if (field.names[0].empty() || payload.size() < size)
                    break;
                frame.fields.push_back({field.names[tuple], valueOf(field.wire, payload.first(size)), field.unit});
                payload = payload.subspan(size);
                const bool disabled = layout.id == PacketId::SetInputMode && frame.fields.back().name.starts_with("cfg")
                    && (static_cast<int>(frame.fields.back().value) & 3) == 0;
                if (disabled)
                    break;
            }
            learn(layout.id, frame);
            if (!layout.tuples)
                return;
        }
    }
    /// What is asked for, or set, tells how the reply reads, and what comes after it. One request is open at a time (README.md#waiting-packets).
    void ask(const Layout &layout, const Packet &packet, DecodedFrame &frame)
    {
        m_asked = packet;
        m_reading = m_wanted;
        if (layout.id == PacketId::GetPosition)
            addSizes(packet.payload, frame);
        decodeRequest(layout, packet.payload, frame);
    }
    static void addSizes(const Bytes &payload, DecodedFrame &frame)
    {
        if (payload.size() == 1)
            frame.fields.push_back({chan.names[0], static_cast<double>(payload[0]), {}});
        for (std::size_t i = 0; payload.size() == axes && i < axes; ++i)
            frame.fields.push_back({sizeNames[i], static_cast<double>(payload[i]), {}});
    }
    void learn(PacketId id, const DecodedFrame &frame)
    {
        if (id == PacketId::SetStreamConfig && !frame.fields.empty())
            m_wanted.config = static_cast<std::uint8_t>(frame.fields.back().value);
        if (id != PacketId::SetDataMask || frame.fields.size() < 2)
            return;
        const auto mask = static_cast<unsigned>(frame.fields[frame.fields.size() - 2].value);
        for (std::size_t i = 0; i < axes; ++i) {
            if (((mask >> i) & 1U) != 0)
                m_wanted.masks[i] = static_cast<std::uint8_t>(frame.fields.back().value);
        }
    }

    void decodeReply(const Layout &layout, const Packet &packet, DecodedFrame &frame)
    {
        const bool stream = layout.id == PacketId::Stream;
        if (!stream) {
            const auto code = returnCode(packet);
            if (!code)
                return;
            frame.fields.push_back({"rc", static_cast<double>(*code), {}});
            const auto asked = std::exchange(m_asked, std::nullopt);
            if (*code != 0) {
                m_wanted = m_reading; // nothing was set
                return;
            }
            m_reading = m_wanted;
            if (layout.id == PacketId::GetPosition && asked && asked->id == packet.id)
                addPositions(*asked, packet, frame);
        }
        if (stream || layout.id == PacketId::GetMotion) {
            addMotion(packet, frame);
            return;
        }
        if (const auto masks = parseDataMasks(packet)) {
            m_reading.masks = m_wanted.masks = *masks;
            for (std::size_t i = 0; i < axes; ++i)
                frame.fields.push_back({maskNames[i], static_cast<double>(m_reading.masks[i]), {}});
        }
        addFields(layout, std::span(packet.payload).subspan(1), frame);
    }
    void addFields(const Layout &layout, std::span<const std::uint8_t> rest, DecodedFrame &frame)
    {
        for (const Field &field : layout.reply) {
            const std::size_t size = sizeOf(field.wire, 0);
            if (field.names[0].empty() || rest.size() < size)
                break;
            frame.fields.push_back({field.names[0], valueOf(field.wire, rest.first(size)), field.unit});
            rest = rest.subspan(size);
        }
        if (layout.id == PacketId::GetStreamConfig && frame.fields.size() > 1)
            m_reading.config = m_wanted.config = static_cast<std::uint8_t>(frame.fields.back().value);
    }
    /// Widths are those that were asked for, or those of the data masks of the channels that were (README.md#stream).
    void addPositions(const Packet &asked, const Packet &reply, DecodedFrame &frame) const
    {
        DataMasks sizes = m_reading.masks;
        for (std::size_t i = 0; i < axes; ++i) {
            if (asked.payload.size() == axes)
                sizes[i] = asked.payload[i];
            else if (!asked.payload.empty() && (asked.payload[0] & maskOf(static_cast<int>(i))) == 0)
                sizes[i] = 0;
        }
        const auto positions = parsePositions(reply, sizes);
        for (std::size_t i = 0; positions && i < axes; ++i) {
            if (const auto position = (*positions)[i])
                frame.fields.push_back({positionNames[i], static_cast<double>(*position), counts});
        }
    }
    void addMotion(const Packet &packet, DecodedFrame &frame) const
    {
        const auto motion = parseMotion(packet, m_reading.masks, m_reading.config);
        if (!motion)
            return;
        if (motion->timing)
            frame.fields.push_back({"timing", static_cast<double>(*motion->timing), "40.96 µs"});
        if (motion->elapsed)
            frame.fields.push_back({"elapsed", static_cast<double>(*motion->elapsed), {}});
        for (std::size_t i = 0; i < axes; ++i) {
            const AxisMotion &axis = motion->channels[i];
            if (axis.position)
                frame.fields.push_back({positionNames[i], static_cast<double>(*axis.position), counts});
            if (axis.velocity)
                frame.fields.push_back({velocityNames[i], static_cast<double>(*axis.velocity), speed});
            if (axis.status)
                frame.fields.push_back({statusNames[i], static_cast<double>(*axis.status), {}});
        }
    }

    /// How motion data and streams read.
    struct Reading {
        DataMasks masks{datamask::startUp, datamask::startUp, datamask::startUp, datamask::startUp};
        std::uint8_t config = 0;
    };
    std::array<Stream, 2> m_streams;
    Reading m_reading;
    Reading m_wanted; ///< once the last request is answered
    std::optional<Packet> m_asked;
};

} // namespace

std::unique_ptr<ByteDecoder> decodeBytes(std::string_view)
{
    return std::make_unique<PacketDecoder>();
}

} // namespace mb::quadquad2drv
