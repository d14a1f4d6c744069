// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include <unistd.h>

namespace mb::test {

/// A folder of its own for one test, removed with everything in it.
class TemporaryFolder {
public:
    TemporaryFolder()
    {
        const std::string pattern = (std::filesystem::temp_directory_path() / "motorbench-XXXXXX").string();
        std::copy(pattern.begin(), pattern.end(), m_path.begin());
        if (::mkdtemp(m_path.data()) == nullptr)
            std::abort();
    }
    TemporaryFolder(const TemporaryFolder &) = delete;
    TemporaryFolder &operator=(const TemporaryFolder &) = delete;
    ~TemporaryFolder()
    {
        std::error_code ignored;
        std::filesystem::remove_all(m_path.data(), ignored);
    }

    [[nodiscard]] std::string path(std::string_view name = {}) const
    {
        return (std::filesystem::path(m_path.data()) / name).string();
    }
    std::string write(std::string_view name, std::string_view text) const
    {
        std::string file = path(name);
        std::ofstream(file, std::ios::binary) << text;
        return file;
    }
    [[nodiscard]] std::string read(std::string_view name) const
    {
        std::ifstream file(path(name), std::ios::binary);
        return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    }

private:
    std::array<char, 256> m_path{};
};

} // namespace mb::test
