// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/workerthreads.h"

#include "async/mailbox.h"

#include <QThread>

#include <deque>
#include <map>
#include <mutex>

namespace mb {
namespace {

struct Job {
    std::function<void()> work;
    std::function<void()> done;
};

} // namespace

/// Outlives the object where a lane hangs.
struct WorkerThreads::Shared {
    std::mutex mutex;
    Mailbox *home = nullptr;
    std::map<std::string, std::deque<Job>> lanes; ///< those that have a thread

    /// The body of a lane's thread.
    void serve(const std::string &lane)
    {
        while (true) {
            Job job;
            {
                const std::lock_guard lock(mutex);
                std::deque<Job> &waiting = lanes[lane];
                if (waiting.empty()) {
                    lanes.erase(lane);
                    return;
                }
                job = std::move(waiting.front());
                waiting.pop_front();
            }
            job.work();
            job.work = nullptr;
            const std::lock_guard lock(mutex);
            if (home)
                home->post(std::move(job.done));
        }
    }
};

WorkerThreads::WorkerThreads(Mailbox &home, std::chrono::milliseconds endLimit)
    : m_shared(std::make_shared<Shared>())
    , m_endLimit(endLimit)
{
    m_shared->home = &home;
}

WorkerThreads::~WorkerThreads()
{
    {
        const std::lock_guard lock(m_shared->mutex);
        m_shared->home = nullptr;
    }
    for (auto &thread : m_threads) {
        if (!thread->wait(static_cast<unsigned long>(m_endLimit.count())))
            (void)thread.release(); // it may not be destroyed while it runs
    }
}

void WorkerThreads::run(const std::string &lane, std::function<void()> work, std::function<void()> done)
{
    m_threads.remove_if([](const std::unique_ptr<QThread> &thread) { return thread->isFinished(); });
    const std::lock_guard lock(m_shared->mutex);
    const auto [waiting, isNew] = m_shared->lanes.try_emplace(lane);
    waiting->second.push_back({std::move(work), std::move(done)});
    if (!isNew)
        return;
    m_threads.emplace_back(QThread::create([shared = m_shared, lane] { shared->serve(lane); }));
    m_threads.back()->start();
}

} // namespace mb
