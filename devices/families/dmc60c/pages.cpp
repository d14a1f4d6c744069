// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/pages.h"

#include "wire/bytes.h"
#include "wire/checksum.h"

#include <limits>
#include <string_view>

namespace mb::dmc60c {
namespace {

constexpr std::uint32_t pageBytes = pageSize;
constexpr std::size_t instructionSize = 4; // low, middle, high byte, and one that flash does not have
constexpr std::uint8_t erased = 0xFF;
constexpr std::size_t versionOffset = versionHexAddress % pageBytes;

constexpr std::uint32_t addressOf(int page)
{
    return static_cast<std::uint32_t>(page) * pageBytes;
}
constexpr std::uint32_t lastAddressOf(int page)
{
    return addressOf(page) + (pageBytes - 1);
}

/// What a linker file has beyond the application.
struct Region {
    std::uint32_t first;
    std::uint32_t last;
    std::string_view name;
};
constexpr std::array otherRegions{
    Region{addressOf(31), lastAddressOf(34), MB_LABEL("pages 31-34 (configuration and descriptors)")},
    Region{addressOf(35), lastAddressOf(42), MB_LABEL("pages 35-42 (bootloader and flash configuration)")},
    Region{0x1001FF0, 0x1001FFF, MB_LABEL("the user-ID words")},
};

struct PaddedPage {
    Page page;
    std::size_t oddBytes = 0; ///< fourth bytes that a tool for this processor would not write
};

PaddedPage paddedPage(const FirmwareImage &image, int number)
{
    PaddedPage padded;
    padded.page.number = number;
    auto &bytes = padded.page.bytes;
    bytes.fill(erased);
    image.overlay(addressOf(number), bytes);
    for (std::size_t i = instructionSize - 1; i < bytes.size(); i += instructionSize) {
        padded.oddBytes += bytes[i] != 0 && bytes[i] != erased ? 1U : 0U;
        bytes[i] = erased;
    }
    return padded;
}

Message counted(std::size_t bytes)
{
    return bytes == 1 ? say("1 byte") : say("%1 bytes", bytes);
}

void noteIgnored(const FirmwareImage &image, std::vector<Message> &notes)
{
    constexpr std::uint32_t beyond = addressOf(lastPage + 1);
    std::size_t rest = image.byteCount(beyond, std::numeric_limits<std::uint32_t>::max());
    for (const Region &region : otherRegions) {
        const std::size_t count = image.byteCount(region.first, region.last);
        rest -= count;
        if (count != 0)
            notes.push_back(say("not sent: %1 for %2", counted(count), Message::label(region.name)));
    }
    if (rest != 0)
        notes.push_back(say("not sent: %1 outside the controller's flash", counted(rest)));
}

bool hasVersion(const FirmwareImage &image)
{
    return image.has(versionHexAddress) && image.has(versionHexAddress + 1);
}

bool hasEntry(const FirmwareImage &image)
{
    for (std::uint32_t i = 0; i + 1 < instructionSize; ++i) {
        if (image.at(entryHexAddress + i).value_or(erased) != erased)
            return true;
    }
    return false;
}

tl::unexpected<Error> refused(Message cause)
{
    return fail(Fault::OutOfRange, std::move(cause));
}

} // namespace

Application pagesOf(const FirmwareImage &image)
{
    Application application;
    std::size_t oddBytes = 0;
    for (int number = lastPage; number >= firstPage; --number) {
        if (!image.hasAny(addressOf(number), lastAddressOf(number)))
            continue;
        const PaddedPage padded = paddedPage(image, number);
        oddBytes += padded.oddBytes;
        application.pages.push_back(padded.page);
    }
    if (hasVersion(image))
        application.version = readU16le(application.pages.front().bytes, versionOffset);
    noteIgnored(image, application.notes);
    if (oddBytes != 0)
        application.notes.push_back(
            say("not sent: %1 where a 24-bit instruction has none, the file may be for another processor",
                counted(oddBytes)));
    return application;
}

Result<Application> applicationFrom(const FirmwareImage &image)
{
    if (!image.hasAny(addressOf(firstPage), lastAddressOf(firstPage)))
        return refused(say("no data in page 0 (0x00000-0x00FFF), the file is not a whole application"));
    if (!image.hasAny(addressOf(lastPage), lastAddressOf(lastPage)))
        return refused(say("no data in page 30 (0x1E000-0x1EFFF), where the version is"));
    if (!hasVersion(image))
        return refused(say("no version at 0x1EFFC"));
    Application application = pagesOf(image);
    if (application.version == noApplication)
        return refused(say("the version at 0x1EFFC is 0xFFFF, which means no application"));
    if (application.version == 0)
        return refused(say("the version at 0x1EFFC is 0x0000"));
    if (!hasEntry(image))
        return refused(say("no instruction at the entry point 0x00400"));
    return application;
}

std::uint32_t pageCrc(CrcVariant variant, std::span<const std::uint8_t> bytes)
{
    switch (variant) {
    case CrcVariant::A: return Crc32{0, 0}.of(bytes);
    case CrcVariant::B: return Crc32{}.of(bytes);
    case CrcVariant::C: break;
    }
    return crc32HalfFlushed(bytes);
}

} // namespace mb::dmc60c
