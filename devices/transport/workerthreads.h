// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/background.h"

#include <chrono>
#include <list>
#include <memory>
#include <string>

class QThread;

namespace mb {

class Mailbox;

/// A thread for each lane in which there is something to do. Threads of Qt, because a serial port that is opened there needs one.
class WorkerThreads final : public Background {
public:
    /// `home` is drained by the thread that calls run(), and outlives this.
    explicit WorkerThreads(Mailbox &home, std::chrono::milliseconds endLimit = std::chrono::seconds(3));
    /// Waits for what is being done, `endLimit` a lane at most; what hangs longer is left to the end of the process.
    ~WorkerThreads() override;

    void run(const std::string &lane, std::function<void()> work, std::function<void()> done) override;

private:
    struct Shared;

    std::shared_ptr<Shared> m_shared;
    std::list<std::unique_ptr<QThread>> m_threads;
    std::chrono::milliseconds m_endLimit;
};

} // namespace mb
