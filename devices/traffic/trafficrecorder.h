// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/backgroundfile.h"
#include "async/noncopyable.h"
#include "async/sleeplog.h"
#include "transport/canlink.h"
#include "wire/framelog.h"

#include <memory>
#include <string>

namespace mb {

/// How a recording stands. Nothing is missing from the file when `lost` is 0.
struct RecordingState {
    std::string path;
    Instant since{};          ///< on the time line of the link
    std::uint64_t frames = 0; ///< that passed the link, both directions, error frames too
    std::uint64_t bytes = 0;  ///< of the file, once all that was taken is written
    std::uint64_t lost = 0;   ///< of them not in the file, and those that the link itself knows missing
    bool finished = false;    ///< the file is closed
    Message problem;          ///< why nothing more is written; empty while all is well

    friend bool operator==(const RecordingState &, const RecordingState &) = default;
};

/// Writes what passes a CAN link into a file, as `candump -L -x` does, or as Vector ASC where its name ends in `.asc`: times are
/// since 1970, R frames were received, T frames sent by this program. A thread of its own writes.
class TrafficRecorder : NonCopyable {
public:
    /// Unsupported for links that are not CAN. `clock` drives the writing and outlives this; `unixOffset` turns the link's time
    /// stamps into Unix time.
    [[nodiscard]] static Result<std::unique_ptr<TrafficRecorder>> start(
        Link &link, Clock &clock, Duration unixOffset, std::unique_ptr<BackgroundFile> file);
    /// The same into a file that it makes; LinkLost when that cannot be.
    [[nodiscard]] static Result<std::unique_ptr<TrafficRecorder>> start(
        Link &link, Clock &clock, Duration unixOffset, const std::string &path);
    /// Ends the recording and waits until it is on disk.
    ~TrafficRecorder();

    [[nodiscard]] RecordingState state() const;
    /// Ends the recording; state() is `finished` a little later.
    void stop();
    /// Ends it for good, and yields the file for somebody who can wait until it is on disk. Nothing else may follow.
    [[nodiscard]] std::shared_ptr<BackgroundFile> end();
    /// The file failed, or is finished: once each.
    [[nodiscard]] Listeners<> &changed() { return m_changed; }

private:
    TrafficRecorder(Link &link, Clock &clock, Duration unixOffset, std::unique_ptr<BackgroundFile> file);
    void take(const Traffic &traffic);
    void append();
    void tick();

    Clock &m_clock;
    SleepLog m_sleeps;
    std::shared_ptr<BackgroundFile> m_file;
    FrameLogWriter m_writer;
    Duration m_unixOffset; ///< without what the computer has slept
    std::string m_text;
    LoggedFrame m_frame;
    std::uint64_t m_frames = 0;
    std::uint64_t m_bytes = 0;
    std::uint64_t m_linkLost = 0; ///< since the start, as last seen
    std::uint64_t m_linkLostBefore = 0;
    Instant m_since{};
    bool m_told = false;
    bool m_stopped = false;
    Listeners<> m_changed;
    Timer m_tick;
    Subscription m_traffic;
    Subscription m_opened;
    Subscription m_batch;
};

} // namespace mb
