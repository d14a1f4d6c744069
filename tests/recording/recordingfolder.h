// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/rollingrecorder.h"

#include <filesystem>
#include <string>
#include <unistd.h>

namespace mb::test {

inline constexpr Duration unixOffset = std::chrono::seconds(1'700'000'000);

/// A folder that goes with the test.
struct Folder {
    std::filesystem::path path;

    Folder()
    {
        std::string name = (std::filesystem::temp_directory_path() / "mb-recording-XXXXXX").string();
        path = ::mkdtemp(name.data());
    }
    ~Folder()
    {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }
    [[nodiscard]] std::string file(const char *name) const { return (path / name).string(); }
};

inline RollingRecorder::Options rolling(const Folder &folder, const char *name)
{
    RollingRecorder::Options options;
    options.folder = folder.path.string();
    options.name = name;
    options.keep = std::chrono::seconds(10);
    options.segment = std::chrono::seconds(2);
    return options;
}

} // namespace mb::test
