// SPDX-License-Identifier: GPL-3.0-or-later
// What is known of the devices of a session outlives them, each in its place. The lines are pseudo terminals.
#include "async/scope.h"
#include "sessionlines.h"
#include "support/heldbackground.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace mb {
namespace {

using test::SessionLines;
using test::wiredFamily;
using test::WiredMotor;

TEST_F(SessionLines, WhatIsKnownOfADeviceIsKeptWhenItChangesAndRecalledWhenItIsFoundAgain)
{
    memory.keepProfiles(folder.path().toStdString() + "/profiles");
    motorOn(*links[0]).knowledge().setCounter("saves", 7);
    motorOn(*links[1]).knowledge().setCounter("saves", 8);
    devices.forget(*links[0]);
    devices.forget(*links[1]);
    EXPECT_EQ(motorOn(*links[0]).knowledge().profile().counters.at("saves"), 7);
    EXPECT_EQ(motorOn(*links[1]).knowledge().profile().counters.at("saves"), 8);
    EXPECT_TRUE(motorOn(*links[0], 4).knowledge().profile().isEmpty()) << "another number";
}

TEST_F(SessionLines, WhatAnEarlierBuildKeptOfADeviceIsFoundUntilSomethingIsKeptOfItsPlace)
{
    const std::string profiles = folder.path().toStdString() + "/profiles";
    memory.keepProfiles(profiles);
    DeviceProfile before;
    before.counters["saves"] = 7;
    ASSERT_TRUE(ProfileBook(profiles).save(links[0]->address().text() + "/wired:3", before));
    WiredMotor &motor = motorOn(*links[0]);
    ASSERT_TRUE(motor.knowledge().profile().counters.contains("saves"));
    EXPECT_EQ(motor.knowledge().profile().counters.at("saves"), 7);
    motor.knowledge().setCounter("saves", 8);
    devices.forget(*links[0]);
    EXPECT_EQ(motorOn(*links[0]).knowledge().profile().counters.at("saves"), 8);
}

TEST_F(SessionLines, WhatAnEarlierBuildKeptOfADeviceIsNotThatOfTheNextAdapterWithTheName)
{
    const std::string profiles = folder.path().toStdString() + "/profiles";
    memory.keepProfiles(profiles);
    DeviceProfile before;
    before.counters["saves"] = 7;
    const std::string old = links[0]->address().text() + "/wired:3";
    ASSERT_TRUE(ProfileBook(profiles).save(old, before));
    EXPECT_EQ(motorOn(*links[0]).knowledge().profile(), before);
    EXPECT_TRUE(QFile::exists(QString::fromStdString(ProfileBook(profiles).pathOf(old) + ".moved")));
    close(*links[0]);
    close(*links[1]);
    unplug(0);
    unplug(1);
    plug(1, 0);
    links[0] = openLine(0);
    EXPECT_TRUE(motorOn(*links[0]).knowledge().profile().isEmpty()) << "of another adapter";
    close(*links[0]);
    unplug(0);
    plug(0, 0);
    links[0] = openLine(0);
    EXPECT_EQ(motorOn(*links[0]).knowledge().profile(), before) << "of its own place";
}

TEST_F(SessionLines, WhatANewerVersionHasKeptOfADeviceIsStillThereAfterThisOneHasKeptMore)
{
    const std::string profiles = folder.path().toStdString() + "/profiles";
    memory.keepProfiles(profiles);
    motorOn(*links[0]).knowledge().setCounter("saves", 7);
    devices.forget(*links[0]);
    QFile file(QDir(QString::fromStdString(profiles)).entryInfoList(QDir::Files).at(0).filePath());
    ASSERT_TRUE(file.open(QIODevice::WriteOnly | QIODevice::Truncate));
    file.write(R"({"verdicts": {"direction": "slips", "ch1.direction": "agrees"}, "wear": {"brush": [1, 2]}})");
    file.close();
    WiredMotor &motor = motorOn(*links[0]);
    motor.knowledge().setVerdict("ch1.direction", DirectionVerdict::Reversed);
    motor.knowledge().setCounter("saves", 8);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const QJsonObject kept = QJsonDocument::fromJson(file.readAll()).object();
    file.close();
    EXPECT_EQ(kept["verdicts"]["direction"], QJsonValue("slips")) << "a word that only the newer one knows";
    EXPECT_EQ(kept["verdicts"]["ch1.direction"], QJsonValue("reversed"));
    EXPECT_EQ(kept["wear"]["brush"].toArray(), QJsonArray({1, 2}));
    EXPECT_EQ(kept["counters"]["saves"], QJsonValue(8));
    motor.knowledge().setVerdict("direction", DirectionVerdict::Agrees);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_EQ(QJsonDocument::fromJson(file.readAll())["verdicts"]["direction"], QJsonValue("agrees"))
        << "found out anew";
}

TEST_F(SessionLines, OfTwoDevicesWithOneNumberEachHasItsOwnProfile)
{
    memory.keepProfiles(folder.path().toStdString() + "/profiles");
    const auto duplicate = [this](int session, const std::vector<Device *> &seen = {}) -> Device & {
        Identity identity;
        identity.family = "wired";
        identity.address = 3;
        identity.session = session;
        identity.state = DeviceState::Duplicate;
        return devices.adopt(*links[0], wiredFamily, identity, seen);
    };
    Device &first = duplicate(0x12);
    first.knowledge().setCounter("saves", 7);
    EXPECT_TRUE(duplicate(0x34, {&first}).knowledge().profile().isEmpty());
    devices.forget(*links[0]);
    EXPECT_EQ(duplicate(0x12).knowledge().profile().counters.at("saves"), 7);
}

TEST_F(SessionLines, WhatIsKeptIsOfThePlaceWhetherOrNotTheUnitHasToldItsSerialNumber)
{
    memory.keepProfiles(folder.path().toStdString() + "/profiles");
    WiredMotor &told = motorOn(*links[0]);
    Identity identity = told.identity();
    identity.serial = "A7";
    told.setIdentity(identity);
    told.knowledge().setCounter("saves", 7);
    devices.forget(*links[0]);
    EXPECT_EQ(motorOn(*links[0]).knowledge().profile().counters.at("saves"), 7) << "it has not told it yet";
}

TEST_F(SessionLines, UntilItIsOnTheDiskWhatIsKnownIsRecalledFromWhereItWaits)
{
    const std::string profiles = folder.path().toStdString() + "/profiles";
    test::HeldBackground background;
    memory.keepProfiles(profiles);
    memory.setBackground(&background);
    motorOn(*links[0]).knowledge().setCounter("saves", 7);
    motorOn(*links[0]).knowledge().setCounter("saves", 8);
    ASSERT_EQ(background.waiting(), 2U);
    EXPECT_FALSE(QFile::exists(QString::fromStdString(background.lane())));
    devices.forget(*links[0]);
    EXPECT_EQ(motorOn(*links[0]).knowledge().profile().counters.at("saves"), 8);
    const QString file = QString::fromStdString(background.lane());
    background.release();
    EXPECT_TRUE(QFile::exists(file));
    devices.forget(*links[0]);
    EXPECT_EQ(motorOn(*links[0]).knowledge().profile().counters.at("saves"), 8);
    ASSERT_TRUE(QFile::remove(file));
    devices.forget(*links[0]);
    EXPECT_TRUE(motorOn(*links[0]).knowledge().profile().isEmpty()) << "nothing waits any more";
}

TEST_F(SessionLines, AProfileThatCannotBeKeptOrReadIsToldInOneLine)
{
    QFile letter(folder.filePath("letter"));
    ASSERT_TRUE(letter.open(QIODevice::WriteOnly));
    const std::string below = folder.filePath("letter/profiles").toStdString();
    std::vector<std::string> told;
    const auto listening
        = memory.profileTrouble().add([&told](const Message &text) { told.push_back(text.english()); });
    memory.keepProfiles(below);
    WiredMotor &motor = motorOn(*links[0]);
    told.clear();
    const std::string cause = ProfileBook(below).save("x", {}).error().text();
    motor.knowledge().setCounter("saves", 7);
    EXPECT_EQ(told, std::vector<std::string>{cause});
    test::HeldBackground background;
    memory.setBackground(&background);
    motor.knowledge().setCounter("saves", 8);
    EXPECT_EQ(told.size(), 1U);
    background.release();
    EXPECT_EQ(told, (std::vector<std::string>{cause, cause}));
    memory.setBackground(nullptr);
    memory.keepProfiles(folder.filePath("profiles").toStdString());
    motor.knowledge().setCounter("saves", 9);
    EXPECT_EQ(told.size(), 2U);
    const QDir kept(folder.filePath("profiles"));
    const QStringList files = kept.entryList(QDir::Files);
    ASSERT_EQ(files.size(), 1);
    QFile damaged(kept.filePath(files.front()));
    ASSERT_TRUE(damaged.open(QIODevice::WriteOnly | QIODevice::Truncate));
    damaged.write("no JSON at all");
    damaged.close();
    devices.forget(*links[0]);
    EXPECT_TRUE(motorOn(*links[0]).knowledge().profile().isEmpty());
    EXPECT_EQ(told.size(), 3U);
}

TEST_F(SessionLines, AProfileThatTheDiskRefusedIsRecalledAndWrittenOnceTheDiskTakesIt)
{
    for (const bool inBackground : {false, true}) {
        const QString letter = folder.filePath(inBackground ? "letter1" : "letter0");
        QFile file(letter);
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        test::HeldBackground background;
        memory.setBackground(inBackground ? &background : nullptr);
        memory.keepProfiles(letter.toStdString() + "/profiles");
        motorOn(*links[0]).knowledge().setCounter("saves", 7);
        background.release();
        devices.forget(*links[0]);
        EXPECT_EQ(motorOn(*links[0]).knowledge().profile().counters.at("saves"), 7);
        ASSERT_TRUE(QFile::remove(letter));
        clock.advance(std::chrono::seconds(11));
        background.release();
        const QStringList kept = QDir(letter + "/profiles").entryList(QDir::Files);
        EXPECT_EQ(kept.size(), 1) << inBackground;
        devices.forget(*links[0]);
        EXPECT_EQ(motorOn(*links[0]).knowledge().profile().counters.at("saves"), 7);
        devices.forget(*links[0]);
        memory.setBackground(nullptr);
    }
}

TEST_F(SessionLines, WhoWaitsForTheDiskIsToldWhatBecameOfTheProfile)
{
    QFile letter(folder.filePath("letter"));
    ASSERT_TRUE(letter.open(QIODevice::WriteOnly));
    test::HeldBackground background;
    memory.setBackground(&background);
    memory.keepProfiles(folder.filePath("letter/profiles").toStdString());
    WiredMotor &motor = motorOn(*links[0]);
    std::vector<Result<void>> told;
    Scope asking(clock);
    const auto ask = [&] {
        asking.spawn<void>(motor.knowledge().kept(), [&told](const Result<void> &kept) { told.push_back(kept); });
        clock.advance(std::chrono::milliseconds(1));
    };
    const auto answer = [&] {
        background.release();
        clock.advance(std::chrono::milliseconds(1));
        return told.back() ? Fault{} : told.back().error().fault;
    };
    ask();
    ASSERT_EQ(told.size(), 1U) << "nothing waits to be written";
    EXPECT_TRUE(told.back());
    motor.knowledge().setCounter("saves", 7);
    ask();
    EXPECT_EQ(told.size(), 1U);
    EXPECT_EQ(answer(), Fault::NotKept);
    ask();
    clock.advance(std::chrono::seconds(9));
    EXPECT_EQ(told.size(), 2U) << "it is tried again";
    clock.advance(std::chrono::seconds(2));
    ASSERT_EQ(told.size(), 3U) << "a disk that hangs keeps nothing";
    EXPECT_EQ(told.back().error().fault, Fault::NotKept);
    ASSERT_TRUE(letter.remove());
    ask();
    (void)answer();
    ASSERT_EQ(told.size(), 4U);
    EXPECT_TRUE(told.back());
}

TEST_F(SessionLines, WhatIsWrittenAfterTheSessionHasEndedIsWrittenAndTellsNobody)
{
    const std::string profiles = folder.path().toStdString() + "/profiles";
    test::HeldBackground background;
    WiredMotor &motor = motorOn(*links[0]);
    motor.knowledge().setCounter("saves", 7);
    auto ending = std::make_unique<SessionMemory>(clock);
    ending->keepProfiles(profiles);
    ending->setBackground(&background);
    ending->keep(motor);
    const QString file = QString::fromStdString(background.lane());
    ending.reset();
    background.release();
    EXPECT_TRUE(QFile::exists(file));
}

} // namespace
} // namespace mb
