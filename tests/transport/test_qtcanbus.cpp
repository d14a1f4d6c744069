// SPDX-License-Identifier: GPL-3.0-or-later
// Links on QtSerialBus, by its plugin "virtualcan": frames pass a server on this computer that the first link brings up.
#include "support/eventloop.h"
#include "transport/backends/qtcanbus.h"
#include "transport/canlink.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <unistd.h>

namespace mb {
namespace {

using namespace std::chrono_literals;

class QtCanBus : public testing::Test {
protected:
    void SetUp() override
    {
        const auto adapters = qtCanAdapters();
        if (std::none_of(adapters.begin(), adapters.end(),
                [](const QtCanAdapter &adapter) { return adapter.path == "virtualcan:can0"; }))
            GTEST_SKIP() << "QtSerialBus has no plugin virtualcan here";
        near = made("");
        far = made("?bitrate=250000");
        ASSERT_TRUE(near->open());
        ASSERT_TRUE(far->open());
        m_hearing = far->received().add([this](const CanFrame &frame) { heard.push_back(frame); });
        // Until both are known to the server, it carries nothing.
        Timer hello(loop.clock());
        const std::function<void()> greet = [&] {
            (void)near->send(standardFrame(0x7FF, std::vector<std::uint8_t>{}));
            hello.startIn(20ms, greet);
        };
        greet();
        ASSERT_TRUE(loop.runUntil([this] { return !heard.empty(); }));
        hello.stop();
        loop.runUntil([] { return false; }, 50ms);
        heard.clear();
    }
    std::unique_ptr<CanLink> made(const std::string &options)
    {
        const int port = 20000 + ::getpid() % 20000; // the usual one may be somebody's
        auto link = makeQtCanLink(
            LinkAddress::parse("qtcan:virtualcan:tcp://127.0.0.1:" + std::to_string(port) + "/can0" + options).value(),
            loop.clock());
        EXPECT_TRUE(link);
        return std::unique_ptr<CanLink>(static_cast<CanLink *>(link->release()));
    }
    bool hears(std::size_t count)
    {
        return loop.runUntil([this, count] { return heard.size() >= count; });
    }

    void carryEveryKind();
    void carryHundreds();
    void closeAndOpenAgain();

