// SPDX-License-Identifier: GPL-3.0-or-later
// What scans leave for the next run of the program.
#include "model/registry.h"
#include "support/heldbackground.h"
#include "support/pseudoterminal.h"
#include "support/simulatedsession.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

namespace mb {
namespace {

Identity node(int address, const char *baud)
{
    Identity identity;
    identity.family = "supermodified";
    identity.address = address;
    identity.dialect = "D1";
    identity.descriptors = {{"baud", baud}};
    return identity;
}

class Scans : public testing::Test {
protected:
    /// Puts a text in place of what was kept.
    void spoil(const std::string &which, const char *text)
    {
        ASSERT_TRUE(book.save(which, {node(4, "57600")}));
        QFile file(QString::fromStdString(book.pathOf(which)));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly | QIODevice::Truncate));
        file.write(text);
    }
    QTemporaryDir folder;
    ScanBook book{folder.path().toStdString() + "/below"};
    const std::string link = "serial:/dev/ttyUSB0";
};

TEST_F(Scans, WhatIsKeptComesBackAndNobodyWithoutAFile)
{
    EXPECT_TRUE(book.load(link).value().empty());
    const std::vector<Identity> seen{node(4, "57600"), node(90, "9600")};
    ASSERT_TRUE(book.save(link, seen));
    EXPECT_EQ(book.load(link).value(), seen);
    EXPECT_TRUE(book.load("serial:/dev/ttyUSB1").value().empty());
}

TEST_F(Scans, NumbersFrom0To65536AreAddresses)
{
    const std::vector<Identity> seen{node(0, "57600"), node(65536, "57600")};
    ASSERT_TRUE(book.save(link, seen));
    EXPECT_EQ(book.load(link).value(), seen);
}

TEST_F(Scans, ADamagedFileIsToldAndReplacedByTheNextScan)
{
    for (const char *text : {"", "{", "[]", "{\"devices\": 3}", "{\"link\": \"serial:/dev/ttyUSB0\"}",
             "{\"link\": \"serial:/dev/ttyUSB0\", \"devices\": [7]}",
             "{\"link\": \"serial:/dev/ttyUSB0\", \"devices\": [{\"family\": \"x\", \"address\": -1}]}",
             "{\"link\": \"serial:/dev/ttyUSB0\", \"devices\": [{\"family\": \"x\", \"address\": 65537}]}",
             "{\"link\": \"serial:/dev/ttyUSB0\", \"devices\": [{\"address\": 1}]}",
             "{\"link\": \"another\", \"devices\": []}",
             "{\"link\": \"another\", \"link\": \"serial:/dev/ttyUSB0\", \"devices\": []}"}) {
        spoil(link, text);
        const auto loaded = book.load(link);
        ASSERT_FALSE(loaded) << text;
        EXPECT_EQ(loaded.error().fault, Fault::OutOfRange);
        ASSERT_TRUE(book.save(link, {node(4, "57600")}));
        EXPECT_EQ(book.load(link).value().size(), 1U);
    }
}

TEST_F(Scans, AFileOfMoreThanAMegabyteIsNoneOfOurs)
{
    ASSERT_TRUE(book.save(link, {node(4, "57600")}));
    QFile file(QString::fromStdString(book.pathOf(link)));
    ASSERT_TRUE(file.open(QIODevice::Append));
    file.write(QByteArray((1 << 20) - static_cast<int>(file.size()), ' '));
    file.flush();
    EXPECT_EQ(book.load(link).value().size(), 1U);
    file.write(" ");
    file.flush();
    EXPECT_FALSE(book.load(link));
}

std::vector<Identity> answering;  ///< to the scans of `family`
std::vector<Identity> remembered; ///< what its last scan was told

Task<void> scanOf(Link &, Clock &, ScanSink &sink)
{
    remembered = sink.remembered();
    for (const Identity &identity : answering)
        sink.found(identity);
    co_return {};
}

Task<void> probeOf(Link &link, Clock &clock, int, ScanSink &sink)
{
    co_await scanOf(link, clock, sink);
    co_return {};
}

/// The serial family with scans that need no wire.
const Family &quickFamily()
{
    static const Family family = [] {
        Family made;
        for (const Family *candidate : families()) {
            if (candidate->key == "supermodified")
                made = *candidate;
        }
        made.scan = scanOf;
        made.probe = probeOf;
        return made;
    }();
    return family;
}

/// One run of the program.
struct Program {
    explicit Program(const std::string &directory)
    {
        session.memory().keepScans(directory);
        told = session.memory().scanTrouble().add([this](const Message &text) { troubles.push_back(text.english()); });
    }
    void scan(const std::string &link)
    {
        const auto opened = session.openLink(*LinkAddress::parse(link));
        ASSERT_TRUE(opened) << opened.error().text();
        EXPECT_TRUE(test::run(clock, session.scan(**opened)));
    }
    const std::array<const Family *, 1> only{&quickFamily()};
    VirtualClock clock;
    Session session{clock, only};
    Subscription told;
    std::vector<std::string> troubles;
};

