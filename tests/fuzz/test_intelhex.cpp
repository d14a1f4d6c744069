// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/pages.h"
#include "firmware/firmwareimage.h"
#include "fuzz/mutation.h"
#include "fuzz/soak.h"
#include "support/hextext.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace mb {
namespace {

using Memory = std::map<std::uint32_t, std::uint8_t>;

/// A second reader, as simple as can be: the bytes by address, or nothing for a file that must be refused.
class SimpleReader {
public:
    static std::optional<Memory> read(std::string text)
    {
        if (text.rfind("\xEF\xBB\xBF", 0) == 0)
            text.erase(0, 3);
        SimpleReader reader;
        std::string line;
        for (const char c : text + '\n') {
            if (c != '\n' && c != '\r') {
                line += c;
                continue;
            }
            if (!reader.take(line))
                return std::nullopt;
            line.clear();
        }
        return reader.m_ended && !reader.m_memory.empty() ? std::optional(reader.m_memory) : std::nullopt;
    }

private:
    bool take(std::string line)
    {
        while (!line.empty() && (line.back() == ' ' || line.back() == '\t'))
            line.pop_back();
        if (line.empty())
            return true;
        std::vector<std::uint8_t> bytes;
        for (std::size_t i = 1; i < line.size(); i += 2) {
            std::uint8_t byte = 0;
            const std::string digits = line.substr(i, 2);
            const auto parsed = std::from_chars(digits.data(), digits.data() + digits.size(), byte, 16);
            if (digits.size() != 2 || parsed.ec != std::errc{} || parsed.ptr != digits.data() + 2)
                return false;
            bytes.push_back(byte);
        }
        std::uint8_t sum = 0;
        for (const std::uint8_t byte : bytes)
            sum = static_cast<std::uint8_t>(sum + byte);
        return line[0] == ':' && !m_ended && bytes.size() >= 5 && bytes.size() == bytes[0] + 5U && sum == 0
            && obey(bytes);
    }

    bool obey(const std::vector<std::uint8_t> &bytes)
    {
        const std::size_t size = bytes[0];
        if (bytes[3] == 1) {
            m_ended = true;
            return size == 0;
        }
        if (bytes[3] == 2 || bytes[3] == 4) {
            const std::uint64_t value = size == 2 ? bytes[4] * 256U + bytes[5] : 0U;
            m_linear = bytes[3] == 4;
            m_base = value * (m_linear ? 65536 : 16);
            return size == 2;
        }
        if (bytes[3] != 0)
            return (bytes[3] == 3 || bytes[3] == 5) && size == 4;
        const std::uint64_t offset = bytes[1] * 256U + bytes[2];
        for (std::size_t i = 0; i < size; ++i) {
            const std::uint64_t address = m_base + offset + i;
            if ((!m_linear && offset + i > 0xFFFF) || address > 0xFFFFFFFF)
                return false;
            const auto [place, isNew] = m_memory.emplace(static_cast<std::uint32_t>(address), bytes[4 + i]);
            if (!isNew && place->second != bytes[4 + i])
                return false;
        }
        return true;
    }

    Memory m_memory;
    std::uint64_t m_base = 0;
    bool m_linear = false;
    bool m_ended = false;
};

/// A file of valid records that lie closely together, so that they often overlap, wrap and conflict.
std::string crowdedFile(test::Mutation &mutation)
{
    std::string text;
    for (std::size_t i = mutation.below(12) + 1; i > 0; --i) {
        const auto low = static_cast<std::uint8_t>(mutation.below(2));
        const auto high = static_cast<std::uint8_t>(mutation.below(8) == 0 ? 0xFF : 0);
        const std::vector<std::uint8_t> base{high, high != 0 ? high : low};
        const std::size_t kind = mutation.below(10);
        if (kind < 3) {
            text += test::hexRecord(kind == 0 ? 2 : 4, 0, base);
            continue;
        }
        const std::uint32_t start = mutation.below(3) == 0 ? 0xFFF0 : 0x0;
        const std::vector<std::uint8_t> data(mutation.below(20), static_cast<std::uint8_t>(mutation.below(12) == 0));
        text += test::hexRecord(0, start + static_cast<std::uint32_t>(mutation.below(16)), data);
    }
    return text + ":00000001FF\n";
}

/// Makes the checksum of every line right that has one, so that changes reach what lies behind that check.
std::string withChecksums(const std::string &text)
{
    std::string result;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        const bool digits = line.size() > 10 && line.size() % 2 == 1
            && line.find_first_not_of("0123456789ABCDEFabcdef", 1) == std::string::npos;
        unsigned sum = 0;
        for (std::size_t i = 1; digits && i + 2 < line.size(); i += 2)
            sum += static_cast<unsigned>(std::stoul(line.substr(i, 2), nullptr, 16));
        std::array<char, 16> check{};
        std::snprintf(check.data(), check.size(), "%02X", (0U - sum) & 0xFFU);
        result += (digits ? line.substr(0, line.size() - 2) + check.data() : line) + '\n';
    }
    return result;
}

