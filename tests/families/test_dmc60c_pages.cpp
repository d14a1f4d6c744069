// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/firmware.h"
#include "families/dmc60c/pages.h"
#include "files/textfile.h"
#include "support/hextext.h"
#include "support/sourcetree.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace mb::dmc60c {
namespace {

using test::HexText;
using test::smallApplication;

/// dmc60c/README.md#vectors.
constexpr const char *referenceFile = ":020000040000FA\n"
                                      ":080000000002040000000000F2\n"
                                      ":020000040001F9\n"
                                      ":04EFFC0017010000F9\n"
                                      ":020000040002F8\n"
                                      ":04AFD800CFFFFF00A8\n"
                                      ":020000040100F9\n"
                                      ":041FF00001010000EB\n"
                                      ":00000001FF\n";

FirmwareImage imageOfPages(const std::string &text)
{
    auto image = FirmwareImage::fromIntelHex(text);
    EXPECT_TRUE(image) << (image ? "" : image.error().text());
    return image.value_or(FirmwareImage());
}

std::string refusal(const HexText &hex)
{
    const auto application = applicationFrom(imageOfPages(hex.text()));
    if (application)
        return "accepted";
    EXPECT_EQ(application.error().fault, Fault::OutOfRange);
    return application.error().text();
}

std::vector<int> numbers(const Application &application)
{
    std::vector<int> result;
    for (const Page &page : application.pages)
        result.push_back(page.number);
    return result;
}

Page unwrittenPage(int number)
{
    Page page;
    page.number = number;
    page.bytes.fill(0xFF);
    return page;
}

TEST(Dmc60cPages, OfTheReferenceFileAreTwo)
{
    const Application application = pagesOf(imageOfPages(referenceFile));
    ASSERT_EQ(numbers(application), (std::vector<int>{30, 0}));
    EXPECT_EQ(application.version, 0x0117);

    Page version = unwrittenPage(30);
    version.bytes[0xFFC] = 0x17;
    version.bytes[0xFFD] = 0x01;
    version.bytes[0xFFE] = 0x00;
    EXPECT_EQ(application.pages[0], version);
    Page reset = unwrittenPage(0);
    const std::array<std::uint8_t, 8> vector{0x00, 0x02, 0x04, 0xFF, 0x00, 0x00, 0x00, 0xFF};
    std::copy(vector.begin(), vector.end(), reset.bytes.begin());
    EXPECT_EQ(application.pages[1], reset);

    EXPECT_EQ(pageCrc(CrcVariant::A, application.pages[0].bytes), 0x09FDAD64U);
    EXPECT_EQ(pageCrc(CrcVariant::B, application.pages[0].bytes), 0xCEE1AD75U);
    EXPECT_EQ(pageCrc(CrcVariant::A, application.pages[1].bytes), 0xE0923A47U);
    EXPECT_EQ(pageCrc(CrcVariant::B, application.pages[1].bytes), 0x278E3A56U);
}

std::vector<std::string> notesOf(const FirmwareImage &image)
{
    std::vector<std::string> notes;
    for (const Message &note : pagesOf(image).notes)
        notes.push_back(note.english());
    return notes;
}

TEST(Dmc60cPages, NoteWhatIsNotSent)
{
    const std::vector<std::string> notes = notesOf(imageOfPages(referenceFile));
    EXPECT_EQ(notes,
        (std::vector<std::string>{"not sent: 4 bytes for pages 35-42 (bootloader and flash configuration)",
            "not sent: 4 bytes for the user-ID words"}));
    HexText hex = smallApplication();
    hex.add(0x1F000, {1}).add(0x2B000, {2}).add(0xFFFF0000, {3, 4}).add(0x2000, {0, 0, 0, 0x55});
    EXPECT_EQ(notesOf(imageOfPages(hex.text())),
        (std::vector<std::string>{"not sent: 1 byte for pages 31-34 (configuration and descriptors)",
            "not sent: 3 bytes outside the controller's flash",
            "not sent: 1 byte where a 24-bit instruction has none, the file may be for another processor"}));
    EXPECT_TRUE(pagesOf(imageOfPages(smallApplication().text())).notes.empty());
}

TEST(Dmc60cPages, CountTheLastByteOfARegionWithIt)
{
    HexText hex = smallApplication();
    hex.add(0x22FFF, {1}).add(0x2AFFF, {2});
    EXPECT_EQ(notesOf(imageOfPages(hex.text())),
        (std::vector<std::string>{"not sent: 1 byte for pages 31-34 (configuration and descriptors)",
            "not sent: 1 byte for pages 35-42 (bootloader and flash configuration)"}));
}

TEST(Dmc60cPreflight, RefusesAVersionOfWhichOneByteIsMissing)
{
    HexText hex;
    hex.add(0x0, {0x00, 0x02, 0x04, 0x00})
        .add(0x400, {0x00, 0x00, 0xFA, 0x00})
        .add(0x1EFFC, {0x17})
        .add(0x1EFFE, {0x00});
    const auto application = applicationFrom(imageOfPages(hex.text()));
    ASSERT_FALSE(application);
    EXPECT_EQ(application.error().text(), "no version at 0x1EFFC");
}

TEST(Dmc60cPages, CrcHasThreeVariants)
{
    const Page blank = unwrittenPage(0);
    EXPECT_EQ(pageCrc(CrcVariant::A, blank.bytes), 0x3648671BU);
    EXPECT_EQ(pageCrc(CrcVariant::B, blank.bytes), 0xF154670AU);
    EXPECT_EQ(pageCrc(CrcVariant::C, blank.bytes), 0x2939ED25U);
}

TEST(Dmc60cPages, HaveNoUnusedByteInAnyInstruction)
{
    const std::vector<std::uint8_t> zeros(0x2000, 0);
    const Application application = pagesOf(imageOfPages(smallApplication().add(0x5800, zeros).text()));
    for (const Page &page : application.pages) {
        for (std::size_t i = 3; i < page.bytes.size(); i += 4)
            ASSERT_EQ(page.bytes[i], 0xFF) << page.number << ' ' << i;
    }
}

TEST(Dmc60cPages, SplitARecordThatStraddlesThem)
{
    std::vector<std::uint8_t> bytes(16);
    for (std::size_t i = 0; i < bytes.size(); ++i)
        bytes[i] = static_cast<std::uint8_t>(i + 1);
    const Application application = pagesOf(imageOfPages(HexText().add(0xFFF8, bytes).text()));
    ASSERT_EQ(numbers(application), (std::vector<int>{16, 15}));
    EXPECT_EQ(application.pages[1].bytes[0xFF8], 1);
    EXPECT_EQ(application.pages[1].bytes[0xFFE], 7);
    EXPECT_EQ(application.pages[0].bytes[0], 9);
    EXPECT_EQ(application.pages[0].bytes[6], 15);
    EXPECT_EQ(application.pages[0].bytes[8], 0xFF);
    EXPECT_EQ(application.version, noApplication);
}

TEST(Dmc60cPages, OfEveryAddressAreTheRightOnes)
{
    for (int number = 0; number <= 43; ++number) {
        const auto first = static_cast<std::uint32_t>(number) * 0x1000U;
        for (const std::uint32_t address : {first, first + 0xFFE}) {
            const Application application = pagesOf(imageOfPages(HexText().add(address, {0x5A}).text()));
            EXPECT_EQ(numbers(application), number <= 30 ? std::vector<int>{number} : std::vector<int>{}) << address;
        }
    }
}

TEST(Dmc60cPreflight, AcceptsTheSmallestApplication)
{
    const auto application = applicationFrom(imageOfPages(smallApplication(0x010A).text()));
    ASSERT_TRUE(application) << application.error().text();
    EXPECT_EQ(numbers(*application), (std::vector<int>{30, 0}));
    EXPECT_EQ(application->version, 0x010A);
}

TEST(Dmc60cPreflight, RefusesEachFileWithItsReason)
{
    const auto noEntry = applicationFrom(imageOfPages(referenceFile));
    ASSERT_FALSE(noEntry);
    EXPECT_EQ(noEntry.error(), (Error{Fault::OutOfRange, say("no instruction at the entry point 0x00400")}));
    EXPECT_EQ(refusal(HexText().add(0x2AFD8, {1, 2, 3, 0})),
        "no data in page 0 (0x00000-0x00FFF), the file is not a whole application");
    EXPECT_EQ(refusal(HexText().add(0x1EFFC, {0x17, 0x01, 0, 0})),
        "no data in page 0 (0x00000-0x00FFF), the file is not a whole application");
    EXPECT_EQ(
        refusal(HexText().add(0x400, {0, 0, 0xFA, 0})), "no data in page 30 (0x1E000-0x1EFFF), where the version is");
    EXPECT_EQ(refusal(HexText().add(0x400, {0, 0, 0xFA, 0}).add(0x1E000, {1, 2, 3, 0})), "no version at 0x1EFFC");
    EXPECT_EQ(refusal(HexText().add(0x400, {0, 0, 0xFA, 0}).add(0x1EFFC, {0x17})), "no version at 0x1EFFC");
    EXPECT_EQ(refusal(HexText().add(0x400, {0, 0, 0xFA, 0}).add(0x1EFFD, {0x17})), "no version at 0x1EFFC");
    EXPECT_EQ(refusal(smallApplication(0xFFFF)), "the version at 0x1EFFC is 0xFFFF, which means no application");
    EXPECT_EQ(refusal(smallApplication(0x0000)), "the version at 0x1EFFC is 0x0000");
}

TEST(Dmc60cPreflight, TakesABlankEntryPointForNone)
{
    const HexText head = HexText().add(0, {0, 2, 4, 0}).add(0x1EFFC, {0x17, 0x01, 0, 0});
    EXPECT_EQ(refusal(HexText(head).add(0x400, {0xFF, 0xFF, 0xFF, 0x00})), "no instruction at the entry point 0x00400");
    EXPECT_EQ(refusal(HexText(head).add(0x404, {0, 0, 0xFA, 0})), "no instruction at the entry point 0x00400");
    for (std::uint8_t byte = 0; byte < 3; ++byte) { // the fourth is no part of an instruction
        std::vector<std::uint8_t> entry{0xFF, 0xFF, 0xFF, 0x00};
        entry[byte] = 0x12;
        EXPECT_NE(refusal(HexText(head).add(0x400, entry)), "no instruction at the entry point 0x00400") << int{byte};
    }
    EXPECT_EQ(refusal(HexText(head).add(0x400, {0, 0, 0, 0})), "accepted"); // 0x000000 is the instruction NOP
}

TEST(Dmc60cDemoFirmware, HasAllPagesAndVersion1p25)
{
    const auto text = readTextFile(inSourceTree("resources/firmware/dmc60c-demo.hex"), FirmwareImage::maxTextSize);
    ASSERT_TRUE(text) << text.error().text();
    const auto application = applicationFrom(imageOfPages(*text));
    ASSERT_TRUE(application) << application.error().text();
    EXPECT_EQ(application->version, 0x0119);
    std::vector<int> descending;
    for (int number = 30; number >= 0; --number)
        descending.push_back(number);
    EXPECT_EQ(numbers(*application), descending);
    EXPECT_EQ(application->notes.size(), 2U); // configuration and user-ID words
}

TEST(Dmc60cFirmware, AnImageIsShownWithItsPagesInTheOrderTheyAreWrittenAndPage0AsTheCriticalOne)
{
    const auto summary = inspect(imageOfPages(smallApplication().add(0x2000, {1, 2, 3, 0}).text()));
    ASSERT_TRUE(summary) << summary.error().text();
    EXPECT_EQ(summary->version, "1.23");
    EXPECT_EQ(summary->parts, (std::vector<int>{30, 2, 0}));
    EXPECT_EQ(summary->criticalPart, 0);
}

} // namespace
} // namespace mb::dmc60c