TEST_F(Scans, ASessionTellsTheNextOneWhoWasThere)
{
    const test::PseudoTerminal port;
    const std::string address = "serial:" + port.path();
    answering = {node(4, "57600"), node(90, "9600")};
    Program(folder.path().toStdString()).scan(address);
    EXPECT_TRUE(remembered.empty());
    answering = {node(90, "9600")};
    Program(folder.path().toStdString()).scan(address);
    EXPECT_EQ(remembered, (std::vector<Identity>{node(4, "57600"), node(90, "9600")}));
    answering = {};
    Program(folder.path().toStdString()).scan(address);
    EXPECT_EQ(remembered, (std::vector<Identity>{node(90, "9600")})) << "who did not answer is forgotten";
    Program(folder.path().toStdString()).scan(address);
    EXPECT_EQ(remembered.size(), 1U) << "but a dead line makes nobody forgotten";
}

TEST_F(Scans, AskingForOneDeviceForgetsNobody)
{
    const test::PseudoTerminal port;
    const std::string address = "serial:" + port.path();
    answering = {node(4, "57600"), node(5, "57600")};
    Program(folder.path().toStdString()).scan(address);
    answering = {node(5, "9600")};
    Program program(folder.path().toStdString());
    ASSERT_TRUE(
        test::run(program.clock, program.session.connect(*DeviceSelector::parse(address + "/supermodified:5"))));
    program.scan(address);
    EXPECT_EQ(remembered, (std::vector<Identity>{node(4, "57600"), node(5, "9600")}));
}

/// What was meant for the unit before must not be written to it.
TEST_F(Scans, AUnitIsThatOfTheSerialNumberWithWhichAScanFoundIt)
{
    Program program(folder.path().toStdString());
    const auto found = [&program](const char *serial) {
        answering = {node(4, "57600")};
        answering[0].serial = serial;
        program.scan("sim:serial");
        EXPECT_EQ(program.session.devices().size(), 1U);
        return program.session.idOf(*program.session.devices().front());
    };
    const DeviceId first = found("A7");
    const DeviceId second = found("A8");
    EXPECT_NE(second, first);
    EXPECT_EQ(found("A7"), first);
    EXPECT_EQ(found("A8"), second);
}

TEST_F(Scans, ASessionWarnsOnceOfADamagedFileAndGoesOn)
{
    const test::PseudoTerminal port;
    const std::string address = "serial:" + port.path();
    answering = {};
    book = ScanBook(folder.path().toStdString());
    spoil(address, "no JSON at all");
    Program program(folder.path().toStdString());
    program.scan(address);
    program.scan(address);
    EXPECT_EQ(program.troubles.size(), 1U);
    EXPECT_TRUE(remembered.empty());
    answering = {node(4, "57600")};
    program.scan(address);
    EXPECT_EQ(program.troubles.size(), 1U);
    EXPECT_EQ(book.load(address).value().size(), 1U);
}

TEST_F(Scans, InTheBackgroundWhoAnsweredIsKeptLaterAndATroubleIsToldOnce)
{
    const test::PseudoTerminal port;
    const std::string address = "serial:" + port.path();
    answering = {node(4, "57600")};
    test::HeldBackground background;
    {
        Program program(folder.path().toStdString());
        program.session.setBackground(&background);
        program.scan(address);
        ASSERT_EQ(background.waiting(), 1U);
        const ScanBook kept(folder.path().toStdString());
        EXPECT_EQ(background.lane(), kept.pathOf(address));
        EXPECT_EQ(kept.load(address).value().size(), 0U);
        background.release();
        EXPECT_EQ(kept.load(address).value(), answering);
    }
    background.release();
    const std::string below = folder.filePath("letter/scans").toStdString();
    QFile letter(folder.filePath("letter"));
    ASSERT_TRUE(letter.open(QIODevice::WriteOnly));
    const std::vector<std::string> told{below + " cannot be made; check the rights of the folder above it"};
    Program later(below);
    later.session.setBackground(&background);
    for (int round = 0; round < 2; ++round) {
        later.scan(address);
        EXPECT_EQ(later.troubles.size(), static_cast<std::size_t>(round));
        background.release();
        EXPECT_EQ(later.troubles, told) << "once of each link and cause";
    }
    later.session.closeLink(*later.session.links().front());
    background.release();
    Program atOnce(below);
    atOnce.scan(address);
    EXPECT_EQ(atOnce.troubles, told);
}

TEST_F(Scans, SimulatedLinksAndThoseWithoutAMemoryKeepNothing)
{
    answering = {node(4, "57600")};
    Program simulated(folder.path().toStdString());
    simulated.scan("sim:serial");
    simulated.scan("sim:serial");
    EXPECT_TRUE(remembered.empty());
    EXPECT_TRUE(QDir(folder.path()).isEmpty());
}

} // namespace
} // namespace mb