void expectConsistent(const FirmwareImage &image, const Memory &memory, const std::string &text)
{
    ASSERT_EQ(image.byteCount(), memory.size()) << text;
    for (const auto &[address, value] : memory)
        ASSERT_EQ(image.at(address), value) << text;
    std::size_t offset = 0;
    std::uint64_t after = 0;
    for (const FirmwareImage::Segment &segment : image.segments()) {
        ASSERT_LE(segment.first, segment.last) << text;
        ASSERT_TRUE(offset == 0 || segment.first > after) << text;
        ASSERT_EQ(segment.offset, offset) << text;
        offset += segment.size();
        after = std::uint64_t{segment.last} + 1;
    }
    ASSERT_EQ(offset, memory.size()) << text;
}

void expectOneClearLine(const Error &error, const std::string &text)
{
    EXPECT_EQ(error.fault, Fault::OutOfRange) << text;
    const std::string line = error.text();
    EXPECT_EQ(line.rfind("line ", 0), 0U) << text;
    EXPECT_TRUE(std::all_of(line.begin(), line.end(), [](char c) { return c >= 0x20 && c < 0x7F; })) << text;
    EXPECT_LT(line.size(), 120U) << text;
}

/// Both readers agree about `text`; true when it was accepted.
bool expectAgreement(const std::string &text)
{
    const auto image = FirmwareImage::fromIntelHex(text);
    const auto memory = SimpleReader::read(text);
    EXPECT_EQ(image.has_value(), memory.has_value()) << text << (image ? "" : image.error().text());
    if (!image) {
        expectOneClearLine(image.error(), text);
        return false;
    }
    if (memory)
        expectConsistent(*image, *memory, text);
    return true;
}

test::Mutation mutationWith(std::uint32_t seed)
{
    return {seed,
        {":", ":00000001FF\n", ":020000040001F9\n", ":020000021000EC\n", ":0400000312345678E5\n", "\r\n", "\n", " ",
            ":10", "FF", std::string(1, '\0'), "\xEF\xBB\xBF", ":0100000001FE\n", ":01FFFF0001FF\n",
            std::string(600, 'A')}};
}

TEST(IntelHexFuzz, EveryChangedFileIsReadRightOrRefusedClearly)
{
    test::Mutation mutation = mutationWith(1);
    int accepted = 0;
    const int total = test::rounds(20'000);
    for (int i = 0; i < total && !::testing::Test::HasFailure(); ++i) {
        const std::string changed = mutation(crowdedFile(mutation));
        accepted += expectAgreement(i % 2 == 0 ? changed : withChecksums(changed)) ? 1 : 0;
    }
    EXPECT_GT(accepted, total / 200);
    EXPECT_LT(accepted, total / 2);
}

TEST(IntelHexFuzz, ValidRecordsInAnyArrangementAreReadRightOrRefusedClearly)
{
    test::Mutation mutation = mutationWith(2);
    int accepted = 0;
    const int total = test::rounds(20'000);
    for (int i = 0; i < total && !::testing::Test::HasFailure(); ++i)
        accepted += expectAgreement(crowdedFile(mutation)) ? 1 : 0;
    EXPECT_GT(accepted, total / 100);
    EXPECT_LT(accepted, total);
}

TEST(IntelHexFuzz, ArbitraryBytesAreRefusedClearly)
{
    test::Mutation mutation = mutationWith(3);
    const int total = test::rounds(5'000);
    for (int i = 0; i < total && !::testing::Test::HasFailure(); ++i) {
        std::string text(mutation.below(200), ' ');
        std::generate(text.begin(), text.end(), [&mutation] { return static_cast<char>(mutation.below(256)); });
        EXPECT_FALSE(expectAgreement(text)) << text;
    }
}

TEST(IntelHexFuzz, PagesOfAnyImageAreDescendingAndWhole)
{
    test::Mutation mutation = mutationWith(4);
    const std::string file = test::smallApplication().text();
    const int total = test::rounds(5'000);
    int accepted = 0;
    for (int i = 0; i < total && !::testing::Test::HasFailure(); ++i) {
        std::string text = crowdedFile(mutation);
        text.erase(text.size() - 12);
        text += mutation.below(2) == 0 ? file : mutation(file);
        const auto image = FirmwareImage::fromIntelHex(text);
        if (!image)
            continue;
        const auto pages = dmc60c::pagesOf(*image).pages;
        const auto rising = std::adjacent_find(pages.begin(), pages.end(),
            [](const dmc60c::Page &a, const dmc60c::Page &b) { return a.number <= b.number; });
        EXPECT_EQ(rising, pages.end()) << text;
        const auto application = dmc60c::applicationFrom(*image);
        if (!application)
            continue;
        ++accepted;
        EXPECT_EQ(application->pages.front().number, 30) << text;
        EXPECT_EQ(application->pages.back().number, 0) << text;
        EXPECT_NE(application->version, 0xFFFF) << text;
        EXPECT_NE(application->version, 0) << text;
    }
    EXPECT_GT(accepted, total / 100);
}

} // namespace
} // namespace mb
