// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/mailbox.h"
#include "transport/workerthreads.h"

#include <gtest/gtest.h>

#include <future>
#include <thread>
#include <vector>

#include <poll.h>

namespace mb {
namespace {

using namespace std::chrono_literals;

class Workers : public testing::Test {
protected:
    /// Serves what comes back until `done`; false when nothing came for twenty seconds.
    bool serveUntil(const std::function<bool()> &done)
    {
        while (!done()) {
            pollfd source{home.descriptor(), POLLIN, 0};
            if (::poll(&source, 1, 20'000) != 1)
                return false;
            home.drain();
        }
        return true;
    }

    Mailbox home;
    WorkerThreads workers{home};
};

} // namespace

TEST_F(Workers, WorkIsDoneElsewhereAndItsEndIsToldHere)
{
    std::thread::id worked;
    std::thread::id told;
    workers.run(
        "a", [&worked] { worked = std::this_thread::get_id(); }, [&told] { told = std::this_thread::get_id(); });
    ASSERT_TRUE(serveUntil([&told] { return told != std::thread::id(); }));
    EXPECT_EQ(told, std::this_thread::get_id());
    EXPECT_NE(worked, std::this_thread::get_id());
}

TEST_F(Workers, ALaneThatHangsHoldsUpNothingButItself)
{
    std::promise<void> gate;
    std::vector<int> ended;
    workers.run(
        "hangs", [open = gate.get_future().share()] { open.wait(); }, [&ended] { ended.push_back(1); });
    workers.run(
        "hangs", [] {}, [&ended] { ended.push_back(2); });
    workers.run(
        "free", [] {}, [&ended] { ended.push_back(3); });
    ASSERT_TRUE(serveUntil([&ended] { return !ended.empty(); }));
    EXPECT_EQ(ended, (std::vector{3}));
    gate.set_value();
    ASSERT_TRUE(serveUntil([&ended] { return ended.size() == 3; }));
    EXPECT_EQ(ended, (std::vector{3, 1, 2})) << "in their order";
}

TEST_F(Workers, ALaneIsServedAgainAfterItWasEmpty)
{
    for (int round = 0; round < 50; ++round) {
        bool ended = false;
        workers.run(
            "a", [] {}, [&ended] { ended = true; });
        ASSERT_TRUE(serveUntil([&ended] { return ended; }));
    }
}

TEST(WorkerThreads, TheEndWaitsForWhatIsBeingWritten)
{
    Mailbox home;
    std::atomic<int> written = 0;
    {
        WorkerThreads workers(home);
        for (int i = 0; i < 20; ++i)
            workers.run(
                "disk", [&written] { ++written; }, [] { FAIL() << "nobody is there to be told"; });
    }
    EXPECT_EQ(written, 20);
}

} // namespace mb
