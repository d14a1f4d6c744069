// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/deviceprofile.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

namespace mb {
namespace {

class Profiles : public testing::Test {
protected:
    QTemporaryDir folder;
    ProfileBook book{folder.path().toStdString() + "/below/it"};
    const std::string selector = "socketcan:can0/abstractdc:3";
};

TEST_F(Profiles, ADeviceWithoutAFileHasAnEmptyProfileAndNothingIsMade)
{
    const auto profile = book.load(selector);
    ASSERT_TRUE(profile);
    EXPECT_TRUE(profile->isEmpty());
    EXPECT_FALSE(QDir(folder.path() + "/below").exists());
}

TEST_F(Profiles, EverythingKeptComesBackEqual)
{
    DeviceProfile profile;
    profile.dialect = "L";
    profile.calibration = {{"counts_per_revolution", 2248.9}, {"amperes_per_count", 0.0488}};
    profile.written = {{"velocity.p", -2147483648LL}, {"velocity.divisor", 1000000}};
    profile.counters = {{"saves.velocity", 41}};
    profile.lost = {"velocity.p"};
    profile.verdicts = {{"direction", DirectionVerdict::Agrees}};
    ASSERT_TRUE(book.save(selector, profile));
    const auto back = book.load(selector);
    ASSERT_TRUE(back);
    EXPECT_EQ(*back, profile);
    EXPECT_DOUBLE_EQ(back->calibrated("amperes_per_count"), 0.0488);
    EXPECT_DOUBLE_EQ(back->calibrated("degrees_per_count", -1.0), -1.0);
}

TEST_F(Profiles, DevicesDoNotShareAFileEvenWhenTheirNamesLookAlike)
{
    EXPECT_NE(book.pathOf("serial:/dev/x/y:1"), book.pathOf("serial:/dev/x.y:1"));
    EXPECT_EQ(book.pathOf(selector).rfind('/'), (folder.path().toStdString() + "/below/it").size());
}

TEST_F(Profiles, AFileNameKeepsLettersDigitsAndDashes)
{
    EXPECT_EQ(fileNameOf("azAZ09-_").substr(0, 9), "azAZ09-_-");
    EXPECT_EQ(fileNameOf("/:@[`{ .~\xC3\xA4").substr(0, 12), "...........-");
    EXPECT_EQ(fileNameOf("a"), "a-e40c292c.json") << "a hash FNV-1a of the whole";
    EXPECT_EQ(fileNameOf("", ".log"), "-811c9dc5.log");
}

TEST_F(Profiles, AWholeNumberIsKeptExactlyOrNotAtAll)
{
    DeviceProfile profile;
    profile.written = {{"most", 9007199254740992LL}, {"least", -9007199254740992LL}, {"nothing", 0}};
    ASSERT_TRUE(book.save(selector, profile));
    EXPECT_EQ(book.load(selector).value(), profile);
}

TEST_F(Profiles, AVerdictOfAnotherVersionIsNoneOfAgreement)
{
    ASSERT_TRUE(book.save(selector, {}));
    QFile file(QString::fromStdString(book.pathOf(selector)));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly | QIODevice::Truncate));
    file.write(R"({"verdicts": {"direction": "good", "ch1.direction": "no motion"}})");
    file.close();
    const auto profile = book.load(selector);
    ASSERT_TRUE(profile);
    EXPECT_FALSE(profile->verdicts.contains("direction"));
    EXPECT_EQ(profile->verdicts.at("ch1.direction"), DirectionVerdict::NoMotion);
}

TEST_F(Profiles, ADamagedFileIsPutAsideAndTold)
{
    for (const char *text : {"", "{", "[]", R"({"calibration": 3})", R"({"written": {"a": "b"}})",
             R"({"counters": {"a": 1.5}})", R"({"lost": {"a": 1}})", R"({"lost": [1]})",
             R"({"calibration": {"a": 1, "a": 2}})", R"({"verdicts": {"direction": 1}})"}) {
        ASSERT_TRUE(book.save(selector, {}));
        QFile file(QString::fromStdString(book.pathOf(selector)));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly | QIODevice::Truncate));
        file.write(text);
        file.close();
        const auto profile = book.load(selector);
        ASSERT_FALSE(profile) << text;
        EXPECT_EQ(profile.error().fault, Fault::OutOfRange);
        EXPECT_TRUE(QFile::exists(file.fileName() + ".damaged"));
        EXPECT_TRUE(book.load(selector)) << "the next start begins afresh";
    }
}

TEST_F(Profiles, AFileOfMoreThanAMebibyteIsNotReadAndStaysWhereItIs)
{
    for (const int more : {0, 1}) {
        ASSERT_TRUE(book.save(selector, {}));
        QFile file(QString::fromStdString(book.pathOf(selector)));
        ASSERT_TRUE(file.open(QIODevice::Append));
        file.write(QByteArray((1 << 20) + more - static_cast<int>(file.size()), ' '));
        file.close();
        EXPECT_EQ(book.load(selector).has_value(), more == 0) << more;
        EXPECT_TRUE(file.exists());
    }
}

TEST_F(Profiles, AFolderThatCannotBeMadeIsOneClearLine)
{
    QFile file(folder.path() + "/below");
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    const auto saved = book.save(selector, {});
    ASSERT_FALSE(saved);
    EXPECT_NE(saved.error().text().find("/below/it"), std::string::npos);
}

} // namespace
} // namespace mb
