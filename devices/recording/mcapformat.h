// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <map>
#include <span>
#include <string>
#include <string_view>

/// The MCAP container, version 0 (mcap.dev/spec): records of one byte kind, eight bytes length, content; integers are
/// little-endian, texts and maps are preceded by their length in bytes (32 bits).
namespace mb::mcap {

inline constexpr std::array<std::uint8_t, 8> magic{0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'};
inline constexpr std::size_t recordHead = 9;

enum class Kind : std::uint8_t {
    Header = 1,
    Footer = 2,
    Schema = 3,
    Channel = 4,
    Message = 5,
    Chunk = 6,
    Statistics = 11,
    Metadata = 12,
    MetadataIndex = 13,
    DataEnd = 15,
};

using Map = std::map<std::string, std::string>;

/// What a sample is in the file: a message of protocol buffers,
///   message Sample { double value = 1; uint64 lost = 2; bool gap = 3; }
/// `lost` samples are known missing before this one; `gap`: it does not connect to the one before.
inline constexpr std::string_view schemaName = "motorbench.Sample";
inline constexpr std::string_view schemaEncoding = "protobuf";

/// The content of a record while it is written.
class Content {
public:
    template <class Integer> Content &put(Integer value)
    {
        static_assert(std::endian::native == std::endian::little);
        std::array<char, sizeof(Integer)> bytes{};
        std::memcpy(bytes.data(), &value, sizeof(Integer));
        m_bytes.append(bytes.data(), bytes.size());
        return *this;
    }
    Content &text(std::string_view text)
    {
        put(static_cast<std::uint32_t>(text.size()));
        m_bytes += text;
        return *this;
    }
    Content &map(const Map &map)
    {
        Content inside;
        for (const auto &[key, value] : map)
            inside.text(key).text(value);
        return text(inside.m_bytes);
    }
    /// Protocol buffers: a number in groups of seven bits.
    Content &varint(std::uint64_t value)
    {
        for (; value >= 0x80U; value >>= 7U)
            m_bytes += static_cast<char>((value & 0x7FU) | 0x80U);
        m_bytes += static_cast<char>(value);
        return *this;
    }
    /// Protocol buffers: field `number` with text, bytes or a message inside.
    Content &field(std::uint32_t number, std::string_view inside)
    {
        varint(number << 3U | 2U).varint(inside.size());
        m_bytes += inside;
        return *this;
    }
    Content &field(std::uint32_t number, std::uint64_t value) { return varint(number << 3U).varint(value); }
    void clear() { m_bytes.clear(); }
    [[nodiscard]] const std::string &bytes() const { return m_bytes; }

private:
    std::string m_bytes;
};

/// Reads a content; once something is missing everything it yields is zero or empty, and ok() is false.
class View {
public:
    explicit View(std::span<const std::uint8_t> bytes)
        : m_bytes(bytes)
    {
    }
    template <class Integer> Integer get()
    {
        Integer value{};
        if (const auto bytes = take(sizeof(Integer)); bytes.size() == sizeof(Integer))
            std::memcpy(&value, bytes.data(), sizeof(Integer));
        return value;
    }
    std::string text()
    {
        const auto bytes = take(get<std::uint32_t>());
        return {bytes.begin(), bytes.end()};
    }
    Map map()
    {
        Map read;
        View inside(take(get<std::uint32_t>()));
        while (m_ok && !inside.m_bytes.empty()) {
            const std::string key = inside.text();
            read[key] = inside.text();
            m_ok = inside.m_ok;
        }
        return read;
    }
    std::uint64_t varint()
    {
        std::uint64_t value = 0;
        for (unsigned shift = 0; shift < 64; shift += 7) {
            const auto byte = get<std::uint8_t>();
            value |= static_cast<std::uint64_t>(byte & 0x7FU) << shift;
            if ((byte & 0x80U) == 0)
                return value;
        }
        m_ok = false;
        return value;
    }
    std::span<const std::uint8_t> take(std::size_t count)
    {
        if (!m_ok || count > m_bytes.size()) {
            m_ok = false;
            return {};
        }
        const auto taken = m_bytes.first(count);
        m_bytes = m_bytes.subspan(count);
        return taken;
    }
    [[nodiscard]] std::span<const std::uint8_t> rest() const { return m_bytes; }
    [[nodiscard]] bool isEmpty() const { return m_bytes.empty(); }
    [[nodiscard]] bool ok() const { return m_ok; }

private:
    std::span<const std::uint8_t> m_bytes;
    bool m_ok = true;
};

} // namespace mb::mcap
