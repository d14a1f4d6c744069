// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/simulatorflash.h"

#include "wire/bytes.h"
#include "wire/checksum.h"

#include <algorithm>

namespace mb::dmc60c::simulation {
namespace {

/// The chip's unit as the firmware uses it: data bits enter behind the register, `padding` zero bits push them through.
std::uint32_t augmentedCrc(std::span<const std::uint8_t> bytes, int padding)
{
    constexpr std::uint32_t polynomial = 0xEDB88320U;
    std::uint32_t crc = 0;
    const auto shift = [&crc](std::uint32_t bit) {
        const bool out = (crc & 1U) != 0U;
        crc = (crc >> 1U) | (bit << 31U);
        if (out)
            crc ^= polynomial;
    };
    for (const std::uint8_t byte : bytes) {
        for (unsigned bit = 0; bit < 8; ++bit)
            shift((byte >> bit) & 1U);
    }
    for (int i = 0; i < padding; ++i)
        shift(0);
    return crc;
}

constexpr int resetVectorSize = 8;
constexpr int versionSize = 4;

} // namespace

std::vector<std::uint8_t> ConfigImage::descriptors() const
{
    std::vector<std::uint8_t> stream;
    for (std::size_t i = 0; i < texts.size(); ++i) {
        const std::string &characters = texts[i];
        if (characters.empty())
            continue;
        stream.push_back(static_cast<std::uint8_t>(i + 1));
        stream.push_back(static_cast<std::uint8_t>(characters.size()));
        stream.insert(stream.end(), characters.begin(), characters.end());
    }
    return stream;
}

std::uint32_t pageCrc(CrcVariant variant, std::span<const std::uint8_t> bytes)
{
    switch (variant) {
    case CrcVariant::A: return augmentedCrc(bytes, 32);
    case CrcVariant::B: return Crc32{}.of(bytes);
    case CrcVariant::C: return augmentedCrc(bytes, 16);
    }
    return 0;
}

bool ApplicationFlash::isRunnable() const
{
    const bool broken = std::ranges::any_of(m_broken, [](bool page) { return page; });
    return m_version != noApplication && !broken && !m_versionFromNowhere;
}

void ApplicationFlash::erase(int page)
{
    m_broken[static_cast<std::size_t>(page)] = true;
    std::fill_n(m_bytes.begin() + std::ptrdiff_t{page} * pageSize, pageSize, blank);
    if (page == lastPage)
        m_version = noApplication;
    if (page == firstPage)
        m_resetVector = false;
}

bool ApplicationFlash::program(int page, std::span<const std::uint8_t> bytes)
{
    if (page == m_spoiled) {
        m_spoiled = -1;
        m_resetVector = true; // the last retry gave at least that back
        return false;
    }
    m_broken[static_cast<std::size_t>(page)] = false;
    // The ends of what the bootloader itself decides about: its own way in, and the version, which comes last (README.md#updates).
    const std::ptrdiff_t first = page == firstPage ? std::ptrdiff_t{resetVectorSize} : 0;
    const std::ptrdiff_t end = page == lastPage ? std::ptrdiff_t{pageSize - versionSize} : pageSize;
    std::copy(bytes.begin() + first, bytes.begin() + end, m_bytes.begin() + std::ptrdiff_t{page} * pageSize + first);
    if (page == lastPage)
        m_savedVersion = readU32le(bytes, pageSize - versionSize);
    if (page == firstPage)
        m_resetVector = true;
    return true;
}

std::vector<std::uint8_t> ApplicationFlash::bytes() const
{
    std::vector<std::uint8_t> read = m_bytes;
    for (std::size_t phantom = 3; phantom < read.size(); phantom += 4)
        read[phantom] = 0;
    return read;
}

void ApplicationFlash::writeVersion()
{
    m_version = static_cast<std::uint16_t>(m_savedVersion.value_or(0));
    m_versionFromNowhere = !m_savedVersion.has_value();
    writeU32le(m_bytes, m_bytes.size() - versionSize, m_savedVersion.value_or(0));
}

} // namespace mb::dmc60c::simulation
