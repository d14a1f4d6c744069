// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/noncopyable.h"
#include "wire/framelog.h"

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace mb {

/// A log file (candump or Vector ASC, by content) as frames in the order of time. It is read in pieces, never as a
/// whole: a file of any length costs a buffer and one place to seek to for every 256 KiB. Blocks as long as the disk does.
class RecordingFile : NonCopyable {
public:
    /// `interface`: only frames of this one; empty: of all. LinkLost when there is no such file or it may not be read,
    /// OutOfRange when it is no recording or has no frame.
    [[nodiscard]] static Result<std::unique_ptr<RecordingFile>> open(const std::string &path, std::string interface);
    ~RecordingFile();

    /// The next frame to play; nothing at the end, or where a piece of the file had none (isReadingOn()): again then. Times never go back: a frame that is older than the one before gets
    /// the time of that.
    [[nodiscard]] Result<std::optional<LoggedFrame>> next();
    [[nodiscard]] bool isReadingOn() const { return m_readsOn; }
    /// next() goes on with the first frame at or after `time`. Not beyond what survey() has seen.
    [[nodiscard]] Result<void> seek(Duration time);

    /// Reads on for one piece, from where the last call ended, and shows every frame; true once the end is reached. A damaged
    /// line is an error that names it, and the recording ends there. A last line that was cut off is its end, and no error.
    [[nodiscard]] Result<bool> survey(const std::function<void(const LoggedFrame &)> &seen);
    /// What survey() has seen that is left out, or may not be whole, for people; empty: nothing.
    [[nodiscard]] Message remark() const { return m_surveyor.place.parser.remark(); }
    /// next() stopped before the end that survey() had seen: somebody changed the file meanwhile.
    [[nodiscard]] bool isCutShort() const { return m_surveyed && m_player.place.time < m_end; }
    [[nodiscard]] double surveyedFraction() const; ///< 0…1

    [[nodiscard]] Duration start() const { return m_start; } ///< of the first frame
    [[nodiscard]] Duration end() const { return m_end; }     ///< of the last frame that survey() has seen

private:
    /// A place in the file, and what the parser knew there.
    struct Place {
        std::uint64_t offset = 0;
        Duration time{};
        FrameLogParser parser;
    };
    struct Cursor {
        Place place; ///< of the line that `text` begins with, at `used`
        std::string text;
        std::size_t used = 0;
    };

    RecordingFile(std::string path, std::string interface, int descriptor);
    [[nodiscard]] Result<std::optional<std::string_view>> line(Cursor &cursor, bool &cut) const;
    /// The next frame that is wanted; nothing at the end, or where the line at `until` is reached without one.
    [[nodiscard]] Result<std::optional<LoggedFrame>> read(
        Cursor &cursor, std::uint64_t until = std::numeric_limits<std::uint64_t>::max()) const;
    [[nodiscard]] Error located(const Error &error) const { return error.about(m_path); }

    std::string m_path;
    std::string m_interface;
    int m_descriptor;
    std::uint64_t m_size = 0;
    Cursor m_player;
    std::optional<LoggedFrame> m_sought; ///< read by seek(), not yet by next()
    bool m_readsOn = false;
    Cursor m_surveyor;
    bool m_surveyed = false;
    Duration m_start{};
    Duration m_end{};
    std::vector<Place> m_places; ///< in the order of time
};

} // namespace mb
