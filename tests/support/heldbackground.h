// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/background.h"

#include <deque>

namespace mb::test {

/// A background in which nothing gets on until the test says so: drivers that do not answer, disks that are slow.
class HeldBackground final : public Background {
public:
    void run(const std::string &lane, std::function<void()> work, std::function<void()> done) override
    {
        m_jobs.push_back({lane, std::move(work), std::move(done)});
    }
    [[nodiscard]] std::size_t waiting() const { return m_jobs.size(); }
    [[nodiscard]] const std::string &lane() const { return m_jobs.front().lane; }
    /// Everything that waits gets done.
    void release()
    {
        while (!m_jobs.empty()) {
            Job job = std::move(m_jobs.front());
            m_jobs.pop_front();
            job.work();
            job.work = nullptr;
            job.done();
        }
    }

private:
    struct Job {
        std::string lane;
        std::function<void()> work;
        std::function<void()> done;
    };
    std::deque<Job> m_jobs;
};

} // namespace mb::test
