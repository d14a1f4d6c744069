// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/intelhex.h"

#include "wire/byteordermark.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>

namespace mb {
namespace {

using Status = Result<void>;

constexpr std::uint64_t addressSpace = std::uint64_t{1} << 32U;
constexpr std::uint32_t window = 0x10000U; // what the 16 address bits of a record reach
constexpr std::size_t frameBytes = 5;      // count, address (2), type, checksum

enum class RecordType : std::uint8_t {
    Data = 0,
    EndOfFile = 1,
    ExtendedSegment = 2,
    StartSegment = 3,
    ExtendedLinear = 4,
    StartLinear = 5,
};

std::string hexText(std::uint32_t value, int digits)
{
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), "0x%0*X", digits, value);
    return text.data();
}

std::string named(char c)
{
    const auto byte = static_cast<unsigned char>(c);
    return byte >= 0x20 && byte < 0x7F ? std::string("'") + c + '\'' : "byte " + hexText(byte, 2);
}

int digitValue(char c)
{
    if (c >= '0' && c <= '9')
        return c - '0';
    if (c >= 'A' && c <= 'F')
        return c - 'A' + 10;
    return c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
}

/// Takes the first line off `rest`; LF, CRLF and CR end one.
std::string_view takeLine(std::string_view &rest)
{
    std::size_t end = 0;
    while (end < rest.size() && rest[end] != '\n' && rest[end] != '\r')
        ++end;
    const std::string_view line = rest.substr(0, end);
    const bool pair = rest.substr(end, 2) == "\r\n";
    rest.remove_prefix(std::min(rest.size(), end + (pair ? 2U : 1U)));
    return line;
}

std::string_view withoutTrailingBlanks(std::string_view line)
{
    const auto last = line.find_last_not_of(" \t");
    return line.substr(0, last == std::string_view::npos ? 0 : last + 1);
}

} // namespace

/// Reads the records one after the other, then joins them. Needs memory in proportion to the text, whatever its
/// addresses.
class IntelHexReader {
public:
    Status read(std::string_view text);
    Result<FirmwareImage> join();

private:
    /// A data record: where it belongs and where its bytes are in m_bytes.
    struct Record {
        std::uint32_t address = 0;
        std::uint32_t size = 0;
        std::uint32_t offset = 0;
        std::uint32_t line = 0;
    };
    /// How the 16 address bits of a data record become 32.
    enum class Addressing { None, Segment, Linear };

    Status readLine(std::string_view line);
    Status decode(std::string_view digits);
    Status interpret();
    Status addData();
    Status expectSize(std::size_t size) const;
    [[nodiscard]] tl::unexpected<Error> wrong(const Message &cause) const { return wrongIn(m_line, cause); }
    [[nodiscard]] static tl::unexpected<Error> wrongIn(std::uint32_t line, const Message &cause)
    {
        return fail(Fault::OutOfRange, say("line %1: %2", line, cause));
    }
    [[nodiscard]] tl::unexpected<Error> conflictAt(std::uint32_t address) const;
    [[nodiscard]] std::uint8_t valueOf(const Record &record, std::uint32_t address) const
    {
        return m_bytes[record.offset + (address - record.address)];
    }
    /// Parts of the record in m_raw.
    [[nodiscard]] std::size_t dataSize() const { return m_raw[0]; }
    [[nodiscard]] std::uint32_t word(std::size_t at) const
    {
        return (static_cast<std::uint32_t>(m_raw[at]) << 8U) | m_raw[at + 1];
    }

    std::vector<Record> m_records;
    std::vector<std::uint8_t> m_bytes;
    std::array<std::uint8_t, 255 + frameBytes> m_raw{};
    std::uint32_t m_line = 0;
    std::uint32_t m_baseAddress = 0;
    Addressing m_base = Addressing::None;
    bool m_ended = false;
};

Status IntelHexReader::read(std::string_view text)
{
    text = withoutByteOrderMark(text);
    bool blank = true;
    while (!text.empty()) {
        ++m_line;
        const std::string_view line = withoutTrailingBlanks(takeLine(text));
        if (line.empty())
            continue;
        blank = false;
        MB_TRY_VOID(readLine(line));
    }
    m_line = std::max(m_line, std::uint32_t{1});
    if (blank)
        return wrong(say("the file is empty"));
    if (!m_ended)
        return wrong(say("the end-of-file record is missing, the file may be cut off"));
    if (m_bytes.empty())
        return wrong(say("the file holds no data"));
    return {};
}

