// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/noncopyable.h"
#include "async/result.h"

#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace mb {

/// A text file written by a thread of its own, so that no disk ever holds up who writes. Records that are taken are written in
/// their order; what cannot be taken or written is counted, never silently gone, and a full disk leaves no half of one. Plain C++, for
/// ThreadSanitizer.
class BackgroundFile : NonCopyable {
public:
    static constexpr std::size_t mostWaiting = 64 * 1024 * 1024; ///< bytes in memory, then nothing more is taken

    struct Status {
        std::uint64_t taken = 0;   ///< records
        std::uint64_t written = 0; ///< records that the system has accepted
        std::uint64_t refused = 0; ///< records that append() did not take
        bool finished = false;     ///< closed: nothing will change any more
        Message problem;           ///< why nothing more is written, in one clause with its remedy
    };

    /// Makes the file, or empties it. LinkLost with cause and remedy when that cannot be, as where another of these writes it, or a
    /// RecordingFile reads it, in any program.
    [[nodiscard]] static Result<std::unique_ptr<BackgroundFile>> create(const std::string &path);
    /// finish(), and waits for it.
    ~BackgroundFile();

    /// One record. False, and counted, when too much waits already or the file failed. Takes a short lock.
    bool append(std::string_view record);
    /// What waits is written soon; without it, once some tens of kilobytes wait.
    void flush();
    /// Nothing more is taken; what waits is written, then the file is closed. Waits for nothing.
    void finish();
    [[nodiscard]] Status status() const;
    [[nodiscard]] const std::string &path() const { return m_path; }

private:
    BackgroundFile(std::string path, int descriptor);
    void run();
    struct Written {
        std::size_t bytes = 0;
        Message problem;
    };
    [[nodiscard]] Written writeAll(std::string_view text) const;
    [[nodiscard]] bool isDeleted() const;
    [[nodiscard]] std::size_t keepWhole(const std::vector<std::size_t> &ends, std::size_t written) const;

    std::string m_path;
    int m_descriptor;
    bool m_hasName; ///< a file system that counts the names of a file, and it has one
    mutable std::mutex m_mutex;
    std::condition_variable m_wake;
    std::string m_waiting;
    std::vector<std::size_t> m_waitingEnds; ///< of its records
    bool m_flush = false;
    bool m_finish = false;
    Status m_status;
    std::thread m_writer; ///< last: it uses all the others
};

} // namespace mb
