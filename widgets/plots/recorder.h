// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/rollingrecorder.h"
#include "widgets/common/workbench.h"

#include <QTimer>

#include <condition_variable>
#include <mutex>
#include <thread>

namespace mb {

/// The file of a recording that is saved now, in a folder, which is made. It is there and empty, so that nobody else takes its name.
[[nodiscard]] QString recordingIn(const QString &folder);

/// The recording that always runs: writes to disk in a thread of its own what devices send, twice a second. GUI thread.
class Recorder : public QObject {
    Q_OBJECT
public:
    struct State {
        bool keeping = false;
        bool saving = false;
        std::uint64_t bytes = 0;
        std::uint64_t samples = 0;
        double since = 0.0; ///< key of the oldest sample on disk
        QString failure;    ///< why nothing is written
    };
    /// `folder`: where all runs keep theirs. Reports recordings of runs that were killed to the workbench.
    Recorder(Workbench &workbench, const QString &folder, QObject *parent = nullptr);
    /// Writes what is recorded up to now; what was kept and not saved goes where startKeeping() said. Where it cannot, the next
    /// start recovers it.
    ~Recorder() override;

    [[nodiscard]] State state() const;
    [[nodiscard]] Duration kept() const { return m_options.keep; }
    /// `folder`: for a file of its own, where nobody saves it before this ends.
    void startKeeping(const QString &folder);
    /// Joins the last minutes before startKeeping() and everything since into a file; saved() follows.
    void save(const QString &path);
    void note(Instant time, const QString &text);

Q_SIGNALS:
    void changed();
    void saved(const QString &path, const QString &error);

private:
    void work();
    void recover();
    void follow();
    void saveKept(RollingRecorder &recorder) const;
    void post(std::function<void(RollingRecorder &)> order);
    void tell(const QString &failure);

    Workbench &m_workbench;
    RollingRecorder::Options m_options;
    QTimer m_follow;
    mutable std::mutex m_mutex; ///< guards the rest
    std::condition_variable m_wake;
    /// While a disk hangs only what is another set of channels waits with the one before.
    struct Following {
        std::vector<ExportChannel> channels;
        std::vector<std::pair<std::string, mcap::Map>> about;
    };
    std::vector<Following> m_following;
    std::vector<std::function<void(RollingRecorder &)>> m_orders;
    State m_state;
    Instant m_now{};
    Duration m_unixOffset{};
    SleepLog m_sleeps;
    bool m_end = false;
    QString m_keepFolder;
    std::thread m_thread;
};

} // namespace mb
