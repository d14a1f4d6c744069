// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/noncopyable.h"
#include "async/sleeplog.h"
#include "recording/export.h"
#include "recording/mcapwriter.h"
#include "recording/samplecursor.h"

#include <list>
#include <map>

namespace mb {

/// The recording on disk that is there before anybody asks for it: everything that devices send goes into MCAP files of a
/// minute each, and those older than `keep` are removed, except while somebody wants to keep what comes. Written data
/// survives the end of the process, however it ends: see recoverRecordings(). One thread, not the engine's: it waits
/// for the disk.
class RollingRecorder : NonCopyable {
public:
    struct Options {
        std::string folder; ///< each run has its own folder in it
        std::string name;   ///< of this run's folder; must be new
        Duration keep = std::chrono::minutes(10);
        Duration segment = std::chrono::minutes(1);
        std::uint64_t mostBytes = 1ULL << 30U; ///< of what nobody asked to keep
    };
    explicit RollingRecorder(Options options);
    /// Ends the last file; the folder becomes `last-session`, in place of the one before, unless it is left. Where that cannot be it
    /// stays as that of a run that was killed.
    ~RollingRecorder();

    /// What there is now. Channels that went away stay in the files that have them, and are let go of once all of theirs is there;
    /// one in another unit, or of a unit with another serial number, is another channel.
    void follow(const std::vector<ExportChannel> &channels, std::vector<std::pair<std::string, mcap::Map>> about);
    /// Writes what has been recorded since and hands it to the kernel. NotKept with path and cause; nothing is lost as
    /// long as the histories have it: files end with their last whole sample, and the next call goes on behind it, in a new one.
    /// A folder that was taken away, or its disk, is told once, and made anew with what was in it, as far as the histories have that.
    /// Unix time is `unixOffset` of the first call: a clock that is set meanwhile leaves neither gaps nor times that go back.
    /// What the computer has slept since is added to what was recorded after it, behind a gap.
    [[nodiscard]] Result<void> write(Instant now, Duration unixOffset, const SleepLog &sleeps = {});
    /// The same with what is still settling: samples of several channels may be in another order than their times.
    [[nodiscard]] Result<void> writeAll(Instant now, Duration unixOffset, const SleepLog &sleeps = {});
    /// A note for the file.
    void note(Instant time, const std::string &text);

    /// From now on nothing is removed; what is there already (up to `keep` back) belongs to it.
    void startKeeping() { m_keeping = true; }
    [[nodiscard]] bool isKeeping() const { return m_keeping; }
    /// Joins everything since `keep` before startKeeping() into one file, and goes back to rolling. While samples wait for a disk that takes
    /// nothing it fails with that cause, and goes on keeping.
    [[nodiscard]] Result<ExportReport> save(const std::string &path, const ExportProgress &progress);

    /// What is kept could not be saved: the folder stays as that of a run that was killed, for recoverRecordings().
    void leave() { m_left = true; }

    [[nodiscard]] std::uint64_t bytes() const;
    [[nodiscard]] std::uint64_t samples() const;
    /// Source time of the oldest sample on disk.
    [[nodiscard]] std::optional<Instant> since() const;

private:
    struct Tracked {
        ExportChannel channel;
        SampleCursor cursor;
        std::size_t number = 0;          ///< of all that were ever tracked
        bool isApart = false;            ///< what comes next does not connect to what is in the file
        std::uint16_t id = 0;            ///< in the file that is being written
        SampleCursor::Place safe{};      ///< everything before it is in a file
        bool gone = false;               ///< nothing comes any more
        std::optional<Duration> slept{}; ///< by the time of the sample that was written last
    };
    struct Segment {
        std::string path;
        Instant begun{};
        Instant last{};
        std::uint64_t bytes = 0;
        std::uint64_t samples = 0;
        std::map<std::size_t, SampleCursor::Place>
            begins; ///< by Tracked::number: what is in front of it is in the files before
    };
    [[nodiscard]] Result<void> beginSegment(Instant now);
    [[nodiscard]] Result<void> endSegment();
    [[nodiscard]] Result<void> writeUntil(Instant now, Instant horizon);
    void followClock(Instant now, Duration unixOffset, const SleepLog &sleeps);
    [[nodiscard]] std::int64_t unixNanoseconds(Instant time) const;
    [[nodiscard]] Result<void> writeSegment(Instant now, Instant horizon);
    void addToFile(Tracked &tracked);
    void settle();
    void salvage();
    void writeSamples(Instant horizon);
    void prune(Instant now);
    [[nodiscard]] Result<void> missWhatIsGone();
    [[nodiscard]] Result<void> lockFolder();

    Options m_options;
    std::string m_path;
    int m_lock = -1;
    std::list<Tracked> m_tracked;
    std::vector<std::pair<std::string, mcap::Map>> m_about;
    std::vector<TimedNote> m_newNotes;
    std::unique_ptr<McapWriter> m_writer;
    std::list<Segment> m_segments;        ///< oldest first; the last is being written
    Segment m_safe;                       ///< of the last: what a full disk cannot take any more
    std::optional<Error> m_failure;       ///< of the last write
    std::optional<Duration> m_unixOffset; ///< without what the computer has slept
    SleepLog m_sleeps;
    std::size_t m_number = 0;
    std::size_t m_trackedEver = 0;
    bool m_keeping = false;
    bool m_left = false;
    bool m_aboutChanged = false;
};

} // namespace mb
