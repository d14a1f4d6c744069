// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"

#include <QObject>
#include <QString>
#include <QThreadPool>

#include <functional>
#include <map>
#include <mutex>

namespace mb {

/// Does in a thread of its own what waits for a disk: the thread of the window renews the lease of a motion meanwhile. One after the
/// other; of what is ordered under one name only the newest is done. Nothing is lost when this goes: it waits for all, and
/// tells how it ended, so it is the last member of who is told. GUI thread.
class DiskThread : public QObject {
    Q_OBJECT
public:
    using Work = std::function<Result<void>()>; ///< in the other thread
    using Done = std::function<void(const Result<void> &result)>;

    DiskThread();
    ~DiskThread() override;

    /// Returns at once; `done` comes later, unless something newer of this name came first.
    void order(const QString &name, Work work, Done done);
    /// Until all is done and told.
    void finish();

private:
    struct Order {
        Work work;
        Done done;
    };
    void carryOut(const QString &name);

    std::mutex m_mutex;
    std::map<QString, Order> m_waiting;
    QThreadPool m_pool;
};

} // namespace mb
