// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/noncopyable.h"
#include "async/result.h"

#include <string>
#include <string_view>

namespace mb {

/// The door through which whole files are written. What is written goes to a file beside the one that is named, and takes its
/// place in commit() only: after a full disk, a crash or without commit() the old file is there as it was. A symbolic link
/// stays one and its target is written, the mode of an existing file is kept, and what is no regular file (`/dev/null`, a
/// pipe) is written to directly. Nothing counts as written before commit() has said so. Any thread, one at a time.
///
/// Streams that must be readable while they grow (recordings) are BackgroundFile and McapWriter.
class OutputFile : NonCopyable {
public:
    explicit OutputFile(std::string path);
    ~OutputFile();

    /// OutOfRange with cause and remedy when nothing can be written there. Nothing is changed by it.
    [[nodiscard]] Result<void> open();
    /// The first failure is kept for commit().
    void write(std::string_view bytes);
    /// Everything is on the disk and under its name, or it fails, NotKept, and the old file stands.
    [[nodiscard]] Result<void> commit();

    [[nodiscard]] const std::string &path() const { return m_path; }
    /// For who writes through a descriptor of its own, between open() and commit(). Owned by this.
    [[nodiscard]] int descriptor() const { return m_descriptor; }

private:
    [[nodiscard]] Result<void> openBeside();
    [[nodiscard]] Result<void> replace();
    [[nodiscard]] tl::unexpected<Error> notOpened(int number) const;
    [[nodiscard]] tl::unexpected<Error> notKept(int number) const;
    void drain();
    int closeFile();

    std::string m_path;
    std::string m_target;    ///< the path without symbolic links
    std::string m_temporary; ///< empty when it is written to directly
    std::string m_buffer;
    int m_descriptor = -1;
    int m_error = 0; ///< of the first write that failed
};

/// All of it or nothing, by an OutputFile.
[[nodiscard]] Result<void> writeFile(const std::string &path, std::string_view bytes);

/// Whether a file could be written there now: its folder, its kind, the permission. For who has long work before the writing, and
/// would fail after it. Whether the disk has room nobody knows before. A pipe is not touched: its reader would take that for the end.
[[nodiscard]] Result<void> checkWritable(const std::string &path);

/// Why a file cannot be written and what helps, never in the words of the locale: "the disk is full", "make room, or …".
[[nodiscard]] Error writeFailure(Fault fault, int systemError);
/// The same of this file: "PATH cannot be written: the disk is full".
[[nodiscard]] Error notWritten(Fault fault, const std::string &path, int systemError);

} // namespace mb
