// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/dmc60c/protocol.h"
#include "firmware/firmwareimage.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

/// From a firmware file to what the bootloader is sent (README.md#updates).
namespace mb::dmc60c {

/// A flash page as it goes over the bus, padded (README.md#updates): what the file does not have is 0xFF, and so is every fourth
/// byte.
struct Page {
    int number = 0; ///< firstPage…lastPage
    std::array<std::uint8_t, pageSize> bytes{};

    friend bool operator==(const Page &, const Page &) = default;
};

struct Application {
    std::vector<Page>
        pages; ///< those of the file, in the order to write them: lastPage, then downwards, firstPage last
    std::uint16_t version = noApplication; ///< major in the high byte; noApplication when the file has none
    std::vector<Message> notes;            ///< one sentence each on what of the file is not sent, or looks odd
};

/// The pages of the file without any judgement.
[[nodiscard]] Application pagesOf(const FirmwareImage &image);

/// pagesOf() after the preflight. Fault::OutOfRange when page 0 or page 30 has no data, when the version word is
/// missing, 0x0000 or 0xFFFF, or when there is no instruction at the entry point.
[[nodiscard]] Result<Application> applicationFrom(const FirmwareImage &image);

/// README.md#page-check: the CRC is nowhere specified. A is what the 2016 bootloader computes, B is zlib's, C is A with half of the
/// flush. Trying is harmless: a page with a wrong CRC erases nothing.
enum class CrcVariant { A, B, C };

/// The CRC of the bytes of a page; it goes little-endian behind them.
[[nodiscard]] std::uint32_t pageCrc(CrcVariant variant, std::span<const std::uint8_t> bytes);

} // namespace mb::dmc60c
