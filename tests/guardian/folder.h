// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace mb::guardian::test {

/// A folder of its own, gone afterwards.
class Folder {
public:
    Folder()
    {
        std::string pattern = testing::TempDir() + "/debtsXXXXXX";
        EXPECT_NE(::mkdtemp(pattern.data()), nullptr);
        m_path = pattern;
    }
    Folder(const Folder &) = delete;
    Folder &operator=(const Folder &) = delete;
    ~Folder() { std::filesystem::remove_all(m_path); }
    [[nodiscard]] std::string path(const std::string &name = {}) const { return m_path + "/" + name; }

private:
    std::string m_path;
};

} // namespace mb::guardian::test
