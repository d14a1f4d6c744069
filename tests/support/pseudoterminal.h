// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <fcntl.h>
#include <pty.h>
#include <termios.h>
#include <unistd.h>

namespace mb::test {

/// Both ends of a pseudo terminal; ours is what a serial adapter would be.
class PseudoTerminal {
public:
    PseudoTerminal()
    {
        std::array<char, 64> name{};
        termios settings{};
        ::cfmakeraw(&settings);
        int other = -1;
        EXPECT_EQ(::openpty(&m_ours, &other, name.data(), &settings, nullptr), 0);
        ::close(other);
        ::fcntl(m_ours, F_SETFL, O_NONBLOCK);
        m_path = name.data();
    }
    PseudoTerminal(const PseudoTerminal &) = delete;
    PseudoTerminal &operator=(const PseudoTerminal &) = delete;
    ~PseudoTerminal() { pull(); }

    [[nodiscard]] const std::string &path() const { return m_path; }
    [[nodiscard]] int descriptor() const { return m_ours; }
    void write(const std::vector<std::uint8_t> &bytes) const
    {
        EXPECT_EQ(::write(m_ours, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
    }
    /// What came and was not read yet.
    [[nodiscard]] std::vector<std::uint8_t> read() const
    {
        std::vector<std::uint8_t> bytes(4096);
        const auto got = ::read(m_ours, bytes.data(), bytes.size());
        bytes.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
        return bytes;
    }
    /// The adapter comes out.
    void pull()
    {
        if (m_ours >= 0)
            ::close(m_ours);
        m_ours = -1;
    }

private:
    int m_ours = -1;
    std::string m_path;
};

} // namespace mb::test
