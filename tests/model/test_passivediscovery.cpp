// SPDX-License-Identifier: GPL-3.0-or-later
// What frames of a recording tell of a unit, joined: each has a part of what is known.
#include "model/passivediscovery.h"

#include <gtest/gtest.h>

namespace mb {
namespace {

/// A frame tells of unit 5: its session is the first byte, the second one the descriptor that it has, the third its text.
std::optional<Identity> tellUnit(const CanFrame &frame)
{
    Identity seen;
    seen.address = 5;
    seen.session = frame.data[0];
    if (frame.size > 2)
        seen.descriptors = {{std::string(1, static_cast<char>(frame.data[1])), std::to_string(frame.data[2])}};
    return seen;
}

Family familyOfUnit()
{
    Family family;
    family.recogniser = [] { return Recogniser(tellUnit); };
    return family;
}

struct Passive : testing::Test {
    void hear(std::initializer_list<std::uint8_t> bytes)
    {
        CanFrame frame;
        std::copy(bytes.begin(), bytes.end(), frame.data.begin());
        frame.size = static_cast<std::uint8_t>(bytes.size());
        discovery.take(frame, false);
    }

    const Family family = familyOfUnit();
    std::array<const Family *, 1> all{&family};
    std::vector<Identity> told;
    PassiveDiscovery discovery{all, [this](const Family &, const Identity &identity) { told.push_back(identity); }};
};

} // namespace

TEST_F(Passive, EachDescriptorStaysAndTakesItsNewestText)
{
    hear({1, 'a', 10});
    hear({1, 'b', 20});
    hear({1, 'b', 21});
    hear({1, 'b', 21}); // nothing new: nobody is told
    ASSERT_EQ(told.size(), 3U);
    using Entries = std::vector<std::pair<std::string, std::string>>;
    EXPECT_EQ(told[1].descriptors, (Entries{{"a", "10"}, {"b", "20"}}));
    EXPECT_EQ(told[2].descriptors, (Entries{{"a", "10"}, {"b", "21"}}));
}

TEST_F(Passive, AnotherSessionIsTheUnitAfterAPowerCycleAndOneThatReturnsASecondUnit)
{
    hear({1});
    hear({2});
    ASSERT_EQ(told.size(), 2U);
    EXPECT_EQ(told[1].session, 2);
    EXPECT_NE(told[1].state, DeviceState::Duplicate);
    hear({1});
    ASSERT_EQ(told.size(), 3U);
    EXPECT_EQ(told[2].state, DeviceState::Duplicate);
}

} // namespace mb
