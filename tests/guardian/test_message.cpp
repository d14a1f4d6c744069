// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/guardian/message.h"

#include <gtest/gtest.h>

#include <functional>

namespace mb::guardian {
namespace {

using namespace std::chrono_literals;

Order watchOrder()
{
    return {Order::Kind::Watch, 7, "serial:ttyUSB0/supermodified:4",
        {{{0x55, 0xAA, 4, 1, 0x1B, 0, 0x1B}, {0x55, 0xAA, 1, 4, 0x1B}, {255, 255, 255, 255, 127}, 40ms, 5},
            {{0}, {}, {}, 500ms, 100}}};
}

TEST(GuardianMessage, OrdersArriveAsTheyWereGiven)
{
    for (const Order &order : {watchOrder(), Order{Order::Kind::Renew, 1, {}, {}},
             Order{Order::Kind::Forget, 2, {}, {}}, Order{Order::Kind::Stop, 0xFFFFFFFF, {}, {}}})
        EXPECT_EQ(decodeOrder(encode(order)), order);
}

TEST(GuardianMessage, ReportsArriveAsTheyWereGiven)
{
    for (const Report &report : {Report{Report::Kind::Standing, 1, false}, Report{Report::Kind::Acted, 9, true},
             Report{Report::Kind::Refused, 0, false}})
        EXPECT_EQ(decodeReport(encode(report)), report);
}

TEST(GuardianMessage, AnythingCutOffOrTooLongIsNothing)
{
    const Bytes whole = encode(watchOrder());
    const std::size_t firstStepEnds
        = encode(Order{Order::Kind::Watch, 7, watchOrder().name, {watchOrder().script[0]}}).size();
    for (std::size_t size = 0; size < whole.size(); ++size) {
        if (size != firstStepEnds) {
            EXPECT_FALSE(decodeOrder(std::span(whole).first(size))) << size;
        }
    }
    Bytes longer = encode(Order{Order::Kind::Renew, 1, {}, {}});
    longer.push_back(0);
    EXPECT_FALSE(decodeOrder(longer));
    const Bytes report = encode(Report{});
    for (std::size_t size = 0; size < report.size(); ++size)
        EXPECT_FALSE(decodeReport(std::span(report).first(size)));
}

TEST(GuardianMessage, AScriptThatCannotBeCarriedOutIsRefused)
{
    const auto with = [](const std::function<void(Step &)> &change) {
        Order order = watchOrder();
        change(order.script[0]);
        return decodeOrder(encode(order));
    };
    EXPECT_TRUE(with([](Step &) {}));
    EXPECT_FALSE(with([](Step &step) { step.bytes.clear(); })) << "nothing to send";
    EXPECT_FALSE(with([](Step &step) { step.mask.pop_back(); })) << "mask and reply differ in length";
    EXPECT_FALSE(with([](Step &step) { step.wait = 0ms; }));
    EXPECT_FALSE(with([](Step &step) { step.wait = 501ms; }));
    EXPECT_FALSE(with([](Step &step) { step.attempts = 0; }));
    EXPECT_FALSE(with([](Step &step) { step.attempts = 101; }));
    EXPECT_FALSE(decodeOrder(encode(Order{Order::Kind::Watch, 1, "empty", {}})));
    Bytes unknown = encode(Order{Order::Kind::Stop, 1, {}, {}});
    unknown[0] = 4;
    EXPECT_FALSE(decodeOrder(unknown));
}

} // namespace
} // namespace mb::guardian
