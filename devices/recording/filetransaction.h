// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"

#include <cstdio>
#include <memory>
#include <string>
#include <string_view>

namespace mb {

/// A file that appears under its name only when it is complete: it is written beside it, and removed when the
/// transaction ends without commit().
class FileTransaction {
public:
    explicit FileTransaction(std::string path);
    FileTransaction(const FileTransaction &) = delete;
    FileTransaction &operator=(const FileTransaction &) = delete;
    ~FileTransaction();

    [[nodiscard]] const std::string &temporaryPath() const { return m_temporary; }
    /// Somebody else has made the file under the temporary path: commit() or remove it.
    void own() { m_made = true; }
    /// LinkLost with the cause.
    [[nodiscard]] Result<void> open();
    void write(std::string_view text);
    [[nodiscard]] Result<void> commit();

private:
    struct Close {
        void operator()(std::FILE *file) const { std::fclose(file); }
    };
    [[nodiscard]] tl::unexpected<Error> failure(int error) const;

    std::string m_path;
    std::string m_temporary;
    std::unique_ptr<std::FILE, Close> m_file;
    bool m_made = false;
    int m_error = 0;
};

} // namespace mb
