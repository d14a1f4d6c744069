// SPDX-License-Identifier: GPL-3.0-or-later
#include "wire/checksum.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace mb {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes ofText(std::string_view text)
{
    return {text.begin(), text.end()};
}

constexpr Crc32 variantA{0, 0};
constexpr Crc32 zlib{};

/// The shift register as a chip would have it, unmirrored, with a chosen number of zero bits for the flush.
std::uint32_t registerAfter(const Bytes &bytes, int flushBits)
{
    std::vector<bool> bits;
    for (const std::uint8_t byte : bytes) {
        for (int i = 0; i < 8; ++i)
            bits.push_back(((byte >> i) & 1U) != 0U);
    }
    bits.resize(bits.size() + static_cast<std::size_t>(flushBits));
    std::uint64_t crc = 0;
    for (const bool bit : bits) {
        crc = (crc << 1U) | (bit ? 1U : 0U);
        if ((crc >> 32U) != 0U)
            crc ^= 0x104C11DB7U;
    }
    std::uint32_t mirrored = 0;
    for (int i = 0; i < 32; ++i)
        mirrored |= static_cast<std::uint32_t>((crc >> i) & 1U) << (31 - i);
    return mirrored;
}

struct PageVector {
    std::string_view name;
    Bytes bytes;
    std::uint32_t a;
    std::uint32_t b;
};

Bytes page(std::uint8_t fill, const Bytes &at = {}, std::size_t offset = 0)
{
    Bytes bytes(4096, fill);
    for (std::size_t i = 0; i < at.size(); ++i)
        bytes[offset + i] = at[i];
    return bytes;
}

/// A page of the DMC60C (dmc60c/README.md#vectors).
std::vector<PageVector> pageVectors()
{
    Bytes counting(4096);
    for (std::size_t i = 0; i < counting.size(); ++i)
        counting[i] = static_cast<std::uint8_t>(i & 0xFFU);
    return {
        {"all 0xFF", page(0xFF), 0x3648671B, 0xF154670A},
        {"all 0x00", page(0x00), 0x00000000, 0xC71C0011},
        {"00 to FF repeated", counting, 0x658D2093, 0xA2912082},
        {"reset vector", page(0xFF, {0x00, 0x02, 0x04, 0xFF, 0x00, 0x00, 0x00, 0xFF}), 0xE0923A47, 0x278E3A56},
        {"version", page(0xFF, {0x17, 0x01, 0x00, 0xFF}, 4092), 0x09FDAD64, 0xCEE1AD75},
        {"version, phantom 0", page(0xFF, {0x17, 0x01, 0x00, 0x00}, 4092), 0x24FF42E9, 0xE3E342F8},
    };
}

TEST(Crc32, HasTheCheckValuesOfItsVariants)
{
    const Bytes check = ofText("123456789");
    EXPECT_EQ(variantA.of(check), 0x2DFD2D88U);
    EXPECT_EQ(zlib.of(check), 0xCBF43926U);
    EXPECT_EQ(crc32HalfFlushed(check), 0xCD6F8FD9U);
}

TEST(Crc32, HasTheValuesOfTheReferencePages)
{
    for (const PageVector &vector : pageVectors()) {
        EXPECT_EQ(variantA.of(vector.bytes), vector.a) << vector.name;
        EXPECT_EQ(zlib.of(vector.bytes), vector.b) << vector.name;
    }
    EXPECT_EQ(crc32HalfFlushed(page(0xFF)), 0x2939ED25U);
    EXPECT_EQ(crc32HalfFlushed(page(0x00)), 0U);
}

TEST(Crc32, AgreesWithTheShiftRegisterOfTheChip)
{
    for (const PageVector &vector : pageVectors()) {
        EXPECT_EQ(variantA.of(vector.bytes), registerAfter(vector.bytes, 32)) << vector.name;
        EXPECT_EQ(crc32HalfFlushed(vector.bytes), registerAfter(vector.bytes, 16)) << vector.name;
    }
}

TEST(Crc32, OfVariantAOverBytesAndTheirCrcIsZero)
{
    Bytes bytes = ofText("a page and its check value");
    const std::uint32_t crc = variantA.of(bytes);
    for (unsigned i = 0; i < 4; ++i)
        bytes.push_back(static_cast<std::uint8_t>((crc >> (8U * i)) & 0xFFU));
    EXPECT_EQ(variantA.of(bytes), 0U);
}

TEST(Crc32, SeesEverySingleBitOfAPage)
{
    Bytes bytes = page(0xFF);
    const std::uint32_t a = variantA.of(bytes);
    const std::uint32_t c = crc32HalfFlushed(bytes);
    for (std::size_t i = 0; i < bytes.size(); i += 61) {
        for (unsigned bit = 0; bit < 8; ++bit) {
            bytes[i] = static_cast<std::uint8_t>(0xFFU & ~(1U << bit));
            EXPECT_NE(variantA.of(bytes), a) << i;
            EXPECT_NE(crc32HalfFlushed(bytes), c) << i;
        }
        bytes[i] = 0xFF;
    }
}

TEST(Crc32, OfNothingIsWhatTheParametersSay)
{
    EXPECT_EQ(variantA.of({}), 0U);
    EXPECT_EQ(zlib.of({}), 0U);
    EXPECT_EQ(crc32HalfFlushed({}), 0U);
}

TEST(Crc32, WorksAtCompileTime)
{
    constexpr std::array<std::uint8_t, 9> check{'1', '2', '3', '4', '5', '6', '7', '8', '9'};
    static_assert(Crc32{}.of(check) == 0xCBF43926U);
    static_assert(crc32HalfFlushed(check) == 0xCD6F8FD9U);
    SUCCEED();
}

} // namespace
} // namespace mb
