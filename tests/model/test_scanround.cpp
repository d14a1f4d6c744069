// SPDX-License-Identifier: GPL-3.0-or-later
// One scan of a link: what a family is told, and what it tells.
#include "support/mutedevice.h"
#include "support/simulatedsession.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

namespace mb {
namespace {

constexpr std::array scannedLinks{LinkKind::Can};
constexpr std::array<std::string_view, 1> scannedBench{"dmc60c:5"};

struct ScanTold {
    std::vector<int> known;
    std::vector<int> remembered;
    ScanExtent extent = ScanExtent::Usual;
    int scans = 0;
    int probes = 0;
    std::optional<Error> fails;
};
ScanTold toldToFamily;
const Family *scannedFamily = nullptr;

class ScannedDevice final : public test::MuteDevice {
public:
    ScannedDevice(Link &link, Clock &clock, const Identity &identity)
        : MuteDevice(*scannedFamily, link, clock, identity)
    {
    }

private:
    Result<void> doCommand(const SetPoint &) override { return {}; }
    void doStop() override { }
    [[nodiscard]] bool isSeenStopped() const override { return true; }
};

void hear(ScanSink &sink)
{
    toldToFamily.known.clear();
    toldToFamily.remembered.clear();
    for (const Identity &identity : sink.known())
        toldToFamily.known.push_back(identity.address);
    for (const Identity &identity : sink.remembered())
        toldToFamily.remembered.push_back(identity.address);
    toldToFamily.extent = sink.extent();
    sink.leftOut(say("those behind the bridge"));
    sink.progress(say("number %1", 3), 3, 7);
}

Task<void> scanAll(Link &, Clock &, ScanSink &sink)
{
    ++toldToFamily.scans;
    hear(sink);
    if (toldToFamily.fails)
        co_return fail(*toldToFamily.fails);
    Identity identity;
    identity.family = "scanned";
    identity.address = 4;
    sink.found(identity);
    sink.found(identity);
    co_return {};
}

Task<void> askOne(Link &, Clock &, int address, ScanSink &sink)
{
    ++toldToFamily.probes;
    hear(sink);
    Identity identity;
    identity.family = "scanned";
    identity.address = address;
    sink.found(identity);
    co_return {};
}

struct ScanRounds : testing::Test {
    ScanRounds()
    {
        toldToFamily = {};
        family.key = "scanned";
        family.links = scannedLinks;
        family.bench = scannedBench;
        family.scan = scanAll;
        family.probe = askOne;
        family.open = [](Link &on, Clock &time, const Identity &identity) -> std::unique_ptr<Device> {
            return std::make_unique<ScannedDevice>(on, time, identity);
        };
        scannedFamily = &family;
        remarked = session.linkBook().remarked().add(
            [this](const Link &, const Message &text) { remarks.push_back(text.english()); });
    }
    Family family = *findFamily(families(), "dmc60c");
    VirtualClock clock;
    std::array<const Family *, 1> only{&family};
    Session session{clock, only};
    Link *link = *session.openLink(*LinkAddress::parse("sim:can"));
    std::vector<std::string> remarks;
    Subscription remarked;
};

TEST_F(ScanRounds, AFamilyIsToldWhomTheListHasAndHowFarToGoAndItsWordsArePassedOn)
{
    std::vector<std::string> steps;
    ScanOptions options;
    options.extent = ScanExtent::Everything;
    options.progress = [&steps](const Message &what, int done, int total) {
        steps.push_back(what.english() + ' ' + std::to_string(done) + '/' + std::to_string(total));
    };
    EXPECT_EQ(test::run(clock, session.scan(*link, options)).value().size(), 1U) << "told twice, found once";
    EXPECT_EQ(toldToFamily.known, std::vector<int>{});
    EXPECT_EQ(toldToFamily.extent, ScanExtent::Everything);
    EXPECT_EQ(steps, std::vector<std::string>{"number 3 3/7"});
    EXPECT_EQ(remarks, std::vector<std::string>{"those behind the bridge"});
    EXPECT_TRUE(test::run(clock, session.scan(*link)));
    EXPECT_EQ(toldToFamily.known, std::vector<int>{4});
    EXPECT_EQ(toldToFamily.extent, ScanExtent::Quick);
    EXPECT_EQ(steps.size(), 1U) << "nobody asked this time";
    EXPECT_EQ(remarks.size(), 1U);
}

TEST_F(ScanRounds, OneThatIsNamedIsAskedAloneAndWhatThatLeavesOutIsNotTold)
{
    const auto device = test::run(clock, session.connect(*DeviceSelector::parse("sim:can/scanned:9")));
    ASSERT_TRUE(device);
    EXPECT_EQ((*device)->identity().address, 9);
    EXPECT_EQ(toldToFamily.probes, 1);
    EXPECT_EQ(toldToFamily.scans, 0);
    EXPECT_EQ(toldToFamily.remembered, std::vector<int>{9});
    EXPECT_EQ(remarks, std::vector<std::string>{});
    family.probe = nullptr;
    ASSERT_TRUE(test::run(clock, session.connect(*DeviceSelector::parse("sim:can/scanned:4"))));
    EXPECT_EQ(toldToFamily.scans, 1);
    EXPECT_EQ(toldToFamily.remembered, std::vector<int>{4}) << "he is asked first";
}

TEST_F(ScanRounds, FailsWithWhatAFamilyFailedWith)
{
    toldToFamily.fails = Error{Fault::LinkLost, say("the cable is out")};
    const auto found = test::run(clock, session.scan(*link));
    ASSERT_FALSE(found);
    EXPECT_EQ(found.error(), *toldToFamily.fails);
    family.probe = nullptr;
    const auto named = test::run(clock, session.connect(*DeviceSelector::parse("sim:can/scanned:4")));
    ASSERT_FALSE(named);
    EXPECT_EQ(named.error(), *toldToFamily.fails);
}

TEST_F(ScanRounds, OfALinkThatNoFamilySpeaksEndsAtOnceWithNobody)
{
    family.links = {};
    EXPECT_EQ(test::run(clock, session.scan(*link)).value(), std::vector<Device *>{});
    EXPECT_EQ(toldToFamily.scans, 0);
}

} // namespace
} // namespace mb
