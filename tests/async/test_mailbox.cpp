// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/mailbox.h"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <thread>
#include <vector>

#include <poll.h>

using namespace mb;

namespace {

bool isReadable(const Mailbox &mailbox, int milliseconds = 0)
{
    pollfd wanted{mailbox.descriptor(), POLLIN, 0};
    return ::poll(&wanted, 1, milliseconds) == 1;
}

} // namespace

TEST(Mailbox, IsReadableOnlyWhileWorkWaits)
{
    Mailbox mailbox;
    EXPECT_FALSE(isReadable(mailbox));
    EXPECT_TRUE(mailbox.post([] {}));
    EXPECT_TRUE(mailbox.post([] {}));
    EXPECT_TRUE(isReadable(mailbox));
    mailbox.drain();
    EXPECT_FALSE(isReadable(mailbox));
}

TEST(Mailbox, RunsWorkInOrderAndWorkPostedMeanwhileNextTime)
{
    Mailbox mailbox;
    std::vector<int> log;
    mailbox.post([&] {
        log.push_back(1);
        mailbox.post([&log] { log.push_back(3); });
    });
    mailbox.post([&log] { log.push_back(2); });
    mailbox.drain();
    EXPECT_EQ(log, (std::vector{1, 2}));
    EXPECT_TRUE(isReadable(mailbox));
    mailbox.drain();
    EXPECT_EQ(log, (std::vector{1, 2, 3}));
}

TEST(Mailbox, RunsUrgentWorkBeforeEverythingThatWaitsAndInTheMiddleOfADrain)
{
    Mailbox mailbox;
    std::vector<int> log;
    mailbox.post([&] {
        log.push_back(2);
        mailbox.postUrgent([&log] { log.push_back(3); });
    });
    mailbox.post([&log] { log.push_back(4); });
    mailbox.postUrgent([&log] { log.push_back(1); });
    EXPECT_TRUE(isReadable(mailbox));
    mailbox.drain();
    EXPECT_EQ(log, (std::vector{1, 2, 3, 4}));
    EXPECT_TRUE(mailbox.postUrgent([&log] { log.push_back(5); }));
    EXPECT_TRUE(isReadable(mailbox)) << "alone, too";
    mailbox.close();
    EXPECT_FALSE(mailbox.postUrgent([] {}));
}

TEST(Mailbox, ClosedTakesNothingAndDropsWhatWaits)
{
    Mailbox mailbox;
    bool ran = false;
    const auto token = std::make_shared<int>(1);
    mailbox.post([&ran, token] { ran = true; });
    EXPECT_EQ(token.use_count(), 2);
    mailbox.close();
    EXPECT_EQ(token.use_count(), 1);
    EXPECT_FALSE(mailbox.post([&ran] { ran = true; }));
    mailbox.drain();
    EXPECT_FALSE(ran);
}

TEST(Mailbox, ClosedByItsOwnWorkRunsNothingAfterIt)
{
    Mailbox mailbox;
    bool ran = false;
    mailbox.post([&mailbox] { mailbox.close(); });
    mailbox.post([&ran] { ran = true; });
    mailbox.drain();
    EXPECT_FALSE(ran);
}

TEST(Mailbox, DroppedWorkMayPostWhileItIsDestroyed)
{
    Mailbox mailbox;
    std::shared_ptr<Mailbox> last(&mailbox, [](Mailbox *box) { box->post([] {}); });
    mailbox.post([last] {});
    last.reset();
    mailbox.close();
    EXPECT_FALSE(mailbox.post([] {}));
}

TEST(Mailbox, TakesWorkFromSeveralThreadsWithoutLossAndInTheOrderOfEach)
{
    constexpr int senders = 4;
    constexpr int each = 20'000;
    Mailbox mailbox;
    std::vector<int> next(senders, 0);
    int taken = 0;
    bool ordered = true;
    std::vector<std::thread> threads;
    for (int sender = 0; sender < senders; ++sender) {
        threads.emplace_back([&, sender] {
            for (int i = 0; i < each; ++i) {
                mailbox.post([&, sender, i] {
                    int &expected = next[static_cast<std::size_t>(sender)];
                    ordered = ordered && expected == i;
                    ++expected;
                    ++taken;
                });
            }
        });
    }
    while (taken < senders * each) {
        ASSERT_TRUE(isReadable(mailbox, 60'000)) << taken;
        mailbox.drain();
    }
    for (auto &thread : threads)
        thread.join();
    EXPECT_TRUE(ordered);
    EXPECT_FALSE(isReadable(mailbox));
}

TEST(Mailbox, ClosingWhileOthersPostLosesNothingSilently)
{
    Mailbox mailbox;
    std::atomic<int> accepted = 0;
    std::atomic<int> refused = 0;
    int ran = 0;
    std::vector<std::thread> threads;
    for (int sender = 0; sender < 3; ++sender) {
        threads.emplace_back([&] {
            while (refused == 0)
                ++(mailbox.post([&ran] { ++ran; }) ? accepted : refused);
        });
    }
    while (ran < 1000) {
        ASSERT_TRUE(isReadable(mailbox, 60'000));
        mailbox.drain();
    }
    mailbox.close();
    for (auto &thread : threads)
        thread.join();
    EXPECT_GE(refused, 1);
    EXPECT_GE(accepted, ran);
    const int before = ran;
    mailbox.drain();
    EXPECT_EQ(ran, before);
}

TEST(Mailbox, CarriesAnswersBackBetweenTwoThreads)
{
    Mailbox engine;
    Mailbox screen;
    bool stop = false;
    std::thread worker([&] {
        while (!stop) {
            if (isReadable(engine, 60'000))
                engine.drain();
        }
    });
    int answer = 0;
    for (int i = 1; i <= 1000; ++i) {
        engine.post([&screen, &answer, i] { screen.post([&answer, i] { answer = 2 * i; }); });
        while (answer != 2 * i) {
            ASSERT_TRUE(isReadable(screen, 60'000));
            screen.drain();
        }
    }
    engine.post([&stop] { stop = true; });
    worker.join();
    EXPECT_EQ(answer, 2000);
}