    test::EventLoop loop;
    std::unique_ptr<CanLink> near;
    std::unique_ptr<CanLink> far;
    std::vector<CanFrame> heard;

private:
    Subscription m_hearing;
};

void QtCanBus::carryEveryKind()
{
    CanFrame remote = standardFrame(0x77, std::vector<std::uint8_t>{});
    remote.remote = true;
    ASSERT_TRUE(near->send(extendedFrame(0x02061405, {1, 2, 3})));
    ASSERT_TRUE(near->send(extendedFrame(0x5, {})));
    ASSERT_TRUE(near->send(standardFrame(0x7FF, std::vector<std::uint8_t>{1, 2, 3, 4, 5, 6, 7, 0xFF})));
    ASSERT_TRUE(near->send(remote));
    ASSERT_TRUE(hears(4));
    EXPECT_EQ(toText(heard[0]), "02061405#010203");
    EXPECT_EQ(toText(heard[1]), "00000005#");
    EXPECT_EQ(toText(heard[2]), "7FF#01020304050607FF");
    EXPECT_EQ(toText(heard[3]), "077#R");
    for (std::size_t i = 0; i < heard.size(); ++i) {
        EXPECT_LE(heard[i].time, loop.clock().now());
        EXPECT_GT(heard[i].time, loop.clock().now() - 20s);
        if (i > 0) {
            EXPECT_GE(heard[i].time, heard[i - 1].time);
        }
    }
    EXPECT_EQ(far->counters().errors, 0U);
}

void QtCanBus::carryHundreds()
{
    for (std::uint32_t id = 0; id < 300; ++id)
        ASSERT_TRUE(near->send(standardFrame(id, std::vector<std::uint8_t>{static_cast<std::uint8_t>(id)})));
    ASSERT_TRUE(hears(300));
    for (std::uint32_t id = 0; id < 300; ++id)
        EXPECT_EQ(heard[id].id, id);
    EXPECT_EQ(near->backlog(), 0U);
}

/// What is sent before the plugin has its connection waits for it.
void QtCanBus::closeAndOpenAgain()
{
    near->close();
    EXPECT_EQ(near->state(), LinkState::Closed);
    EXPECT_FALSE(near->send(standardFrame(1, std::vector<std::uint8_t>{})));
    ASSERT_TRUE(near->open());
    for (std::uint8_t number = 1; number <= 50; ++number)
        ASSERT_TRUE(near->send(standardFrame(number % 2, std::vector<std::uint8_t>{number})));
    EXPECT_EQ(near->backlog(), 50U);
    ASSERT_TRUE(near->send(standardFrame(1, std::vector<std::uint8_t>{0xEE}), Priority::Urgent));
    EXPECT_EQ(near->backlog(), 26U) << "it takes the older ones of its identifier with it";
    ASSERT_TRUE(hears(26));
    EXPECT_EQ(toText(heard[0]), "001#EE") << "and goes first";
    for (std::size_t i = 1; i < 26; ++i) {
        EXPECT_EQ(heard[i].id, 0U);
        EXPECT_EQ(heard[i].data[0], 2 * i);
    }
    EXPECT_EQ(near->backlog(), 0U);
    near->close();
    ASSERT_TRUE(near->open());
    ASSERT_TRUE(near->send(standardFrame(3, std::vector<std::uint8_t>{})));
    EXPECT_EQ(near->backlog(), 1U);
    near->close();
    EXPECT_EQ(near->backlog(), 0U);
    EXPECT_EQ(loop.clock().armed(), 0U) << "nothing is tried again";
}

// One test: the plugin's server lives as long as the process, and the event loop that serves it only as long as a test.
TEST_F(QtCanBus, CarriesFramesOfEveryKindInTheirOrderUrgentOnesFirst)
{
    carryEveryKind();
    heard.clear();
    carryHundreds();
    heard.clear();
    closeAndOpenAgain();
}

TEST(QtCanBusAddress, APluginOrAnInterfaceThatIsNotThereIsNamed)
{
    test::EventLoop loop;
    auto plugin = makeQtCanLink(LinkAddress::parse("qtcan:nosuch:can0").value(), loop.clock());
    ASSERT_TRUE(plugin);
    const auto opened = (*plugin)->open();
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().fault, Fault::LinkLost);
    EXPECT_TRUE(opened.error().text().starts_with("there is no CAN plugin nosuch")) << opened.error().text();
    EXPECT_EQ((*plugin)->state(), LinkState::Closed);
    for (const char *wrong : {"qtcan:virtualcan", "qtcan::can0", "qtcan:virtualcan:", "qtcan:virtualcan:can0?bitrate=0",
             "qtcan:virtualcan:can0?bitrate=-5", "qtcan:virtualcan:can0?speed=5"}) {
        const auto address = LinkAddress::parse(wrong);
        if (!address)
            continue;
        const auto link = makeQtCanLink(*address, loop.clock());
        ASSERT_FALSE(link) << wrong;
        EXPECT_EQ(link.error().fault, Fault::OutOfRange) << wrong;
    }
    EXPECT_TRUE(makeQtCanLink(LinkAddress::parse("qtcan:virtualcan:can0?bitrate=1").value(), loop.clock()));
}

TEST(QtCanBusAdapters, APluginWithoutAdapterSaysWhatHelps)
{
    for (const QtCanAdapter &adapter : qtCanAdapters()) {
        const bool isPluginOnly = adapter.path.find(':') == std::string::npos;
        EXPECT_EQ(isPluginOnly, !adapter.missing.empty()) << adapter.path;
        EXPECT_EQ(isPluginOnly, !adapter.remedy.empty()) << adapter.path;
        if (isPluginOnly) {
            const std::string text = adapter.missing.english();
            EXPECT_TRUE(text.starts_with("the plugin " + adapter.path + " finds no adapter")) << text;
            EXPECT_EQ(text.find("()"), std::string::npos) << text;
            EXPECT_EQ(text.find(":)"), std::string::npos) << text;
        }
    }
}

} // namespace
} // namespace mb