Status IntelHexReader::readLine(std::string_view line)
{
    if (m_ended)
        return wrong(say("something follows the end-of-file record"));
    if (line.front() != ':')
        return wrong(say("%1 where a record begins with a colon, is this an Intel HEX file?", named(line.front())));
    MB_TRY_VOID(decode(line.substr(1)));
    return interpret();
}

/// Digits to m_raw; afterwards length and checksum are right.
Status IntelHexReader::decode(std::string_view digits)
{
    const auto odd = std::ranges::find_if(digits, [](char c) { return digitValue(c) < 0; });
    if (odd != digits.end())
        return wrong(say("%1 is not a hexadecimal digit", named(*odd)));
    if (digits.size() % 2 != 0)
        return wrong(say("%1 digits, an even number is needed", digits.size()));
    const std::size_t size = digits.size() / 2;
    if (size < frameBytes)
        return wrong(say("the record is cut off after %1 bytes", size));
    const auto byteAt = [digits](std::size_t i) {
        return static_cast<std::uint8_t>(digitValue(digits[2 * i]) * 16 + digitValue(digits[2 * i + 1]));
    };
    if (const std::size_t announced = byteAt(0); announced + frameBytes != size)
        return wrong(say("%1 data bytes are announced, %2 are there", announced, size - frameBytes));
    std::uint32_t sum = 0;
    for (std::size_t i = 0; i < size; ++i) {
        m_raw[i] = byteAt(i);
        sum += m_raw[i];
    }
    const std::uint32_t check = m_raw[size - 1];
    if (const std::uint32_t needed = (check - sum) & 0xFFU; needed != check)
        return wrong(say("checksum is %1, %2 is needed", hexText(check, 2), hexText(needed, 2)));
    return {};
}

Status IntelHexReader::expectSize(std::size_t size) const
{
    if (dataSize() == size)
        return {};
    return wrong(
        say("a record of type %1 has %2 data bytes, not %3", hexText(m_raw[3], 2).substr(2), size, dataSize()));
}

Status IntelHexReader::interpret()
{
    switch (static_cast<RecordType>(m_raw[3])) {
    case RecordType::Data: return addData();
    case RecordType::EndOfFile: m_ended = true; return expectSize(0);
    case RecordType::ExtendedSegment:
        m_base = Addressing::Segment;
        m_baseAddress = word(4) << 4U;
        return expectSize(2);
    case RecordType::ExtendedLinear:
        m_base = Addressing::Linear;
        m_baseAddress = word(4) << 16U;
        return expectSize(2);
    case RecordType::StartSegment:
    case RecordType::StartLinear: return expectSize(4); // where a program would start; controllers have reset vectors
    }
    return wrong(say("record type %1 is unknown", hexText(m_raw[3], 2)));
}

Status IntelHexReader::addData()
{
    const std::uint64_t inWindow = word(1);
    const std::uint64_t address = m_baseAddress + inWindow;
    // Past its 64 KiB a segment wraps to its own start, and what happens without a base depends on the reader.
    if (m_base != Addressing::Linear && inWindow + dataSize() > window)
        return wrong(say("the data runs past the end of its 64 KiB segment"));
    if (address + dataSize() > addressSpace)
        return wrong(say("the data runs past the end of 32-bit addresses"));
    if (dataSize() == 0)
        return {};
    m_records.push_back(
        {static_cast<std::uint32_t>(address), m_raw[0], static_cast<std::uint32_t>(m_bytes.size()), m_line});
    const auto data = std::span(m_raw).subspan(4, dataSize());
    m_bytes.insert(m_bytes.end(), data.begin(), data.end());
    return {};
}

