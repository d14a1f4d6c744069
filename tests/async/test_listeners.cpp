// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/listeners.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

using namespace mb;

TEST(Listeners, AreCalledInTheOrderTheyCameWithTheArguments)
{
    Listeners<int> list;
    std::string log;
    const auto a = list.add([&log](int value) { log += "a" + std::to_string(value); });
    const auto b = list.add([&log](int value) { log += "b" + std::to_string(value); });
    list.notify(1);
    list.notify(2);
    EXPECT_EQ(log, "a1b1a2b2");
    EXPECT_EQ(list.size(), 2U);
}

TEST(Listeners, NotifyingAnEmptyListDoesNothing)
{
    const Listeners<> list;
    list.notify();
    EXPECT_EQ(list.size(), 0U);
}

TEST(Listeners, EndWithTheirSubscription)
{
    Listeners<> list;
    int calls = 0;
    {
        const auto subscription = list.add([&calls] { ++calls; });
        EXPECT_TRUE(subscription.isActive());
        list.notify();
    }
    list.notify();
    EXPECT_EQ(calls, 1);
    EXPECT_EQ(list.size(), 0U);
}

TEST(Listeners, RemovedWhileNotifyingAreNotCalledAnyMore)
{
    Listeners<> list;
    Subscription second;
    int calls = 0;
    const auto first = list.add([&second] { second.reset(); });
    second = list.add([&calls] { ++calls; });
    list.notify();
    EXPECT_EQ(calls, 0);
    EXPECT_EQ(list.size(), 1U);
}

TEST(Listeners, MayRemoveThemselves)
{
    Listeners<> list;
    Subscription self;
    int calls = 0;
    self = list.add([&] {
        self.reset();
        ++calls;
    });
    list.notify();
    list.notify();
    EXPECT_EQ(calls, 1);
}

TEST(Listeners, AddedWhileNotifyingAreCalledFromTheNextTimeOn)
{
    Listeners<> list;
    std::vector<Subscription> added;
    int calls = 0;
    const auto first = list.add([&] { added.push_back(list.add([&calls] { ++calls; })); });
    list.notify();
    EXPECT_EQ(calls, 0);
    list.notify();
    EXPECT_EQ(calls, 1);
}

TEST(Listeners, MayNotifyAgainAndRemoveInside)
{
    Listeners<int> list;
    std::string log;
    Subscription last;
    const auto first = list.add([&](int depth) {
        log += std::to_string(depth);
        if (depth == 0)
            list.notify(1);
        else
            last.reset();
    });
    last = list.add([&log](int) { log += 'x'; });
    list.notify(0);
    list.notify(2);
    EXPECT_EQ(log, "012");
}

TEST(Listeners, MayDestroyTheListThatNotifies)
{
    auto list = std::make_unique<Listeners<>>();
    int calls = 0;
    const auto first = list->add([&list] { list.reset(); });
    const auto second = list->add([&calls] { ++calls; });
    list->notify();
    EXPECT_EQ(list, nullptr);
    EXPECT_EQ(calls, 1);
}

TEST(Listeners, SubscriptionsOutliveTheList)
{
    Subscription left;
    {
        Listeners<> list;
        left = list.add([] {});
    }
    left.reset();
    EXPECT_FALSE(left.isActive());
}

TEST(Listeners, MovingASubscriptionKeepsItAndAssigningEndsTheOldOne)
{
    Listeners<> list;
    int a = 0;
    int b = 0;
    auto one = list.add([&a] { ++a; });
    auto two = list.add([&b] { ++b; });
    two = std::move(one);
    list.notify();
    EXPECT_EQ(a, 1);
    EXPECT_EQ(b, 0);
    EXPECT_EQ(list.size(), 1U);
}

TEST(Listeners, ACallbackMayOwnAnotherSubscriptionOfTheSameList)
{
    Listeners<> list;
    int calls = 0;
    auto inner = std::make_shared<Subscription>(list.add([&calls] { ++calls; }));
    auto outer = list.add([inner] {});
    inner.reset();
    list.notify();
    outer.reset();
    list.notify();
    EXPECT_EQ(calls, 1);
    EXPECT_EQ(list.size(), 0U);
}