Result<FirmwareImage> IntelHexReader::join()
{
    std::ranges::stable_sort(m_records, [](const Record &a, const Record &b) { return a.address < b.address; });
    FirmwareImage image;
    image.m_bytes.reserve(m_bytes.size());
    std::uint64_t end = addressSpace + 1; // of the last segment
    for (const Record &record : m_records) {
        const auto bytes = std::span(m_bytes).subspan(record.offset, record.size);
        if (image.m_segments.empty() || record.address > end) {
            image.m_segments.push_back({record.address, record.address, image.m_bytes.size()});
            end = record.address;
        }
        FirmwareImage::Segment &segment = image.m_segments.back();
        const std::size_t known = std::min<std::size_t>(bytes.size(), end - record.address);
        const std::size_t at = segment.offset + (record.address - segment.first);
        for (std::size_t i = 0; i < known; ++i) {
            if (image.m_bytes[at + i] != bytes[i])
                return conflictAt(record.address + static_cast<std::uint32_t>(i));
        }
        image.m_bytes.insert(image.m_bytes.end(), bytes.begin() + static_cast<std::ptrdiff_t>(known), bytes.end());
        end += bytes.size() - known;
        segment.last = static_cast<std::uint32_t>(end - 1);
    }
    return image;
}

/// Names the first two lines that disagree about `address`.
tl::unexpected<Error> IntelHexReader::conflictAt(std::uint32_t address) const
{
    std::vector<Record> covering;
    std::copy_if(m_records.begin(), m_records.end(), std::back_inserter(covering), [address](const Record &record) {
        return record.address <= address && address - record.address < record.size;
    });
    std::ranges::sort(covering, [](const Record &a, const Record &b) { return a.line < b.line; });
    const Record &first = covering.front();
    const auto second = std::ranges::find_if(
        covering, [&](const Record &record) { return valueOf(record, address) != valueOf(first, address); });
    return wrongIn(second->line,
        say("address %1 is %2 here and %3 in line %4", hexText(address, 5), hexText(valueOf(*second, address), 2),
            hexText(valueOf(first, address), 2), first.line));
}

Result<FirmwareImage> FirmwareImage::fromIntelHex(std::string_view text)
{
    if (text.size() > maxTextSize)
        return fail(Fault::OutOfRange, say("the text is longer than %1 MiB", maxTextSize >> 20U));
    IntelHexReader reader;
    MB_TRY_VOID(reader.read(text));
    auto image = reader.join();
    if (image)
        image->keepLines(text);
    return image;
}

void FirmwareImage::keepLines(std::string_view text)
{
    constexpr std::string_view ends = "\r\n";
    constexpr std::string_view blanks = " \t\xEF\xBB\xBF"; // and the byte order mark
    while (!text.empty()) {
        const auto end = text.find_first_of(ends);
        std::string_view line = text.substr(0, end);
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
        if (line.empty())
            continue;
        m_lines.emplace_back(line.substr(0, line.find_last_not_of(blanks) + 1));
    }
}

namespace {

std::string recordOf(RecordType type, std::uint32_t address, std::span<const std::uint8_t> data)
{
    std::vector<std::uint8_t> bytes{static_cast<std::uint8_t>(data.size()), static_cast<std::uint8_t>(address >> 8U),
        static_cast<std::uint8_t>(address & 0xFFU), static_cast<std::uint8_t>(type)};
    bytes.insert(bytes.end(), data.begin(), data.end());
    unsigned sum = 0;
    for (const std::uint8_t byte : bytes)
        sum += byte;
    bytes.push_back(static_cast<std::uint8_t>(0U - sum));
    std::string line = ":";
    for (const std::uint8_t byte : bytes) {
        line += "0123456789ABCDEF"[byte >> 4U];
        line += "0123456789ABCDEF"[byte & 0xFU];
    }
    return line + '\n';
}

} // namespace

std::string toIntelHex(const FirmwareImage &image)
{
    constexpr std::size_t perLine = 16;
    std::string text;
    std::uint32_t upper = 0;
    for (const FirmwareImage::Segment &segment : image.segments()) {
        std::span<const std::uint8_t> rest = image.bytes(segment);
        std::uint32_t address = segment.first;
        while (!rest.empty()) {
            if (address >> 16U != upper) {
                upper = address >> 16U;
                const std::array base{static_cast<std::uint8_t>(upper >> 8U), static_cast<std::uint8_t>(upper & 0xFFU)};
                text += recordOf(RecordType::ExtendedLinear, 0, base);
            }
            const std::size_t size = std::min<std::size_t>({rest.size(), perLine, window - (address & 0xFFFFU)});
            text += recordOf(RecordType::Data, address & 0xFFFFU, rest.first(size));
            rest = rest.subspan(size);
            address += static_cast<std::uint32_t>(size);
        }
    }
    return text + recordOf(RecordType::EndOfFile, 0, {});
}

} // namespace mb
